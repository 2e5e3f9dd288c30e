// The images of a file that is written again.
#pragma once

#include "gltf/json/tiny.h"
#include "gltf/kept/kept.h"
#include "gltf/writing/binary_buffer.h"

namespace orbicube::gltf {

// Puts the bytes of the model's images, which are those of the kept file, into the buffer: from base64, from files of
// its folder, and from its views unless these are in the buffer already. Those of files that cannot be read keep their
// name.
void add_images(BinaryBuffer& buffer, const Kept& kept, bool views_added, tiny::Model& model);

// Throws Error unless an image is in a buffer view, in base64, or in a file of the folder, if it is there.
void check_image(const Kept& kept, const tiny::Image& image, const std::string& where);

}  // namespace orbicube::gltf
