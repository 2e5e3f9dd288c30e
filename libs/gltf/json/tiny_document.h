// A document for tinygltf: JSON values that it takes as they are, so that no text is written and read again.
#pragma once

#include <cstddef>
#include <string>

#include "gltf/json/json.h"
#include "gltf/json/json_memory.h"
#include "gltf/json/tiny.h"

namespace orbicube::gltf {

// The value, made in the JsonMemory of the calling thread. Arrays and objects that are nested deeper than `max_depth`
// become null. Whole numbers up to 2^53 become integers however they are written (5.0, 5e0), unsigned where they may
// be: tinygltf takes no other ones for sizes.
TinyJson tiny_value(JsonValue value, std::size_t max_depth);

// Reads the model of a document with tinygltf. False, with its message, where it refuses the document.
bool load_model(TinyJson document, tiny::Model& model, std::string& problem);

}  // namespace orbicube::gltf
