#include "repair/handles/shortest_loop.h"

#include <algorithm>
#include <limits>

#include "base/heap.h"

namespace orbicube::repair {
namespace {

struct Entry {
  double distance;
  Index vertex;
  bool operator>(const Entry& o) const { return distance != o.distance ? distance > o.distance : vertex > o.vertex; }
};

class Search {
 public:
  Search(const Soup& soup, const mesh::Connectivity& connectivity, std::span<const std::uint64_t> codes, double limit,
         const base::Host& host)
      : soup_(soup),
        connectivity_(connectivity),
        codes_(codes),
        host_(host),
        distance_(soup.positions.size(), std::numeric_limits<double>::infinity(), host.memory),
        code_(soup.positions.size(), 0, host.memory),
        before_(soup.positions.size(), no_index, host.memory),
        settled_(soup.positions.size(), 0, host.memory),
        touched_(host.memory),
        open_(host.memory),
        best_(host.memory) {
    best_.length = limit;
  }

  EdgeLoop run() {
    Array<std::uint8_t> roots(soup_.positions.size(), 0, host_.memory);
    for (Index h = 0; h < codes_.size(); ++h) {
      if (codes_[h] != 0) roots[std::min(connectivity_.start(h), connectivity_.end(h))] = 1;
    }
    for (Index v = 0; v < roots.size(); ++v) {
      if (roots[v] == 0) continue;
      host_.report("finding the shortest loop", v, roots.size());
      from(v);
    }
    if (best_.vertices.empty()) best_.length = 0;
    return best_;
  }

 private:
  double length(Index h) const {
    return (soup_.positions[connectivity_.end(h)] - soup_.positions[connectivity_.start(h)]).norm();
  }

  void from(Index root) {
    reach(root, 0, 0, no_index);
    std::size_t count = 0;
    while (!open_.empty()) {
      if (++count % 4096 == 0) host_.report("finding the shortest loop", root, soup_.positions.size());
      const Entry entry = open_.pop();
      const Index v = entry.vertex;
      if (settled_[v] != 0 || entry.distance > distance_[v]) continue;
      if (!(2 * entry.distance < best_.length)) break;
      settled_[v] = 1;
      connectivity_.for_each_outgoing(v, [&](Index h) {
        const Index to = connectivity_.end(h);
        const std::uint64_t code = code_[v] ^ codes_[h];
        if (settled_[to] != 0) {
          if (to != before_[v] && code != code_[to]) close(v, to, entry.distance + length(h) + distance_[to]);
        } else if (entry.distance + length(h) < distance_[to]) {
          reach(to, entry.distance + length(h), code, v);
        }
      });
    }
    for (const Index v : touched_) {
      distance_[v] = std::numeric_limits<double>::infinity();
      settled_[v] = 0;
    }
    touched_.clear();
    open_.clear();
  }

  void reach(Index v, double distance, std::uint64_t code, Index before) {
    if (distance_[v] == std::numeric_limits<double>::infinity()) touched_.push_back(v);
    distance_[v] = distance;
    code_[v] = code;
    before_[v] = before;
    open_.push({distance, v});
  }

  // The loop through the edge from u to w and back over the paths to the root, without what both have in common.
  void close(Index u, Index w, double length_with_tail) {
    Array<Index> left(host_.memory), right(host_.memory);
    for (Index v = u; v != no_index; v = before_[v])
      left.push_back(v);
    for (Index v = w; v != no_index; v = before_[v])
      right.push_back(v);
    std::size_t common = 0;
    while (common < left.size() && common < right.size() &&
           left[left.size() - 1 - common] == right[right.size() - 1 - common])
      ++common;
    const double tail = distance_[left[left.size() - common]];
    const double length = length_with_tail - 2 * tail;
    if (!(length < best_.length) || left.size() + right.size() + 1 < 2 * common + 3) return;
    best_.length = length;
    best_.vertices.clear();
    best_.vertices.insert(best_.vertices.end(), left.begin(), left.end() - static_cast<std::ptrdiff_t>(common - 1));
    right.resize(right.size() - common);
    best_.vertices.insert(best_.vertices.end(), right.rbegin(), right.rend());
  }

  const Soup& soup_;
  const mesh::Connectivity& connectivity_;
  std::span<const std::uint64_t> codes_;
  const base::Host& host_;
  Array<double> distance_;
  Array<std::uint64_t> code_;  // of the path to the root
  Array<Index> before_;
  Array<std::uint8_t> settled_;
  Array<Index> touched_;
  base::Heap<Entry> open_;
  EdgeLoop best_;
};

}  // namespace

EdgeLoop shortest_loop(const Soup& soup, const mesh::Connectivity& connectivity, std::span<const std::uint64_t> codes,
                       double limit, const base::Host& host) {
  return Search(soup, connectivity, codes, limit, host).run();
}

}  // namespace orbicube::repair
