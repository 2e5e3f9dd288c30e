#include "mesh/features/feature_repairs.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "base/heap.h"

namespace orbicube::mesh {
namespace {

constexpr double price_of_others = 8;  // times the length, of edges that are no guides

// Shortest ways over a surface from a vertex of a feature line to another line.
class WayFinder {
 public:
  WayFinder(FeatureLines& lines, const FeatureLines& guides, const base::Host& host)
      : lines_(lines),
        guides_(guides),
        host_(host),
        positions_(lines.positions()),
        from_(positions_.size(), no_index, host.memory),
        own_(positions_.size(), 0, host.memory),
        queue_(host.memory) {}

  // Marks a vertex as one of the lines that the way begins at.
  void keep_off(Index vertex) { own_[vertex] = 1; }
  bool kept_off(Index vertex) const { return own_[vertex] != 0; }

  // Offers a first step, at a price besides that of its edge.
  void offer(Index half_edge, double extra) { queue_.push({extra + price(half_edge), end(half_edge), half_edge}); }

  // Adds the cheapest way to a vertex of a line that is not one of the own, or a branch where `branches` is true.
  // Returns whether there is one. What was kept off and offered is forgotten.
  bool add_way(Index start, bool branches) {
    from_.assign(from_.size(), no_index);
    Index hit = no_index;
    while (!queue_.empty() && hit == no_index) {
      host_.report("features", 0, 0);
      const Open open = queue_.pop();
      const Index v = open.vertex;
      if (v == start || from_[v] != no_index) continue;
      from_[v] = open.half_edge;
      if (const std::size_t degree = lines_.degree(v); degree > 0) {
        const bool closes = branches && degree == 1 && along_guides(start, v);
        if (own_[v] == 0 || (branches && degree > 2) || closes) hit = v;
        continue;
      }
      lines_.connectivity().for_each_outgoing(v, [&](Index h) {
        if (from_[end(h)] == no_index) queue_.push({open.price + price(h), end(h), h});
      });
    }
    queue_.clear();
    own_.assign(own_.size(), 0);
    if (hit == no_index) return false;
    by_guides_ = along_guides(start, hit);
    for (Index v = hit; v != start; v = lines_.connectivity().start(from_[v]))
      lines_.add(from_[v]);
    return true;
  }

  // Whether the last way that was added has only guides.
  bool by_guides() const { return by_guides_; }

 private:
  struct Open {
    double price;
    Index vertex;
    Index half_edge;  // to the vertex
    bool operator>(const Open& other) const {
      return std::tie(price, vertex, half_edge) > std::tie(other.price, other.vertex, other.half_edge);
    }
  };

  bool along_guides(Index start, Index v) const {
    for (; v != start; v = lines_.connectivity().start(from_[v])) {
      if (!guides_.contains(from_[v])) return false;
    }
    return true;
  }
  Index end(Index half_edge) const { return lines_.connectivity().end(half_edge); }
  double price(Index half_edge) const {
    const double length = (positions_[end(half_edge)] - positions_[lines_.connectivity().start(half_edge)]).norm();
    return length * (guides_.contains(half_edge) ? 1 : price_of_others);
  }

