// Files with EXT_meshopt_compression: made by meshoptimizer's encoders, and changed in every way.
#ifdef ORBICUBE_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <doctest/doctest.h>

#include <random>

#include "gltf/json/compressed_view.h"
#include "gltf/kept/kept.h"
#include "gltf/writing/write.h"
#include "made_files.h"

using namespace orbicube;
using namespace orbicube::gltf::test;

#ifdef ORBICUBE_WITH_MESHOPTIMIZER

namespace {

// Replaces a view of the file by one that is compressed, at the end of the buffer; the view refers to a buffer without
// bytes, as writers do.
void compress(MadeFile& file, std::size_t view, std::size_t stride, const char* mode, const char* filter,
              const std::vector<unsigned char>& bytes) {
  if (file.json["buffers"].size() == 1)
    file.json["buffers"].push_back(
        {{"byteLength", 1000}, {"extensions", {{gltf::compression_extension, {{"fallback", true}}}}}});
  file.buffer.resize((file.buffer.size() + 3) / 4 * 4);
  Json& changed = file.json["bufferViews"][view];
  Json extension = {{"buffer", 0},
                    {"byteOffset", file.buffer.size()},
                    {"byteLength", bytes.size()},
                    {"byteStride", stride},
                    {"count", changed["byteLength"].get<std::size_t>() / stride},
                    {"mode", mode}};
  if (filter != nullptr) extension["filter"] = filter;
  changed["buffer"] = 1;
  changed["byteOffset"] = 0;
  changed["extensions"] = {{gltf::compression_extension, extension}};
  file.buffer.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  file.json["buffers"][0]["byteLength"] = file.buffer.size();
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {gltf::compression_extension};
}

std::vector<unsigned char> encoded_positions() {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), corner_positions.data(), 4, 12));
  return bytes;
}

std::vector<unsigned char> encoded_corners(bool sequence) {
  const std::vector<unsigned int> corners(corner_indices.begin(), corner_indices.end());
  std::vector<unsigned char> bytes(sequence ? meshopt_encodeIndexSequenceBound(12, 4)
                                            : meshopt_encodeIndexBufferBound(12, 4));
  bytes.resize(sequence ? meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners.data(), 12)
                        : meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), corners.data(), 12));
  return bytes;
}

MadeFile compressed_tetrahedron() {
  MadeFile file = tetrahedron();
  file.buffer.clear();
  compress(file, 0, 12, "ATTRIBUTES", nullptr, encoded_positions());
  compress(file, 1, 2, "INDICES", nullptr, encoded_corners(true));
  return file;
}

Json& extension_of(MadeFile& file, std::size_t view) {
  return file.json["bufferViews"][view]["extensions"][gltf::compression_extension];
}

}  // namespace

TEST_CASE("A compressed file has the surface of the file that it is of") {
  CHECK(gltf::version_of_meshoptimizer() > 0);
  CHECK(is_tetrahedron(read_text(compressed_tetrahedron().glb())));

  // Triangles: meshoptimizer may rotate their corners.
  MadeFile file = compressed_tetrahedron();
  compress(file, 1, 2, "TRIANGLES", "NONE", encoded_corners(false));
  const mesh::Mesh read = read_text(file.glb());
  REQUIRE(read.triangles.size() == 4);
  for (std::size_t t = 0; t < 4; ++t) {
    mesh::Triangle wanted = {corner_indices[3 * t], corner_indices[3 * t + 1], corner_indices[3 * t + 2]};
    for (int turn = 0; turn < 2 && wanted != read.triangles[t]; ++turn)
      wanted = {wanted[1], wanted[2], wanted[0]};
    CHECK(wanted == read.triangles[t]);
  }

  // Exponents and mantissas: small integers are exact.
  std::array<std::uint32_t, 12> exponential{};
  for (std::size_t i = 0; i < 12; ++i)
    exponential[i] = static_cast<std::uint32_t>(corner_positions[i]);  // 2^0 * mantissa
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), exponential.data(), 4, 12));
  file = compressed_tetrahedron();
  compress(file, 0, 12, "ATTRIBUTES", "EXPONENTIAL", bytes);
  CHECK(is_tetrahedron(read_text(file.glb())));
}

TEST_CASE("What is kept of a compressed file is written without compression") {
  const std::string bytes = compressed_tetrahedron().glb();
  std::unique_ptr<gltf::Kept> kept;
  gltf::read(std::as_bytes(std::span(bytes)), {}, {}, base::Host(), nullptr, &kept);
  REQUIRE(kept != nullptr);
  const auto written = gltf::to_bytes(*kept, gltf::Form::glb, base::Host());
  const std::string text(reinterpret_cast<const char*>(written.data()), written.size());
  CHECK(text.find("meshopt") == std::string::npos);
  CHECK(is_tetrahedron(read_text(text)));
}

