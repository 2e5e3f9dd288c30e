// The code of tinygltf, over JSON values in memory of ours.
#include <utility>

#include "gltf/json/json_memory.h"

namespace {

// What tinygltf is about to read on this thread.
thread_local orbicube::gltf::TinyJson* document = nullptr;

}  // namespace

// tinygltf starts with the text of a document, which has been read here (json.h): its call for the values gets those.
template <>
template <>
orbicube::gltf::TinyJson orbicube::gltf::TinyJson::parse<const char*>(const char*, const char*, const parser_callback_t,
                                                                      const bool, const bool) {
  return std::move(*document);
}

namespace nlohmann {

using tiny_json = orbicube::gltf::TinyJson;

}  // namespace nlohmann

#define TINYGLTF_IMPLEMENTATION
#define json tiny_json
#include "gltf/json/tiny.h"
#undef json

#include "gltf/json/tiny_document.h"

namespace orbicube::gltf {

bool load_model(TinyJson values, tiny::Model& model, std::string& problem) {
  document = &values;
  tiny::TinyGLTF reader;
  std::string warning;
  constexpr std::string_view no_text = "{  }";  // four characters at least
  return reader.LoadASCIIFromString(&model, &problem, &warning, no_text.data(), no_text.size(), "", tiny::NO_REQUIRE);
}

}  // namespace orbicube::gltf
