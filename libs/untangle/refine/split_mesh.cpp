#include "untangle/refine/split_mesh.h"

#include <algorithm>
#include <utility>

namespace orbicube::untangle {
namespace {

using Edge = std::array<Index, 2>;

constexpr std::size_t elements_at_once = 8192;

// All faces of all elements, of `size` vertices in ascending order, sorted.
template <std::size_t size, std::size_t corners>
Array<std::array<Index, size>> faces_of(std::span<const std::array<Index, corners>> elements, const base::Host& host) {
  Array<std::array<Index, size>> faces(host.memory);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i % elements_at_once == 0) host.report("refine", 0, 0);
    std::array<Index, corners> e = elements[i];
    std::sort(e.begin(), e.end());
    for (unsigned chosen = 0; chosen < 1U << corners; ++chosen) {
      std::array<Index, size> face;
      std::size_t count = 0;
      for (std::size_t k = 0; k < corners; ++k) {
        if ((chosen >> k & 1U) == 0) continue;
        if (count < size) face[count] = e[k];
        ++count;
      }
      if (count == size) faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  host.report("refine", 0, 0);
  return faces;
}

// The edges of faces that one element alone has, sorted.
template <std::size_t corners>
Array<Edge> boundary_edges(std::span<const std::array<Index, corners>> elements, const base::Host& host) {
  const auto faces = faces_of<corners - 1>(elements, host);
  Array<Edge> edges(host.memory);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if ((i > 0 && faces[i - 1] == faces[i]) || (i + 1 < faces.size() && faces[i + 1] == faces[i])) continue;
    for (std::size_t k = 1; k < corners - 1; ++k)
      for (std::size_t l = 0; l < k; ++l)
        edges.push_back({faces[i][l], faces[i][k]});
  }
  std::sort(edges.begin(), edges.end());
  host.report("refine", 0, 0);
  return edges;
}

template <std::size_t size>
bool all_marked(const std::array<Index, size>& simplex, std::span<const std::uint8_t> marked) {
  return std::all_of(simplex.begin(), simplex.end(), [&](Index v) { return v < marked.size() && marked[v] != 0; });
}

}  // namespace

template <std::size_t corners>
SplitMesh<corners>::SplitMesh(std::span<const Element> elements, std::size_t vertices,
                              std::pmr::memory_resource* memory)
    : elements_(elements.begin(), elements.end(), memory),
      parents_(elements.size(), memory),
      origins_(vertices, memory),
      around_(vertices, memory) {
  for (Index v = 0; v < vertices; ++v) {
    origins_[v].vertices.fill(no_index);
    origins_[v].weights.fill(0);
    origins_[v].vertices[0] = v;
    origins_[v].weights[0] = 1;
  }
  for (Index i = 0; i < elements.size(); ++i) {
    parents_[i] = i;
    for (const Index v : elements[i])
      around_[v].push_back(i);
  }
}

template <std::size_t corners>
Origin<corners> SplitMesh<corners>::middle_of(std::span<const Index> simplex) const {
  Origin<corners> middle;
  middle.vertices.fill(no_index);
  middle.weights.fill(0);
  for (const Index v : simplex) {
    const Origin<corners>& of = origins_[v];
    for (std::size_t k = 0; k < corners && of.vertices[k] != no_index; ++k) {
      // All lie in one element of the mesh before, which has a place for each.
      std::size_t place = 0;
      while (middle.vertices[place] != no_index && middle.vertices[place] != of.vertices[k])
        ++place;
      middle.vertices[place] = of.vertices[k];
      middle.weights[place] += of.weights[k] / static_cast<double>(simplex.size());
    }
  }
  return middle;
}

