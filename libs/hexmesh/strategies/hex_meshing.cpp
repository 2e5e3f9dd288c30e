#include "hexmesh/strategies/hex_meshing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "hexmesh/grid/even_lengths.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/padding.h"
#include "hexmesh/grid/sharp_map.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "polycube/outputs/patch_graph.h"
#include "polycube/surface/distortion.h"

namespace orbicube::hexmesh {
namespace {

// The patches of the polycube that get a layer, and which part of its boundary they are.
struct PaddedFaces {
  Array<std::uint8_t> faces;
  double part = 0;

  PaddedFaces(const HexMesh& mesh, Array<std::uint8_t> chosen) : faces(std::move(chosen)) {
    double count = 0;
    for (const Index patch : mesh.quad_patches)
      count += faces[patch];
    part = count / static_cast<double>(mesh.quads.size());
  }
};

// A map that hexahedra may follow, and what all meshes along it have in common.
struct Guide {
  PolycubeSurface surface;
  bool sharp;  // edges were brought to those of the polycube
  polycube::PatchGraph graph;

  Guide(const PolycubeSurface& of, bool is_sharp, const base::Host& host)
      : surface(of), sharp(is_sharp), graph(polycube::make_patch_graph(of.map, host)) {}
};

// Whether protrusions have no room on the polycube: what changes angles twofold on average has no hexahedra there.
bool has_lost_limbs(const polycube::SurfaceMap& map, const base::Host& host) {
  constexpr double most = 2;
  return polycube::measure_distortion(map, host).angle_mean > most;
}

// One of the strategies to mesh the solid.
struct Strategy {
  const Guide* guide;
  int padding;  // the first or the second choice
  PaddedFaces padded;

  bool same(const Guide* other, int other_padding) const { return guide == other && padding == other_padding; }
};

// What may be padded, the most promising first.
void add_strategies(Array<Strategy>& strategies, const Guide& guide, const HexOptions& options, std::size_t cells,
                    int across, const base::Host& host) {
  const polycube::SurfaceMap& map = guide.surface.map;
  const HexMesh mesh = sample_hexahedra(domain_of_cells(guide.graph, cells, 0, host, across), map, host);
  const std::size_t count = 1 + *std::max_element(map.patches.begin(), map.patches.end());
  int choices = 0;
  const auto add = [&](Array<std::uint8_t> faces) {
    strategies.push_back({&guide, choices++, PaddedFaces(mesh, std::move(faces))});
  };
  const auto add_all = [&](std::uint8_t value) { add(Array<std::uint8_t>(count, value, host.memory)); };
  if (options.padding == Padding::with) add_all(1);
  if (options.padding == Padding::without) add_all(0);
  if (options.padding != Padding::automatic) return;
  add(choose_padding(mesh, host));
  // Where what was chosen turns out bad: none, or all.
  add_all(strategies.back().padded.part > 0 ? 0 : 1);
}

// The grid of one of the strategies, with its layers, in units of a cell.
struct Grid {
  HexMesh mesh;
  std::size_t padding = 0;  // number of the last hexahedra
  double scale = 1;

  Grid(const Strategy& strategy, std::size_t cells, int across, const base::Host& host)
      : mesh(sample_hexahedra(domain_of_cells(strategy.guide->graph, cells, strategy.padded.part, host, across),
                              strategy.guide->surface.map, host)) {
    const polycube::SurfaceMap& map = strategy.guide->surface.map;
    const std::size_t inner = mesh.hexahedra.size();
    double volume = 0;
    Vector3 low = map.positions[map.triangles[0][0]], high = low;
    for (const mesh::Triangle& t : map.triangles) {
      for (const Index v : t) {
        low = low.cwiseMin(map.positions[v]);
        high = high.cwiseMax(map.positions[v]);
      }
    }
    const Vector3 origin = near_origin(low, high);
    const auto at = [&](Index v) { return Vector3(map.positions[v] - origin); };
    for (const mesh::Triangle& t : map.triangles)
      volume += at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6;
    scale = std::cbrt(static_cast<double>(inner) / std::abs(volume));
    for (Vector3& p : mesh.positions)
      p *= scale;
    pad(mesh, strategy.padded.faces, 1, host);
    padding = mesh.hexahedra.size() - inner;
  }
};

// The best of the meshes that are made.
class Mesher {
 public:
  Mesher(const PolycubeSurface& solid, const HexOptions& options, const base::Host& host)
      : solid_(solid),
        options_(options),
        host_(host),
        target_(solid),
        whole_(host.memory),
        guides_(host.memory),
        strategies_(host.memory) {}

