// Where the bytes of a buffer are: in a data URI, or in a file of the glTF file's own folder. Nothing else is ever
// opened, whatever a file requires.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::gltf {

// For messages: the beginning of a text from a file, which may be long and hold anything, in printable ASCII.
std::string in_quotes(std::string_view text);

// The base64 text of a data URI; none when `uri` is no data URI. Throws Error "unsupported-uri" for data in another
// encoding.
std::optional<std::string_view> base64_of_data_uri(std::string_view uri);

// The name of a file below the glTF file's folder that a relative URI (RFC 3986) stands for, percent-encoding and dots
// resolved: "buffers/../a.bin" is "a.bin". Throws Error "unsafe-path" for everything that leads or could lead
// elsewhere: schemes, absolute paths, ".." beyond the folder, backslashes, control characters, and these in encoded
// form; "unsupported-uri" for queries, fragments and nothing; "parse" for a broken encoding.
std::string file_of_uri(std::string_view uri);

// All bytes of a file `name` (of file_of_uri) below `folder`. Throws Error "unsafe-path" when it lies outside the
// folder (a link) or is not a regular file, "io" when it cannot be read, "cancelled".
base::Array<std::byte> read_file_below(const std::filesystem::path& folder, const std::string& name,
                                       const base::Host& host);

}  // namespace orbicube::gltf
