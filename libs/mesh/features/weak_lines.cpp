#include "mesh/features/weak_lines.h"

#include <algorithm>

namespace orbicube::mesh {
namespace {

constexpr double min_turn = 3;      // degrees, in the mean along a line; less is the error of positions
constexpr double times_beside = 2;  // more than beside the line

class WeakLines {
 public:
  WeakLines(FeatureLines& lines, const FeatureLines& candidates, std::span<const Triangle> triangles,
            const base::Host& host)
      : lines_(lines),
        candidates_(candidates),
        triangles_(triangles),
        host_(host),
        done_(3 * triangles.size(), 0, host.memory) {}

  void run() {
    const auto vertices = static_cast<Index>(lines_.positions().size());
    // Lines with ends, then closed ones.
    for (const bool closed : {false, true}) {
      for (Index v = 0; v < vertices; ++v) {
        if (v % 4096 == 0) host_.report("features", 0, 0);
        if (closed || candidates_.degree(v) != 2) candidates_.for_each(v, [&](Index h) { decide(h); });
      }
    }
  }

 private:
  const Connectivity& connectivity() const { return lines_.connectivity(); }

  double turn(Index h) const {
    return degrees_between(normal(triangle_of(h)), normal(triangle_of(connectivity().opposite(h))));
  }
  Vector3 normal(Index t) const { return triangle_normal(lines_.positions(), triangles_[t]); }

  // The largest turn at the vertex opposite to a half-edge, of edges that are no candidates.
  double turn_beside(Index h) const {
    double most = 0;
    const Index apex = connectivity().end(Connectivity::next(h));
    connectivity().for_each_outgoing(apex, [&](Index out) {
      if (!candidates_.contains(out) && !lines_.contains(out)) most = std::max(most, turn(out));
    });
    return most;
  }

  void decide(Index first) {
    if (done_[first] != 0) return;
    double turns = 0, beside = 0;
    std::size_t count = 0;
    candidates_.follow(first, [&](Index h) {
      const Index back = connectivity().opposite(h);
      done_[h] = done_[back] = 1;
      turns += turn(h);
      beside += 0.5 * (turn_beside(h) + turn_beside(back));
      ++count;
    });
    if (turns < min_turn * static_cast<double>(count) || turns < times_beside * beside) return;
    candidates_.follow(first, [&](Index h) { lines_.add(h); });
  }

  FeatureLines& lines_;
  const FeatureLines& candidates_;
  std::span<const Triangle> triangles_;
  const base::Host& host_;
  Array<std::uint8_t> done_;  // of each half-edge
};

}  // namespace

void add_weak_lines(FeatureLines& lines, const FeatureLines& candidates, std::span<const Triangle> triangles,
                    const base::Host& host) {
  WeakLines(lines, candidates, triangles, host).run();
}

}  // namespace orbicube::mesh
