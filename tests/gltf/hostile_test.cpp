// Files that lie: each ends with the kind of error that says what is wrong, and nothing that a file says can crash the
// reader or make it allocate what the file cannot hold.
#include <doctest/doctest.h>

#include <memory_resource>
#include <random>

#include "gltf/json/json.h"
#include "made_files.h"

using namespace orbicube;
using gltf::test::Json;
using gltf::test::kind_of;
using gltf::test::MadeFile;
using gltf::test::tetrahedron;

namespace {

// Counts the most memory that was held at a time.
class CountingMemory final : public std::pmr::memory_resource {
 public:
  std::size_t most = 0;

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    most = std::max(most, held_ += size);
    return std::pmr::new_delete_resource()->allocate(size, alignment);
  }
  void do_deallocate(void* pointer, std::size_t size, std::size_t alignment) override {
    held_ -= size;
    std::pmr::new_delete_resource()->deallocate(pointer, size, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
  std::size_t held_ = 0;
};

// Reads whatever it is; answers how much memory that took. Errors must have a kind of the table.
std::size_t memory_of_reading(const std::string& bytes) {
  CountingMemory memory;
  base::Host host;
  host.memory = &memory;
  try {
    const mesh::Mesh surface = gltf::read(std::as_bytes(std::span(bytes)), {}, {}, host);
    for (const mesh::Triangle& triangle : surface.triangles) {
      for (const mesh::Index v : triangle)
        REQUIRE(v < surface.positions.size());
    }
    for (const mesh::Vector3& position : surface.positions)
      REQUIRE(position.allFinite());
  } catch (const base::Error& error) {
    REQUIRE(error.status() != base::Status::internal);
    REQUIRE(std::string(error.what()).size() < 1000);
  }
  return memory.most;
}

}  // namespace

TEST_CASE("Each lie ends with its kind") {
  struct Lie {
    std::string pointer, value, kind;  // what is put where in the document (null: taken away)
  };
  const std::string huge = "4611686018427387904";
  for (const Lie& lie : std::vector<Lie>{
           Lie{"/asset", "null", "parse"},
           Lie{"/asset/version", "\"1.0\"", "unsupported-version"},
           Lie{"/asset/version", "\"two\"", "parse"},
           Lie{"/asset/version", "2.0", "parse"},
           Lie{"/meshes", "null", "empty-mesh"},
           Lie{"/meshes", "{}", "parse"},
           Lie{"/meshes/0", "7", "parse"},
           Lie{"/meshes/0/primitives", "null", "parse"},
           Lie{"/meshes/0/primitives/0/mode", "7", "parse"},
           Lie{"/meshes/0/primitives/0/mode", "-1", "parse"},
           Lie{"/meshes/0/primitives/0/mode", "0", "unsupported-mode"},
           Lie{"/meshes/0/primitives/0/attributes/POSITION", "null", "missing-attribute"},
           Lie{"/meshes/0/primitives/0/attributes/POSITION", "2", "index-range"},
           Lie{"/meshes/0/primitives/0/attributes/POSITION", "1", "accessor-type"},
           Lie{"/meshes/0/primitives/0/indices", "0", "accessor-type"},
           Lie{"/meshes/0/primitives/0/indices", "18446744073709551615", "index-range"},
           Lie{"/accessors/0/type", "\"VEC2\"", "accessor-type"},
           Lie{"/accessors/0/componentType", "5124", "accessor-type"},
           Lie{"/accessors/0/componentType", "5125", "accessor-type"},
           Lie{"/accessors/0/count", "5", "accessor-range"},
           Lie{"/accessors/0/count", "0", "empty-mesh"},
           Lie{"/accessors/0/count", "3", "index-range"},
           Lie{"/accessors/0/count", "3.5", "parse"},
           Lie{"/accessors/0/count", "-1", "parse"},
           Lie{"/accessors/0/count", huge, "accessor-range"},
           Lie{"/accessors/0/count", "18446744073709551615", "accessor-range"},
           Lie{"/accessors/0/count", "1e300", "parse"},
           Lie{"/accessors/0/byteOffset", "1", "accessor-range"},
           Lie{"/accessors/0/byteOffset", "18446744073709551612", "accessor-range"},
           Lie{"/accessors/0/bufferView", "2", "parse"},
           Lie{"/accessors/1/count", "11", "parse"},
           Lie{"/accessors/1/count", "15", "accessor-range"},
           Lie{"/accessors/1/componentType", "5126", "accessor-type"},
           Lie{"/accessors/1/componentType", "5122", "accessor-type"},
           Lie{"/bufferViews/0/byteLength", huge, "accessor-range"},
           Lie{"/bufferViews/0/byteLength", "47", "accessor-range"},
           Lie{"/bufferViews/0/byteOffset", "18446744073709551615", "accessor-range"},
           Lie{"/bufferViews/0/byteStride", "4", "accessor-range"},
           Lie{"/bufferViews/0/byteStride", huge, "accessor-range"},
           Lie{"/bufferViews/0/buffer", "1", "parse"},
           Lie{"/buffers/0/byteLength", "73", "truncated"},
           Lie{"/buffers/0/byteLength", huge, "truncated"},
           Lie{"/buffers/0/byteLength", "20", "accessor-range"},
           Lie{"/buffers/0/byteLength", "null", "parse"},
           Lie{"/nodes/0/mesh", "1", "index-range"},
           Lie{"/nodes/0/children", "[0]", "parse"},
           Lie{"/nodes/0/children", "[1]", "index-range"},
           Lie{"/nodes/0/scale", "[1, 0, 1]", "degenerate-geometry"},
           Lie{"/nodes/0/scale", "[1e-200, 1e-200, 1e-200]", "accepted"},
           Lie{"/nodes/0", R"({"mesh": 0, "scale": [1e308, 1, 1], "translation": [1e308, 0, 0]})", "non-finite"},
           Lie{"/nodes/0/scale", "[1, 1]", "parse"},
           Lie{"/nodes/0/rotation", "[0, 0, 0, 0]", "parse"},
           Lie{"/nodes/0/matrix", "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]", "parse"},
           Lie{"/scenes/0/nodes", "[1]", "index-range"},
           Lie{"/scene", "1", "index-range"},
       }) {
    CAPTURE(lie.pointer);
    CAPTURE(lie.value);
    MadeFile file = tetrahedron();
    file.json[Json::json_pointer(lie.pointer)] = Json::parse(lie.value);
    std::string text = file.json.dump();
    if (lie.value == "null") {
      // Takes the member away.
      const Json::json_pointer pointer(lie.pointer);
      file.json[pointer.parent_pointer()].erase(pointer.back());
      text = file.json.dump();
    }
    CHECK(kind_of(MadeFile::glb_of(text, file.buffer)) == lie.kind);
  }
}

TEST_CASE("Sparse lies and values that are none end with their kinds") {
  MadeFile file = tetrahedron();
  const std::size_t elements = file.add_view(std::array<std::uint16_t, 2>{1, 3});
  const std::size_t values = file.add_view(std::array<float, 6>{1, 0, 0, 0, 0, 1});
  Json& sparse = file.json["accessors"][0]["sparse"];
  const Json honest = {{"count", 2},
                       {"indices", {{"bufferView", elements}, {"componentType", 5123}}},
                       {"values", {{"bufferView", values}}}};
  sparse = honest;
  CHECK(kind_of(file.glb()) == "accepted");
  sparse["count"] = 5;
  CHECK(kind_of(file.glb()) == "accessor-range");
  sparse["count"] = 3;
  CHECK(kind_of(file.glb()) == "accessor-range");
  sparse = honest;
  sparse["indices"]["componentType"] = 5126;
  CHECK(kind_of(file.glb()) == "accessor-type");
  sparse = honest;
  sparse["indices"]["bufferView"] = values;  // the bits of floats are no elements
  CHECK(kind_of(file.glb()) == "index-range");
  sparse = honest;
  sparse.erase("values");
  CHECK(kind_of(file.glb()) == "parse");
  // Without a base, a count costs the file nothing and must not cost memory.
  sparse = honest;
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 1000000000;
  CHECK(kind_of(file.glb()) == "accessor-range");
  CHECK(memory_of_reading(file.glb()) < 100000);

  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    MadeFile not_finite = tetrahedron();
    std::memcpy(not_finite.buffer.data() + 20, &bad, sizeof bad);
    CHECK(kind_of(not_finite.glb()) == "non-finite");
  }
  for (const std::uint16_t index : {std::uint16_t{4}, std::uint16_t{65535}}) {
    MadeFile beyond = tetrahedron();
    std::memcpy(beyond.buffer.data() + 48 + 10, &index, sizeof index);
    CHECK(kind_of(beyond.glb()) == "index-range");
  }
}

