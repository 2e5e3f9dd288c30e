#include "files/map_file.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "files/surface_file.h"
#include "gltf/reading/read.h"
#include "mesh/search/predicates.h"
#include "report/text.h"

namespace orbicube::cli {
namespace {

bool same_connections(const mesh::Mesh& shape, const mesh::Mesh& map) {
  const auto sorted = [](mesh::Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  return shape.positions.size() == map.positions.size() &&
         std::equal(shape.triangles.begin(), shape.triangles.end(), map.triangles.begin(), map.triangles.end(),
                    [&](const mesh::Triangle& a, const mesh::Triangle& b) { return sorted(a) == sorted(b); });
}

// Maps of other programs may flip triangles or leave the sphere: a few spoil figures there, many the whole.
void check_map(const mesh::Mesh& map, const std::filesystem::path& path, Session& session) {
  std::size_t positive = 0, negative = 0;
  mesh::Index first_positive = mesh::no_index, first_negative = mesh::no_index, first_flat = mesh::no_index;
  const auto count = [](std::size_t& of, mesh::Index& first, std::size_t t) {
    if (of++ == 0) first = static_cast<mesh::Index>(t);
  };
  std::size_t flat = 0;
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    const mesh::Triangle& v = map.triangles[t];
    const int sign = mesh::orientation_from_origin(map.positions[v[0]], map.positions[v[1]], map.positions[v[2]]);
    if (sign > 0) count(positive, first_positive, t);
    if (sign < 0) count(negative, first_negative, t);
    if (sign == 0) count(flat, first_flat, t);
  }
  const bool mirrored = negative > positive;  // of a surface that is inward-oriented
  const std::size_t over = mirrored ? positive : negative;
  const std::string of_all = " of " + base::counted(map.triangles.size(), "triangle");
  const auto place = [](mesh::Index t) { return ", the first is triangle " + std::to_string(t); };
  session.figures()["map"] = {{"flipped", over}, {"degenerate", flat}};
  constexpr std::size_t most_bad = 4;  // a quarter
  if (most_bad * (over + flat) > map.triangles.size()) {
    throw Failure(Exit::wrong_input, path, "invalid-argument",
                  "this is no map to the sphere: it flips " + std::to_string(over) + " and flattens " +
                      std::to_string(flat) + of_all + "; orbicube sphere makes one");
  }
  if (over > 0)
    session.note("the map flips " + std::to_string(over) + of_all + place(mirrored ? first_positive : first_negative) +
                 ": it is not one to one there");
  if (flat > 0) session.note("the map flattens " + std::to_string(flat) + of_all + place(first_flat));
  constexpr double far = 1e-3;
  std::size_t off = 0;
  double least = 1, most = 1;
  for (const mesh::Triangle& t : map.triangles) {
    for (const mesh::Index v : t) {
      const double length = map.positions[v].stableNorm();
      off += std::abs(length - 1) > far;
      least = std::min(least, length);
      most = std::max(most, length);
    }
  }
  session.figures()["map"]["length_min"] = least;
  session.figures()["map"]["length_max"] = most;
  if (off > 0)
    session.note("directions of the map have lengths from " + number(least) + " to " + number(most) +
                 ", not 1; they were normalized");
}

}  // namespace

mesh::Mesh read_map(const mesh::Mesh& shape, const std::string& shape_path, const std::filesystem::path& path,
                    Session& session) {
  mesh::Mesh map(session.host().memory);
  bool found = false;
  if (is_gltf(path)) {
    about(path, Role::input, [&] {
      try {
        map = gltf::read(path, {.morph_target = "sphere"}, session.host());
        found = true;
      } catch (const base::Error& error) {
        if (std::string_view(error.kind()) != "missing-attribute") throw;  // a map on its own, without a target
      }
    });
  }
  if (!found) map = read_input(path, false, session).mesh;
  if (!same_connections(shape, map)) {
    throw Failure(Exit::wrong_input, path, "invalid-argument",
                  "it has not the vertices and triangles of " + shape_path + ", in that order");
  }
  check_map(map, path, session);
  return map;
}

}  // namespace orbicube::cli
