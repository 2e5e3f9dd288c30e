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

// body(i) for every i in [0, count). An item should take no more than a few microseconds, so that cancelling is prompt.
template <class Body>
void for_each_in_pieces(std::size_t count, const char* phase, const Host& host, const Body& body) {
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

}  // namespace orbicube::base