TEST_CASE("Containers and texts that are none end with their kinds") {
  const std::string whole = tetrahedron().glb();
  CHECK(kind_of("") == "empty-file");
  CHECK(kind_of("solid cube") == "bad-magic");
  CHECK(kind_of("glTG" + whole.substr(4)) == "bad-magic");
  const auto with_byte = [&](std::size_t at, char byte) {
    std::string changed = whole;
    changed[at] = byte;
    return changed;
  };
  CHECK(kind_of(with_byte(4, 1)) == "unsupported-version");
  CHECK(kind_of(with_byte(10, 1)) == "truncated");
  CHECK(kind_of(with_byte(9, 0)) == "parse");  // the header's length ends before the chunks do
  CHECK(kind_of(with_byte(14, 1)) == "truncated");
  CHECK(kind_of(with_byte(16, 'j')) == "parse");
  CHECK(kind_of(whole + "garbage") == "accepted");
  CHECK(kind_of(MadeFile::glb_of("[1, 2]", "")) == "parse");
  for (const char* text : {"{", "{\"a\"}", "{\"a\": 1,}", "{'a': 1}", "{\"a\": NaN}", "{\"a\": 01}", "{} {}",
                           "{\"a\": \"\x01\"}", "{\"\xFF\": 1}", "{\"a\": \"\\ud800\"}", "{\"a\": 1e999}", "{/**/}"}) {
    CAPTURE(text);
    CHECK(kind_of(text) == "parse");
  }
  for (const std::string& open : {std::string("["), std::string("{\"a\":")}) {
    std::string deep;
    for (int i = 0; i < 100000; ++i)
      deep += open;
    CHECK(kind_of(deep) == "depth-limit");
  }
}

