// A loop over many small independent items, on the host's threads in pieces, with reports in between.
#pragma once

#include <algorithm>
#include <cstddef>

#include "base/host.h"

namespace orbicube::sphere_map {

// body(i) for every i in [0, count). An item should take no more than a few microseconds, so that cancelling is prompt.
template <class Body>
void for_each_in_pieces(std::size_t count, const char* phase, const base::Host& host, const Body& body) {
  constexpr std::size_t piece = 1024;
  constexpr std::size_t pieces_at_once = 32;
  for (std::size_t first = 0; first < count; first += piece * pieces_at_once) {
    host.report(phase, first, count);
    const std::size_t end = std::min(count, first + piece * pieces_at_once);
    host.parallel_for((end - first + piece - 1) / piece, [&](std::size_t p) {
      const std::size_t last = std::min(end, first + (p + 1) * piece);
      for (std::size_t i = first + p * piece; i < last; ++i)
        body(i);
    });
  }
}

}  // namespace orbicube::sphere_map
