// Loops over many items on threads, which the host hears of.
#pragma once

#include <algorithm>

#include "base/host.h"

namespace orbicube::base {

// body(begin, end) for pieces of [0, count), `piece` items each, in any order and on any thread, with reports of
// `phase` in between.
template <class Body>
void parallel_pieces(const Host& host, const char* phase, std::size_t count, std::size_t piece, const Body& body) {
  constexpr std::size_t pieces_at_once = 16;
  const std::size_t pieces = (count + piece - 1) / piece;
  for (std::size_t first = 0; first < pieces; first += pieces_at_once) {
    host.report(phase, 0, 0);
    host.parallel_for(std::min(pieces_at_once, pieces - first),
                      [&](std::size_t p) { body((first + p) * piece, std::min(count, (first + p + 1) * piece)); });
  }
}

}  // namespace orbicube::base
