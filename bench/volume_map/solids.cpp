// Maps of real solids to their polycubes with one setting, as `orbicube volume` makes them: tetrahedra, how many were
// inverted at the start, steps, how often the boundary was fixed, distortion, and seconds of one processor for the
// tetrahedra, the polycube, and the map. With OUT the solids are written there as NAME-source.mesh and NAME-image.mesh.
//
//     bench-solids FOLDER [OUT [solid.obj ...]]
#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/topology/orient.h"
#include "polycube/map/construction.h"
#include "tetrahedra/tetrahedra.h"
#include "volume_map/input/filled_solid.h"
#include "volume_map/solid/boundary_refinement.h"
#include "volume_map/solid/solid_map.h"

using namespace orbicube;
using mesh::Vector3;

namespace {

const std::vector<std::string> solids = {"bunny.ply",       "hand.off",        "rocker-arm.obj",   "fertility.off",
                                         "bumpy-torus.off", "three-torus.off", "double-torus.off", "rod.obj",
                                         "joint.obj",       "hanger.off",      "kitten.ply",       "fandisk.obj",
                                         "b0.obj",          "anchor.off",      "torus.obj",        "block.off"};

double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// |J|^2 / (3 det^(2/3)), 1 for similarities: the mean by volumes.
double distortion(const volume_map::SolidMap& map) {
  double sum = 0, volumes = 0;
  for (const mesh::Tetrahedron& t : map.tetrahedra) {
    Eigen::Matrix3d from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      from.col(static_cast<Eigen::Index>(k)) = map.source[t[k + 1]] - map.source[t[0]];
      to.col(static_cast<Eigen::Index>(k)) = map.image[t[k + 1]] - map.image[t[0]];
    }
    const Eigen::Matrix3d j = to * from.inverse();
    const double root = std::cbrt(j.determinant()), volume = from.determinant();
    sum += volume * j.squaredNorm() / (3 * root * root);
    volumes += volume;
  }
  return sum / volumes;
}

void write(const std::filesystem::path& path, const base::Array<Vector3>& positions,
           const base::Array<mesh::Tetrahedron>& tetrahedra, const base::Host& host) {
  mesh::Mesh cells(host.memory);
  cells.positions = positions;
  cells.tetrahedra = tetrahedra;
  mesh::write_mesh(path, cells, {}, host);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::printf("bench-solids FOLDER [OUT [solid ...]]\n"), 2;
  const std::string out = argc > 2 ? argv[2] : "";
  const std::vector<std::string> names = argc > 3 ? std::vector<std::string>(argv + 3, argv + argc) : solids;
  std::printf("%-14s %8s %8s %6s %5s %10s %7s %8s %8s\n", "solid", "tets", "inverted", "steps", "holds", "distortion",
              "fill s", "polycube", "map s");
  std::size_t mapped = 0;
  for (const std::string& file : names) {
    const std::string name = std::filesystem::path(file).stem().string();
    const double start = now();
    try {
      const base::Host host;
      mesh::Mesh surface = mesh::read_mesh(std::filesystem::path(argv[1]) / file, {}, host);
      mesh::orient(surface.positions, surface.triangles, host);
      const volume_map::FilledSolid filled = volume_map::filled_solid(surface, 6000, tetrahedra::filled_mesh, host);
      const double after_fill = now();
      base::Array<Vector3> outer(host.memory);
      mesh::Index vertices = 0;
      for (const mesh::Triangle& t : filled.surface) {
        for (const mesh::Index v : t)
          vertices = std::max(vertices, v + 1);
      }
      const auto best = polycube::construct(std::span(filled.solid.positions).first(vertices), filled.surface,
                                            {.corners = 100, .preferred_corners = 60}, host);
      const double after_polycube = now();
      const polycube::SurfaceMap& on_surface = best.made.map;
      const auto refined = volume_map::refine_boundary(filled.solid.positions, filled.solid.tetrahedra, filled.surface,
                                                       on_surface, host);
      const auto map =
          volume_map::map_solid(on_surface, on_surface.polycube, refined.positions, refined.tetrahedra, {}, host);
      std::printf("%-14s %8zu %8zu %6zu %5d %10.3f %7.1f %8.1f %8.1f\n", name.c_str(), map.tetrahedra.size(),
                  map.inverted_at_start, map.steps, map.holds, distortion(map), after_fill - start,
                  after_polycube - after_fill, now() - after_polycube);
      ++mapped;
      if (!out.empty()) {
        write(std::filesystem::path(out) / (name + "-source.mesh"), map.source, map.tetrahedra, host);
        write(std::filesystem::path(out) / (name + "-image.mesh"), map.image, map.tetrahedra, host);
      }
    } catch (const base::Error& error) {
      std::printf("%-14s %s: %s (%.1f s)\n", name.c_str(), error.kind(), error.what(), now() - start);
    }
    std::fflush(stdout);
  }
  std::printf("%zu of %zu mapped one to one\n", mapped, names.size());
  return mapped == names.size() ? 0 : 1;
}
