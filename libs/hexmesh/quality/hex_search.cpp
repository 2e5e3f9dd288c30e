#include "hexmesh/quality/hex_search.h"

#include <algorithm>

#include "hexmesh/quality/hex_moves.h"

namespace orbicube::hexmesh {
namespace {

constexpr double floor_of_snapping = 0.15;

class Search {
 public:
  Search(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options, const base::Host& host)
      : mesh_(mesh), boundary_(boundary), options_(options), host_(host), moves_(mesh, boundary, host) {}

  // Vertices that are on the surface by as much as their hexahedra allow, which are to stay as good as `floor`. Returns
  // how many are not there.
  std::size_t snap(double floor) {
    std::size_t left = 0, count = 0;
    for (const Index v : boundary_.vertices()) {
      if (count++ % 64 == 0) host_.report("snap", count, boundary_.vertices().size());
      Vector3& x = mesh_.positions[v];
      const Vector3 from = x;
      const Vector3 to = boundary_.project(v, from).position;
      if (from == to) continue;
      const double before = std::min(moves_.worst_around(v, HexMoves::lowest), floor);
      bool done = false;
      for (const double part : {1.0, 0.5, 0.25}) {
        x = part == 1 ? to : Vector3(from + part * (to - from));
        if (moves_.worst_around(v, before) >= before) {
          done = part == 1;
          break;
        }
        x = from;
      }
      left += !done;
    }
    return left;
  }

  // What the search has won is not to be lost: places on a raised surface move a little each time.
  std::size_t snap_without_loss() {
    const double won = std::max(floor_of_snapping, moves_.worst());
    snap(won);
    return snap(won);
  }

  // The worst hexahedra, by moves of their vertices that make the worst around each better.
  void improve() {
    Array<std::pair<double, Index>> order(mesh_.hexahedra.size(), host_.memory);
    // Of all hexahedra, as of the last pass; few change in each.
    Array<double> qualities(order.size(), 0, host_.memory);
    Array<std::uint8_t> changed(order.size(), 1, host_.memory);
    Array<Index> vertices(host_.memory);
    const auto most = std::min(
        order.size(),
        std::max<std::size_t>(30, static_cast<std::size_t>(options_.part * static_cast<double>(order.size()))));
    double radius = 0.2;
    const Array<Vector3> start(mesh_.positions, host_.memory);
    for (int pass = 0; pass < options_.passes; ++pass, radius = std::max(0.01, 0.93 * radius)) {
      for (Index i = 0; i < order.size(); ++i) {
        if (i % 1024 == 0) report("improve", pass, options_.passes);
        if (changed[i] != 0) qualities[i] = moves_.quality(i, HexMoves::lowest);
        changed[i] = 0;
        order[i] = {qualities[i], i};
      }
      std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end());
      vertices.clear();
      for (std::size_t i = 0; i < most; ++i) {
        for (const Index v : mesh_.hexahedra[order[i].second])
          vertices.push_back(v);
      }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (const Index v : vertices) {
        report("improve", pass, options_.passes);
        HexMoves::Range range{start[v]};
        if (held(v)) range.reach = options_.reach;
        if (!moves_.try_better_places(v, radius, range)) continue;
        for (const Index i : moves_.around(v))
          changed[i] = 1;
      }
    }
  }

  // All hexahedra on average, by moves after which the sum of the scaled Jacobians around a vertex is greater. The
  // worst around it may become less good as long as it stays good, and better than the worst of the mesh.
  void raise_mean() {
    constexpr double nothing_to_gain = 0.985;
    const double kept = std::max(options_.kept, moves_.worst());
    const Array<Vector3> start(mesh_.positions, host_.memory);
    double radius = 0.2;
    for (int pass = 0; pass < options_.mean_passes; ++pass, radius *= 0.85) {
      for (Index v = 0; v < mesh_.positions.size(); ++v) {
        if (v % 64 == 0) report("raise", pass, options_.mean_passes);
        double sum = moves_.sum_around(v);
        if (sum >= nothing_to_gain * static_cast<double>(moves_.around(v).size())) continue;
        const double floor = std::min(kept, moves_.worst_around(v, HexMoves::lowest));
        const double reach = held(v) ? std::min(options_.reach, options_.mean_reach) : options_.mean_reach;
        moves_.try_places(v, radius, {start[v], reach}, [&] {
          const double now = moves_.sum_around(v);
          const bool better = now > sum + HexMoves::min_gain && moves_.worst_around(v, floor) >= floor;
          if (better) sum = now;
          return better;
        });
      }
    }
  }

 private:
  void report(const char* phase, int pass, int passes) const {
    host_.report(phase, static_cast<std::uint64_t>(pass), static_cast<std::uint64_t>(passes));
  }

  bool held(Index v) const { return options_.all || boundary_.hold(v) > 1; }

  HexMesh& mesh_;
  const HexBoundary& boundary_;
  const HexSearchOptions& options_;
  const base::Host& host_;
  HexMoves moves_;
};

}  // namespace

std::size_t search_hexahedra(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                             const base::Host& host) {
  Search search(mesh, boundary, options, host);
  for (int k = 0; k < 3; ++k)
    search.snap(floor_of_snapping);
  search.improve();
  return search.snap_without_loss();
}

std::size_t raise_mean(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                       const base::Host& host) {
  Search search(mesh, boundary, options, host);
  search.raise_mean();
  return search.snap_without_loss();
}

}  // namespace orbicube::hexmesh