template <std::size_t corners>
Index SplitMesh<corners>::split(std::span<const Index> simplex) {
  const auto added = static_cast<Index>(origins_.size());
  origins_.push_back(middle_of(simplex));
  around_.emplace_back();
  const auto has = [&](Index element, Index v) {
    const Element& e = elements_[element];
    return std::find(e.begin(), e.end(), v) != e.end();
  };
  const Index replaced = *std::min_element(simplex.begin(), simplex.end(), [&](Index v, Index w) {
    return std::pair(around_[v].size(), v) < std::pair(around_[w].size(), w);
  });
  Array<Index> star(elements_.get_allocator());
  for (const Index i : around_[replaced]) {
    if (std::all_of(simplex.begin(), simplex.end(), [&](Index v) { return has(i, v); })) star.push_back(i);
  }
  for (const Index i : star) {
    const Element whole = elements_[i];
    std::replace(elements_[i].begin(), elements_[i].end(), replaced, added);
    std::erase(around_[replaced], i);
    around_[added].push_back(i);
    for (const Index v : simplex) {
      if (v == replaced) continue;
      Element part = whole;
      std::replace(part.begin(), part.end(), v, added);
      const auto number = static_cast<Index>(elements_.size());
      elements_.push_back(part);
      parents_.push_back(parents_[i]);
      for (const Index w : part)
        around_[w].push_back(number);
    }
  }
  return added;
}

template <std::size_t corners>
Array<Edge> inner_edges(std::span<const std::array<Index, corners>> elements, const base::Host& host) {
  Array<Edge> edges = faces_of<2>(elements, host);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const Array<Edge> boundary = boundary_edges(elements, host);
  std::erase_if(edges, [&](const Edge& e) { return std::binary_search(boundary.begin(), boundary.end(), e); });
  return edges;
}

template <std::size_t corners>
std::size_t split_marked(SplitMesh<corners>& mesh, std::span<const std::uint8_t> marked, const base::Host& host) {
  const std::size_t before = mesh.vertices();
  const auto split = [&](std::span<const Index> simplex) {
    host.report("refine", 0, 0);
    mesh.split(simplex);
  };
  for (const Edge& e : inner_edges<corners>(mesh.elements(), host)) {
    if (all_marked(e, marked)) split(e);
  }
  // Faces with edges in the boundary alone, which are not in it themselves.
  if constexpr (corners == 4) {
    const auto faces = faces_of<3>(mesh.elements(), host);
    for (std::size_t i = 1; i < faces.size(); ++i) {
      if (faces[i] == faces[i - 1] && all_marked(faces[i], marked)) split(faces[i]);
    }
  }
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    const std::array<Index, corners> e = mesh.elements()[i];
    if (all_marked(e, marked)) split(e);
  }
  return mesh.vertices() - before;
}

template <std::size_t corners>
std::size_t split_edges_of(SplitMesh<corners>& mesh, std::span<const Index> elements, const base::Host& host) {
  Array<std::array<Index, corners>> chosen(host.memory);
  for (const Index i : elements)
    chosen.push_back(mesh.elements()[i]);
  Array<Edge> edges = faces_of<2>(std::span<const std::array<Index, corners>>(chosen), host);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const Array<Edge> boundary = boundary_edges(mesh.elements(), host);
  std::size_t count = 0;
  for (const Edge& e : edges) {
    if (std::binary_search(boundary.begin(), boundary.end(), e)) continue;
    host.report("refine", 0, 0);
    mesh.split(e);
    ++count;
  }
  return count;
}

template class SplitMesh<3>;
template class SplitMesh<4>;
template std::size_t split_marked<3>(SplitMesh<3>&, std::span<const std::uint8_t>, const base::Host&);
template std::size_t split_marked<4>(SplitMesh<4>&, std::span<const std::uint8_t>, const base::Host&);
template std::size_t split_edges_of<3>(SplitMesh<3>&, std::span<const Index>, const base::Host&);
template std::size_t split_edges_of<4>(SplitMesh<4>&, std::span<const Index>, const base::Host&);
template Array<Edge> inner_edges<3>(std::span<const Triangle>, const base::Host&);
template Array<Edge> inner_edges<4>(std::span<const Tetrahedron>, const base::Host&);

}  // namespace orbicube::untangle
