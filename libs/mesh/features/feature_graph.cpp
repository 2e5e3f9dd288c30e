#include "mesh/features/feature_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "mesh/features/feature_lines.h"
#include "mesh/features/feature_repairs.h"
#include "mesh/features/weak_lines.h"

namespace orbicube::mesh {
namespace {

using Chain = std::vector<Index>;  // of vertices along a line

class Builder {
 public:
  Builder(const FeatureLines& lines, double angle, std::span<const Index> ends, std::span<const Triangle> triangles,
          FeatureGraph& graph, const base::Host& host)
      : lines_(lines),
        angle_(angle),
        triangles_(triangles),
        graph_(graph),
        host_(host),
        corner_(lines.positions().size(), no_index, host.memory) {
    for (const Index v : ends)
      add_corner(v, false);
  }

  void run(double shortest_side) {
    for (Index v = 0; v < corner_.size(); ++v) {
      if (!lines_.is_corner(v, angle_) || corner_[v] != no_index) continue;
      if (has_short_side(v, shortest_side))
        graph_.bends.push_back(v);
      else
        add_corner(v, false);
    }
    find_patches();
    take_chains();
    order_ends();
    measure_patches();
  }

 private:
  Index vertex_count() const { return static_cast<Index>(corner_.size()); }

  // Whether a line only bends there and does so again, ends or branches nearer than `shortest`.
  bool has_short_side(Index v, double shortest) const {
    if (shortest == 0 || lines_.degree(v) != 2) return false;
    bool result = false;
    lines_.for_each(v, [&](Index side) {
      double length = 0;
      bool open = true;
      lines_.follow(side, [&](Index h) {
        if (!open) return;
        const Index at = lines_.connectivity().end(h);
        length += (lines_.positions()[at] - lines_.positions()[lines_.connectivity().start(h)]).norm();
        open = length < shortest && !lines_.is_corner(at, angle_);
      });
      result = result || length < shortest;
    });
    return result;
  }

  void add_corner(Index v, bool soft) {
    if (corner_[v] != no_index) return;
    corner_[v] = static_cast<Index>(graph_.corners.size());
    graph_.corners.push_back({v, soft});
  }

  void find_patches() {
    graph_.patches.assign(triangles_.size(), no_index);
    Array<Index> open(host_.memory);
    Index count = 0;
    for (Index first = 0; first < triangles_.size(); ++first) {
      if (graph_.patches[first] != no_index) continue;
      host_.report("features", 0, 0);
      graph_.patches[first] = count;
      open.push_back(first);
      while (!open.empty()) {
        const Index t = open.back();
        open.pop_back();
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
          if (lines_.contains(h)) continue;
          const Index beside = triangle_of(lines_.connectivity().opposite(h));
          if (graph_.patches[beside] != no_index) continue;
          graph_.patches[beside] = count;
          open.push_back(beside);
        }
      }
      ++count;
    }
    graph_.euler.assign(count, 0);
  }

  // Lines between corners, then closed ones.
  void take_chains() {
    Array<std::uint8_t> done(3 * triangles_.size(), 0, host_.memory);
    const auto take = [&](Index from) {
      lines_.for_each(from, [&](Index h) {
        if (done[h] != 0) return;
        Chain chain{from};
        for (Index way = h; way != no_index;) {
          done[way] = done[lines_.connectivity().opposite(way)] = 1;
          const Index at = lines_.connectivity().end(way), back = lines_.connectivity().opposite(way);
          chain.push_back(at);
          way = no_index;
          if (at == from || corner_[at] != no_index) break;
          lines_.for_each(at, [&](Index next) {
            if (next != back) way = next;
          });
        }
        add_chain(chain);
      });
    };
    const std::size_t hard = graph_.corners.size();
    for (std::size_t c = 0; c < hard; ++c)
      take(graph_.corners[c].vertex);
    for (Index v = 0; v < vertex_count(); ++v) {
      if (v % 4096 == 0) host_.report("features", 0, 0);
      take(v);
    }
  }

  double length(std::span<const Index> chain) const {
    double sum = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
      sum += (lines_.positions()[chain[i]] - lines_.positions()[chain[i - 1]]).norm();
    return sum;
  }

  // The place of a chain nearest to a part of its length.
  std::size_t place_at(const Chain& chain, double part) const {
    const double whole = length(chain);
    double at = 0, best = whole;
    std::size_t place = 0;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      at += (lines_.positions()[chain[i]] - lines_.positions()[chain[i - 1]]).norm();
      if (std::abs(at - part * whole) < best) {
        best = std::abs(at - part * whole);
        place = i;
      }
    }
    return place;
  }

