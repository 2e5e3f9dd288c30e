// What the JSON of a glTF file must look like before tinygltf reads it: tinygltf casts numbers to the type that it
// wants, and leaves out what it does not understand.
#pragma once

#include "gltf/json/json.h"

namespace orbicube::gltf {

// Checks all members that a surface is read from: their types, and that numbers are whole and within what the model
// holds. Throws Error with the path of the value: "parse", "index-range" for an index and "accessor-range" or
// "truncated" for a size that nothing can have, "accessor-type", "unsupported-version", "unsupported-extension".
void check_structure(JsonValue root);

}  // namespace orbicube::gltf
