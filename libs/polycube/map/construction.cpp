#include "polycube/map/construction.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/place_text.h"
#include "mesh/topology/topology.h"
#include "polycube/unfolded/map_improvement.h"
#include "polycube/voxels/voxel_construction.h"

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
std::size_t max_voxel_polycubes(std::size_t triangles) {
  constexpr std::size_t work = 600'000, least = 4, most = 24;
  return std::clamp(work / std::max<std::size_t>(triangles, 1), least, most);
}

// Those that are improved and compared, where none is good enough.
std::size_t max_voxel_maps(std::size_t triangles) {
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
        best_{Construction(host.memory), Method::automatic, std::nullopt} {}

  BestConstruction run() {
    if (options_.method == Method::dissertation) return as_printed();
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
  BestConstruction as_printed() const {
    dissertation::Printed printed = dissertation::construct_as_printed(
        positions_, triangles_,
        {.corner_points = budget_, .area_weight = options_.area_weight, .max_rounds = options_.rounds}, host_);
    return {std::move(printed.made), Method::dissertation, std::move(printed.report)};
  }

  void try_voxels() {
    const std::size_t most = max_voxel_maps(triangles_.size());
    std::size_t grid = 0;
    for (std::size_t i = 0; i < most && grid < voxel_grids.size() && !reaches(i == 0 ? good_enough : fair); ++i) {
      const bool made = attempt(Method::voxels, "grid-based", [&] {
        Construction one = construct_by_voxels(
            positions_, triangles_,
            {.corners = budget_, .max_polycubes = max_voxel_polycubes(triangles_.size()), .first_grid = grid}, host_);
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
    if (options_.corners < fewest_corners) throw base::Error("no-valid-result", "a polycube has at least 8 corners");
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
    const base::Stage all(host_, 0.5);
    try {
      Construction made = [&] {
        const base::Stage stage(host_, 0.8);
        return make();
      }();
      tried_ += made.tried;
      valid_ += made.valid;
      if (budget_ > 0 && made.certificate.corners > budget_)
        return fail("no fewer than " + base::counted(made.certificate.corners, "corner"));
      made.distortion = improve_map(made.map, made.certificate, {}, host_);
      const Distortion& d = made.distortion;
      host_.log(name + ": " + base::counted(made.certificate.corners, "corner") + ", angle " +
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

// Takes vertices in no triangle out. number: of each vertex that is kept, its number before.
void keep_used(std::span<const std::uint8_t> used, Array<Vector3>& positions, Array<Triangle>& triangles,
               Array<Index>& number) {
  Array<Index> place(used.size(), no_index, positions.get_allocator().resource());
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    place[v] = static_cast<Index>(number.size());
    positions[number.size()] = positions[v];
    number.push_back(v);
  }
  positions.resize(number.size());
  for (Triangle& t : triangles) {
    for (Index& v : t)
      v = v < place.size() ? place[v] : no_index;  // refused where triangles are checked
  }
}

// Puts them back where they were among the first `kept` vertices of the map; on the polycube they are where the first
// of the others is.
void add_unused(std::span<const std::uint8_t> used, std::span<const Index> number, std::size_t kept, SurfaceMap& map,
                const base::Host& host) {
  const auto unused = static_cast<Index>(used.size() - kept);
  const auto numbered = [&](Index v) {
    if (v == no_index) return v;
    return v < kept ? number[v] : v + unused;
  };
  const std::size_t added = map.positions.size() - kept;
  Array<Vector3> positions(used.size() + added, Vector3::Zero(), host.memory);
  Array<Vector3> polycube(used.size() + added, map.polycube[0], host.memory);
  Array<VertexSource> sources(used.size() + added, host.memory);
  for (Index v = 0; v < used.size(); ++v)
    sources[v] = {{v, no_index, no_index}, {1, 0, 0}};
  for (Index v = 0; v < map.positions.size(); ++v) {
    const Index to = numbered(v);
    positions[to] = map.positions[v];
    polycube[to] = map.polycube[v];
    sources[to] = map.vertex_sources[v];
    for (Index& corner : sources[to].corner)
      corner = numbered(corner);
  }
  map.positions = std::move(positions);
  map.polycube = std::move(polycube);
  map.vertex_sources = std::move(sources);
  for (Triangle& t : map.triangles) {
    for (Index& v : t)
      v = numbered(v);
  }
}

}  // namespace

BestConstruction construct(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const ConstructionOptions& options, const base::Host& host) {
  // At a size near 1: products of lengths neither overflow nor vanish, and any power of two gives the same bits.
  const int exponent = mesh::unit_scale_exponent(positions, triangles);
  const Array<std::uint8_t> used = mesh::used_vertices(positions.size(), triangles, host.memory);
  const bool all = std::find(used.begin(), used.end(), 0) == used.end();
  Array<Index> number(host.memory);
  Array<Vector3> scaled(positions.begin(), positions.end(), host.memory);
  Array<Triangle> own(triangles.begin(), triangles.end(), host.memory);
  if (!all) keep_used(used, scaled, own, number);
  mesh::scale_by_power(scaled, exponent);
  BestConstruction best =
      mesh::with_places_of_caller(exponent, [&] { return BestOfAll(scaled, own, options, host).run(); });
  SurfaceMap& map = best.made.map;
  mesh::scale_by_power(map.positions, -exponent);
  mesh::scale_by_power(map.polycube, -exponent);
  if (!all) add_unused(used, number, scaled.size(), map, host);
  std::copy(positions.begin(), positions.end(), map.positions.begin());
  return best;
}

}  // namespace orbicube::polycube
