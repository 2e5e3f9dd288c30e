#include "repair/handles/handles.h"

#include <algorithm>
#include <limits>

#include "mesh/topology/connectivity.h"
#include "repair/handles/homology.h"
#include "repair/handles/shortest_loop.h"
#include "repair/holes/fill.h"

namespace orbicube::repair {
namespace {

// How far vertices of a cut move to the mean of their neighbors on their side. Larger: patches are farther apart;
// smaller: less of the surface moves.
constexpr double pull = 0.1;

// Gives the triangles on the left of the loop vertices of their own, behind all others, in the order of the loop.
void open_along(Soup& soup, const mesh::Connectivity& connectivity, const EdgeLoop& loop) {
  const std::size_t n = loop.vertices.size();
  Array<std::array<Index, 2>> corners(soup.memory());  // and their new vertices
  for (std::size_t i = 0; i < n; ++i) {
    const Index v = loop.vertices[i], next = loop.vertices[(i + 1) % n], before = loop.vertices[(i + n - 1) % n];
    const Index copy = soup.add_vertex(Vector3(soup.positions[v]), soup.vertex_source[v]);
    Index h = no_index;
    connectivity.for_each_outgoing(v, [&](Index out) {
      if (connectivity.end(out) == next) h = out;
    });
    // From the edge to the next vertex counter-clockwise to the edge from the vertex before.
    while (h != no_index && connectivity.end(h) != before) {
      corners.push_back({h, copy});
      h = connectivity.opposite(mesh::Connectivity::previous(h));
    }
  }
  for (const auto& [corner, copy] : corners)
    soup.triangles[corner / 3][corner % 3] = copy;
}

// Moves the vertices of both sides toward the mean of their neighbors that are not on the loop. Returns the largest
// move.
double pull_apart(Soup& soup, const EdgeLoop& loop) {
  const std::size_t n = loop.vertices.size(), first = soup.positions.size() - n;
  Array<Index> number(soup.positions.size(), no_index, soup.memory());
  for (Index i = 0; i < n; ++i) {
    number[loop.vertices[i]] = i;
    number[first + i] = static_cast<Index>(n) + i;
  }
  Array<Vector3> sum(2 * n, Vector3::Zero(), soup.memory());
  Array<Index> count(2 * n, 0, soup.memory());
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) {
      if (number[v] == no_index) continue;
      for (const Index w : t) {
        if (number[w] != no_index) continue;
        sum[number[v]] += soup.positions[w] - soup.positions[v];
        ++count[number[v]];
      }
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    if (count[i] == 0) continue;
    const Vector3 move = pull * sum[i] / static_cast<double>(count[i]);
    soup.positions[i < n ? loop.vertices[i] : first + i - n] += move;
    largest = std::max(largest, move.norm());
  }
  return largest;
}

}  // namespace

HandleFigures cut_handles(Soup& soup, const HandleOptions& options, const Context& context) {
  HandleFigures figures;
  if (options.max_genus < 0 && !(options.max_length > 0)) return figures;
  const double limit = options.max_length > 0 ? options.max_length : std::numeric_limits<double>::infinity();
  while (true) {
    EdgeLoop loop(soup.memory());
    {
      const mesh::Connectivity connectivity(soup.positions.size(), soup.triangles, context.host);
      const Homology homology = homology_codes(soup, connectivity, context.host);
      if (homology.genus == 0 || homology.genus <= options.max_genus) return figures;
      loop = shortest_loop(soup, connectivity, homology.codes, limit, context.host);
      if (loop.vertices.empty()) return figures;
      open_along(soup, connectivity, loop);
    }
    Vector3 place = Vector3::Zero();
    for (const Index v : loop.vertices)
      place += soup.positions[v] / static_cast<double>(loop.vertices.size());
    context.record(Action::cut_handle, place, loop.length, loop.vertices.size());
    figures.largest_move = std::max(figures.largest_move, pull_apart(soup, loop));
    Array<Event> unused(soup.memory());
    const HoleFigures patches =
        fill_holes(soup, {.max_edges = 0, .fair = false}, {context.host, unused, context.counted});
    figures.triangles += patches.triangles;
    figures.longest = std::max(figures.longest, loop.length);
    ++figures.cut;
  }
}

}  // namespace orbicube::repair
