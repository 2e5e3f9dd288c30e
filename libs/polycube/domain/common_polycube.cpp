#include "polycube/domain/common_polycube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "mesh/topology/topology.h"
#include "polycube/domain/shape_copies.h"
#include "polycube/layout/drawn_construction.h"
#include "polycube/surface/decimation.h"

namespace orbicube::polycube {
namespace {

// A shape as polycubes are tried on it: some of its triangles, or itself.
struct CoarseShape {
  CoarseShape(const SurfaceSpan& shape, const base::Host& host)
      : positions(host.memory), triangles(host.memory), sources(host.memory) {
    whole = shape.triangles.size() <= coarse_enough;
    if (whole) {
      positions.assign(shape.positions.begin(), shape.positions.end());
      triangles.assign(shape.triangles.begin(), shape.triangles.end());
      return;
    }
    const Surface surface(Array<Vector3>(shape.positions.begin(), shape.positions.end(), host.memory),
                          Array<Triangle>(shape.triangles.begin(), shape.triangles.end(), host.memory), host);
    take_left(decimate(surface, {}, search_triangles, host), shape.positions, positions, triangles, sources, host);
  }

  // Of a copy of a shape, the copy of its triangles.
  CoarseShape(const SurfaceSpan& shape, const CoarseShape& original, const base::Host& host)
      : whole(original.whole),
        positions(host.memory),
        triangles(original.triangles, host.memory),
        sources(host.memory) {
    if (whole) positions.assign(shape.positions.begin(), shape.positions.end());
    for (const Index v : original.sources)
      positions.push_back(shape.positions[v]);
  }

  bool whole;
  Array<Vector3> positions;
  Array<Triangle> triangles;
  Array<Index> sources;  // of vertices, in the shape; empty for the whole
};

class CommonConstruction {
 public:
  CommonConstruction(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options, const base::Host& host)
      : shapes_(shapes), options_(options), host_(host), bends_(shapes.size() * shapes.size()), best_(host.memory) {}

