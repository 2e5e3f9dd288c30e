#include "scenes/parameter_scene.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/files/file.h"
#include "mesh/files/text_writer.h"
#include "mesh/search/measures.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "polycube/surface/surface_map.h"
#include "scenes/checkered_scene.h"
#include "scenes/page_figures.h"
#include "scenes/polycube_page.h"

namespace orbicube::cli {

using mesh::Index;
using mesh::Vector3;

ParameterSurface parameter_surface(std::span<const Vector3> positions, std::span<const mesh::Tetrahedron> tetrahedra,
                                   const volume_map::Parameterization& map, const base::Host& host) {
  struct Corner {
    Index vertex;
    std::array<double, 2> coordinates;
    Index place;  // three a triangle
    Vector3 parameter;
  };
  const mesh::TetrahedralConnectivity connectivity(positions.size(), tetrahedra, host);
  base::Array<Corner> corners(host.memory);
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    const int axis = map.label[face] / 2, sign = map.label[face] % 2 != 0 ? 1 : -1;
    for (const Index v : connectivity.vertices(face)) {
      const Vector3& f = map.corners[face / 4][connectivity.corner_of(face / 4, v)];
      corners.push_back({v, {sign * f[(axis + 1) % 3], f[(axis + 2) % 3]}, static_cast<Index>(corners.size()), f});
    }
  }
  ParameterSurface surface(host.memory);
  surface.triangles.resize(corners.size() / 3);
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.vertex, a.coordinates, a.place) < std::tie(b.vertex, b.coordinates, b.place);
  });
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& c = corners[i];
    if (i == 0 || c.vertex != corners[i - 1].vertex || c.coordinates != corners[i - 1].coordinates) {
      surface.positions.push_back(positions[c.vertex]);
      surface.coordinates.push_back(c.coordinates);
      surface.parameters.push_back(c.parameter);
    }
    surface.triangles[c.place / 3][c.place % 3] = static_cast<Index>(surface.positions.size() - 1);
  }
  return surface;
}

void write_parameter_scene(const std::filesystem::path& path, const ParameterSurface& surface, const std::string& name,
                           const base::Host& host) {
  const mesh::Measures box = mesh::measures(surface.positions, surface.triangles, host);
  gltf::FloatFrame frame;
  frame.translation = 0.5 * box.low + 0.5 * box.high;
  frame.scale = gltf::float_scale((0.5 * box.high - 0.5 * box.low).maxCoeff());
  const base::Array<float> places = gltf::stored_positions(surface.positions, frame, host.memory);
  // One unit of texture coordinates is two cells, a square of each color.
  std::vector<float> coordinates;
  for (const auto& [u, v] : surface.coordinates) {
    coordinates.push_back(static_cast<float>(0.5 * u));
    coordinates.push_back(static_cast<float>(-0.5 * v));
  }
  CheckeredScene checkered(frame, name, 2, host.memory);
  gltf::Scene& scene = checkered.scene;
  scene.positions = places;
  scene.triangles = surface.triangles;
  scene.smooth_normals = true;
  scene.texture_coordinates = coordinates;
  gltf::write(path, scene, host);
}

void write_parameter_obj(const std::filesystem::path& path, const ParameterSurface& surface, const base::Host& host) {
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, 2 * surface.positions.size() + surface.triangles.size(), host);
  for (const Vector3& p : surface.positions) {
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    out.end_item();
  }
  for (const auto& [u, v] : surface.coordinates) {
    out << "vt " << u << ' ' << v << '\n';
    out.end_item();
  }
  for (const mesh::Triangle& t : surface.triangles) {
    out << "f";
    for (const Index v : t)
      out << ' ' << v + 1 << '/' << v + 1;
    out << '\n';
    out.end_item();
  }
  out.flush();
  file.commit();
}

std::size_t write_parameter_page(const std::string& path, const ParameterSurface& surface, const std::string& name,
                                 std::vector<std::pair<std::string, std::string>> figures, Session& session) {
  const base::Host& host = session.host();
  polycube::SurfaceMap map(host.memory);
  map.positions = surface.positions;
  map.polycube = surface.parameters;
  map.triangles = surface.triangles;
  const FaceDistortions faces = face_distortions(map, host);
  PageResult result;
  result.name = name;
  result.positions = surface.positions;
  result.polycube = surface.parameters;
  result.triangles = surface.triangles;
  result.quasi_conformal = faces.quasi_conformal;
  result.area_ratio = faces.area_ratio;
  result.figures = std::move(figures);
  return write_page(path, {&result, 1}, "Parameterization of " + name, session);
}

}  // namespace orbicube::cli
