// tinygltf 2.7 (MIT), as this library compiles it: one typed model of a document, read from JSON and written as JSON.
// It opens no file, decodes no image and no buffer: uri.h, base64.h and asset.h do that, with their checks. Its
// namespace has another name here, so that a program which links this library statically may have a tinygltf of its
// own.
#pragma once

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NOEXCEPTION  // exceptions pass through it: "cancelled", std::bad_alloc
#define tinygltf orbicube_tinygltf
#include "gltf/json/tiny_streams.h"

#include <tiny_gltf.h>

namespace orbicube::gltf {

namespace tiny = ::tinygltf;

}  // namespace orbicube::gltf
