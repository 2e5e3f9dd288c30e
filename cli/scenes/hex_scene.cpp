#include "scenes/hex_scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gltf/writing/float_frame.h"
#include "gltf/writing/write.h"

namespace orbicube::cli {
namespace {

using base::Array;
using hexmesh::Hexahedron;
using hexmesh::Quad;
using mesh::Index;
using mesh::Vector3;

constexpr std::size_t items_between_reports = std::size_t{1} << 14U;
using Color = std::array<double, 3>;  // linear
constexpr Color outside = {0.85, 0.71, 0.48}, worst = {0.8, 0.03, 0.02}, best = {0.16, 0.38, 0.89};

// A face of a hexahedron, by its vertices in ascending order.
struct Face {
  Quad sorted;
  Index hexahedron;
  std::uint8_t number;
  bool kept;
};

Array<Face> faces_of(const hexmesh::HexMesh& mesh, const std::vector<bool>& kept, const base::Host& host) {
  Array<Face> faces(host.memory);
  faces.reserve(6 * mesh.hexahedra.size());
  for (Index h = 0; h < mesh.hexahedra.size(); ++h) {
    if (h % items_between_reports == 0) host.report("faces to show", h, mesh.hexahedra.size());
    for (std::uint8_t f = 0; f < 6; ++f) {
      Quad face{};
      for (std::size_t k = 0; k < 4; ++k)
        face[k] = mesh.hexahedra[h][hexmesh::hexahedron_faces[f][k]];
      std::sort(face.begin(), face.end());
      faces.push_back({face, h, f, kept[h]});
    }
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.hexahedron < b.hexahedron;
  });
  return faces;
}

struct Shown {
  explicit Shown(std::pmr::memory_resource* memory)
      : positions(memory), normals(memory), colors(memory), triangles(memory), edges(memory) {}

  void add(const std::array<Vector3, 4>& corners, const Color& color) {
    const auto first = static_cast<Index>(positions.size() / 3);
    const Vector3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    for (const Vector3& p : corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        positions.push_back(static_cast<float>(p[axis]));
        normals.push_back(static_cast<float>(normal[axis]));
        colors.push_back(static_cast<std::uint8_t>(std::lround(255 * color[k])));
      }
      colors.push_back(255);
    }
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
    for (Index k = 0; k < 4; ++k)
      edges.push_back({first + k, first + (k + 1) % 4});
  }

  Array<float> positions, normals;
  Array<std::uint8_t> colors;
  Array<mesh::Triangle> triangles;
  Array<std::array<Index, 2>> edges;
};

Color color_of(double scaled_jacobian) {
  const double t = std::clamp(2 * scaled_jacobian - 1, 0.0, 1.0);
  Color result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = (1 - t) * worst[k] + t * best[k];
  return result;
}

}  // namespace

Json write_hex_scene(const std::filesystem::path& path, const hexmesh::HexMesh& mesh, Cut cut, const std::string& name,
                     const base::Host& host) {
  Vector3 low = mesh.positions.front(), high = low;
  for (const Vector3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3 middle = 0.5 * low + 0.5 * high;
  const gltf::FloatFrame frame{middle, gltf::float_scale((0.5 * high - 0.5 * low).maxCoeff())};
  std::vector<bool> kept(mesh.hexahedra.size(), true);
  for (std::size_t h = 0; h < kept.size(); ++h) {
    Vector3 center = Vector3::Zero();
    for (const Index v : mesh.hexahedra[h])
      center += mesh.positions[v] / 8;
    const bool in_front = center.z() > middle.z();
    kept[h] = cut == Cut::none || !in_front || (cut == Cut::quarter && center.y() <= middle.y());
  }
  Shown shown(host.memory);
  std::size_t cut_quads = 0;
  const Array<Face> faces = faces_of(mesh, kept, host);
  for (std::size_t i = 0; i < faces.size();) {
    const bool inner = i + 1 < faces.size() && faces[i + 1].sorted == faces[i].sorted;
    const Face& face = inner && !faces[i].kept ? faces[i + 1] : faces[i];
    const bool seen = face.kept && (!inner || faces[i].kept != faces[i + 1].kept);
    i += inner ? 2 : 1;
    if (!seen) continue;
    const Hexahedron& cell = mesh.hexahedra[face.hexahedron];
    std::array<Vector3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = frame.stored(mesh.positions[cell[hexmesh::hexahedron_faces[face.number][k]]]);
    shown.add(corners, inner ? color_of(hexmesh::scaled_jacobian(mesh.positions, cell)) : outside);
    cut_quads += inner;
  }
  gltf::Scene scene;
  scene.positions = shown.positions;
  scene.normals = shown.normals;
  scene.colors = shown.colors;
  scene.triangles = shown.triangles;
  scene.edges = shown.edges;
  scene.translation = frame.translation;
  scene.scale = frame.scale;
  scene.base_color = {1, 1, 1, 1};
  scene.name = name;
  gltf::write(path, scene, host);
  return {{"output", path.string()}, {"quads", shown.triangles.size() / 2}, {"quads_inside", cut_quads}};
}

}  // namespace orbicube::cli
