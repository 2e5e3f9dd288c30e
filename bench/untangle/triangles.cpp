// A hundred flat meshes of up to 50000 triangles, of four kinds, untangled with one setting: inverted before and after
// by exact signs, steps, and seconds of all processors; and beside them those of a peer (peer_content.h).
//
//     bench-untangle-triangles [first case [last case [maximum steps of the peer]]]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "bench/untangle/peer_content.h"
#include "tests/untangle/flat_cases.h"
#include "untangle/triangles/untangle_triangles.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

// Cases 0 to 99, 25 of each kind, from small to large.
test::FlatCase make(std::size_t number) {
  const std::size_t kind = number / 25, i = number % 25;
  const double t = static_cast<double>(i) / 24;
  const int edge = static_cast<int>(4 + t * t * 154);
  if (kind == 0) return test::strewn(edge, i);
  if (kind == 1) {
    const int rows = 3 + static_cast<int>(t * 67);
    return test::bent(5 * rows, rows, (0.5 + 1.4 * static_cast<double>(i % 5) / 4) * std::numbers::pi, 0.3 * rows, i);
  }
  if (kind == 2) return test::bump(edge, 0.3 + static_cast<double>(i % 5), i);
  return test::swirled(edge, (1 + static_cast<double>(i % 6)) * std::numbers::pi);
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t first = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const std::size_t last = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 99;
  const std::size_t peer_steps = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 2000;
  std::printf("%4s %-8s %8s %8s %8s %6s %6s %10s %8s %8s | %8s %6s %8s\n", "case", "kind", "tris", "before", "after",
              "steps", "polish", "min det", "energy", "s", "peer", "steps", "s");
  std::size_t good = 0, peer_good = 0, count = 0;
  for (std::size_t i = first; i <= last && i < 100; ++i) {
    const test::FlatCase c = make(i);
    std::clock_t start = std::clock();
    const UntangledTriangles result = untangle_triangles(c.mesh(), {}, base::Host());
    std::printf("%4zu %-8s %8zu %8zu %8zu %6zu %6zu %10.3g %8.3f %8.2f", i, c.name.c_str(), c.triangles.size(),
                result.inverted_before, result.inverted, result.steps, result.polish_steps, result.min_determinant,
                result.energy, seconds_since(start));
    std::fflush(stdout);
    ++count;
    good += result.inverted == 0;
    if (peer_steps > 0) {
      start = std::clock();
      const bench::PeerResult peer = bench::PeerContent(c).minimize(peer_steps);
      std::printf(" | %8zu %6zu %8.2f", peer.inverted, peer.steps, seconds_since(start));
      peer_good += peer.inverted == 0;
    }
    std::printf("\n");
  }
  std::printf("%zu of %zu without inverted triangles; the peer: %zu\n", good, count, peer_good);
  return good == count ? 0 : 1;
}
