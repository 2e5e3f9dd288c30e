// Small surfaces and solids, and small files, for hostile calls to start from.
#pragma once

#include <cstdint>
#include <vector>

namespace hostile {

struct Mesh {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;   // a surface, most of them closed
  std::vector<std::uint32_t> tetrahedra;  // of the same vertices
};
const std::vector<Mesh>& meshes();

const std::vector<std::vector<char>>& files();

}  // namespace hostile
