#include "repair/holes/fill.h"

#include <algorithm>
#include <limits>

#include "base/grouping.h"
#include "mesh/search/intersections.h"
#include "mesh/topology/edge_table.h"
#include "repair/holes/fairing.h"
#include "repair/holes/loops.h"
#include "repair/holes/obstacles.h"
#include "repair/holes/refinement.h"
#include "repair/holes/triangulation.h"

namespace orbicube::repair {
namespace {

// What the surface has around one hole, in numbers of the loop.
struct Surroundings {
  explicit Surroundings(std::pmr::memory_resource* memory)
      : vertices(memory), points(memory), apexes(memory), connected(memory), outside(memory), scales(memory) {}

  Array<Index> vertices;
  Array<Vector3> points, apexes;
  Array<std::array<Index, 2>> connected;
  Array<OuterEdge> outside;
  Array<double> scales;
  double length = 0;
};

// How a patch is laid; each where the one before it meets something.
enum class Laying : std::uint8_t { bent, refined, flat, avoiding };

struct Laid {
  std::size_t first_triangle, end_triangle;
  Surroundings around;
  Laying laying, before;
  Patch avoiding;  // of Laying::avoiding
};

// An edge of a patch between vertices of several holes.
struct SharedEdge {
  Index a, b;
  std::size_t patch;
};

class Filling {
 public:
  Filling(Soup& soup, const HoleOptions& options, const Context& context)
      : soup_(soup), options_(options), context_(context), number_(soup.positions.size(), no_index, soup.memory()) {}

  HoleFigures run() {
    const base::Host& host = context_.host;
    const BoundaryLoops loops = boundary_loops(soup_, host);
    figures_.found = loops.size();
    if (loops.size() == 0) return figures_;
    around_ = base::cells_around<Index, 3>(soup_.triangles, soup_.positions.size(), soup_.memory());
    const std::size_t vertices = soup_.positions.size(), triangles = soup_.triangles.size();
    loops_at_.assign(vertices, 0);
    for (const Index h : loops.half_edges)
      ++loops_at_[mesh::start_of(soup_.triangles, h)];
    Array<Laid> laid(soup_.memory());
    for (std::size_t i = 0; i < loops.size(); ++i) {
      host.report("filling holes", i, loops.size());
      Surroundings around = surroundings(loops[i]);
      const Vector3 place = centre(around.points);
      if (options_.max_edges > 0 && loops[i].size() > options_.max_edges) {
        context_.record(Action::left_hole, place, around.length, loops[i].size());
        continue;
      }
      context_.record(Action::filled_hole, place, around.length, loops[i].size());
      ++figures_.filled;
      const std::size_t first = soup_.triangles.size();
      const Laying laying = options_.fair ? Laying::bent : Laying::flat;
      lay(make(around, laying), around.vertices);
      note_shared_edges({soup_.triangles.begin() + static_cast<std::ptrdiff_t>(first), soup_.triangles.end()},
                        laid.size());
      laid.push_back({first, soup_.triangles.size(), std::move(around), laying, laying, Patch(soup_.memory())});
    }
    lay_again(laid, vertices, triangles);
    figures_.vertices = soup_.positions.size() - vertices;
    figures_.triangles = soup_.triangles.size() - triangles;
    return figures_;
  }

 private:
  static constexpr std::size_t no_patch = std::numeric_limits<std::size_t>::max();

  static Vector3 centre(std::span<const Vector3> points) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& p : points)
      sum += p - points[0];
    return points[0] + sum / static_cast<double>(points.size());
  }

