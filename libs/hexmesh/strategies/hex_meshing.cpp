#include "hexmesh/strategies/hex_meshing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "hexmesh/grid/even_lengths.h"
#include "hexmesh/grid/sharp_map.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "hexmesh/strategies/polycube_grids.h"
#include "hexmesh/strategies/refinement.h"

namespace orbicube::hexmesh {
namespace {

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
        strategies_(host.memory),
        tried_(host.memory) {}

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
  double excess_of_best() const { return best_ ? excess(*best_, options_.distance) : 0; }
  // Hardly valid.
  static constexpr double least_of_good = 0.3;
  bool poor() const { return best_->quality.min_scaled_jacobian <= least_of_good; }

  bool refine(Refinement& refinement) const { return !spent_ && refinement.next(excess_, excess_of_best()); }

  // Whether one more mesh of this number of cells is affordable.
  bool afford(std::size_t cells) {
    spent_ = spent_ || (drafted_ > 0 && drafted_ + cells > affordable());
    return !spent_;
  }
  // Hexahedra of all meshes together.
  std::size_t affordable() const {
    constexpr std::size_t most = 40;       // of the option `cells`: some ten meshes of that number, and a few of more
    constexpr std::size_t cheap = 20'000;  // take about twenty seconds
    constexpr double useful = 2;           // excess up to which a mesh is handed out
    const bool found = best_ && excess_of_best() <= useful;
    return std::max(most * options_.cells, found ? cheap : 2 * cheap);
  }
  bool half_spent() const { return 2 * drafted_ > affordable(); }

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
    for (Refinement refinement(options_.cells, options_.max_cells);;) {
      const std::size_t cells = refinement.cells();
      const base::Stage stage(host_, half_of_the_rest);
      excess_ = 0;
      make(cells);
      if (options_.to_beat == 0 && too_few_across()) make(cells);
      // What is near but poor is tried with twice as many cells, once.
      if (options_.distance == 0 || options_.to_beat > 0 || (near() && (cells > options_.cells || !poor()))) return;
      if (!refine(refinement)) return;
    }
  }

  void fill_space() {
    for (Refinement refinement(options_.cells, options_.max_cells);;) {
      const base::Stage stage(host_, half_of_the_rest);
      excess_ = 0;
      if (make_by_voxels(refinement.cells()) || options_.distance == 0 || !refine(refinement)) return;
    }
  }

  // The polycube first; a grid, which has a layer around, where that is not near or poor. With more cells what was
  // nearer, while more cells help.
  void fill_either() {
    const bool is_map = !solid_.map.triangles.empty(), grid_may = options_.padding != Padding::without;
    base::require(is_map || grid_may, "there is no polycube, and the cells of a grid in space have a layer around");
    if (!grid_may) return fill_polycube();
    const bool late = is_map && has_lost_limbs(solid_.map, host_);
    if (is_map && !late) make_guides();
    double by_polycube = 0, by_grid = 0;  // excess of the last; 0: there is none, or none that is promising
    Refinement refinement(options_.cells, options_.max_cells);
    do {
      const std::size_t cells = refinement.cells();
      const base::Stage stage(host_, half_of_the_rest);
      const bool first = cells == options_.cells, grid_first = !first && grid_promises_more(by_grid, cells);
      if (grid_first) {
        excess_ = 0;
        make_by_voxels(cells);
        by_grid = excess_;
        if (near() && !poor()) return;
      }
      if (first || across_ > 1 || no_grid_ || worth_refining(by_polycube, by_grid, cells)) {
        excess_ = 0;
        grid_follows_ = first;
        make(cells);
        if (too_few_across()) make(cells);
        if (by_polycube > 0 && excess_ > std::pow(by_polycube / excess_, patience)) {
          excess_ = 0;
          refinement.forget();
        }
        by_polycube = excess_;
      }
      if (near() && !poor()) return;
      const bool grid_may_be_near = may_be_near({last_grid_.first, by_grid}, cells);
      if (!grid_first && (first || by_polycube == 0 || (near() ? grid_may_be_near : by_polycube > clearly * by_grid))) {
        excess_ = 0;
        make_by_voxels(cells);
        by_grid = excess_;
        if (no_grid_ && too_few_across()) make(cells);
      }
      if (std::exchange(grid_follows_, false)) by_polycube = make_what_was_left(cells, by_polycube);
      if (near() && (!first || !poor())) return;
      excess_ = by_polycube == 0 || by_grid == 0 ? by_polycube + by_grid : std::min(by_polycube, by_grid);
    } while (options_.distance > 0 && refine(refinement));
    if (late && !best_) fill_polycube();
  }

