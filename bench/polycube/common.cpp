#include "common.h"

#include <cstdio>
#include <filesystem>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "bench/measuring.h"
#include "mesh/files/read.h"
#include "mesh/topology/orient.h"
#include "polycube/domain/common_polycube.h"
#include "polycube/outputs/quad_mesh.h"

namespace orbicube::bench {

using namespace orbicube::polycube;

void compare_common(std::span<const std::string> files, std::size_t corners, const base::Host& host) {
  std::vector<mesh::Mesh> meshes;
  std::vector<SurfaceSpan> shapes;
  for (const std::string& file : files) {
    meshes.push_back(mesh::read_mesh(file, {}, host));
    mesh::orient(meshes.back().positions, meshes.back().triangles, host);
  }
  for (const mesh::Mesh& m : meshes)
    shapes.push_back({m.positions, m.triangles});
  const double start = cpu_seconds();
  try {
    CommonPolycubeOptions options;
    options.construction.corners = corners;
    const CommonPolycube common = construct_common(shapes, options, host);
    const double seconds = cpu_seconds() - start;
    std::printf("%-18s %9s %9s %9s %9s\n", "shape", "own", "common", "angle", "area");
    double own = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
      own += common.own_energies[i];
      std::printf("%-18s %9.4f %9.4f %9.3f %9.3f%s\n", std::filesystem::path(files[i]).stem().string().c_str(),
                  common.own_energies[i], energy_of(common.maps[i], {}, host), common.distortions[i].angle_mean,
                  common.distortions[i].area_mean, i == common.base ? "  (made for this one)" : "");
    }
    std::printf("%-18s %9.4f %9.4f, %.1f %% more; %zu corners, %.1f s\n", "sum", own, common.energies.back(),
                100 * (common.energies.back() / own - 1), common.graph.corners.size(), seconds);
    // The same points of the polycube on each: the maps are one to one, so their composition is.
    const PolycubeGrid grid = make_grid(common.graph, {.quads = 20000}, host);
    for (std::size_t i = 0; i < files.size(); ++i) {
      QuadMesh quads = mesh_grid(common.graph, grid, host);
      sample_grid(common.maps[i], quads, host);
      const QuadQuality quality = measure_quads(quads.positions, quads.quads, host);
      std::printf("  %zu quads, scaled Jacobian %.3f on average, %zu not convex\n", quads.quads.size(),
                  quality.mean_scaled_jacobian, quality.not_convex);
    }
  } catch (const base::Error& error) {
    std::printf("%s after %.1f s: %s\n", error.kind(), cpu_seconds() - start, error.what());
  }
}

}  // namespace orbicube::bench
