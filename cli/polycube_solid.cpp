#include "polycube_solid.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "any_genus_surface.h"
#include "checked_file.h"
#include "mesh/file.h"
#include "mesh/measures.h"
#include "mesh/write.h"
#include "surface_file.h"
#include "volume_map/coarse_surface.h"
#include "volume_map/solid_boundary.h"
#ifdef ORBICUBE_WITH_TETRAHEDRA
#include "tetrahedra/tetrahedra.h"
#endif

namespace orbicube::cli {
namespace {

void take_tetrahedra(const mesh::Mesh& solid, PolycubeSolidInput& result, Session& session) {
  if (!solid.hexahedra.empty()) throw base::Error("unsupported", "a mesh of hexahedra already");
  volume_map::BoundaryFirst first = volume_map::boundary_first(solid, session.host());
  result.positions = std::move(first.positions);
  result.tetrahedra = std::move(first.tetrahedra);
  result.surface = std::move(first.surface);
}

// So many triangles of a surface are mapped.
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
// Tetrahedra inside no larger than this: about as those beside the surface, but not more than some ten thousand for
// their own sake. Where there are few, maps of the solid find no way.
double largest_volume(const volume_map::CoarseSurface& surface, const base::Host& host) {
  double length = 0;
  for (const mesh::Triangle& t : surface.triangles)
    length += (surface.positions[t[1]] - surface.positions[t[0]]).norm();
  length /= static_cast<double>(surface.triangles.size());
  const double volume = std::abs(mesh::measures(surface.positions, surface.triangles, host).volume);
  return std::max(0.3 * length * length * length, volume / 30000);
}

// Fills the surface, or a coarser one of about so many triangles; a finer one where that meets itself.
void fill(const PolycubeSolidOptions& options, mesh::Mesh&& surface, PolycubeSolidInput& result, Session& session) {
  const base::Host& host = session.host();
  std::size_t target = target_of(options, surface);
  while (true) {
    volume_map::CoarseSurface coarse = volume_map::coarse_surface(surface.positions, surface.triangles, target, host);
    try {
      tetrahedra::Solid solid =
          tetrahedra::fill(coarse.positions, coarse.triangles, {.max_volume = largest_volume(coarse, host)}, host);
      result.positions = std::move(solid.positions);
      result.tetrahedra = std::move(solid.tetrahedra);
      result.surface = std::move(coarse.triangles);
      break;
    } catch (const base::Error&) {
      if (target >= surface.triangles.size()) throw;
      target = std::min(2 * target, surface.triangles.size());
      host.report("decimate", 0, 0);
    }
  }
  if (result.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}
#endif

}  // namespace

void add_polycube_solid_options(CLI::App& verb, PolycubeSolidOptions& options) {
  verb.add_option("IN", options.input, std::string("closed surface, or a mesh of tetrahedra: ") + surface_endings)
      ->required()
      ->type_name("");
  verb.add_option("--corners", options.corners, "corners of the polycube at most; 0: any number (60)")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb.add_option("--triangles", options.triangles,
                  "a surface of more than twice as many is mapped by a coarser one of about so many (6000)")
      ->check(unnamed(CLI::Range(100, 10'000'000)))
      ->type_name("N");
  verb.add_flag("--weld", options.weld, "join vertices at identical positions if the surface is not closed");
}

Json json_of(const PolycubeSolidOptions& options) {
  return {{"corners", options.corners}, {"triangles", options.triangles}, {"weld", options.weld}};
}

PolycubeSolidInput read_polycube_solid(const PolycubeSolidOptions& options, Inside inside, Session& session) {
  const base::Host& host = session.host();
  const auto format = mesh::format_of_path(options.input);
  const double start = session.seconds();
  PolycubeSolidInput result{base::Array<mesh::Vector3>(host.memory), base::Array<mesh::Tetrahedron>(host.memory),
                            base::Array<mesh::Triangle>(host.memory), polycube::Construction(host.memory),
                            mesh::Mesh(host.memory)};
  bool cells = false;
  if (format == mesh::Format::medit || format == mesh::Format::vtk) {
    InputMesh input = read_input(options.input, options.weld, session);
    cells = !input.mesh.tetrahedra.empty() || !input.mesh.hexahedra.empty();
    if (cells) about(options.input, Role::input, [&] { take_tetrahedra(input.mesh, result, session); });
  }
  if (!cells && inside == Inside::nothing) {
    AnyGenusSurface surface = read_any_genus_surface(options.input, options.weld, session);
    session.figures()["input"] = surface.figures;
    about(options.input, Role::input, [&] { take_surface(options, std::move(surface.mesh), result, session); });
  } else if (!cells) {
#ifdef ORBICUBE_WITH_TETRAHEDRA
    AnyGenusSurface surface = read_any_genus_surface(options.input, options.weld, session);
    session.figures()["input"] = surface.figures;
    about(options.input, Role::input, [&] { fill(options, std::move(surface.mesh), result, session); });
#else
    throw Failure(Exit::wrong_input, options.input, "unsupported",
                  "this build has no TetGen to fill a surface; give a mesh of tetrahedra");
#endif
  }
  const double filled = session.seconds();
  about(options.input, Role::input, [&] {
    // The surface's vertices are the first ones; what lies inside is of no interest to the polycube.
    mesh::Index outer = 0;
    for (const mesh::Triangle& t : result.surface) {
      for (const mesh::Index v : t)
        outer = std::max(outer, v + 1);
    }
    polycube::BestConstruction best = polycube::construct(std::span(result.positions).first(outer), result.surface,
                                                          {.corners = options.corners, .seed = session.seed()}, host);
    result.made = std::move(best.made);
  });
  session.figures()["polycube"] = {{"corners", result.made.certificate.corners},
                                   {"patches", result.made.certificate.patches},
                                   {"genus", result.made.certificate.genus},
                                   {"surface_triangles", result.surface.size()},
                                   {"distortion_of_angles", result.made.distortion.angle_mean},
                                   {"distortion_of_areas", result.made.distortion.area_mean}};
  session.figures()["seconds_fill"] = filled - start;
  session.figures()["seconds_polycube"] = session.seconds() - filled;
  return result;
}

void write_cells_exactly(const std::string& path, const mesh::Mesh& cells, bool text, const base::Host& host) {
  about(path, Role::output, [&] {
    CheckedFile file(path);
    mesh::write_mesh(file.path(), cells, {.binary = !text}, host);
    const mesh::Mesh again = mesh::read_mesh(file.path(), {}, host);
    if (again.positions != cells.positions || again.tetrahedra != cells.tetrahedra ||
        again.hexahedra != cells.hexahedra)
      throw base::Error("no-valid-result", "what was written is not what is read again");
    file.commit();
  });
}

void require_cells_writable(const std::string& path) {
  const auto format = mesh::format_of_path(path);
  if (format != mesh::Format::medit && format != mesh::Format::vtk)
    throw Failure(Exit::wrong_input, path, "unsupported-format", "cells are written to .mesh and .vtk");
  require_writable(path);
}

}  // namespace orbicube::cli
