#include "polycube/layout/arc_routes.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "polycube/layout/handle_loops.h"

namespace orbicube::polycube {
namespace {

// A path may go this far from its guide, in parts of the surface's diagonal, for four times the cost of its length.
constexpr double guide_width = 0.08, guide_strength = 3;

}  // namespace

ArcRoutes::ArcRoutes(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, LayoutDrawing& drawing,
                     const base::Host& host)
    : layout_(layout),
      guide_(guide),
      surface_(surface),
      drawing_(drawing),
      host_(host),
      search_(surface, host),
      starts_(host.memory),
      ends_(host.memory) {}

// Length, more expensive far from the line that guides the arc and where the surface has been split for other arcs.
auto ArcRoutes::guided_cost(Index arc) const {
  return [&surface = surface_, &level = drawing_.levels(), diagonal = drawing_.diagonal(),
          &line = guide_.arc[arc]](Index h) {
    const Index v = surface.start(h), w = surface.end(h);
    const Vector3 middle = 0.5 * (surface.position[v] + surface.position[w]);
    double squared = PathSearch::infinite;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vector3 from = middle - line[i], along = line[i + 1] - line[i];
      const double length = along.squaredNorm();
      const double t = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
      squared = std::min(squared, (from - t * along).squaredNorm());
    }
    const double off = std::sqrt(squared) / (guide_width * diagonal);
    const double split = std::max(level[v], level[w]);
    return (surface.length(h) + 1e-9 * diagonal) * (1 + guide_strength * off * off) * (1 + 0.5 * split * split);
  };
}

void ArcRoutes::set_sectors(Index arc) {
  drawing_.sector(2 * arc, starts_);
  drawing_.sector(2 * arc + 1, ends_);
}

double ArcRoutes::find(Index arc, bool generator) {
  Array<Index>& path = drawing_.path(arc);
  set_sectors(arc);
  const double cost = search_.find(first_vertex(arc), starts_, last_vertex(arc), ends_, {}, guided_cost(arc), path);
  if (cost == PathSearch::infinite) throw base::Error("internal", "no way for an edge of the polycube");
  if (!generator) return cost;
  return leaves_sides_connected(arc, path) ? cost : find_generator(arc, path);
}

bool ArcRoutes::leaves_sides_connected(Index arc, std::span<const Index> path) {
  drawing_.mark(arc, path, true);
  const bool connected = drawing_.sides_connected(path);
  drawing_.mark(arc, path, false);
  return connected;
}

// Sets the cheapest path found that does not separate the surface; returns its cost.
double ArcRoutes::find_generator(Index arc, Array<Index>& path) {
  const Index from = first_vertex(arc), to = last_vertex(arc);
  set_sectors(arc);
  const auto cost = guided_cost(arc);
  double least = PathSearch::infinite;
  Array<Index> found(host_.memory), best(host_.memory);
  Array<std::pair<double, Array<Index>>> crossing(host_.memory);  // paths that pass a vertex twice
  HandleLoops(surface_, host_).for_each([&](const Array<std::uint8_t>& odd) {
    const double length = search_.find(from, starts_, to, ends_, odd, cost, found);
    if (!(length < least)) return;
    if (first_repeated(found) < found.size()) {
      crossing.emplace_back(length, Array<Index>(found.begin(), found.end(), host_.memory));
      return;
    }
    least = length;
    best = found;
  });
  if (!best.empty()) {
    path = best;
    return least;
  }
  std::stable_sort(crossing.begin(), crossing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [length, twice] : crossing)
    if (open_loop(arc, twice, path)) return length;
  throw base::Error("no-valid-result", "no path was found for an edge that goes around a handle");
}

std::size_t ArcRoutes::first_repeated(std::span<const Index> path) const {
  Array<std::uint8_t> seen(surface_.vertices(), 0, host_.memory);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (seen[path[i]]) return i;
    seen[path[i]] = 1;
  }
  return path.size();
}

// Cuts a path that passes a vertex twice before the second time, and goes on from there by any way that is left.
bool ArcRoutes::open_loop(Index arc, std::span<const Index> twice, Array<Index>& path) {
  const std::size_t cut = first_repeated(twice);
  if (cut < 3) return false;
  const Index to = last_vertex(arc);
  Array<Index> first(twice.begin(), twice.begin() + static_cast<std::ptrdiff_t>(cut), host_.memory);
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    if (surface_.between(first[i], first[i + 1]) == no_index) return false;  // an edge split meanwhile
  const auto show = [&](bool on) {
    drawing_.mark(arc, first, on);
    surface_.occupied[first.back()] = on;
  };
  show(true);
  const std::size_t before = surface_.vertices();
  drawing_.unblock(first);
  Array<Index> tip_starts(host_.memory), rest(host_.memory);
  surface_.for_each_outgoing(first.back(), [&](Index h) {
    if (surface_.arc[h] == no_index) tip_starts.push_back(h);
  });
  drawing_.sector(2 * arc + 1, ends_);
  const double length = search_.find(first.back(), tip_starts, to, ends_, {}, guided_cost(arc), rest);
  show(false);
  if (surface_.vertices() != before) set_sectors(arc);  // half-edges have moved
  if (length == PathSearch::infinite) return false;
  first.insert(first.end(), rest.begin() + 1, rest.end());
  const bool connected = leaves_sides_connected(arc, first);
  if (connected) path = first;
  return connected;
}

}  // namespace orbicube::polycube