  // Cuts closed chains into three.
  void add_chain(const Chain& chain) {
    if (chain.front() != chain.back()) return halve(chain);
    add_corner(chain.front(), true);
    std::size_t first = place_at(chain, 1.0 / 3), second = place_at(chain, 2.0 / 3);
    if (second <= first) second = first + 1;
    if (second + 1 >= chain.size()) first = chain.size() - 3, second = chain.size() - 2;
    add_corner(chain[first], true);
    add_corner(chain[second], true);
    const auto at = [&](std::size_t i) { return chain.begin() + static_cast<std::ptrdiff_t>(i); };
    halve(Chain(at(0), at(first + 1)));
    halve(Chain(at(first), at(second + 1)));
    halve(Chain(at(second), chain.end()));
  }

  // Halves chains that are much longer than their chords, so that a path along them cannot take a short cut.
  void halve(const Chain& chain) {
    constexpr double most = 1.8;
    const double chord = (lines_.positions()[chain.front()] - lines_.positions()[chain.back()]).norm();
    if (chain.size() < 4 || length(chain) < most * chord) return add_arc(chain);
    const std::size_t middle = place_at(chain, 0.5);
    add_corner(chain[middle], true);
    halve(Chain(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(middle + 1)));
    halve(Chain(chain.begin() + static_cast<std::ptrdiff_t>(middle), chain.end()));
  }

  void add_arc(const Chain& chain) {
    FeatureArc arc;
    arc.corners = {corner_[chain.front()], corner_[chain.back()]};
    const Index h = lines_.find(chain[0], chain[1]);
    arc.patches = {graph_.patches[triangle_of(h)], graph_.patches[triangle_of(lines_.connectivity().opposite(h))]};
    arc.begin = static_cast<Index>(graph_.vertices.size());
    graph_.vertices.insert(graph_.vertices.end(), chain.begin(), chain.end());
    arc.end = static_cast<Index>(graph_.vertices.size());
    graph_.arcs.push_back(arc);
  }

  void order_ends() {
    // Of each half-edge that begins an arc, twice the arc and its end.
    Array<Index> begins(3 * triangles_.size(), no_index, host_.memory);
    for (Index a = 0; a < graph_.arcs.size(); ++a) {
      const auto v = graph_.vertices_of(graph_.arcs[a]);
      begins[lines_.find(v[0], v[1])] = 2 * a;
      begins[lines_.find(v[v.size() - 1], v[v.size() - 2])] = 2 * a + 1;
    }
    graph_.around.assign(graph_.corners.size(), [&](const auto& visit) {
      for (Index c = 0; c < graph_.corners.size(); ++c)
        lines_.for_each(graph_.corners[c].vertex, [&](Index h) {
          if (begins[h] != no_index) visit(c, FeatureEnd{begins[h] / 2, begins[h] % 2});
        });
    });
  }

  // Vertices, less edges, plus triangles; each patch counts those on its border.
  void measure_patches() {
    Array<Index> beside(host_.memory);
    for (Index v = 0; v < vertex_count(); ++v) {
      if (v % 4096 == 0) host_.report("features", 0, 0);
      beside.clear();
      lines_.connectivity().for_each_outgoing(v, [&](Index h) { beside.push_back(graph_.patches[triangle_of(h)]); });
      std::sort(beside.begin(), beside.end());
      beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
      for (const Index p : beside)
        ++graph_.euler[p];
    }
    for (Index h = 0; h < 3 * triangles_.size(); ++h) {
      const Index own = graph_.patches[triangle_of(h)], other = lines_.connectivity().opposite(h);
      if (h % 3 == 0) ++graph_.euler[own];
      // An edge between two patches belongs to both.
      if (h < other || own != graph_.patches[triangle_of(other)]) --graph_.euler[own];
    }
  }

  const FeatureLines& lines_;
  const double angle_;
  std::span<const Triangle> triangles_;
  FeatureGraph& graph_;
  const base::Host& host_;
  Array<Index> corner_;  // of each vertex
};

constexpr double shortest_end = 0.025;  // of the diagonal: lines that end inside a patch are longer
constexpr double weaker = 0.5;          // of the angle: edges along which a sharp line is continued

double diagonal_of(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  if (triangles.empty()) return 0;
  Vector3 low = positions[triangles[0][0]], high = low;
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  return (high - low).norm();
}

