// A page to look at maps: shapes beside their maps to the sphere or to a polycube, colored by distortion, with the
// figures; one HTML file that loads nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace orbicube::cli {

// One map to show. The spans are read during the call only.
struct PageResult {
  std::string name;                           // what the reader chooses it by, as a file's name
  std::span<const mesh::Vector3> positions;   // the shape, in any unit
  std::span<const mesh::Vector3> directions;  // its map to the sphere, one unit vector a vertex; or
  std::span<const mesh::Vector3> polycube;    // to a polycube, a position a vertex
  std::span<const mesh::Triangle> triangles;  // of both
  std::span<const double> quasi_conformal;    // sigma_max / sigma_min of each triangle; infinite where it has no area
  std::span<const double> area_ratio;         // area on the map over area on the shape, both wholes equal
  std::vector<std::pair<std::string, std::string>> figures;  // rows of the table: name and value, in reading order
  // With a shape's spherical harmonics a slider shows it as they give it to each degree: (degree + 1)^2 coefficients of
  // x, y and z each, in the order and the basis of libs/harmonics (coefficients.h), at the directions above. May be
  // empty.
  std::uint32_t degree = 0;
  std::span<const double> coefficients;
  std::span<const double> energies;  // of an optimization, one after each iteration; may be empty
  bool z_up = false;                 // which way is up in the first view: z rather than y
};

// The text of the page, complete: styles, script and data are inside. About 28 bytes a vertex and 16 a coefficient of
// all three coordinates. Names are escaped. Throws Error invalid-argument when there is no result, one has no triangle,
// sizes differ or an index is out of range. O(n) time for n triangles in all.
std::string report_page(std::span<const PageResult> results, const std::string& title);

}  // namespace orbicube::cli