  // `half_edges`: of the faces; the loop passes them the other way.
  Surroundings surroundings(std::span<const Index> half_edges) {
    Surroundings s(soup_.memory());
    const std::size_t n = half_edges.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Index h = half_edges[n - 1 - i];
      const Index v = mesh::end_of(soup_.triangles, h);
      const Index apex = mesh::start_of(soup_.triangles, mesh::next_in_triangle(mesh::next_in_triangle(h)));
      number_[v] = static_cast<Index>(i);
      s.vertices.push_back(v);
      s.points.push_back(soup_.positions[v]);
      s.apexes.push_back(soup_.positions[apex]);
      s.length += (soup_.positions[v] - soup_.positions[mesh::start_of(soup_.triangles, h)]).norm();
    }
    Array<Index> neighbors(soup_.memory());
    for (Index i = 0; i < n; ++i) {
      const Index v = s.vertices[i];
      neighbors.clear();
      for (const Index t : around_[v]) {
        for (const Index w : soup_.triangles[t]) {
          if (w != v) neighbors.push_back(w);
        }
      }
      std::sort(neighbors.begin(), neighbors.end());
      neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
      double sum = 0;
      for (const Index w : neighbors) {
        sum += (soup_.positions[w] - soup_.positions[v]).norm();
        const bool of_loop = number_[w] != no_index;
        if (of_loop && i < number_[w]) s.connected.push_back({i, number_[w]});
        const bool of_boundary = of_loop && (number_[w] == (i + 1) % n || i == (number_[w] + 1) % n);
        if (!of_boundary) s.outside.push_back({i, soup_.positions[w]});
      }
      s.scales.push_back(sum / static_cast<double>(neighbors.size()));
    }
    for (const Index v : s.vertices)
      number_[v] = no_index;
    connect_by_patches(s, no_patch);
    return s;
  }

  // Adds the edges that patches besides the own one have.
  void connect_by_patches(Surroundings& s, std::size_t own) {
    for (Index i = 0; i < s.vertices.size(); ++i)
      number_[s.vertices[i]] = i;
    for (const SharedEdge& e : shared_edges_) {
      const Index i = number_[e.a], k = number_[e.b];
      if (e.patch != own && i != no_index && k != no_index) s.connected.push_back({std::min(i, k), std::max(i, k)});
    }
    std::sort(s.connected.begin(), s.connected.end());
    for (const Index v : s.vertices)
      number_[v] = no_index;
  }

  // Edges of a patch between vertices of several holes, which no other patch may have.
  void note_shared_edges(std::span<const Triangle> triangles, std::size_t patch) {
    for (const Triangle& c : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = c[k], b = c[(k + 1) % 3];
        if (a < loops_at_.size() && b < loops_at_.size() && loops_at_[a] > 1 && loops_at_[b] > 1)
          shared_edges_.push_back({a, b, patch});
      }
    }
  }

  Patch make(const Surroundings& around, Laying laying, const Obstacles* obstacles = nullptr) const {
    Patch patch(soup_.memory());
    patch.loop_size = around.points.size();
    patch.points = around.points;
    patch.scales = around.scales;
    Loop loop{.points = around.points, .apexes = around.apexes, .connected = around.connected};
    if (obstacles != nullptr) {
      loop.avoids = [&](const Triangle& t) {
        return obstacles->meet({around.vertices[t[0]], around.vertices[t[1]], around.vertices[t[2]]});
      };
    }
    patch.triangles = triangulate(loop, context_.host);
    const bool closes_itself = patch.triangles.size() == 1 && around.apexes[0] == around.points[2];
    if (patch.triangles.empty() || closes_itself) make_cone(patch);
    if (laying <= Laying::refined) refine(patch, around.connected, context_.host);
    if (laying == Laying::bent && patch.points.size() > patch.loop_size) fair(patch, around.outside, context_.host);
    return patch;
  }

  // All edges of it are new, whatever the surface has.
  static void make_cone(Patch& patch) {
    const auto n = static_cast<Index>(patch.loop_size);
    patch.triangles.clear();
    patch.points.push_back(centre({patch.points.data(), n}));
    double sum = 0;
    for (Index i = 0; i < n; ++i)
      sum += patch.scales[i];
    patch.scales.push_back(sum / n);
    for (Index i = 0; i < n; ++i)
      patch.triangles.push_back({i, (i + 1) % n, n});
  }

  void lay(const Patch& patch, std::span<const Index> loop) {
    const std::size_t first = soup_.positions.size();
    for (std::size_t i = patch.loop_size; i < patch.points.size(); ++i)
      soup_.add_vertex(patch.points[i], no_index);
    for (Triangle t : patch.triangles) {
      for (Index& v : t)
        v = v < patch.loop_size ? loop[v] : static_cast<Index>(first + v - patch.loop_size);
      soup_.add_triangle(t, no_index);
    }
  }

  // Lays patches that meet something without bending, those that still do without refinement, and at last of the
  // triangles that meet the fewest others, if that is better.
  void lay_again(std::span<Laid> laid, std::size_t vertices, std::size_t triangles) {
    Array<std::size_t> before(soup_.memory());
    for (const Laying laying : {Laying::refined, Laying::flat, Laying::avoiding}) {
      if (!options_.fair && laying != Laying::avoiding) continue;
      const Array<std::size_t> meetings = count_meetings(laid);
      Array<std::uint8_t> again(laid.size(), 0, soup_.memory());
      for (std::size_t i = 0; i < laid.size(); ++i)
        again[i] = static_cast<std::uint8_t>(meetings[i] > 0);
      if (std::none_of(again.begin(), again.end(), [](std::uint8_t a) { return a != 0; })) return;
      if (laying == Laying::avoiding) make_avoiding(laid, again);
      for (std::size_t i = 0; i < laid.size(); ++i) {
        laid[i].before = laid[i].laying;
        if (again[i] != 0) laid[i].laying = laying;
      }
      lay_all(laid, vertices, triangles);
      before = meetings;
    }
    take_back(laid, before, vertices, triangles);
  }

  // Patches that meet no less than before are laid as before.
  void take_back(std::span<Laid> laid, std::span<const std::size_t> before, std::size_t vertices,
                 std::size_t triangles) {
    const auto avoids = [](const Laid& l) { return l.laying == Laying::avoiding; };
    if (std::none_of(laid.begin(), laid.end(), avoids)) return;
    const Array<std::size_t> meetings = count_meetings(laid);
    bool any = false;
    for (std::size_t i = 0; i < laid.size(); ++i) {
      if (!avoids(laid[i]) || meetings[i] < before[i]) continue;
      laid[i].laying = laid[i].before;
      any = true;
    }
    if (any) lay_all(laid, vertices, triangles);
  }

  void make_avoiding(std::span<Laid> laid, std::span<const std::uint8_t> again) {
    Array<std::uint8_t> obstacle(soup_.triangles.size(), 1, soup_.memory());
    shared_edges_.clear();
    for (std::size_t i = 0; i < laid.size(); ++i) {
      const std::size_t first = laid[i].first_triangle, count = laid[i].end_triangle - first;
      if (again[i] != 0) std::fill_n(obstacle.begin() + static_cast<std::ptrdiff_t>(first), count, std::uint8_t{0});
      note_shared_edges({soup_.triangles.data() + first, count}, i);
    }
    const Obstacles obstacles(soup_.positions, soup_.triangles, obstacle, context_.host);
    for (std::size_t i = 0; i < laid.size(); ++i) {
      if (again[i] == 0) continue;
      Surroundings around = laid[i].around;
      connect_by_patches(around, i);
      laid[i].avoiding = make(around, Laying::avoiding, &obstacles);
      Array<Triangle> triangles = laid[i].avoiding.triangles;
      for (Triangle& t : triangles) {
        for (Index& v : t)
          v = v < around.vertices.size() ? around.vertices[v] : no_index;
      }
      note_shared_edges(triangles, i);
    }
  }

  // `vertices`, `triangles`: numbers of those without any patch.
  void lay_all(std::span<Laid> laid, std::size_t vertices, std::size_t triangles) {
    soup_.positions.resize(vertices);
    soup_.vertex_source.resize(vertices);
    soup_.triangles.resize(triangles);
    soup_.triangle_source.resize(triangles);
    for (Laid& l : laid) {
      l.first_triangle = soup_.triangles.size();
      lay(l.laying == Laying::avoiding ? l.avoiding : make(l.around, l.laying), l.around.vertices);
      l.end_triangle = soup_.triangles.size();
    }
  }

  // For each patch, the number of its triangles' meetings with others; within the patch each counts twice.
  Array<std::size_t> count_meetings(std::span<const Laid> laid) const {
    Array<std::size_t> count(laid.size(), 0, soup_.memory());
    const auto pairs = mesh::intersecting_triangles(soup_.positions, soup_.triangles, context_.host);
    for (const auto& pair : pairs) {
      for (const Index t : pair) {
        const auto at = std::upper_bound(laid.begin(), laid.end(), t,
                                         [](Index triangle, const Laid& l) { return triangle < l.first_triangle; });
        if (at != laid.begin() && t < (at - 1)->end_triangle) ++count[static_cast<std::size_t>(at - 1 - laid.begin())];
      }
    }
    return count;
  }

  Soup& soup_;
  const HoleOptions& options_;
  const Context& context_;
  Array<Index> number_;  // of the vertices of the loop at hand
  base::Groups<Index, Index> around_{soup_.memory()};
  Array<Index> loops_at_{soup_.memory()};  // number of loops through each vertex
  Array<SharedEdge> shared_edges_{soup_.memory()};
  HoleFigures figures_;
};

}  // namespace

HoleFigures fill_holes(Soup& soup, const HoleOptions& options, const Context& context) {
  return Filling(soup, options, context).run();
}

}  // namespace orbicube::repair
