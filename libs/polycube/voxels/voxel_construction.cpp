#include "polycube/voxels/voxel_construction.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/topology.h"
#include "polycube/layout/layout_map.h"
#include "polycube/surface/range_text.h"
#include "polycube/voxels/simplification.h"

namespace orbicube::polycube {
namespace {

// Corners when there is no budget: what follows a shape's parts and leaves each room.
constexpr std::size_t plenty = 100;

class VoxelConstruction {
 public:
  VoxelConstruction(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                    const VoxelConstructionOptions& options, const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        options_(options),
        host_(host),
        genus_(genus_of(positions, triangles, host)),
        occupancy_(positions, triangles, occupancy_resolution, host),
        made_(host.memory) {}

  Construction run() {
    for (made_.grid = options_.first_grid; made_.grid < voxel_grids.size(); ++made_.grid) {
      if (try_grid(voxel_grids[made_.grid])) return std::move(made_);
    }
    std::string reasons;
    for (const Failure& failure : failures_)
      reasons += (reasons.empty() ? "" : "; ") + failure.reason +
                 (failure.most > 0 ? " (" + range_text(failure.fewest, failure.most) + " corners)" : std::string());
    throw base::Error("no-valid-result",
                      "no polycube of " + std::to_string(made_.tried) + " has a valid map: " + reasons);
  }

 private:
  // One reason, and how many corners the polycubes that met it had.
  struct Failure {
    std::string reason;
    std::size_t fewest = 0, most = 0;
  };

  static std::int64_t genus_of(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                               const base::Host& host) {
    const auto topology = mesh::topology(positions, triangles, host);
    mesh::require_closed_manifold(topology);
    if (!topology.genus) throw base::Error("not-connected", "a polycube map needs one closed, oriented surface");
    return *topology.genus;
  }

  bool try_grid(int min_cells) {
    if (made_.tried >= options_.max_polycubes) return false;
    VoxelisationOptions grid;
    grid.min_cells = min_cells;
    try {
      const Voxelisation voxels = voxelise(positions_, triangles_, genus_, occupancy_, grid, host_);
      Simplification simplification(voxels, host_);
      std::size_t last = 0;
      // Down to two thirds each time, and to the fewest possible.
      for (std::size_t target = options_.corners > 0 ? options_.corners : plenty; target > 0;
           target = target < 8 ? 0 : 2 * target / 3) {
        simplification.reduce(target);
        if (simplification.corners() == last) continue;
        last = simplification.corners();
        if (made_.tried >= options_.max_polycubes) break;
        if (try_polycube(simplification.solid(), last)) return true;
      }
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      fail(error.what(), 0);
    }
    return false;
  }

  bool try_polycube(const VoxelSolid& solid, std::size_t corners) {
    ++made_.tried;
    try {
      const Layout layout = make_layout(solid, host_);
      EditableSurface surface(positions_, triangles_, host_);
      Drawing drawing = trace(layout, surface, host_);
      made_.map = map_layout(layout, surface, drawing, {}, host_);
      made_.certificate = certify(made_.map, host_);
      if (!made_.certificate.valid()) throw base::Error("no-valid-result", made_.certificate.reason);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      fail(error.what(), corners);
      return false;
    }
    made_.distortion = measure_distortion(made_.map, host_);
    ++made_.valid;
    return true;
  }

  void fail(const std::string& reason, std::size_t corners) {
    host_.log(base::counted(corners, "corner") + ": " + reason);
    auto same = std::find_if(failures_.begin(), failures_.end(), [&](const Failure& f) { return f.reason == reason; });
    if (same == failures_.end()) same = failures_.insert(failures_.end(), {reason, corners, corners});
    if (corners == 0) return;
    same->fewest = same->fewest == 0 ? corners : std::min(same->fewest, corners);
    same->most = std::max(same->most, corners);
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const VoxelConstructionOptions& options_;
  const base::Host& host_;
  std::int64_t genus_;
  Occupancy occupancy_;
  Construction made_;
  std::vector<Failure> failures_;
};

}  // namespace

Construction construct_by_voxels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const VoxelConstructionOptions& options, const base::Host& host) {
  return VoxelConstruction(positions, triangles, options, host).run();
}

}  // namespace orbicube::polycube
