#include "meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace hostile {
namespace {

using Index = std::uint32_t;

// Tetrahedra from a vertex in the middle, which is in no triangle.
Mesh filled(Mesh surface) {
  const auto n = static_cast<Index>(surface.positions.size() / 3);
  double middle[3] = {0, 0, 0};
  for (std::size_t i = 0; i < surface.positions.size(); ++i)
    middle[i % 3] += surface.positions[i] / n;
  surface.positions.insert(surface.positions.end(), middle, middle + 3);
  for (std::size_t t = 0; t + 3 <= surface.triangles.size(); t += 3) {
    surface.tetrahedra.push_back(n);
    for (std::size_t k = 0; k < 3; ++k)
      surface.tetrahedra.push_back(surface.triangles[t + k]);
  }
  return surface;
}

Mesh refined(const Mesh& from) {
  Mesh result{from.positions, {}, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [place, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<Index>(result.positions.size() / 3));
    for (std::size_t k = 0; is_new && k < 3; ++k)
      result.positions.push_back((from.positions[3 * a + k] + from.positions[3 * b + k]) / 2);
    return place->second;
  };
  for (std::size_t t = 0; t + 3 <= from.triangles.size(); t += 3) {
    const Index a = from.triangles[t], b = from.triangles[t + 1], c = from.triangles[t + 2];
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Index v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca})
      result.triangles.push_back(v);
  }
  return result;
}

Mesh on_sphere(Mesh mesh) {
  for (std::size_t i = 0; i + 3 <= mesh.positions.size(); i += 3) {
    const double length = std::hypot(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
    for (std::size_t k = 0; k < 3; ++k)
      mesh.positions[i + k] /= length;
  }
  return mesh;
}

Mesh octahedron() {
  return {{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
          {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5},
          {}};
}

// The surface of cells of a grid.
Mesh of_cells(const std::vector<std::array<int, 3>>& cells, double length) {
  Mesh result;
  std::map<std::array<int, 3>, Index> vertices;
  const auto has = [&](const std::array<int, 3>& cell) {
    for (const auto& c : cells) {
      if (c == cell) return true;
    }
    return false;
  };
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = vertices.try_emplace(at, static_cast<Index>(vertices.size()));
    for (std::size_t k = 0; is_new && k < 3; ++k)
      result.positions.push_back(at[k] * (k == 0 ? length : 1));
    return place->second;
  };
  for (const auto& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        auto beside = cell;
        beside[axis] += side == 1 ? 1 : -1;
        if (has(beside)) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<std::array<int, 3>, 4> corners = {cell, cell, cell, cell};
        for (auto& corner : corners)
          corner[axis] += side;
        ++corners[1][u], ++corners[2][u], ++corners[2][v], ++corners[3][v];
        if (side == 0) std::swap(corners[1], corners[3]);
        const Index q[4] = {vertex(corners[0]), vertex(corners[1]), vertex(corners[2]), vertex(corners[3])};
        for (const int k : {0, 1, 2, 0, 2, 3})
          result.triangles.push_back(q[k]);
      }
    }
  }
  return result;
}

Mesh torus(Index around, Index across) {
  Mesh result;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < across; ++j) {
      const double u = 6.283185307179586 * i / around, v = 6.283185307179586 * j / across;
      for (const double x : {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)})
        result.positions.push_back(x);
      const Index a = i * across + j, b = (i + 1) % around * across + j, c = i * across + (j + 1) % across,
                  d = (i + 1) % around * across + (j + 1) % across;
      for (const Index w : {a, b, d, a, d, c})
        result.triangles.push_back(w);
    }
  }
  return result;
}

}  // namespace

const std::vector<Mesh>& meshes() {
  static const auto& all = *new auto([] {
    const Mesh cube = of_cells({{0, 0, 0}}, 1);
    Mesh open = refined(cube);
    open.triangles.resize(open.triangles.size() - 6);
    return std::vector<Mesh>{
        {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}, {0, 1, 2, 3}},
        filled(cube),
        filled(refined(cube)),
        filled(of_cells({{0, 0, 0}}, 100)),
        filled(octahedron()),
        filled(on_sphere(refined(octahedron()))),
        filled(on_sphere(refined(refined(octahedron())))),
        filled(torus(8, 5)),
        filled(of_cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1)),
        filled(of_cells({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 1, 1}}, 1)),
        filled(of_cells({{0, 0, 0}, {3, 0, 0}}, 1)),
        filled(of_cells({{0, 0, 0}, {1, 1, 0}}, 1)),  // an edge of four triangles
        filled(open),
    };
  }());
  return all;
}

const std::vector<std::vector<char>>& files() {
  static const auto& all = *new auto([] {
    std::vector<std::vector<char>> result;
    for (const std::string text :
         {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
          "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
          "1\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
          "0\nendloop\nendfacet\nendsolid a\n",
          "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 "
          "4 0\nEnd\n",
          "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
          "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
          "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
          "\"meshes\":"
          "[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":"
          "5126,"
          "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}],\"bufferViews\":[{\"buffer\":0,"
          "\"byteLength\":36}],"
          "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
          "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}"})
      result.emplace_back(text.begin(), text.end());
    return result;
  }());
  return all;
}

}  // namespace hostile
