// Writes files with everything that a scene may hold to a folder, for other programs to read (engines/), and prints a
// line for each: name, vertices, triangles, edges, names of morph targets separated by commas.
//
// Usage: write-gltf-samples FOLDER
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "gltf/writing/checker.h"
#include "gltf/writing/parts.h"
#include "gltf/writing/write.h"

using namespace orbicube;

namespace {

// A torus of n by n quads, and the same torus thinner.
struct Shape {
  std::vector<float> positions, thinner, texture_coordinates;
  std::vector<std::uint8_t> colors;
  std::vector<mesh::Triangle> triangles;
  std::vector<std::array<mesh::Index, 2>> edges;

  explicit Shape(std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / n;
        for (const auto& [to, radius] : {std::pair{&positions, 1.0}, std::pair{&thinner, 0.5}}) {
          const double r = 2 + radius * std::cos(v);
          for (const double x : {r * std::cos(u), r * std::sin(u), radius * std::sin(v)})
            to->push_back(static_cast<float>(x));
        }
        texture_coordinates.push_back(static_cast<float>(i) / static_cast<float>(n));
        texture_coordinates.push_back(static_cast<float>(j) / static_cast<float>(n));
        for (const std::uint32_t channel : {255 * i / n, 255 * j / n, 128U, 255U})
          colors.push_back(static_cast<std::uint8_t>(channel));
        const auto at = [&](std::uint32_t a, std::uint32_t b) { return a % n * n + b % n; };
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        edges.push_back({at(i, j), at(i + 1, j)});
      }
    }
  }
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  const base::Array<std::byte> png = gltf::checker_png({}, std::pmr::get_default_resource());
  struct Sample {
    const char* name;
    std::uint32_t n;
    bool plain;
  };
  for (const Sample& sample : {Sample{"plain.glb", 20, true}, Sample{"all.glb", 24, false},
                               Sample{"all.gltf", 24, false}, Sample{"large.glb", 300, false}}) {
    const Shape shape(sample.n);
    const std::vector<gltf::MorphTarget> targets = {{"thin", shape.thinner}, {"same", shape.positions}};
    gltf::Scene scene;
    scene.positions = shape.positions;
    scene.triangles = shape.triangles;
    if (!sample.plain) {
      scene.smooth_normals = scene.morph_normals = true;
      scene.texture_coordinates = shape.texture_coordinates;
      scene.colors = shape.colors;
      scene.morph_targets = targets;
      scene.morph_seconds = 1.5;
      scene.edges = shape.edges;
      scene.texture = png;
      scene.translation = {1, 2, 3};
      scene.scale = 0.1;
      scene.base_color[3] = 0.5;
      scene.extras = R"({"distortion": 1.25})";
    }
    gltf::write(folder / sample.name, scene, base::Host());
    std::printf("%s %zu %zu %zu %s\n", sample.name, shape.positions.size() / 3, shape.triangles.size(),
                scene.edges.size(), sample.plain ? "" : "thin,same");
  }
  // A transparent surface with another inside. Readers describe the first.
  const Shape shape(24);
  std::vector<mesh::Vector3> outer, inner;
  for (const auto& [from, to] : {std::pair{&shape.positions, &outer}, std::pair{&shape.thinner, &inner}}) {
    for (std::size_t i = 0; i < from->size(); i += 3)
      to->push_back({(*from)[i], (*from)[i + 1], (*from)[i + 2]});
  }
  std::vector<gltf::Part> parts(2);
  parts[0] = {.name = "surface", .positions = outer, .triangles = shape.triangles, .color = {0.8, 0.8, 0.8, 0.2}};
  parts[1] = {.name = "core", .positions = inner, .triangles = shape.triangles, .colors = shape.colors, .flat = true};
  gltf::write_parts(folder / "parts.glb", parts, base::Host());
  std::printf("parts.glb %zu %zu 0 \n", outer.size(), shape.triangles.size());
  return 0;
}
