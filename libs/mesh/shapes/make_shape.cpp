#include "mesh/shapes/make_shape.h"

#include <array>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/shapes/make_shape_kinds.h"

namespace orbicube::mesh {
namespace {

struct Shape {
  ShapeDescription description;
  Mesh (*make)(const ShapeOptions&, const base::Host&);
};

constexpr std::array table = {
    Shape{{"creature", "smooth animal with legs, arms, fingers, neck, head and tail", 0}, make_creature},
    Shape{{"blob", "smooth bumpy ball", 0}, make_blob},
    Shape{{"star", "ball with spikes", 0}, make_star},
    Shape{{"sphere", "unit sphere", 0}, make_sphere},
    Shape{{"cube", "cube with sharp edges", 0}, make_cube},
    Shape{{"torus", "ring", 1}, make_torus},
    Shape{{"three-holes", "plate with three square holes, all faces along the axes", 3}, make_three_holes},
    Shape{{"bracket", "angle bracket with four round holes", 4}, make_bracket},
    Shape{{"l-shape", "bar with a right angle, all faces along the axes", 0}, make_angle},
    Shape{{"cylinder", "round bar with flat ends", 0}, make_cylinder},
    Shape{{"vase", "solid of revolution with a wavy profile and flat ends", 0}, make_vase},
};

constexpr auto descriptions = [] {
  std::array<ShapeDescription, table.size()> all{};
  for (std::size_t i = 0; i < table.size(); ++i)
    all[i] = table[i].description;
  return all;
}();

}  // namespace

std::span<const ShapeDescription> shapes() {
  return descriptions;
}

Mesh make_shape(std::string_view name, const ShapeOptions& options, const base::Host& host) {
  constexpr std::size_t max_triangles = 100'000'000;
  if (options.triangles > max_triangles) {
    throw base::Error("invalid-argument", base::counted(options.triangles, "triangle") + "; at most " +
                                              std::to_string(max_triangles) + " can be made");
  }
  for (const Shape& shape : table) {
    if (name == shape.description.name) return shape.make(options, host);
  }
  std::string known;
  for (const ShapeDescription& d : descriptions)
    known += (known.empty() ? "" : ", ") + std::string(d.name);
  throw base::Error("invalid-argument", "no shape is called '" + std::string(name) + "'; there are " + known);
}

}  // namespace orbicube::mesh
