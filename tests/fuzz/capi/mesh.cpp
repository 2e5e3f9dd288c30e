// Meshes: bytes of files in every format, cells of any kind, topology, orientation, searches, exact signs.
#include <algorithm>

#include "scratch.h"
#include "shapes.h"

using namespace fuzz;

namespace {

void look_at(obc_mesh* mesh, Input& in, Host& host) {
  const std::size_t vertices = obc_mesh_vertex_count(mesh);
  std::vector<double> positions(3 * vertices);
  std::vector<std::uint32_t> triangles(3 * obc_mesh_triangle_count(mesh)),
      tetrahedra(4 * obc_mesh_tetrahedron_count(mesh)), hexahedra(8 * obc_mesh_hexahedron_count(mesh));
  require(ok([&](obc_error* e) {
            return obc_mesh_copy(mesh, positions.data(), triangles.data(), tetrahedra.data(), hexahedra.data(), e);
          }),
          "a mesh cannot be copied");
  require_finite(positions, "a position that is not finite");
  for (const auto* cells : {&triangles, &tetrahedra, &hexahedra})
    require_below(*cells, vertices, "a cell with a vertex that does not exist");
  require(obc_mesh_format(mesh) != nullptr && obc_mesh_note(mesh, SIZE_MAX) == nullptr,
          "no format, or a note too many");
  ok([&](obc_error* e) { return obc_mesh_check_cells(mesh, host.c(), e); });
  obc_mesh_tetrahedron_quality_report quality;
  obc_mesh_tetrahedron_quality_report_init(&quality, sizeof quality);
  ok([&](obc_error* e) { return obc_mesh_tetrahedron_quality(mesh, host.c(), &quality, e); });
  obc_mesh* boundary = nullptr;
  if (ok([&](obc_error* e) { return obc_mesh_boundary(mesh, host.c(), &boundary, e); })) {
    require(obc_mesh_vertex_count(boundary) == vertices, "a boundary with other vertices");
    obc_mesh_destroy(boundary);
  }
  if (in.one_in(16)) {
    static constexpr const char* endings[] = {".obj", ".off", ".ply", ".stl", ".mesh", ".vtk"};
    const Scratch file(endings[in.below(6)]);
    obc_mesh_write_options options;
    obc_mesh_write_options_init(&options, sizeof options);
    options.binary = in.choice(2);
    if (ok([&](obc_error* e) { return obc_mesh_write(file.path(), mesh, &options, host.c(), e); })) {
      obc_mesh* again = nullptr;
      if (ok([&](obc_error* e) { return obc_mesh_read(file.path(), nullptr, host.c(), &again, e); }))
        obc_mesh_destroy(again);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  obc_mesh* mesh = nullptr;

  const Shape shape = surface(in), body = solid(in);
  obc_mesh_cells cells;
  obc_mesh_cells_init(&cells, sizeof cells);
  const bool first = in.one_in(2);
  cells.positions = first ? shape.positions.data() : body.positions.data();
  cells.vertex_count = first ? shape.vertex_count() : body.vertex_count();
  const auto corners = in.indices(8 * in.below(3), cells.vertex_count);
  if (first) {
    cells.triangles = shape.cells.data();
    cells.triangle_count = shape.cell_count();
  } else {
    cells.tetrahedra = body.cells.data();
    cells.tetrahedron_count = body.cell_count();
  }
  cells.hexahedra = corners.data();
  cells.hexahedron_count = corners.size() / 8;
  if (ok([&](obc_error* e) { return obc_mesh_create(&cells, host.c(), &mesh, e); })) {
    look_at(mesh, in, host);
    obc_mesh_destroy(mesh);
  }

  const obc_surface given = shape.surface();
  obc_mesh_topology_report topology;
  obc_mesh_topology_report_init(&topology, sizeof topology);
  ok([&](obc_error* e) { return obc_mesh_topology(&given, host.c(), &topology, e); });
  ok([&](obc_error* e) { return obc_mesh_check_closed_genus_zero(&given, host.c(), e); });
  auto turned = shape.cells;
  obc_mesh_orient_report oriented;
  obc_mesh_orient_report_init(&oriented, sizeof oriented);
  ok([&](obc_error* e) {
    return obc_mesh_orient(shape.positions.data(), shape.vertex_count(), turned.data(), shape.cell_count(), host.c(),
                           &oriented, e);
  });
  std::vector<std::uint32_t> vertices(shape.vertex_count());
  if (ok([&](obc_error* e) {
        return obc_mesh_first_at_same_position(shape.positions.data(), shape.vertex_count(), host.c(), vertices.data(),
                                               e);
      })) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      require(vertices[i] <= i, "not the first at a position");
  }
  std::uint32_t pairs[10];
  std::size_t count = 0;
  if (ok([&](obc_error* e) { return obc_mesh_intersections(&given, host.c(), pairs, 5, &count, e); }))
    require(count <= 5, "more pairs than there is room for");
  std::vector<double> normals(3 * shape.vertex_count()), areas(shape.vertex_count());
  if (ok([&](obc_error* e) { return obc_mesh_vertex_normals(&given, host.c(), normals.data(), e); }))
    require_finite(normals, "a normal that is not finite");
  if (ok([&](obc_error* e) { return obc_mesh_vertex_areas(&given, host.c(), areas.data(), e); }))
    require(std::all_of(areas.begin(), areas.end(), [](double area) { return area >= 0; }), "an area below zero");
  obc_mesh_distance distance;
  obc_mesh_distance_init(&distance, sizeof distance);
  ok([&](obc_error* e) { return obc_mesh_surface_distance(&given, &given, host.c(), &distance, e); });
  const auto cloud = in.numbers(9);
  double mean = 0;
  if (ok([&](obc_error* e) {
        return obc_mesh_mean_distance(shape.positions.data(), shape.vertex_count(), cloud.data(), 3, host.c(), &mean,
                                      e);
      }))
    require(mean >= 0, "a distance below zero");
  obc_mesh_search* search = nullptr;
  if (ok([&](obc_error* e) { return obc_mesh_search_create(&given, host.c(), &search, e); })) {
    const auto points = in.numbers(9);
    std::uint32_t at[3], triangles[3];
    double weights[9], places[9], distances[3];
    if (ok([&](obc_error* e) { return obc_mesh_search_vertices(search, points.data(), 3, at, e); }))
      require_below(at, shape.vertex_count(), "a nearest vertex that does not exist");
    if (ok([&](obc_error* e) {
          return obc_mesh_search_surface(search, points.data(), 3, triangles, weights, places, distances, e);
        }))
      require_below(triangles, shape.cell_count(), "a nearest triangle that does not exist");
    obc_mesh_search_destroy(search);
  }
  const auto x = in.numbers(12);
  for (const std::int32_t sign :
       {obc_mesh_orientation_2d(&x[0], &x[2], &x[4]), obc_mesh_orientation_3d(&x[0], &x[3], &x[6], &x[9]),
        obc_mesh_orientation_from_origin(&x[0], &x[3], &x[6])})
    require(sign >= -1 && sign <= 2, "no sign");

  obc_mesh_read_options options;
  obc_mesh_read_options_init(&options, sizeof options);
  options.weld_identical = in.choice(2);
  const std::int32_t format = in.choice(6);
  static constexpr const char* heads[] = {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                          "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                                          "ply\nformat ascii 1.0\nelement vertex 3\n",
                                          "solid a\nfacet normal 0 0 1\nouter loop\n",
                                          "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n",
                                          "# vtk DataFile Version 3.0\na\nASCII\n"};
  std::vector<std::uint8_t> bytes;
  if (format >= 0 && format < 6 && in.one_in(2)) {
    for (const char* c = heads[format]; *c != '\0'; ++c)
      bytes.push_back(in.one_in(40) ? in.byte() : static_cast<std::uint8_t>(*c));
  }
  bytes.insert(bytes.end(), in.rest().begin(), in.rest().end());
  if (ok([&](obc_error* e) {
        return obc_mesh_read_memory(bytes.data(), bytes.size(), format, &options, host.c(), &mesh, e);
      })) {
    look_at(mesh, in, host);
    obc_mesh_destroy(mesh);
  }
  return 0;
}
