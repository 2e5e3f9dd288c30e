#include "sphere_map/hierarchy/vertex_rings.h"

#include <algorithm>
#include <utility>

#include "base/grouping.h"

namespace orbicube::sphere_map {

VertexRings::VertexRings(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host)
    : places_(vertex_count, host.memory), pool_(host.memory) {
  const auto report = [&](std::size_t step) {
    if (step % 65536 == 0) host.report("rings", step, 0);
  };
  std::pmr::memory_resource* const memory = host.memory;
  // For each vertex the pairs (a, b) of its triangles (vertex, a, b), then a walk from each a to its b.
  const auto for_each_corner = [&](const auto& visit) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const Triangle& t = triangles[k];
      for (std::size_t i = 0; i < 3; ++i)
        visit(t[i], std::array<Index, 2>{t[(i + 1) % 3], t[(i + 2) % 3]});
      report(k);
    }
  };
  const base::Groups<std::array<Index, 2>> pairs(vertex_count, for_each_corner, memory);
  pool_.resize(pairs.all().size());
  Array<Index> successor(vertex_count, memory);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto valence = static_cast<Index>(pairs.size(v));
    places_[v] = {pairs.begin(v), valence, valence};
    report(v);
    if (valence == 0) continue;
    for (const auto& [from, to] : pairs[v])
      successor[from] = to;
    Index neighbor = pairs[v].front()[0];
    for (std::size_t i = 0; i < valence; ++i, neighbor = successor[neighbor])
      pool_[pairs.begin(v) + i] = neighbor;
  }
}

std::size_t VertexRings::find(Index vertex, Index neighbor) const {
  const auto r = (*this)[vertex];
  return static_cast<std::size_t>(std::find(r.begin(), r.end(), neighbor) - r.begin());
}

bool VertexRings::adjacent(Index a, Index b) const {
  if (valence(a) > valence(b)) std::swap(a, b);
  return find(a, b) < valence(a);
}

void VertexRings::move_ring(Index vertex, std::size_t begin, std::size_t capacity) {
  Place& place = places_[vertex];
  std::copy_n(pool_.begin() + static_cast<std::ptrdiff_t>(place.begin), place.size,
              pool_.begin() + static_cast<std::ptrdiff_t>(begin));
  place.begin = begin;
  place.capacity = static_cast<Index>(capacity);
}

void VertexRings::reserve(Index vertex, std::size_t size) {
  if (size <= places_[vertex].capacity) return;
  const std::size_t capacity = grown_capacity(places_[vertex], size);
  const std::size_t begin = pool_.size();
  pool_.resize(begin + capacity);
  move_ring(vertex, begin, capacity);
}

VertexRings::Room VertexRings::set_aside(std::size_t size) {
  const std::size_t begin = pool_.size();
  pool_.reserve(begin + size);
  pool_.resize(begin + size);
  return {begin, begin + size};
}

bool VertexRings::make_room(Index removed, Index kept, Room& room) {
  const std::size_t size = valence(kept) + valence(removed) - 3;
  if (size <= places_[kept].capacity) return true;
  const std::size_t capacity = grown_capacity(places_[kept], size);
  if (room.end - room.begin < capacity) return false;
  move_ring(kept, room.begin, capacity);
  room.begin += capacity;
  return true;
}

void VertexRings::renumber(std::span<const Index> number) {
  Array<Place> places(places_.size(), places_.get_allocator());
  for (std::size_t v = 0; v < places_.size(); ++v)
    places[number[v]] = places_[v];
  places_ = std::move(places);
  for (Index& neighbor : pool_)
    neighbor = number[neighbor];
}

void VertexRings::start_with(Index vertex, Index neighbor) {
  Index* r = ring(vertex);
  std::rotate(r, r + find(vertex, neighbor), r + valence(vertex));
}

void VertexRings::erase(Index vertex, std::size_t position) {
  Place& place = places_[vertex];
  Index* r = ring(vertex);
  std::copy(r + position + 1, r + place.size, r + position);
  --place.size;
}

void VertexRings::insert(Index vertex, std::size_t position, Index neighbor) {
  reserve(vertex, places_[vertex].size + std::size_t{1});
  Place& place = places_[vertex];
  Index* r = ring(vertex);
  std::copy_backward(r + position, r + place.size, r + place.size + 1);
  r[position] = neighbor;
  ++place.size;
}

void VertexRings::collapse(const Collapse& collapse, std::span<const Index> ring_of_removed) {
  const auto [removed, kept, begin, size] = collapse;
  // ring_of_removed = kept, left, inner..., right: the triangles (removed, kept, left) and (removed, right, kept)
  // vanish, and in the ring of `kept` the inner vertices take the place of `removed`.
  const std::span<const Index> inner = ring_of_removed.subspan(2, size - std::size_t{3});
  const Index left = ring_of_removed[1];
  const Index right = ring_of_removed[size - std::size_t{1}];
  const std::size_t position = find(kept, removed);
  reserve(kept, valence(kept) + inner.size());
  Place& place = places_[kept];
  Index* r = ring(kept);
  if (inner.empty()) {
    std::copy(r + position + 1, r + place.size, r + position);
  } else {
    std::copy_backward(r + position + 1, r + place.size, r + place.size + inner.size() - 1);
  }
  std::copy(inner.begin(), inner.end(), r + position);
  place.size = static_cast<Index>(place.size + inner.size() - 1);
  erase(left, find(left, removed));
  erase(right, find(right, removed));
  for (const Index v : inner)
    ring(v)[find(v, removed)] = kept;
}

void VertexRings::split(const Collapse& collapse, std::span<const Index> ring_of_removed) {
  const auto [removed, kept, begin, size] = collapse;
  const std::span<const Index> inner = ring_of_removed.subspan(2, size - std::size_t{3});
  const Index left = ring_of_removed[1];
  const Index right = ring_of_removed[size - std::size_t{1}];
  Place& place = places_[kept];
  Index* r = ring(kept);
  // Bring `left` to the front: then the inner vertices follow it and `right` follows them.
  std::rotate(r, r + find(kept, left), r + place.size);
  if (inner.empty()) {
    insert(kept, 1, removed);
  } else {
    r[1] = removed;
    std::copy(r + 1 + inner.size(), r + place.size, r + 2);
    place.size = static_cast<Index>(place.size - (inner.size() - 1));
  }
  insert(left, find(left, kept), removed);
  insert(right, find(right, kept) + 1, removed);
  for (const Index v : inner)
    ring(v)[find(v, kept)] = removed;
}

}  // namespace orbicube::sphere_map
