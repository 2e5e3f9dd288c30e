#include "frame_field/singularities/zipping.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "frame_field/singularities/meshability.h"
#include "quaternion/cube_group.h"

namespace orbicube::frame_field {
namespace {

using quaternion::cube_group;
using quaternion::CubeClass;

// What things cost, in edges of a quarter turn along them.
constexpr double askew_cost = 1.5;   // of a quarter turn about an axis across the edge
constexpr double improper_cost = 8;  // of half turns and third turns
constexpr double vertex_cost = 3;    // an inner vertex that no hexahedral mesh has
constexpr double mismatch_cost = 2;  // times sin^2 of half the angle across a face
// Changes for less are not made; what is worth most comes first.
constexpr double least_worth[] = {8, 4, 2, 1, 0.5, 0.05};
constexpr std::uint32_t max_passes = 30;  // for each

enum class EdgeKind : std::uint8_t { regular, of_three, of_five, other };

struct VertexState {
  std::uint8_t of_three = 0, of_five = 0, others = 0;

  void add(EdgeKind kind, int change) {
    std::uint8_t* count = kind == EdgeKind::of_three  ? &of_three
                          : kind == EdgeKind::of_five ? &of_five
                          : kind == EdgeKind::other   ? &others
                                                      : nullptr;
    if (count != nullptr) *count = static_cast<std::uint8_t>(*count + change);
  }
  double cost() const {
    // With an improper edge, what is wrong is the edge.
    return others > 0 || is_vertex_of_hexahedra(of_three, of_five) ? 0 : vertex_cost;
  }
};

struct EdgeState {
  double cost = 0;
  EdgeKind kind = EdgeKind::regular;
};

struct LocalEdge {
  mesh::Edge vertices;  // ascending
  std::size_t ring;
  EdgeState state;
  bool operator<(const LocalEdge& o) const { return vertices != o.vertices ? vertices < o.vertices : ring < o.ring; }
};

EdgeKind kind_of(std::int8_t turn) {
  return turn == 1 ? EdgeKind::of_three : turn == -1 ? EdgeKind::of_five : EdgeKind::other;
}

class Zipper {
 public:
  Zipper(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
         const mesh::EdgeRings& rings, std::span<const std::uint8_t> boundary_vertices,
         std::span<const Quaternion> field, const base::Host& host, Array<std::uint8_t>& matchings)
      : positions_(positions),
        connectivity_(connectivity),
        rings_(rings),
        boundary_vertices_(boundary_vertices),
        field_(field),
        host_(host),
        matchings_(matchings),
        edges_(host.memory),
        faces_(host.memory),
        vertices_(positions.size(), VertexState{}, host.memory) {}

  std::size_t run(std::span<const std::uint8_t> inside, const SingularGraph& graph) {
    collect(inside, graph);
    std::size_t changes = 0;
    for (const double least : least_worth) {
      for (std::uint32_t pass = 0; pass < max_passes; ++pass) {
        std::size_t made = 0;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
          if (i % base::items_between_reports == 0) host_.report("zipping", pass, max_passes);
          made += improve(faces_[i], least) ? 1 : 0;
        }
        changes += made;
        if (made == 0) break;
      }
    }
    return changes;
  }

 private:
  struct Face {
    Index number;
    mesh::Triangle vertices;
    std::array<Index, 3> edge;  // opposite each vertex; no_index on the boundary
  };

  void collect(std::span<const std::uint8_t> inside, const SingularGraph& graph) {
    for (const SingularEdge& edge : graph.edges) {
      for (const Index v : edge.vertices)
        vertices_[v].add(kind_of(edge.turn), 1);
    }
    Array<std::uint8_t> touched(positions_.size(), 0, host_.memory);
    for (Index t = 0; t < inside.size(); ++t) {
      if (inside[t] == 0) continue;
      for (const Index v : connectivity_.tetrahedra()[t])
        touched[v] = 1;
    }
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (r % base::items_between_reports == 0) host_.report("zipping", r, rings_.size());
      mesh::Edge edge = rings_.vertices(r);
      if (rings_.on_boundary(r) || touched[edge[0]] == 0 || touched[edge[1]] == 0) continue;
      if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
      edges_.push_back({edge, r, state_of(r, no_index, 0)});
    }
    std::ranges::sort(edges_, std::less<>());
    for (Index f = 0; f < connectivity_.face_count(); ++f) {
      if (inside[f / 4] == 0 || connectivity_.on_boundary(f)) continue;
      const Index other = connectivity_.opposite(f);
      if (other < f || inside[other / 4] == 0) continue;
      const mesh::Triangle v = connectivity_.vertices(f);
      faces_.push_back({f, v, {edge_of(f, v[1], v[2]), edge_of(f, v[2], v[0]), edge_of(f, v[0], v[1])}});
    }
  }

  Index edge_of(Index face, Index a, Index b) const {
    const mesh::Edge key{std::min(a, b), std::max(a, b)};
    auto at = std::lower_bound(edges_.begin(), edges_.end(), LocalEdge{key, 0, {}});
    // Where two parts of a solid touch in an edge it has two rings.
    for (; at != edges_.end() && at->vertices == key; ++at) {
      const auto ring = rings_.faces(at->ring);
      if (std::ranges::any_of(ring, [&](Index f) { return f == face || f == connectivity_.opposite(face); }))
        return static_cast<Index>(at - edges_.begin());
    }
    return no_index;
  }

