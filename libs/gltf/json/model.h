// A glTF document as tinygltf's typed model, from JSON that was checked and back to JSON.
#pragma once

#include <cstddef>
#include <string>

#include "base/host.h"
#include "gltf/json/json.h"
#include "gltf/json/tiny.h"

namespace orbicube::gltf {

// Which members of a document the model has: all, or those that a surface is read from.
enum class Extent { everything, surface };

// The model of a document that check_structure accepts. Its buffers have no data, since Asset holds the bytes; its
// images have no pixels, but bufferView, mimeType or uri as in the document, if these are of the right type. Numbers of
// extras and of unknown extensions that are whole have 32 bits; values that are null or empty, or nested deeper than 64
// levels, are left out: tinygltf holds no others. Throws Error "parse" when tinygltf refuses the document,
// "unsupported" beyond 4 GiB or when the model would take far more memory than the document has bytes, "cancelled".
// O(length of the document).
tiny::Model model_of(const JsonDocument& document, Extent extent, const base::Host& host);

// The JSON of a model, without buffers. Throws Error "invalid-argument" when a text in it is not UTF-8.
std::string text_of(const tiny::Model& model, const base::Host& host);

// The name of an element for messages: "accessors[3]".
std::string place_of(const char* array, std::size_t index);

}  // namespace orbicube::gltf
