#include "repair/soup/t_junctions.h"

#include <algorithm>
#include <span>

#include "mesh/search/bounding_volume_tree.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::repair {
namespace {

struct Split {
  Index half_edge;  // of the face that has the edge alone
  double along;     // 0 at its start, 1 at its end
  Index vertex;
  double distance;
  bool operator<(const Split& o) const {
    return half_edge != o.half_edge ? half_edge < o.half_edge : along != o.along ? along < o.along : vertex < o.vertex;
  }
};

class TJunctions {
 public:
  TJunctions(Soup& soup, double distance, const Context& context)
      : soup_(soup), distance_(distance), context_(context), open_(context.host.memory) {
    const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, context.host);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.half_edges(e).size() == 1) open_.push_back(edges.half_edges(e)[0]);
    }
  }

  TJunctionFigures run() {
    TJunctionFigures figures;
    Array<Split> splits = find();
    for (std::size_t begin = 0, end = 0; begin < splits.size(); begin = end) {
      const Index t = splits[begin].half_edge / 3;
      while (end < splits.size() && splits[end].half_edge / 3 == t)
        ++end;
      const Array<Split> of_face(splits.begin() + static_cast<std::ptrdiff_t>(begin),
                                 splits.begin() + static_cast<std::ptrdiff_t>(end), context_.host.memory);
      for (const Split& s : of_face) {
        context_.record(Action::split_edge, soup_.positions[s.vertex], s.distance);
        figures.largest_move = std::max(figures.largest_move, s.distance);
      }
      figures.splits += of_face.size();
      cut(t, of_face);
    }
    return figures;
  }

 private:
  Array<Split> find() const {
    const base::Host& host = context_.host;
    Array<mesh::Box> boxes(host.memory);
    Array<Index> vertices(host.memory);
    for (const Index h : open_) {
      mesh::Box box;
      for (const Index v : {mesh::start_of(soup_.triangles, h), mesh::end_of(soup_.triangles, h)}) {
        box.add(soup_.positions[v]);
        vertices.push_back(v);
      }
      boxes.push_back(box);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    Array<Split> splits(host.memory);
    if (open_.empty()) return splits;
    const mesh::BoundingVolumeTree tree(boxes, host);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i % 256 == 0) host.report("T-junctions", i, vertices.size());
      const Vector3& p = soup_.positions[vertices[i]];
      const mesh::Box around{p.array() - distance_, p.array() + distance_};
      tree.for_each_near(around, [&](Index edge) { consider(open_[edge], vertices[i], splits); });
    }
    std::sort(splits.begin(), splits.end());
    return splits;
  }

  void consider(Index h, Index v, Array<Split>& splits) const {
    const Triangle& face = soup_.triangles[h / 3];
    if (face[0] == v || face[1] == v || face[2] == v) return;
    const Vector3& a = soup_.positions[mesh::start_of(soup_.triangles, h)];
    const Vector3& b = soup_.positions[mesh::end_of(soup_.triangles, h)];
    const Vector3& p = soup_.positions[v];
    const double square = (b - a).squaredNorm();
    if (!(square > 0)) return;
    const double along = (p - a).dot(b - a) / square;
    if (!(along > 0 && along < 1)) return;
    const double off = (a + along * (b - a) - p).norm();
    if (!(off <= distance_) || (p - a).norm() <= distance_ || (p - b).norm() <= distance_) return;
    splits.push_back({h, along, v, off});
  }

  // Cuts the triangle with splits of up to three of its edges, sorted by edge: a fan from the corner across the first
  // edge, of whose triangles the last has the second edge and the first the third.
  void cut(Index t, std::span<const Split> splits) {
    const Index source = soup_.triangle_source[t];
    const Triangle corners = soup_.triangles[t];
    Array<Triangle> parts(1, corners, context_.host.memory);
    for (std::size_t begin = 0, end = 0; begin < splits.size(); begin = end) {
      const Index k = splits[begin].half_edge % 3;
      while (end < splits.size() && splits[end].half_edge % 3 == k)
        ++end;
      const Index a = corners[k], b = corners[(k + 1) % 3];
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const Triangle part = parts[i];
        const auto at = static_cast<Index>(std::find(part.begin(), part.end(), a) - part.begin());
        if (at == 3 || part[(at + 1) % 3] != b) continue;
        const Index apex = part[(at + 2) % 3];
        Index from = a;
        for (std::size_t s = begin; s < end; ++s) {
          if (splits[s].vertex == apex) continue;
          parts.push_back({from, splits[s].vertex, apex});
          from = splits[s].vertex;
        }
        parts[i] = {from, b, apex};
        break;
      }
    }
    soup_.triangles[t] = parts[0];
    for (std::size_t i = 1; i < parts.size(); ++i)
      soup_.add_triangle(parts[i], source);
  }

  Soup& soup_;
  double distance_;
  const Context& context_;
  Array<Index> open_;
};

}  // namespace

TJunctionFigures split_t_junctions(Soup& soup, double distance, const Context& context) {
  return TJunctions(soup, distance, context).run();
}

}  // namespace orbicube::repair