  FeatureLines& lines_;
  const FeatureLines& guides_;
  const base::Host& host_;
  std::span<const Vector3> positions_;
  Array<Index> from_;        // the half-edge that a vertex was reached by
  Array<std::uint8_t> own_;  // of the lines that the way begins at
  base::Heap<Open> queue_;
  bool by_guides_ = false;
};

// A sector between two neighboring feature lines at a corner: its edges, with the angle up to each, and its angle.
struct Sector {
  struct Spoke {
    Index half_edge;
    double angle;
  };
  std::vector<Spoke> spokes;  // the last is the feature line at its end
  double angle = 0;
};

std::vector<Sector> sectors_at(Index corner, const FeatureLines& lines) {
  const Connectivity& connectivity = lines.connectivity();
  const auto positions = lines.positions();
  Index first = no_index;
  lines.for_each(corner, [&](Index h) {
    if (first == no_index) first = h;
  });
  std::vector<Sector> sectors(1);
  Index h = first;
  do {
    const Index next = connectivity.opposite(Connectivity::previous(h));
    const Vector3 a = positions[connectivity.end(h)] - positions[corner];
    const Vector3 b = positions[connectivity.end(next)] - positions[corner];
    sectors.back().angle += degrees_between(a, b);
    sectors.back().spokes.push_back({next, sectors.back().angle});
    h = next;
    if (lines.contains(h) && h != first) sectors.emplace_back();
  } while (h != first);
  return sectors;
}

}  // namespace

bool drop_short_ends(FeatureLines& lines, const FeatureLines& kept, double length, const base::Host& host) {
  const Connectivity& connectivity = lines.connectivity();
  Array<Index> line(host.memory);
  bool dropped = false;
  for (Index v = 0; v < lines.positions().size(); ++v) {
    if (v % 4096 == 0) host.report("features", 0, 0);
    if (lines.degree(v) != 1) continue;
    line.clear();
    double sum = 0;
    bool keep = false;
    lines.for_each(v, [&](Index first) {
      lines.follow(first, [&](Index h) {
        line.push_back(h);
        sum += (lines.positions()[connectivity.end(h)] - lines.positions()[connectivity.start(h)]).norm();
        keep = keep || kept.contains(h);
      });
    });
    if (keep || sum > length) continue;
    for (const Index h : line)
      lines.remove(h);
    dropped = true;
  }
  return dropped;
}

ContinuedEnds continue_ends(FeatureLines& lines, const FeatureLines& guides, const base::Host& host) {
  ContinuedEnds ends{Array<Index>(host.memory), Array<Index>(host.memory)};
  for (Index v = 0; v < lines.positions().size(); ++v) {
    if (lines.degree(v) == 1) ends.by_guides.push_back(v);
  }
  WayFinder finder(lines, guides, host);
  const Connectivity& connectivity = lines.connectivity();
  for (const Index v : ends.by_guides) {
    host.report("features", 0, 0);
    if (lines.degree(v) != 1) continue;  // another line was continued to it
    finder.keep_off(v);
    lines.for_each(v, [&](Index h) { lines.follow(h, [&](Index way) { finder.keep_off(connectivity.end(way)); }); });
    connectivity.for_each_outgoing(v, [&](Index h) {
      if (!lines.contains(h)) finder.offer(h, 0);
    });
    if (!finder.add_way(v, true) || !finder.by_guides()) ends.by_others.push_back(v);
  }
  std::erase_if(ends.by_guides,
                [&](Index v) { return std::binary_search(ends.by_others.begin(), ends.by_others.end(), v); });
  return ends;
}

std::size_t cut_wide_sectors(FeatureLines& lines, const FeatureLines& guides, double angle, const base::Host& host) {
  constexpr double widest = 300;                       // degrees
  constexpr double first_part = 0.3, last_part = 0.7;  // of a sector, that the cut begins between
  constexpr double degrees_per_edge = 30;              // off the middle, that cost as much as an edge
  std::size_t cuts = 0;
  WayFinder finder(lines, guides, host);
  const Connectivity& connectivity = lines.connectivity();
  const auto positions = lines.positions();
  for (Index v = 0; v < positions.size(); ++v) {
    if (v % 4096 == 0) host.report("features", 0, 0);
    if (!lines.is_corner(v, angle)) continue;
    for (const Sector& sector : sectors_at(v, lines)) {
      if (sector.angle < widest) continue;
      finder.keep_off(v);
      lines.for_each(v, [&](Index h) { lines.follow(h, [&](Index way) { finder.keep_off(connectivity.end(way)); }); });
      for (const Sector::Spoke& spoke : sector.spokes) {
        const double part = spoke.angle / sector.angle;
        if (part <= first_part || part >= last_part || lines.degree(connectivity.end(spoke.half_edge)) > 0) continue;
        const double length = (positions[connectivity.end(spoke.half_edge)] - positions[v]).norm();
        finder.offer(spoke.half_edge, length * std::abs(spoke.angle - sector.angle / 2) / degrees_per_edge);
      }
      if (finder.add_way(v, false)) ++cuts;
    }
  }
  return cuts;
}

}  // namespace orbicube::mesh