  HexResult best() {
    if (options_.method == HexMethod::polycube)
      fill_polycube();
    else if (options_.method == HexMethod::grid)
      fill_space();
    else
      fill_either();
    // Where a mesh came near, its defects are more useful than the failure of another strategy.
    if (!best_) throw base::Error("no-valid-result", meets_.empty() ? reason_ : meets_);
    return std::move(*best_);
  }

 private:
  bool near() const { return best_ && excess(*best_, options_.distance) <= 1; }
  // Hardly valid.
  bool poor() const {
    constexpr double least = 0.3;
    return best_->quality.min_scaled_jacobian <= least;
  }

  void make_guides() {
    const base::Stage stage(host_, 0.05);
    guides_.reserve(2);
    const auto add = [&](const polycube::SurfaceMap& map, bool sharp) {
      guides_.emplace_back(PolycubeSurface{map, solid_.fine_positions, solid_.fine_triangles}, sharp, host_);
    };
    if (options_.feature_angle > 0) sharp_ = map_with_sharp_edges(solid_.map, options_.feature_angle, host_);
    if (sharp_) {
      *sharp_ = map_with_even_lengths(*sharp_, host_);
      add(*sharp_, true);
    }
    plain_ = map_with_even_lengths(solid_.map, host_);
    add(*plain_, false);
  }

  void fill_polycube() {
    make_guides();
    for (std::size_t cells = options_.cells;; cells *= 2) {
      const base::Stage stage(host_, half_of_the_rest);
      make(cells);
      if (too_few_across()) make(cells);
      if (options_.distance == 0 || 2 * cells > options_.max_cells) return;
      // What is near but poor is tried with twice as many cells, once.
      if (near() && (cells > options_.cells || !poor())) return;
    }
  }

  void fill_space() {
    for (std::size_t cells = options_.cells;; cells *= 2) {
      const base::Stage stage(host_, half_of_the_rest);
      if (make_by_voxels(cells) || options_.distance == 0 || 2 * cells > options_.max_cells) return;
    }
  }

  // The polycube first; a grid, which has a layer around, where that is not near or poor. More cells of the polycube
  // only where the first were not too far.
  void fill_either() {
    constexpr double hopeless = 1.5;
    const bool is_map = !solid_.map.triangles.empty(), grid_may = options_.padding != Padding::without;
    base::require(is_map || grid_may, "there is no polycube, and the cells of a grid in space have a layer around");
    if (!grid_may) return fill_polycube();
    const bool late = is_map && has_lost_limbs(solid_.map, host_);
    if (is_map && !late) make_guides();
    for (std::size_t cells = options_.cells;; cells *= 2) {
      const base::Stage stage(host_, half_of_the_rest);
      const bool first = cells == options_.cells, second = cells == 2 * options_.cells;
      if (first || across_ > 1 || no_grid_ || (second && best_ && excess(*best_, options_.distance) <= hopeless))
        make(cells);
      if (too_few_across()) make(cells);
      if (near() && !poor()) return;
      make_by_voxels(cells);
      if (no_grid_ && too_few_across()) make(cells);
      if (near() && (!first || !poor())) return;
      if (options_.distance == 0 || 2 * cells > options_.max_cells) break;
    }
    if (late && !best_) fill_polycube();
  }