  // Meshes of the polycube that a grid, which promised more, did not make needless, nor will more cells. Returns their
  // excess().
  double make_what_was_left(std::size_t cells, double by_polycube) {
    const bool more_cells = !no_grid_ && 2 * cells <= options_.max_cells;
    if (strategies_.empty() || (near() && (!poor() || more_cells))) return by_polycube;
    excess_ = by_polycube;
    make_each(cells);
    return excess_;
  }

  // With more cells: those of a grid, by its last mesh, before those of a polycube that are worse.
  bool grid_promises_more(double by_grid, std::size_t cells) const {
    if (by_grid == 0 || no_grid_ || !near() || best_->grid_based) return false;
    return grid_least_ > best_->quality.min_scaled_jacobian && may_be_near({last_grid_.first, by_grid}, cells);
  }

  // More cells of the polycube, where there are others of a grid: by its meshes and those of grids so far.
  bool worth_refining(double by_polycube, double by_grid, std::size_t cells) const {
    constexpr double hopeless = 1.5;
    if (by_polycube == 0) return false;
    return by_grid == 0 || by_polycube <= hardly * by_grid ||
           (cells == 2 * options_.cells && excess_of_best() <= hopeless);
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

  // Of excess(): a strategy that is nearer by this factor is the only one, one that is hardly farther is one of two.
  static constexpr double clearly = 0.5, hardly = 1.5;
  // Of steps as the last one, with more cells: a strategy that would require more to be near is given up for others.
  static constexpr double patience = 3;
  static constexpr double good = 0.4;
  // How many attempts there will be is not known: each is a part of what is left of the progress.
  static constexpr double half_of_the_rest = 0.5, third_of_the_rest = 1.0 / 3.0;

  // What is near to the surface by itself is better than what is fixed there. What is good in one strategy is not tried
  // in another; with more cells, which are slow, a little less is good.
  bool done(std::size_t cells) const {
    constexpr double good_of_many = 0.3;
    return (min_near_ > 0 ? min_near_ : least_) > (cells > options_.cells ? good_of_many : good);
  }

  // Whether a mesh of this scaled Jacobian, fixed or with the weights of its worst corners raised, may be of use: that
  // is rarely larger by more than a half then. A grid that follows is hardly ever poor.
  bool may_help(double scaled_jacobian) const {
    constexpr double most_gained = 1.5;
    double beaten = options_.to_beat;
    if (near()) beaten = std::max(beaten, best_->quality.min_scaled_jacobian);
    if (grid_follows_) beaten = std::max(beaten, least_of_good);
    return most_gained * scaled_jacobian >= beaten;
  }

  Nearness attempt(const Strategy& strategy, std::size_t cells, const HexManner& manner) {
    if (spent_) return {};
    const base::Stage stage(host_, third_of_the_rest);
    try {
      PolycubeGrid grid(strategy, cells, across_, host_);
      if (!afford(grid.mesh.hexahedra.size())) return {};
      HexResult now = finish_apart(
          [&] {
            drafted_ += grid.mesh.hexahedra.size();
            return HexDraft(copy_of(grid.mesh, host_), grid.padding, grid.scale, strategy.guide->surface, target_,
                            {.distance = options_.distance, .rounds = options_.rounds}, host_);
          },
          manner);
      now.follows_sharp_edges = strategy.guide->sharp;
      return take(std::move(now), &strategy, manner);
    } catch (const base::Error& error) {
      tolerate(error);
      return {};
    }
  }

  // Keeps what is better than what there is.
  Nearness take(HexResult&& now, const Strategy* strategy, const HexManner& manner) {
    log_made(now, manner, host_);
    if (!now.quality.valid()) {
      reason_ = what_is_wrong(now.quality);
      if (now.quality.positive()) meets_ = reason_;
      return {};
    }
    least_ = std::max(least_, now.quality.min_scaled_jacobian);
    const double excess_of_now = excess(now, options_.distance), scaled_jacobian = now.quality.min_scaled_jacobian;
    excess_ = excess_ == 0 ? excess_of_now : std::min(excess_, excess_of_now);
    const bool near = excess_of_now <= 1, by_itself = near && !now.hardly_near;
    if (near) min_near_ = std::max(min_near_, now.quality.min_scaled_jacobian);
    if (!best_ || better(now, *best_, options_.distance)) {
      best_ = std::move(now);
      if (strategy != nullptr) {
        best_guide_ = strategy->guide;
        best_padding_ = strategy->padding;
      }
    }
    return {near, by_itself, scaled_jacobian};
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
      if (made.first < last_grid_.first || std::exchange(last_grid_, made) == made) return false;
      for (const bool hold : {false, true}) {
        if (hold && options_.distance == 0) return false;
        if (!hold && !may_be_near(free_, made.first)) continue;
        if (!afford(made.first)) return false;
        const base::Stage stage(host_, half_of_the_rest);
        HexResult now = finish_apart(
            [&] {
              drafted_ += made.first;
              return HexDraft(copy_of(grid.mesh, host_), grid.padding, grid.scale, {whole_}, target_,
                              {.distance = options_.distance, .rounds = options_.rounds}, host_);
            },
            {.hold = hold});
        now.grid_based = true;
        if (!hold && now.quality.valid()) free_ = {made.first, excess(now, options_.distance)};
        const Nearness taken = take(std::move(now), nullptr, {.hold = hold});
        grid_least_ = taken.scaled_jacobian;
        if (taken.near) return true;
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
    tried_.assign(strategies_.size(), Tried());
    if (!strategies_.empty()) make_each(cells);
  }

  // Those of use that were not made yet.
  void make_each(std::size_t cells) {
    for (std::size_t i = 0; i < strategies_.size(); ++i) {
      if (done(cells)) return;
      follow(strategies_[i], cells, tried_[i]);
      if (options_.to_beat > 0) return;
    }
    // Vertices on the surface itself are less accurate and leave more room.
    for (std::size_t i = 0; i < strategies_.size(); ++i) {
      if (least_ > 0 || std::exchange(tried_[i].unraised, true)) continue;
      attempt(strategies_[i], cells, {.lift = false, .hold = options_.distance > 0});
    }
  }

  void follow(const Strategy& strategy, std::size_t cells, Tried& tried) {
    const auto make_one = [&](bool& which, const HexManner& manner) {
      which = true;
      const Nearness now = attempt(strategy, cells, manner);
      tried.near |= now.near;
      if (now.scaled_jacobian > 0) tried.last = now;
    };
    // More cells are there for what is far: fixed at once.
    if (cells == options_.cells && !tried.free) make_one(tried.free, {});
    const bool unknown = tried.last.scaled_jacobian == 0;
    if (!tried.fixed && !tried.last.by_itself && options_.distance > 0 &&
        (unknown || may_help(tried.last.scaled_jacobian)))
      make_one(tried.fixed, {.hold = true});
    if (tried.near && !tried.insisted && !done(cells) && !half_spent() && may_help(tried.last.scaled_jacobian))
      make_one(tried.insisted, {.hold = tried.fixed, .insist = true});
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
  Array<Tried> tried_;  // of each strategy
  std::optional<HexResult> best_;
  // Of the last grid whose boundary was free: its hexahedra and excess().
  std::pair<std::size_t, double> free_ = {0, 0};
  const Guide* best_guide_ = nullptr;  // of the polycube's, the best when it was made
  int best_padding_ = 0;
  bool no_grid_ = false;                               // of cells in space, the last time
  bool grid_follows_ = false;                          // after the meshes of the polycube, unless they are good
  double grid_least_ = 0;                              // the scaled Jacobian of its last mesh
  std::pair<std::size_t, double> last_grid_ = {0, 0};  // its hexahedra and its scale
  int across_ = 1;                                     // minimum number of cells across a passage
  std::string reason_, meets_;  // why there is none: the last, and of what had positive hexahedra
  // Scaled Jacobians of what is best among meshes of one number of cells: of all, and of those that are near.
  double least_ = 0, min_near_ = 0;
  double excess_ = 0;        // of the nearest among those that refinements go by; 0: there is none
  std::size_t drafted_ = 0;  // hexahedra of all meshes
  bool spent_ = false;       // no more are affordable
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