// Returns the lines of edges of `sharp` that are none of `lines`, each by its vertices, from a corner to the next.
// Closed ones are cut somewhere.
Array<Array<Index>> left_out_lines(FeatureLines sharp, const FeatureLines& lines, std::size_t triangles, double angle,
                                   const base::Host& host) {
  Array<Array<Index>> left_out(host.memory);
  const Connectivity& connectivity = lines.connectivity();
  for (Index h = 0; h < 3 * triangles; ++h) {
    if (lines.contains(h) && sharp.contains(h)) sharp.remove(h);
  }
  FeatureLines rest = sharp;
  for (const bool closed : {false, true}) {
    for (Index first = 0; first < 3 * triangles; ++first) {
      if (!rest.contains(first) || (!closed && sharp.degree(connectivity.start(first)) == 2)) continue;
      left_out.emplace_back(1, connectivity.start(first));
      sharp.follow(first, [&](Index h) {
        const Index v = connectivity.end(h);
        rest.remove(h);
        left_out.back().push_back(v);
        if (sharp.degree(v) == 2 && sharp.is_corner(v, angle)) left_out.emplace_back(1, v);
      });
      if (left_out.back().size() == 1) left_out.pop_back();
    }
  }
  return left_out;
}

// Removes edges, and lines that end inside a patch without them.
void leave_out(FeatureLines& lines, std::span<const Edge> edges, const FeatureLines& none, const base::Host& host) {
  for (const auto& [from, end] : edges) {
    const Index h = from < lines.positions().size() ? lines.find(from, end) : no_index;
    if (h != no_index) lines.remove(h);
  }
  while (drop_short_ends(lines, none, std::numeric_limits<double>::infinity(), host)) {
  }
}

}  // namespace

FeatureGraph feature_graph(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const FeatureOptions& options, const base::Host& host) {
  base::require(options.angle > 0 && options.angle < 180, "`feature_angle` must be between 0 and 180 degrees");
  const Connectivity connectivity(positions.size(), triangles, host);
  for (Index h = 0; h < 3 * triangles.size(); ++h) {
    if (connectivity.opposite(h) == no_index) throw base::Error("not-closed", "the surface has a boundary");
  }
  FeatureGraph graph(host.memory);
  FeatureLines lines(positions, connectivity, triangles.size(), host);
  if (options.sharp) lines.add_sharp(options.angle, triangles);
  const auto add = [&](std::span<const Edge> edges, FeatureLines& to) {
    for (const auto& [from, end] : edges) {
      if (from >= positions.size() || end >= positions.size()) continue;
      if (const Index h = lines.find(from, end); h != no_index) to.add(h);
    }
  };
  add(options.edges, lines);
  FeatureLines guides(positions, connectivity, triangles.size(), host);
  add(options.lines, guides);
  if (options.weak_lines) {
    FeatureLines candidates(positions, connectivity, triangles.size(), host);
    for (Index h = 0; h < 3 * triangles.size(); ++h) {
      if (guides.contains(h) && !lines.contains(h)) candidates.add(h);
    }
    add_weak_lines(lines, candidates, triangles, host);
  }
  for (Index h = 0; h < 3 * triangles.size(); ++h) {
    if (!lines.contains(h) || connectivity.opposite(h) < h) continue;
    ++graph.sharp_edges;
    graph.sharp_length += (positions[connectivity.end(h)] - positions[connectivity.start(h)]).norm();
  }
  if (options.sharp) {
    drop_short_ends(lines, guides, shortest_end * diagonal_of(positions, triangles), host);
    guides.add_sharp(options.angle * weaker, triangles);
  }
  ContinuedEnds continued = continue_ends(lines, guides, host);
  Array<Index>& ends = continued.by_others;
  graph.continued = ends.size();
  graph.fades.swap(continued.by_guides);
  graph.cut_sectors = cut_wide_sectors(lines, guides, options.angle, host);
  if (!options.without.empty()) {
    leave_out(lines, options.without, FeatureLines(positions, connectivity, triangles.size(), host), host);
    std::erase_if(ends, [&](Index v) { return lines.degree(v) == 0; });
  }
  for (const Index v : options.corners) {
    if (v < positions.size() && connectivity.outgoing(v) != no_index) ends.push_back(v);
  }
  if (options.sharp) {
    FeatureLines sharp(positions, connectivity, triangles.size(), host);
    sharp.add_sharp(options.angle, triangles);
    graph.left_out = left_out_lines(std::move(sharp), lines, triangles.size(), options.angle, host);
  }
  Builder(lines, options.angle, ends, triangles, graph, host).run(options.shortest_side);
  return graph;
}

}  // namespace orbicube::mesh