  // Near, but with another volume: protrusions are thin, and equal cells are so few across that their boundary cuts
  // corners. From now on there are more across than that.
  bool too_few_across() {
    constexpr int enough = 6;
    const double near = no_grid_ ? 1 : 0.25;  // of the distance that is allowed
    if (across_ > 1 || !best_ || guides_.empty() || options_.distance == 0) return false;
    if (best_->volume_error <= options_.distance || best_->distance > near * options_.distance) return false;
    across_ = enough;
    return true;
  }

  // What fails in one strategy may work in another; where more cells are more than there can be, what was found stays.
  void tolerate(const base::Error& error) {
    const bool too_many = best_ && error.status() == base::Status::invalid_argument;
    if (error.status() != base::Status::no_valid_result && !too_many) throw;
    reason_ = error.what();
  }

  static constexpr double good = 0.4;
  // How many attempts there will be is not known: each is a part of what is left of the progress.
  static constexpr double half_of_the_rest = 0.5, third_of_the_rest = 1.0 / 3.0;

  // What is near to the surface by itself is better than what is fixed there. What is good in one strategy is not tried
  // in another; with more cells, which are slow, a little less is good.
  bool done(std::size_t cells) const {
    constexpr double good_of_many = 0.3;
    return (min_near_ > 0 ? min_near_ : least_) > (cells > options_.cells ? good_of_many : good);
  }

  // Whether a mesh is valid and as near to the surface as requested, and so much so that there is no need for another.
  struct Nearness {
    bool near = false, by_itself = false;
  };
  Nearness attempt(const Strategy& strategy, std::size_t cells, const HexManner& manner) {
    const base::Stage stage(host_, third_of_the_rest);
    try {
      Grid grid(strategy, cells, across_, host_);
      HexResult now = finish_apart(
          [&] {
            return HexDraft(copy_of(grid.mesh), grid.padding, grid.scale, strategy.guide->surface, target_,
                            {.distance = options_.distance, .rounds = options_.rounds}, host_);
          },
          manner);
      now.follows_sharp_edges = strategy.guide->sharp;
      return take(std::move(now), &strategy);
    } catch (const base::Error& error) {
      tolerate(error);
      return {};
    }
  }

  // Keeps what is better than what there is.
  Nearness take(HexResult&& now, const Strategy* strategy) {
    if (!now.quality.valid()) {
      reason_ = what_is_wrong(now.quality);
      if (now.quality.positive()) meets_ = reason_;
      return {};
    }
    least_ = std::max(least_, now.quality.min_scaled_jacobian);
    const bool near = excess(now, options_.distance) <= 1, by_itself = near && !now.hardly_near;
    if (near) min_near_ = std::max(min_near_, now.quality.min_scaled_jacobian);
    if (!best_ || better(now, *best_, options_.distance)) {
      best_ = std::move(now);
      if (strategy != nullptr) {
        best_guide_ = strategy->guide;
        best_padding_ = strategy->padding;
      }
    }
    return {near, by_itself};
  }

  HexMesh copy_of(const HexMesh& mesh) const {
    HexMesh result(host_.memory);
    result = mesh;
    return result;
  }

  // Whether there is one that is near.
  bool make_by_voxels(std::size_t cells) {
    if (whole_.triangles.empty()) {
      whole_.positions.assign(target_.positions.begin(), target_.positions.end());
      whole_.triangles.assign(target_.triangles.begin(), target_.triangles.end());
      whole_.patches.assign(whole_.triangles.size(), 0);
    }
    no_grid_ = true;
    try {
      const VoxelHexes grid = voxel_hexahedra(target_.positions, target_.triangles, cells, host_);
      no_grid_ = false;
      // As many as before where that is as few as there can be.
      const std::pair made = {grid.mesh.hexahedra.size(), grid.scale};
      if (std::exchange(last_grid_, made) == made) return false;
      for (const bool hold : {false, true}) {
        if (hold && options_.distance == 0) return false;
        const base::Stage stage(host_, half_of_the_rest);
        HexResult now = finish_apart(
            [&] {
              return HexDraft(copy_of(grid.mesh), grid.padding, grid.scale, {whole_}, target_,
                              {.distance = options_.distance, .rounds = options_.rounds}, host_);
            },
            {.hold = hold});
        now.grid_based = true;
        if (take(std::move(now), nullptr).near) return true;
      }
    } catch (const base::Error& error) {
      tolerate(error);
    }
    return false;
  }

