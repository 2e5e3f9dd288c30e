#include <algorithm>

#include "base/counted.h"
#include "hexmesh/features/embedding.h"

namespace orbicube::hexmesh {
namespace {

class Regions {
 public:
  Regions(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape, Embedding& embedding,
          const base::Host& host)
      : mesh_(mesh),
        quads_(quads),
        shape_(shape),
        embedding_(embedding),
        host_(host),
        border_(4 * quads.quads().size(), 0, host.memory),
        region_(quads.quads().size(), no_index, host.memory),
        patch_(host.memory) {}

  std::optional<FeatureObstacle> run() {
    for (const Array<Index>& path : embedding_.paths) {
      for (std::size_t i = 1; i < path.size(); ++i) {
        const Index h = quads_.find(path[i - 1], path[i]);
        border_[h] = border_[quads_.opposite(h)] = 1;
      }
    }
    fill();
    if (auto obstacle = name_regions()) return obstacle;
    if (patch_.size() != shape_.patches()) {
      return FeatureObstacle{no_index, no_index,
                             "the paths of the arcs bound " + base::counted(patch_.size(), "region") + ", there are " +
                                 base::counted(shape_.patches(), "patch", "patches")};
    }
    embedding_.quad_patches.resize(region_.size());
    for (std::size_t q = 0; q < region_.size(); ++q)
      embedding_.quad_patches[q] = patch_[region_[q]];
    return compare_euler();
  }

 private:
  void fill() {
    Array<Index> open(host_.memory);
    for (Index first = 0; first < region_.size(); ++first) {
      if (region_[first] != no_index) continue;
      host_.report("features", 0, 0);
      const auto number = static_cast<Index>(patch_.size());
      patch_.push_back(no_index);
      region_[first] = number;
      open.push_back(first);
      while (!open.empty()) {
        const Index q = open.back();
        open.pop_back();
        for (Index h = 4 * q; h < 4 * q + 4; ++h) {
          const Index beside = quads_.opposite(h) / 4;
          if (border_[h] != 0 || region_[beside] != no_index) continue;
          region_[beside] = number;
          open.push_back(beside);
        }
      }
    }
  }

  // Patches of regions by the arcs on their borders; without any, by the surface next to them.
  std::optional<FeatureObstacle> name_regions() {
    for (Index a = 0; a < shape_.arcs(); ++a) {
      const auto& path = embedding_.paths[a];
      const auto& [left, right] = shape_.graph().arcs[a].patches;
      for (std::size_t i = 1; i < path.size(); ++i) {
        const Index h = quads_.find(path[i - 1], path[i]);
        Index& on_left = patch_[region_[h / 4]];
        if (on_left == no_index) on_left = left;
        Index& on_right = patch_[region_[quads_.opposite(h) / 4]];
        if (on_right == no_index) on_right = right;
        if (on_left != left || on_right != right)
          return FeatureObstacle{no_index, a, "the path of the arc has other patches beside it"};
      }
    }
    for (std::size_t q = 0; q < region_.size(); ++q) {
      Index& patch = patch_[region_[q]];
      if (patch == no_index) patch = shape_.nearest_patch(mesh_.positions[quads_.quads()[q][0]]);
    }
    Array<std::uint8_t> found(shape_.patches(), 0, host_.memory);
    for (const Index patch : patch_) {
      if (found[patch]++ != 0)
        return FeatureObstacle{no_index, no_index, "the paths of the arcs cut a patch into two regions"};
    }
    return {};
  }

  std::optional<FeatureObstacle> compare_euler() const {
    Array<std::int64_t> euler(shape_.patches(), 0, host_.memory);
    Array<Index> beside(host_.memory);
    for (const Index v : quads_.vertices()) {
      beside.clear();
      quads_.for_each_outgoing(v, [&](Index h) { beside.push_back(embedding_.quad_patches[h / 4]); });
      std::sort(beside.begin(), beside.end());
      beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
      for (const Index p : beside)
        ++euler[p];
    }
    for (Index h = 0; h < border_.size(); ++h) {
      const Index own = embedding_.quad_patches[h / 4], other = quads_.opposite(h);
      if (h % 4 == 0) ++euler[own];
      if (h < other || own != embedding_.quad_patches[other / 4]) --euler[own];
    }
    for (Index p = 0; p < shape_.patches(); ++p) {
      if (euler[p] != shape_.graph().euler[p])
        return FeatureObstacle{no_index, no_index, "a region has another topology than its patch"};
    }
    return {};
  }

  const HexMesh& mesh_;
  const BoundaryQuads& quads_;
  const FeatureShape& shape_;
  Embedding& embedding_;
  const base::Host& host_;
  Array<std::uint8_t> border_;  // of each half-edge
  Array<Index> region_;         // of each quad
  Array<Index> patch_;          // of each region
};

}  // namespace

std::optional<FeatureObstacle> match_patches(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape,
                                             Embedding& embedding, const base::Host& host) {
  return Regions(mesh, quads, shape, embedding, host).run();
}

}  // namespace orbicube::hexmesh
