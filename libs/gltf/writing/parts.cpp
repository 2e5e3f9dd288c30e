#include "gltf/writing/parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "gltf/json/document.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/container_writer.h"
#include "gltf/writing/normals.h"
#include "mesh/files/file.h"

namespace orbicube::gltf {
namespace {

void check(const Part& part, const base::Host& host) {
  const auto require = [&](bool condition, const char* message) {
    if (!condition) throw base::Error("invalid-argument", "part '" + part.name + "': " + message);
  };
  require(!part.triangles.empty(), "there are no triangles to write");
  require(part.positions.size() < mesh::no_index && 3 * part.triangles.size() < mesh::no_index,
          "there are more vertices than 32-bit indices can count");
  require(part.colors.empty() || part.colors.size() == 4 * part.positions.size(),
          "colors have another size than positions");
  require(std::ranges::all_of(part.color, [](double c) { return c >= 0 && c <= 1; }),
          "the color is not between 0 and 1");
  require(part.translation.allFinite() && std::isfinite(part.scale) && part.scale > 0,
          "translation is not finite, or scale is not a positive number");
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report("checking", i, part.positions.size());
    require(part.positions[i].cast<float>().allFinite(), "positions are not finite");
  }
  for (const mesh::Triangle& t : part.triangles)
    require(std::ranges::max(t) < part.positions.size(), "a triangle has a vertex that does not exist");
}

// What is stored of a part. Arrays live until the buffer is written.
struct Stored {
  base::Array<float> positions, normals;
  base::Array<std::uint8_t> colors;
  base::Array<mesh::Triangle> triangles;

  Stored(const Part& part, const base::Host& host)
      : positions(host.memory), normals(host.memory), colors(host.memory), triangles(host.memory) {
    const auto add = [&](mesh::Index v) {
      for (const double x : part.positions[v])
        positions.push_back(static_cast<float>(x));
      if (!part.colors.empty()) {
        const auto color = part.colors.subspan(4 * std::size_t{v}, 4);
        colors.insert(colors.end(), color.begin(), color.end());
      }
    };
    if (part.flat) {
      for (const mesh::Triangle& t : part.triangles) {
        const auto first = static_cast<mesh::Index>(3 * triangles.size());
        for (const mesh::Index v : t)
          add(v);
        triangles.push_back({first, first + 1, first + 2});
      }
    } else {
      for (mesh::Index v = 0; v < part.positions.size(); ++v)
        add(v);
      triangles.assign(part.triangles.begin(), part.triangles.end());
    }
    // Where each corner has one triangle, its smooth normal is that triangle's.
    normals = smooth_normals(positions, triangles, host);
  }
};

template <class Sink>
void emit(std::span<const Part> parts, Form form, const base::Host& host, const Sink& sink) {
  std::vector<Stored> stored;
  std::vector<PartAccessors> accessors;
  BinaryBuffer buffer(host);
  stored.reserve(parts.size());
  for (const Part& part : parts) {
    const Stored& s = stored.emplace_back(part, host);
    PartAccessors added{};
    added.position = buffer.add_floats(s.positions, 3, true);
    added.normal = buffer.add_floats(s.normals, 3, false);
    if (!s.colors.empty()) added.color = buffer.add_colors(s.colors);
    added.triangles = buffer.add_indices({s.triangles.front().data(), 3 * s.triangles.size()}, s.positions.size() / 3);
    accessors.push_back(added);
  }
  emit_container(form, model_of(parts, accessors), "", buffer, host, sink);
}

void check(std::span<const Part> parts, const base::Host& host) {
  if (parts.empty()) throw base::Error("invalid-argument", "there are no parts to write");
  for (const Part& part : parts)
    check(part, host);
}

}  // namespace

void write_parts(const std::filesystem::path& path, std::span<const Part> parts, const base::Host& host) {
  check(parts, host);
  mesh::OutputFile file(path);
  emit(parts, form_of_path(path).value_or(Form::glb), host,
       [&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.commit();
}

base::Array<std::byte> parts_to_bytes(std::span<const Part> parts, Form form, const base::Host& host) {
  check(parts, host);
  base::Array<std::byte> result(host.memory);
  emit(parts, form, host,
       [&](std::span<const std::byte> bytes) { result.insert(result.end(), bytes.begin(), bytes.end()); });
  return result;
}

}  // namespace orbicube::gltf
