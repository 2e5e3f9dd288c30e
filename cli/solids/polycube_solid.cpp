#include "solids/polycube_solid.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "mesh/files/file.h"
#include "mesh/files/write.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"
#include "report/unit_size.h"
#include "volume_map/meshing/coarse_surface.h"
#include "volume_map/meshing/hex_pieces.h"
#include "volume_map/solid/solid_boundary.h"
#include "volume_map/solid/solid_polycube.h"
#ifdef ORBICUBE_WITH_TETRAHEDRA
#include "solids/filled_solid.h"
#endif

namespace orbicube::cli {
namespace {

void take_tetrahedra(const mesh::Mesh& solid, PolycubeSolidInput& result, Session& session) {
  volume_map::BoundaryFirst first = volume_map::boundary_first(solid, session.host());
  result.positions = std::move(first.positions);
  result.tetrahedra = std::move(first.tetrahedra);
  result.surface = std::move(first.surface);
}

// Triangle count of the mapped surface.
std::size_t target_of(const PolycubeSolidOptions& options, const mesh::Mesh& surface) {
  return surface.triangles.size() > 2 * options.triangles ? options.triangles : surface.triangles.size();
}

void take_surface(const PolycubeSolidOptions& options, mesh::Mesh&& surface, PolycubeSolidInput& result,
                  Session& session) {
  volume_map::CoarseSurface coarse =
      volume_map::coarse_surface(surface.positions, surface.triangles, target_of(options, surface), session.host());
  result.positions = std::move(coarse.positions);
  result.surface = std::move(coarse.triangles);
  if (result.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}

#ifdef ORBICUBE_WITH_TETRAHEDRA
void fill(const PolycubeSolidOptions& options, mesh::Mesh&& surface, PolycubeSolidInput& result, Session& session) {
  FilledSolid filled = [&] {
    try {
      return filled_solid(surface, options.triangles, session.host());
    } catch (const base::Error& error) {
      if (std::string_view(error.kind()) == "self-intersection")
        volume_map::refuse_self_intersections(surface.positions, surface.triangles, 0, session.host());
      throw;
    }
  }();
  result.positions = std::move(filled.solid.positions);
  result.tetrahedra = std::move(filled.solid.tetrahedra);
  result.surface = std::move(filled.surface);
  if (result.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}
#endif

void make_polycube(const PolycubeSolidOptions& options, Polycubes polycubes, PolycubeSolidInput& result,
                   Session& session) {
  const base::Host& host = session.host();
  // The surface's vertices are the first ones; what lies inside is of no interest to the polycube.
  mesh::Index outer = 0;
  for (const mesh::Triangle& t : result.surface) {
    for (const mesh::Index v : t)
      outer = std::max(outer, v + 1);
  }
  const std::span<const mesh::Vector3> positions = std::span(result.positions).first(outer);
  try {
    if (polycubes != Polycubes::none) {
      result.made = volume_map::construct_polycube(
          positions, result.surface, {.corners = options.corners, .preferred_corners = 60, .seed = session.seed()},
          host);
      return;
    }
  } catch (const base::Error& error) {
    if (polycubes == Polycubes::needed || error.status() != base::Status::no_valid_result) throw;
    session.note("there is no polycube: " + std::string(error.what()));
  }
  if (!result.fine.triangles.empty()) return;
  result.fine.positions.assign(positions.begin(), positions.end());
  result.fine.triangles.assign(result.surface.begin(), result.surface.end());
}

volume_map::Pieces cell_pieces(const mesh::Mesh& solid, const base::Host& host) {
  if (!solid.hexahedra.empty()) throw base::Error("unsupported", "a mesh of hexahedra already");
  return volume_map::pieces_of(solid.tetrahedra, solid.positions.size(), host);
}

// Solids are on the inner side of their outer walls and on the outer side of the walls of cavities.
void turn_parts(const volume_map::SurfacePieces& pieces, std::span<mesh::Triangle> triangles, Session& session) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (pieces.wrong_side[i] == 0) continue;
    std::swap(triangles[i][1], triangles[i][2]);
    ++turned;
  }
  if (turned > 0) session.note(std::to_string(turned) + " triangles of parts that looked into the solid were turned");
}

// The solid and the polycube of one piece. `power`: see volume_map::size_exponent.
PolycubeSolidInput read_piece(const PolycubeSolidOptions& options, Inside inside, Polycubes polycubes, mesh::Mesh part,
                              int power, Session& session) {
  const base::Host& host = session.host();
  PolycubeSolidInput result{base::Array<mesh::Vector3>(host.memory), base::Array<mesh::Tetrahedron>(host.memory),
                            base::Array<mesh::Triangle>(host.memory), polycube::Construction(host.memory),
                            mesh::Mesh(host.memory)};
  const auto enter_working_space = [&](std::span<mesh::Vector3> positions, std::span<const mesh::Triangle> surface) {
    if (inside == Inside::tetrahedra) return;
    result.space = volume_map::WorkingSpace(positions, surface, power);
    result.space.take(positions);
  };
  const bool cells = !part.tetrahedra.empty() || !part.hexahedra.empty();
  if (!cells) enter_working_space(part.positions, part.triangles);
  if (cells) {
    take_tetrahedra(part, result, session);
    enter_working_space(result.positions, result.surface);
  } else if (polycubes == Polycubes::none) {
    result.fine = std::move(part);
  } else if (inside == Inside::nothing) {
    take_surface(options, std::move(part), result, session);
  } else {
#ifdef ORBICUBE_WITH_TETRAHEDRA
    fill(options, std::move(part), result, session);
#endif
  }
  return result;
}

// Of the polycubes of all pieces, if all have one.
void add_polycube_figures(const std::vector<PolycubeSolidInput>& results, Session& session) {
  std::size_t corners = 0, patches = 0, triangles = 0;
  std::int64_t genus = 0;
  double angles = 0, areas = 0;
  bool all = true;
  for (const PolycubeSolidInput& result : results) {
    all = all && !result.made.map.triangles.empty();
    corners += result.made.certificate.corners;
    patches += result.made.certificate.patch_count;
    genus += result.made.certificate.genus;
    triangles += result.surface.size();
    angles += result.made.distortion.angle_mean / static_cast<double>(results.size());
    areas += result.made.distortion.area_mean / static_cast<double>(results.size());
  }
  if (all) {
    session.figures()["polycube"] = {{"corners", corners},
                                     {"patches", patches},
                                     {"genus", genus},
                                     {"surface_triangles", triangles},
                                     {"distortion_of_angles", angles},
                                     {"distortion_of_areas", areas}};
  }
}

}  // namespace

void add_polycube_solid_options(CLI::App& verb, PolycubeSolidOptions& options) {
  verb.add_option("IN", options.input, std::string("closed surface, or a tetrahedral mesh: ") + surface_endings)
      ->required()
      ->type_name("");
  verb.add_option("--corners", options.corners,
                  "maximum number of polycube corners per boundary component; 0: no limit [default: 100]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb.add_option(
          "--triangles", options.triangles,
          "a surface of more than twice as many triangles is mapped through a coarser one of about N [default: 6000]")
      ->check(unnamed(CLI::Range(100, 10'000'000)))
      ->type_name("N");
  verb.add_flag("--weld", options.weld, "weld vertices at identical positions if the surface is not closed");
}

Json json_of(const PolycubeSolidOptions& options) {
  return {{"corners", options.corners}, {"triangles", options.triangles}, {"weld", options.weld}};
}

volume_map::SurfacePieces pieces_of_surface(InputMesh& input, Inside inside, std::size_t max_pieces, Session& session) {
  constexpr double few = 0.05;
  const base::Host& host = session.host();
  mesh::Mesh& surface = input.mesh;
  volume_map::require_closed_surface(surface.positions, surface.triangles, host);
  const mesh::OrientReport turned = mesh::orient(surface.positions, surface.triangles, host);
  if (turned.triangles_turned > 0)
    session.note(std::to_string(turned.triangles_turned) + " triangles were turned to agree with their neighbors");
  if (turned.turned_outward) session.note("the surface looked inward; all triangles were turned");
  const volume_map::SurfacePieces pieces = volume_map::surface_pieces(surface.positions, surface.triangles, host);
  if (max_pieces > 0) volume_map::require_cells_for_pieces(pieces.count, max_pieces);
  turn_parts(pieces, surface.triangles, session);
  if (inside == Inside::nothing || pieces.count + pieces.cavities > 1) {
    const std::size_t pairs = volume_map::refuse_self_intersections(surface.positions, surface.triangles, few, host);
    if (pairs > 0) session.note(std::to_string(pairs) + " pairs of triangles meet where they should not");
  }
  session.figures()["input"] = {{"format", input.report.format},
                                {"vertices", surface.positions.size()},
                                {"triangles", surface.triangles.size()},
                                {"genus", mesh::topology(surface.positions, surface.triangles, host).genus.value_or(0)},
                                {"cavities", pieces.cavities}};
  return pieces;
}

std::vector<PolycubeSolidInput> read_polycube_solid(const PolycubeSolidOptions& options, Inside inside,
                                                    Polycubes polycubes, Session& session) {
  const base::Host& host = session.host();
  const double start = session.seconds();
  InputMesh input = session.portion(0.03, [&] { return read_input(options.input, options.weld, session); });
  const int exponent = bring_to_unit_size(input.mesh);
  const bool cells = !input.mesh.tetrahedra.empty() || !input.mesh.hexahedra.empty();
#ifndef ORBICUBE_WITH_TETRAHEDRA
  if (!cells && inside == Inside::tetrahedra)
    throw Failure(Exit::wrong_input, options.input, "unsupported",
                  "this build has no TetGen to fill a surface; give a mesh of tetrahedra");
#endif
  std::vector<PolycubeSolidInput> results;
  double filling = 0;
  about(options.input, Role::input, [&] {
    const volume_map::Pieces pieces =
        cells ? cell_pieces(input.mesh, host) : pieces_of_surface(input, inside, options.max_pieces, session);
    if (cells && options.max_pieces > 0) volume_map::require_cells_for_pieces(pieces.count, options.max_pieces);
    std::optional<volume_map::PieceCutter> cutter;
    if (pieces.count > 1) cutter.emplace(input.mesh, pieces, host);
    const int power = volume_map::size_exponent(input.mesh.positions);
    for (std::size_t i = 0; i < pieces.count; ++i) {
      const base::Stage stage(host, 1.0 / static_cast<double>(pieces.count - i));
      const double before = session.seconds();
      mesh::Mesh part = cutter ? cutter->piece(i) : std::move(input.mesh);
      PolycubeSolidInput result = read_piece(options, inside, polycubes, std::move(part), power, session);
      filling += session.seconds() - before;
      make_polycube(options, polycubes, result, session);
      result.exponent = exponent;
      results.push_back(std::move(result));
    }
  });
  add_polycube_figures(results, session);
  if (results.size() > 1) session.figures()["pieces"] = results.size();
  session.figures()["seconds_fill"] = filling;
  session.figures()["seconds_polycube"] = session.seconds() - start - filling;
  return results;
}

void write_cells_exactly(const std::string& path, const mesh::Mesh& cells, bool text, Session& session) {
  const base::Host& host = session.host();
  about(path, Role::output, [&] {
    const std::filesystem::path file = session.stage(path);
    mesh::write_mesh(file, cells, {.binary = !text}, host);
    const mesh::Mesh again = mesh::read_mesh(file, {}, host);
    if (again.positions != cells.positions || again.tetrahedra != cells.tetrahedra ||
        again.hexahedra != cells.hexahedra)
      throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  });
}

}  // namespace orbicube::cli