  // What has been good with fewer cells is with more; where voxels are next and there is nothing near, what has been
  // best.
  void find_ways(std::size_t cells) {
    strategies_.clear();
    for (const Guide& guide : guides_) {
      try {
        add_strategies(strategies_, guide, options_, cells, across_, host_);
      } catch (const base::Error& error) {
        tolerate(error);
      }
    }
    const bool near_by_polycube = near() && !best_->grid_based;
    const bool one = options_.method == HexMethod::automatic && cells > options_.cells && !near_by_polycube;
    if (best_guide_ != nullptr && (one || best_->quality.min_scaled_jacobian > good))
      std::erase_if(strategies_, [&](const Strategy& strategy) { return !strategy.same(best_guide_, best_padding_); });
  }

  // Meshes of about the given number of cells until one is good.
  void make(std::size_t cells) {
    least_ = min_near_ = 0;
    find_ways(cells);
    if (strategies_.empty()) return;
    // More cells are there for what is far: fixed at once.
    const bool free_first = cells == options_.cells, distance_counts = options_.distance > 0;
    for (const Strategy& strategy : strategies_) {
      if (done(cells)) return;
      HexManner manner;
      Nearness now;
      if (free_first) now = attempt(strategy, cells, manner);
      bool near = now.near;
      if (!now.by_itself && distance_counts) near |= attempt(strategy, cells, manner = {.hold = true}).near;
      manner.insist = true;
      if (near && !done(cells)) attempt(strategy, cells, manner);
    }
    // Vertices on the surface itself are less accurate and leave more room.
    for (const Strategy& strategy : strategies_) {
      if (least_ == 0) attempt(strategy, cells, {.lift = false, .hold = distance_counts});
    }
  }

  const PolycubeSurface& solid_;
  const HexOptions& options_;
  const base::Host& host_;
  const TargetSurface target_;
  polycube::SurfaceMap whole_;  // the whole surface as one chart, for the cells of a grid
  // The map as it is and with sharp edges in their target positions, both with arc-length equalization.
  std::optional<polycube::SurfaceMap> plain_, sharp_;
  Array<Guide> guides_;
  Array<Strategy> strategies_;
  std::optional<HexResult> best_;
  const Guide* best_guide_ = nullptr;  // of the polycube's, the best when it was made
  int best_padding_ = 0;
  bool no_grid_ = false;                               // of cells in space, the last time
  std::pair<std::size_t, double> last_grid_ = {0, 0};  // its hexahedra and its scale
  int across_ = 1;                                     // minimum number of cells across a passage
  std::string reason_, meets_;  // why there is none: the last, and of what had positive hexahedra
  // Scaled Jacobians of what is best among meshes of one number of cells: of all, and of those that are near.
  double least_ = 0, min_near_ = 0;
};

}  // namespace

HexResult make_hexahedra(const PolycubeSurface& solid, const HexOptions& options, const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0 && options.rounds <= max_rounds, "the number of rounds must be from 0 to 1000");
  base::require(options.feature_angle >= 0 && options.feature_angle < 180,
                "`feature_angle` must be at least 0 and below 180 degrees");
  base::require(options.distance >= 0 && options.distance <= 100, "the distance must be from 0 to 100 percent");
  base::require(options.max_cells <= 10'000'000, "max_cells must be at most 10 million");
  base::require(!solid.map.triangles.empty() || options.method != HexMethod::polycube, "there is no polycube");
  base::require(options.padding != Padding::without || options.method != HexMethod::grid,
                "the cells of a grid in space have a layer around");
  return Mesher(solid, options, host).best();
}

}  // namespace orbicube::hexmesh