TEST_CASE("A value of a document says where it stands") {
  const gltf::JsonDocument document(R"({"a": [1, {"b\n": "\u00e4\ud83d\ude00"}, 3.0], "a": 2})", base::Host());
  const gltf::JsonValue root = document.root();
  CHECK(root.path() == "the document");
  std::vector<std::string> paths;
  root.member("a").for_each_element([&](gltf::JsonValue value) { paths.push_back(value.path()); });
  CHECK(paths == std::vector<std::string>{"a[0]", "a[1]", "a[2]"});
  std::vector<gltf::JsonValue> values;
  root.member("a").for_each_element([&](gltf::JsonValue value) { values.push_back(value); });
  CHECK(values[1].member("b\n").string() == "ä😀");
  CHECK(values[1].member("b\n").path() == "a[1].b\n");
  CHECK(values[2].unsigned_integer() == 3);
  CHECK_FALSE(root.member("c"));
  CHECK_THROWS_WITH_AS(values[1].required("c"), "a[1] has no c", base::Error);
  CHECK_THROWS_WITH_AS(values[0].string(), "a[0] is not a string", base::Error);
}

TEST_CASE("A file that ends anywhere is refused") {
  MadeFile file = tetrahedron();
  const std::string whole = file.glb();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    const std::string kind = kind_of(whole.substr(0, length));
    CHECK(kind == (length == 0 ? "empty-file" : "truncated"));
  }
  const std::string text = file.json.dump();
  for (std::size_t length = 1; length < text.size(); ++length) {
    CAPTURE(length);
    CHECK(kind_of(text.substr(0, length)) == "parse");
  }
}

TEST_CASE("Changed bytes never give an invalid surface, nor more memory than a file of its size may take") {
  MadeFile file = tetrahedron();
  file.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", file.add_view(std::array<std::uint8_t, 1>{2})}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.add_view(std::array<float, 3>{0, 1, 0})}}}};
  const std::string whole = file.glb();
  std::mt19937 random(11);
  constexpr std::string_view telling = "0123456789-+.eE{}[]\",:\\ \xFF";
  std::size_t most = 0;
  for (int run = 0; run < 30000; ++run) {
    std::string changed = whole;
    for (std::size_t change = 1 + random() % 3; change > 0; --change) {
      const std::size_t at = random() % changed.size();
      switch (random() % 4) {
        case 0:
          changed[at] = static_cast<char>(random() & 0xFFU);
          break;
        case 1:
          changed[at] = telling[random() % telling.size()];
          break;
        case 2:
          changed.insert(at, 1, telling[random() % telling.size()]);
          break;
        default:
          changed.erase(at, 1);
      }
      // Lengths that agree lead deeper.
      if (changed.size() > 12 && random() % 2 == 0) changed[8] = static_cast<char>(changed.size() & 0xFFU);
    }
    most = std::max(most, memory_of_reading(changed));
  }
  CHECK(most < 100 * whole.size());
}

TEST_CASE("Showing the same data again and again is bounded") {
  MadeFile file = tetrahedron();
  Json primitives = Json::array();
  for (int i = 0; i < 1000; ++i)
    primitives.push_back(file.json["meshes"][0]["primitives"][0]);
  file.json["meshes"][0]["primitives"] = primitives;
  Json nodes = Json::array();
  Json roots = Json::array();
  for (int i = 0; i < 2000; ++i) {
    nodes.push_back({{"mesh", 0}});
    roots.push_back(i);
  }
  file.json["nodes"] = nodes;
  file.json["scenes"][0]["nodes"] = roots;
  const std::string bytes = file.glb();
  CHECK(kind_of(bytes) == "unsupported");
  CHECK(memory_of_reading(bytes) < 150000000);
}
