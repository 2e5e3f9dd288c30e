#include "view_page/viewed_file.h"

#include <cstdio>
#include <string>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "frame_field/frames_file.h"
#include "frame_field/singularities/singularities.h"
#include "gltf/reading/read.h"
#include "gltf/reading/target_names.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/topology.h"

namespace orbicube::cli {
namespace {

constexpr std::size_t max_targets = 8;

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void add_figures(const mesh::Mesh& mesh, const std::string& format, const base::Host& host, ViewItem& item) {
  auto& figures = item.figures;
  const auto count = [&](const char* name, std::size_t n) {
    if (n > 0) figures.emplace_back(name, std::to_string(n));
  };
  const bool cells = !mesh.tetrahedra.empty() || !mesh.hexahedra.empty();
  count("Vertices", mesh.positions.size());
  if (!cells) count("Triangles", mesh.triangles.size());
  count("Tetrahedra", mesh.tetrahedra.size());
  count("Hexahedra", mesh.hexahedra.size());
  if (!cells) {
    const mesh::Topology t = mesh::topology(mesh.positions, mesh.triangles, host);
    figures.emplace_back("Connected parts", std::to_string(t.components));
    figures.emplace_back("Closed", t.closed() ? "yes" : "no: " + base::counted(t.boundary_loops, "boundary loop"));
    figures.emplace_back("Manifold", t.manifold() ? "yes" : "no");
    figures.emplace_back("Genus", t.genus ? std::to_string(*t.genus) : "none");
    figures.emplace_back("Area (unit of the file, squared)", digits(t.area));
    if (t.closed() && t.manifold() && t.inconsistent_edges == 0)
      figures.emplace_back("Volume (unit of the file, cubed)", digits(t.volume));
  }
  figures.emplace_back("Format", format);
}

// Morph targets with the vertices and triangles of the shape.
void add_targets(const std::filesystem::path& path, Session& session, ViewedFile& file) {
  std::vector<std::string> names = gltf::target_names(path, session.host());
  if (names.size() > max_targets) {
    session.note(base::counted(names.size() - max_targets, "morph target") + " of " + path.filename().string() +
                 " left out");
    names.resize(max_targets);
  }
  const auto read_all = [&](bool weld) {
    file.targets.clear();
    file.mesh = gltf::read(path, {.weld_identical = weld, .morph_target = {}}, session.host());
    for (const std::string& name : names) {
      file.targets.push_back(gltf::read(path, {.weld_identical = weld, .morph_target = name}, session.host()));
      if (file.targets.back().triangles != file.mesh.triangles) return false;
    }
    return true;
  };
  // Vertices along seams are welded, so that normals are smooth, unless a map tears them apart.
  if (!names.empty() && !read_all(true) && !read_all(false)) return;
  for (std::size_t i = 0; i < file.targets.size(); ++i)
    file.item.targets.emplace_back(names[i], file.targets[i].positions);
}

}  // namespace

bool is_frames(const std::filesystem::path& path) {
  return path.extension() == ".frames";
}

void read_viewed(const std::filesystem::path& path, bool weld, Session& session, ViewedFile& file) {
  InputMesh input = read_input(path, weld, session);
  file.mesh = std::move(input.mesh);
  file.item.name = path.filename().string();
  file.item.mesh = &file.mesh;
  about(path, Role::input, [&] {
    if (is_gltf(path)) add_targets(path, session, file);
    add_figures(file.mesh, input.report.format, session.host(), file.item);
  });
}

void add_field(const std::filesystem::path& path, Session& session, ViewedFile& file) {
  about(path, Role::input, [&] {
    const base::Host& host = session.host();
    const mesh::Mesh& solid = file.mesh;
    if (solid.tetrahedra.empty() || !solid.hexahedra.empty())
      throw base::Error("no-cells", "a frame field follows its mesh of tetrahedra, and " + file.item.name + " is none");
    mesh::require_valid_cells(solid, host);
    const frame_field::Field field = frame_field::read_frames(path, solid.tetrahedra.size(), host);
    const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
    const auto matchings = frame_field::matchings(connectivity, field, host);
    const auto graph = frame_field::singular_graph(solid.positions, connectivity, field, matchings, host);
    file.item.curves = {{"around which cells meet in threes", {}}, {"in fives", {}}, {"other singular edges", {}}};
    for (const frame_field::SingularEdge& edge : graph.edges)
      file.item.curves[edge.turn == 1    ? 0
                       : edge.turn == -1 ? 1
                                         : 2]
          .edges.push_back({edge.vertices[0], edge.vertices[1]});
    file.item.name += ", " + path.filename().string();
    file.item.figures.emplace_back("Singular curves", std::to_string(graph.curves()));
    file.item.figures.emplace_back("Singular nodes", std::to_string(graph.nodes.size()));
  });
}

}  // namespace orbicube::cli
