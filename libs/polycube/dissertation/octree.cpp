#include "polycube/dissertation/octree.h"

#include <algorithm>
#include <utility>

namespace orbicube::polycube::dissertation {
namespace {

constexpr const char* octree_phase = "octree";

class Octree {
 public:
  Octree(const Occupancy& occupancy, const OctreeOptions& options, const base::Host& host)
      : occupancy_(occupancy), options_(options), host_(host), solid_(planes(), host.memory) {}

  VoxelSolid build() {
    divide({0, 0, 0}, 0);
    return std::move(solid_);
  }

 private:
  int boxes() const { return 1 << options_.depth; }

  // The plane of the occupancy below box `i` of the finest level.
  int cell_plane(std::size_t axis, int i) const {
    return static_cast<int>(static_cast<std::int64_t>(occupancy_.count(axis)) * i / boxes());
  }

  std::array<Array<double>, 3> planes() const {
    std::array<Array<double>, 3> result = {Array<double>(host_.memory), Array<double>(host_.memory),
                                           Array<double>(host_.memory)};
    for (std::size_t a = 0; a < 3; ++a) {
      const double low = occupancy_.low()[static_cast<Eigen::Index>(a)];
      const double size = occupancy_.cell_size();
      result[a].push_back(low - size);
      for (int i = 0; i <= boxes(); ++i)
        result[a].push_back(low + cell_plane(a, i) * size);
      result[a].push_back(low + (occupancy_.count(a) + 1) * size);
    }
    return result;
  }

  // A box of the given level; `at` counts boxes of the finest one.
  void divide(const Cell& at, int level) {
    host_.report(octree_phase, 0, 0);
    const int width = boxes() >> level;
    std::array<int, 3> begin{}, end{};
    double volume = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      begin[a] = cell_plane(a, at[a]);
      end[a] = cell_plane(a, at[a] + width);
      volume *= end[a] - begin[a];
    }
    const auto filled = static_cast<double>(occupancy_.inside(begin, end));
    if (filled == 0 && level > 0) return;
    if (filled == volume || level == options_.depth) {
      if (filled > options_.inside * volume || level == 0) fill(at, width);
      return;
    }
    for (int child = 0; child < 8; ++child) {
      const int half = width / 2;
      divide({at[0] + half * (child & 1), at[1] + half * (child >> 1 & 1), at[2] + half * (child >> 2 & 1)}, level + 1);
    }
  }

  void fill(const Cell& at, int width) {
    for (int x = 0; x < width; ++x)
      for (int y = 0; y < width; ++y)
        for (int z = 0; z < width; ++z)
          solid_.set(solid_.place({at[0] + x + 1, at[1] + y + 1, at[2] + z + 1}), true);
  }

  const Occupancy& occupancy_;
  const OctreeOptions& options_;
  const base::Host& host_;
  VoxelSolid solid_;
};

}  // namespace

int max_octree_depth(const Occupancy& occupancy) {
  const int fewest = std::min({occupancy.count(0), occupancy.count(1), occupancy.count(2)});
  int depth = 0;
  while ((2 << depth) <= fewest)
    ++depth;
  return depth;
}

VoxelSolid octree_solid(const Occupancy& occupancy, const OctreeOptions& options, const base::Host& host) {
  return Octree(occupancy, options, host).build();
}

}  // namespace orbicube::polycube::dissertation
