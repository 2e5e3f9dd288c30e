// A page to look at meshes: surfaces with maps, tetrahedra and hexahedra, each in a view of its own; one HTML file that
// loads nothing.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace orbicube::cli {

// Edges to draw as a curve within a solid.
struct ViewCurves {
  std::string name;
  std::vector<std::array<mesh::Index, 2>> edges;
};

// A mesh to show. What it points to is read during the call only.
struct ViewItem {
  std::string name;
  const mesh::Mesh* mesh = nullptr;  // with cells: its triangles are left out
  std::vector<std::pair<std::string, std::span<const mesh::Vector3>>>
      targets;  // maps of a surface, a position a vertex
  std::vector<ViewCurves> curves;
  std::vector<std::pair<std::string, std::string>> figures;  // rows of the table: name and value, in reading order
};

// How the page begins; the reader can change all of it.
struct ViewStart {
  bool z_up = false;   // which way is up: z rather than y
  std::string preset;  // as in the address of the page (mesh_page.js); empty: nothing
};

// The text of the page, complete: styles, script and data are inside. 12 bytes a vertex, 4 a corner of a triangle or
// cell (up to 2^24 vertices). Positions are rounded to steps of the box over 2^24 - 1. Throws Error invalid-argument
// when there is no item, or one has no element. O(n) time.
std::string view_page(std::span<const ViewItem> items, const std::string& title, const ViewStart& start);

}  // namespace orbicube::cli