  // Of an edge when the matching of a face is `matching`.
  EdgeState state_of(std::size_t ring, Index face, std::uint8_t matching) const {
    const auto faces = rings_.faces(ring);
    const Index opposite = face == no_index ? no_index : connectivity_.opposite(face);
    const auto matching_of = [&](Index f) {
      return f == face ? matching : f == opposite ? cube_group.inverse[matching] : matchings_[f];
    };
    std::uint8_t rotation = 0;
    for (const Index f : faces)
      rotation = cube_group.product[rotation][matching_of(f)];
    const mesh::Edge& v = rings_.vertices(ring);
    const Vector3 along = positions_[v[1]] - positions_[v[0]];
    switch (cube_group.conjugacy_class[rotation]) {
      case CubeClass::identity:
        return {};
      case CubeClass::face_quarter: {
        const double cosine = turn_along(
            faces.size(), rotation, along,
            [&](std::size_t k) -> const Quaternion& {
              return field_[mesh::TetrahedralConnectivity::tetrahedron_of(faces[k])];
            },
            [&](std::size_t k) { return matching_of(faces[k]); });
        return {1 + askew_cost * (1 - std::abs(cosine)), cosine > 0 ? EdgeKind::of_three : EdgeKind::of_five};
      }
      default:
        return {improper_cost, EdgeKind::other};
    }
  }

  // What changes when the face gets a matching.
  double worth(const Face& face, std::uint8_t matching, std::array<EdgeState, 3>& states) const {
    const Quaternion& from = field_[face.number / 4];
    const Quaternion& to = field_[connectivity_.opposite(face.number) / 4];
    const auto mismatch = [&](std::uint8_t g) {
      const double cosine = dot(quaternion::multiply(from, cube_group.element[g]), to);
      return 1 - cosine * cosine;
    };
    double change = mismatch_cost * (mismatch(matching) - mismatch(matchings_[face.number]));
    std::array<VertexState, 3> vertices;
    for (std::size_t c = 0; c < 3; ++c) {
      vertices[c] = vertices_[face.vertices[c]];
      if (inner(face.vertices[c])) change -= vertices[c].cost();
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (face.edge[c] == no_index) continue;
      const LocalEdge& edge = edges_[face.edge[c]];
      states[c] = state_of(edge.ring, face.number, matching);
      change += states[c].cost - edge.state.cost;
      for (const std::size_t end : {(c + 1) % 3, (c + 2) % 3}) {
        vertices[end].add(edge.state.kind, -1);
        vertices[end].add(states[c].kind, 1);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (inner(face.vertices[c])) change += vertices[c].cost();
    }
    return -change;
  }

  bool inner(Index vertex) const { return boundary_vertices_[vertex] == 0; }

  // Makes the change of the face's matching that is worth most, if one is worth more than so much.
  bool improve(const Face& face, double most) {
    const bool singular = std::ranges::any_of(
        face.edge, [&](Index e) { return e != no_index && edges_[e].state.kind != EdgeKind::regular; });
    if (!singular) return false;
    std::uint8_t best = 0;
    std::array<EdgeState, 3> states, chosen;
    const std::uint8_t now = matchings_[face.number];
    for (std::uint8_t turn = 1; turn < quaternion::cube_order; ++turn) {
      const std::uint8_t matching = cube_group.product[turn][now];
      const double value = worth(face, matching, states);
      if (!(value > most)) continue;
      most = value;
      best = turn;
      chosen = states;
    }
    if (best == 0) return false;
    const std::uint8_t matching = cube_group.product[best][now];
    matchings_[face.number] = matching;
    matchings_[connectivity_.opposite(face.number)] = cube_group.inverse[matching];
    for (std::size_t c = 0; c < 3; ++c) {
      if (face.edge[c] == no_index) continue;
      LocalEdge& edge = edges_[face.edge[c]];
      for (const std::size_t end : {(c + 1) % 3, (c + 2) % 3}) {
        VertexState& vertex = vertices_[face.vertices[end]];
        vertex.add(edge.state.kind, -1);
        vertex.add(chosen[c].kind, 1);
      }
      edge.state = chosen[c];
    }
    return true;
  }

  std::span<const Vector3> positions_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const mesh::EdgeRings& rings_;
  std::span<const std::uint8_t> boundary_vertices_;
  std::span<const Quaternion> field_;
  const base::Host& host_;
  Array<std::uint8_t>& matchings_;
  Array<LocalEdge> edges_;
  Array<Face> faces_;
  Array<VertexState> vertices_;
};

}  // namespace

std::size_t zip(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                const FaultFinder& finder, std::span<const Quaternion> field, std::span<const std::uint8_t> inside,
                const SingularGraph& graph, const base::Host& host, Array<std::uint8_t>& matchings) {
  return Zipper(positions, connectivity, finder.rings(), finder.boundary_vertices(), field, host, matchings)
      .run(inside, graph);
}

}  // namespace orbicube::frame_field