  CommonPolycube run() {
    check();
    originals_ = originals_of(shapes_, host_);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (originals_[i] == i)
        coarse_shapes_.emplace_back(shapes_[i], host_);
      else
        coarse_shapes_.emplace_back(shapes_[i], coarse_shapes_[originals_[i]], host_);
    }
    for (const CoarseShape& shape : coarse_shapes_)
      coarse_.push_back({shape.positions, shape.triangles});
    if (options_.target.graph != nullptr) return on_target();
    find_own();
    try_polycubes();
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const CommonPolycube& a, const CommonPolycube& b) {
      return a.energies.back() < b.energies.back();
    });
    for (CommonPolycube& candidate : candidates_) {
      if (!finish(candidate)) continue;
      best_.own_energies = own_energies_;
      best_.tried = tried_;
      return std::move(best_);
    }
    throw base::Error("no-valid-result", reasons_);
  }

 private:
  void check() {
    base::require(!shapes_.empty(), "no shapes");
    base::require(options_.landmarks.empty() || options_.landmarks.size() == shapes_.size(),
                  "each shape must have landmarks, or none");
    for (const auto& points : options_.landmarks)
      base::require(points.size() == options_.landmarks[0].size(), "each shape must have as many landmarks");
    std::optional<std::int64_t> genus;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const auto facts = mesh::topology(shapes_[i].positions, shapes_[i].triangles, host_);
      mesh::require_closed_manifold(facts);
      if (!facts.genus) throw base::Error("not-connected", "shape " + std::to_string(i) + " is no connected surface");
      if (genus && *genus != *facts.genus)
        throw base::Error("wrong-genus", "shape 0 has genus " + std::to_string(*genus) + ", shape " +
                                             std::to_string(i) + " " + std::to_string(*facts.genus) +
                                             ": they have no polycube in common");
      genus = facts.genus;
    }
    genus_ = genus.value_or(0);
  }

  void fail(const std::string& name, const std::string& what) {
    reasons_ += (reasons_.empty() ? "" : "; ") + name + ": " + what;
    host_.log(name + ": " + what);
  }

  // Calls make() unless that ends without a valid result, which is noted.
  template <class Make>
  bool attempt(const std::string& name, const Make& make) {
    try {
      make();
      return true;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      fail(name, error.what());
      return false;
    }
  }

  // In the host's memory, which plain copies are not.
  SurfaceMap copy_of(const SurfaceMap& map) const {
    SurfaceMap result(host_.memory);
    result = map;
    return result;
  }

  // Each shape's own polycube, and what it comes to with the best proportions: what a common one is measured by.
  void find_own() {
    own_energies_.assign(shapes_.size(), std::numeric_limits<double>::quiet_NaN());
    own_methods_.assign(shapes_.size(), Method::automatic);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      own_.emplace_back();
      if (originals_[i] != i) {
        own_energies_[i] = own_energies_[originals_[i]];
        continue;
      }
      attempt("polycube of shape " + std::to_string(i), [&] {
        auto [made, method, printed] =
            construct(shapes_[i].positions, shapes_[i].triangles, options_.construction, host_);
        own_[i] = std::move(made.map);
        own_methods_[i] = method;
        CommonMaps alone(host_.memory);
        alone.maps.push_back(copy_of(*own_[i]));
        settle(alone);
        polycube::improve(alone, std::array<std::size_t, 1>{0}, max_rounds, improvement(), host_);
        own_energies_[i] = alone.energies.back();
      });
    }
  }

  // Each shape's own polycube drawn on all shapes, and those of coarse shapes by each construction, which takes time in
  // proportion to the square of the number of shapes.
  void try_polycubes() {
    constexpr std::size_t max_drawings = 48;
    const auto name_of = [](std::size_t i) { return "polycube of shape " + std::to_string(i); };
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (own_[i]) try_polycube(name_of(i), i, *own_[i], coarse_shapes_[i].whole);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (originals_[i] != i) continue;
      for (const Method method : {Method::labels, Method::voxels}) {
        ConstructionOptions options = options_.construction;
        if (options.method != Method::automatic && options.method != method) continue;
        if (coarse_shapes_[i].whole && own_methods_[i] == method) continue;  // that is its own
        if (tried_ * shapes_.size() >= max_drawings) return;
        options.method = method;
        const std::string name = name_of(i) + (method == Method::labels ? " by labels" : " grid-based");
        attempt(name, [&] {
          const SurfaceMap map = construct(coarse_[i].positions, coarse_[i].triangles, options, host_).made.map;
          try_polycube(name, i, map, true);
        });
      }
    }
  }

  // On the coarse shapes; `there`: the model is a map of the coarse shape itself.
  void try_polycube(const std::string& name, std::size_t base, const SurfaceMap& model, bool there) {
    ++tried_;
    attempt(name, [&] {
      CommonPolycube found(host_.memory);
      found.base = base;
      found.genus = genus_;
      found.graph = make_patch_graph(model, host_);
      for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (originals_[i] != i) {
          found.maps.push_back(map_of_copy(found.maps[originals_[i]], coarse_[i].positions, host_));
          continue;
        }
        if (i == base && there) {
          found.maps.push_back(copy_of(model));
          continue;
        }
        found.maps.push_back(draw(i, coarse_[i], found.graph, model, i == base ? nullptr : &bend(base, i)));
      }
      settle(found);
      improve(found, 2);
      host_.log(name + ": energies add up to " + std::to_string(found.energies.back()));
      candidates_.push_back(std::move(found));
    });
  }

  SurfaceMap draw(std::size_t number, const SurfaceSpan& shape, const PatchGraph& graph, const SurfaceMap& model,
                  const ScatteredMap* from_model) {
    DrawingOptions drawing;
    drawing.model = &model;
    drawing.from_model = from_model;
    try {
      return construct_on(shape.positions, shape.triangles, graph, genus_, drawing, host_).map;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      throw base::Error("no-valid-result", "on shape " + std::to_string(number) + ": " + error.what());
    }
  }

  const ScatteredMap& bend(std::size_t from, std::size_t to) {
    std::optional<ScatteredMap>& result = bends_[from * shapes_.size() + to];
    if (result) return *result;
    Array<PointPair> pairs(host_.memory);
    if (!options_.landmarks.empty())
      for (std::size_t k = 0; k < options_.landmarks[0].size(); ++k)
        pairs.push_back({options_.landmarks[from][k], options_.landmarks[to][k]});
    return result.emplace(bend_shape(coarse_[from], coarse_[to], pairs, host_));
  }

  CommonImprovementOptions improvement() const {
    return {.domain = options_.domain,
            .proportions = options_.proportions.value_or(options_.target.graph == nullptr),
            .corners = options_.corners,
            .corner_search = options_.corner_search};
  }

  void settle(CommonMaps& common) const { polycube::settle(common, improvement(), host_); }

  void improve(CommonPolycube& common, int rounds) {
    polycube::improve(common, originals_, rounds, improvement(), host_);
  }

  // The given polycube: on the first shape, then along its map on the others, which are drawn on without it where that
  // fails.
  CommonPolycube on_target() {
    const CommonTarget& target = options_.target;
    if (target.genus != genus_)
      throw base::Error("wrong-genus", "the polycube has genus " + std::to_string(target.genus) + ", the shapes " +
                                           std::to_string(genus_));
    const auto alone = [&](std::size_t i) {
      return construct_on(shapes_[i].positions, shapes_[i].triangles, *target.graph, genus_, {.pose = target.pose},
                          host_)
          .map;
    };
    best_.genus = genus_;
    best_.tried = 1;
    best_.own_energies.assign(shapes_.size(), std::numeric_limits<double>::quiet_NaN());
    best_.maps.push_back(alone(0));
    for (std::size_t i = 1; i < shapes_.size(); ++i) {
      if (originals_[i] != i) {
        best_.maps.push_back(map_of_copy(best_.maps[originals_[i]], shapes_[i].positions, host_));
        continue;
      }
      std::optional<SurfaceMap> map;
      attempt("along the map of shape 0",
              [&] { map = draw(i, shapes_[i], *target.graph, best_.maps[0], &bend(0, i)); });
      best_.maps.push_back(map ? std::move(*map) : alone(i));
    }
    settle(best_);
    improve(best_, max_rounds);
    best_.graph = make_patch_graph(best_.maps[0], host_);
    return std::move(best_);
  }

  // From coarse shapes to whole ones.
  bool finish(CommonPolycube& candidate) {
    return attempt("polycube of shape " + std::to_string(candidate.base), [&] {
      // The planes have moved since it was drawn.
      candidate.graph = make_patch_graph(candidate.maps[candidate.base], host_);
      if (std::any_of(coarse_shapes_.begin(), coarse_shapes_.end(), [](const CoarseShape& s) { return !s.whole; })) {
        for (std::size_t i = 0; i < shapes_.size(); ++i)
          if (originals_[i] != i)
            candidate.maps[i] = map_of_copy(candidate.maps[originals_[i]], shapes_[i].positions, host_);
          else if (!coarse_shapes_[i].whole)
            candidate.maps[i] = draw(i, shapes_[i], candidate.graph, candidate.maps[i], nullptr);
        settle(candidate);
      }
      improve(candidate, max_rounds);
      candidate.graph = make_patch_graph(candidate.maps[candidate.base], host_);
      best_ = std::move(candidate);
    });
  }

  static constexpr int max_rounds = 6;

  std::span<const SurfaceSpan> shapes_;
  const CommonPolycubeOptions& options_;
  const base::Host& host_;
  std::vector<std::size_t> originals_;  // of each shape: itself, or the one that it is a copy of
  std::vector<CoarseShape> coarse_shapes_;
  std::vector<SurfaceSpan> coarse_;
  std::vector<std::optional<SurfaceMap>> own_;
  std::vector<Method> own_methods_;
  Array<double> own_energies_{host_.memory};
  std::vector<std::optional<ScatteredMap>> bends_;  // from each shape to each
  std::vector<CommonPolycube> candidates_;          // on the coarse shapes
  CommonPolycube best_;
  std::int64_t genus_ = 0;
  std::size_t tried_ = 0;
  std::string reasons_;
};

}  // namespace

CommonPolycube construct_common(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options,
                                const base::Host& host) {
  return CommonConstruction(shapes, options, host).run();
}

}  // namespace orbicube::polycube
