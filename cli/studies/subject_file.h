// The file of a subject: a surface, or a label image whose label has one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "session/session.h"
#include "solids/closed_surface.h"

namespace orbicube::cli {

// Whether its name ends as those of label images do.
bool is_label_image(const std::filesystem::path& file);

// Returns the file's name without its endings.
std::string name_of_subject(const std::filesystem::path& file);

// Reads and repairs a surface, or extracts that of `label`, without handles and of the largest part, as `orbicube
// surface` does; 0: the only label of the image. Throws Failure.
ClosedSurface read_subject(const std::filesystem::path& file, std::int32_t label, Session& session);

// Returns a hash of what the result of a subject depends on: the bytes of its file, or what files beside it add to (of
// glTF files the surface, of images the labels and where they are), and `key`, a text of the options. Throws Failure.
std::string hash_of_input(const std::filesystem::path& file, const std::string& key, Session& session);

}  // namespace orbicube::cli