TEST_CASE("Compressed bytes that are damaged are refused with their place") {
  MadeFile file = compressed_tetrahedron();
  extension_of(file, 1)["mode"] = "TRIANGLES";
  std::string message;
  try {
    read_text(file.glb());
  } catch (const base::Error& error) {
    message = error.what();
  }
  CHECK_MESSAGE(message.find("bufferViews[1].extensions.EXT_meshopt_compression") != std::string::npos, message);
}

TEST_CASE("A compressed view that lies ends with its kind") {
  const auto with = [](std::size_t view, const char* member, const Json& value) {
    MadeFile file = compressed_tetrahedron();
    extension_of(file, view)[member] = value;
    return kind_of(file.glb());
  };
  CHECK(with(0, "mode", "ATTRIBUTES") == "accepted");
  CHECK(with(0, "mode", "attributes") == "parse");
  CHECK(with(0, "mode", 1) == "parse");
  CHECK(with(0, "filter", "SOME") == "parse");
  CHECK(with(0, "filter", "QUATERNION") == "parse");   // of 8 bytes
  CHECK(with(1, "filter", "EXPONENTIAL") == "parse");  // of indices
  CHECK(with(0, "byteStride", 0) == "parse");
  CHECK(with(0, "byteStride", 6) == "parse");
  CHECK(with(0, "byteStride", 260) == "parse");
  CHECK(with(1, "byteStride", 12) == "parse");
  CHECK(with(0, "count", 5) == "accessor-range");
  CHECK(with(0, "count", -1) == "parse");
  CHECK(with(0, "count", 1e15) == "accessor-range");
  CHECK(with(0, "buffer", 2) == "parse");
  CHECK(with(0, "buffer", 1) == "truncated");  // without bytes
  CHECK(with(0, "byteLength", 1e9) == "accessor-range");
  CHECK(with(0, "byteLength", 8) == "truncated");
  CHECK(with(0, "byteOffset", 1e9) == "accessor-range");
  CHECK(with(1, "mode", "TRIANGLES") == "truncated");
  for (const char* member : {"buffer", "byteLength", "byteStride", "count", "mode"}) {
    MadeFile file = compressed_tetrahedron();
    extension_of(file, 0).erase(member);
    CHECK(kind_of(file.glb()) == "parse");
  }
  // More than 64 times the bytes, which no encoder reaches, is not allocated.
  MadeFile file = compressed_tetrahedron();
  file.json["bufferViews"][0]["byteLength"] = 1'200'000'000;
  extension_of(file, 0)["count"] = 100'000'000;
  CHECK(kind_of(file.glb()) == "accessor-range");
}

TEST_CASE("A file that does not use the extension has the bytes of its buffers, and one that requires it uses it") {
  MadeFile file = tetrahedron();
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {gltf::compression_extension};
  CHECK(kind_of(file.glb()) == "unsupported-extension");  // which it has nowhere
  file.json.erase("extensionsRequired");
  CHECK(is_tetrahedron(read_text(file.glb())));
  file.json.erase("extensionsUsed");
  file.json["bufferViews"][0]["extensions"] = {{gltf::compression_extension, {{"buffer", 7}}}};
  CHECK(is_tetrahedron(read_text(file.glb())));
}

TEST_CASE("Changed bytes of a compressed file never give an invalid surface") {
  const std::string whole = compressed_tetrahedron().glb();
  const std::size_t content = whole.find("BIN");
  std::mt19937 random(5);
  for (int run = 0; run < 20000; ++run) {
    std::string changed = whole;
    const std::size_t from = run % 2 == 0 ? content : 20;
    for (std::size_t change = 1 + random() % 3; change > 0; --change)
      changed[from + random() % (changed.size() - from)] = static_cast<char>(random() & 0xFFU);
    try {
      const mesh::Mesh surface = read_text(changed);
      for (const mesh::Triangle& triangle : surface.triangles)
        for (const mesh::Index corner : triangle)
          REQUIRE(corner < surface.positions.size());
    } catch (const base::Error&) {
      continue;
    }
  }
}

#else

TEST_CASE("A build without meshoptimizer refuses files that require it, and reads those that also have the bytes") {
  MadeFile file = tetrahedron();
  file.json["extensionsUsed"] = {gltf::compression_extension};
  CHECK(is_tetrahedron(read_text(file.glb())));
  file.json["extensionsRequired"] = {gltf::compression_extension};
  CHECK(kind_of(file.glb()) == "unsupported-extension");
}

#endif
