#include "polycube/construction.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/topology.h"
#include "polycube/map_improvement.h"
#include "polycube/voxel_construction.h"

namespace orbicube::polycube {
namespace {

constexpr std::size_t fewest_corners = 8;  // of any polycube

// Sums of both means; 2 is an isometry. Maps as little distorted as that are not compared with others.
constexpr double good_enough = 2.2;
// Nor are further grids tried where one made a map that is no worse than that: each takes as long as the first.
constexpr double fair = 3;
// Fewer corners win among maps that differ by less than this part.
constexpr double about_equal = 0.02;

// The polycubes of voxels that may be drawn and mapped, which takes time in proportion to the triangles: many for
// small surfaces, a few for large ones.
std::size_t most_voxel_polycubes(std::size_t triangles) {
  constexpr std::size_t work = 600'000, least = 4, most = 24;
  return std::clamp(work / std::max<std::size_t>(triangles, 1), least, most);
}

// Those that are improved and compared, where none is good enough.
std::size_t most_voxel_maps(std::size_t triangles) {
  constexpr std::size_t work = 60'000, least = 1, most = 3;
  return std::clamp(work / std::max<std::size_t>(triangles, 1), least, most);
}

// Means over faces: each triangle is to be of use, small ones too.
double score(const Distortion& d) {
  return d.angle_mean + d.area_mean;
}

bool better(const Construction& a, const Construction& b) {
  const double x = score(a.distortion), y = score(b.distortion);
  if (std::abs(x - y) <= about_equal * std::min(x, y) && a.certificate.corners != b.certificate.corners)
    return a.certificate.corners < b.certificate.corners;
  return x < y;
}

class BestOfAll {
 public:
  BestOfAll(std::span<const Vector3> positions, std::span<const Triangle> triangles, const ConstructionOptions& options,
            const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        options_(options),
        host_(host),
        budget_(budget()),
        best_{Construction(host.memory), Method::automatic} {}

  BestConstruction run() {
    if (options_.method != Method::voxels) {
      attempt(Method::labels, "by labels", [&] {
        return construct_by_labels(
            positions_, triangles_,
            {.corners = budget_, .preferred_corners = options_.preferred_corners, .seed = options_.seed}, host_);
      });
    }
    if (options_.method != Method::labels) try_voxels();
    if (!found()) throw base::Error("no-valid-result", reasons_);
    best_.made.tried = tried_;
    best_.made.valid = valid_;
    return std::move(best_);
  }

 private:
  void try_voxels() {
    const std::size_t most = most_voxel_maps(triangles_.size());
    std::size_t grid = 0;
    for (std::size_t i = 0; i < most && grid < voxel_grids.size() && !reaches(i == 0 ? good_enough : fair); ++i) {
      const bool made = attempt(Method::voxels, "by voxels", [&] {
        Construction one = construct_by_voxels(
            positions_, triangles_,
            {.corners = budget_, .most_polycubes = most_voxel_polycubes(triangles_.size()), .first_grid = grid}, host_);
        grid = one.grid + 1;
        return one;
      });
      if (!made) return;
    }
  }

  bool reaches(double sum) const { return found() && score(best_.made.distortion) <= sum; }
  bool found() const { return best_.method != Method::automatic; }

  // Also says whether there can be a polycube map at all.
  std::size_t budget() const {
    const auto facts = mesh::topology(positions_, triangles_, host_);
    mesh::require_closed_manifold(facts);
    if (!facts.genus) throw base::Error("not-connected", "a polycube map needs one closed, oriented surface");
    if (options_.corners == 0) return 0;
    if (options_.corners < fewest_corners) throw base::Error("no-valid-result", "a polycube has 8 corners at least");
    return std::max(options_.corners, fewest_corners * (1 + static_cast<std::size_t>(*facts.genus)));
  }

  // Whether there was a valid map.
  template <class Construct>
  bool attempt(Method method, const std::string& name, const Construct& make) {
    const auto fail = [&](const std::string& reason) {
      reasons_ += (reasons_.empty() ? "" : "; ") + name + ": " + reason;
      host_.log(name + ": " + reason);
      return false;
    };
    try {
      Construction made = make();
      tried_ += made.tried;
      valid_ += made.valid;
      if (budget_ > 0 && made.certificate.corners > budget_)
        return fail("no fewer than " + std::to_string(made.certificate.corners) + " corners");
      made.distortion = improve_map(made.map, made.certificate, {}, host_);
      const Distortion& d = made.distortion;
      host_.log(name + ": " + std::to_string(made.certificate.corners) + " corners, angle " +
                std::to_string(d.angle_mean) + ", area " + std::to_string(d.area_mean));
      if (found() && !better(made, best_.made)) return true;
      best_.made = std::move(made);
      best_.method = method;
      return true;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      return fail(error.what());
    }
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const ConstructionOptions& options_;
  const base::Host& host_;
  std::size_t budget_;
  BestConstruction best_;
  std::size_t tried_ = 0, valid_ = 0;
  std::string reasons_;
};

}  // namespace

BestConstruction construct(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const ConstructionOptions& options, const base::Host& host) {
  return BestOfAll(positions, triangles, options, host).run();
}

}  // namespace orbicube::polycube
