#include "volume_map/frames/seamless_system.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/grouping.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/place_text.h"
#include "volume_map/frames/transitions.h"

namespace orbicube::volume_map {
namespace {

using quaternion::cube_group;
using Connectivity = mesh::TetrahedralConnectivity;
using Forms3 = std::array<Index, 3>;

class Builder {
 public:
  Builder(std::span<const Vector3> positions, const Connectivity& connectivity, const mesh::EdgeRings& rings,
          const FrameCut& cut, const base::Host& host)
      : positions_(positions),
        connectivity_(connectivity),
        rings_(rings),
        cut_(cut),
        host_(host),
        system_(host.memory),
        forms_(host.memory),
        gap_(cut.sheets(), host.memory),
        turn_(cut.vertex_of_copy.size(), 0, host.memory),
        shift_(cut.vertex_of_copy.size(), Forms3{}, host.memory),
        integer_(3 * positions.size(), 0, host.memory),
        equations_(host.memory),
        vertex_equations_(host.memory),
        ties_(host.memory),
        of_node_(3 * positions.size(), no_index, host.memory) {}

  SeamlessSystem build() {
    for (Forms3& gap : gap_) {
      for (Index& g : gap)
        g = forms_.of_unknown(unknowns_++);
    }
    for (const Index sheet : cut_.one_sided) {
      // The gap is also that of the way back: g = - M g.
      const Forms3 back = turned(cut_.rotation[cut_.sheet_faces[sheet]], gap_[sheet]);
      for (std::size_t a = 0; a < 3; ++a)
        equations_.push_back(forms_.sum(gap_[sheet][a], 1, back[a], 1));
    }
    relate_copies();
    label_boundary();
    tie_boundary();
    tie_singular_edges();
    number_nodes();
    solve();
    return std::move(system_);
  }

 private:
  struct Node {
    Index number;  // 3 vertex + axis in the chart of its first copy
    int sign;
    Index form;
  };
  struct Tie {
    Index from, to;
    int sign;  // value of `to` = sign * value of `from` + form
    Index form;
  };
  struct VertexEquation {
    Index vertex;
    std::array<int, 3> factor;  // of its coordinates in the chart of the first copy
    Index form;
  };

  Forms3 turned(std::uint8_t rotation, const Forms3& x) {
    Forms3 y{};
    for (std::size_t a = 0; a < 3; ++a)
      y[a] = forms_.sum(x[Transition::source(rotation, a)], Transition::sign(rotation, a), 0, 1);
    return y;
  }

  // Beyond a face that is cut: coordinates turned by the inverse of its rotation, plus this.
  Forms3 gap_of(Index face) {
    const Forms3& g = gap_[cut_.sheet[face]];
    if (cut_.forward[face] != 0) return g;
    Forms3 back = turned(cube_group.inverse[cut_.rotation[face]], g);
    for (Index& b : back)
      b = forms_.sum(b, -1, 0, 1);
    return back;
  }

  // From one copy of a vertex to another, across a face that is cut.
  struct Link {
    Index from, to, face;
  };

  // Returns the links of all copies, sorted, one of a kind: with the same ends and the same sheet.
  Array<Link> find_links() const {
    Array<Link> links(host_.memory);
    for (Index face = 0; face < connectivity_.face_count(); ++face) {
      if (cut_.sheet[face] == no_index) continue;
      const Index other = connectivity_.opposite(face) / 4;
      for (const Index v : connectivity_.vertices(face))
        links.push_back({cut_.copies[face / 4][connectivity_.corner_of(face / 4, v)],
                         cut_.copies[other][connectivity_.corner_of(other, v)], face});
    }
    const auto key = [&](const Link& l) {
      return std::array{l.from, l.to, cut_.sheet[l.face], Index{cut_.forward[l.face]}};
    };
    std::sort(links.begin(), links.end(),
              [&](const Link& a, const Link& b) { return std::pair(key(a), a.face) < std::pair(key(b), b.face); });
    links.erase(std::unique(links.begin(), links.end(), [&](const Link& a, const Link& b) { return key(a) == key(b); }),
                links.end());
    return links;
  }

  // A copy that is reached again, with this turn and shift: both ways say the same, (M - M') f + shift - shift' = 0.
  void add_loop_equations(Index copy, std::uint8_t turn, const Forms3& shift) {
    for (std::size_t a = 0; a < 3; ++a) {
      VertexEquation e{cut_.vertex_of_copy[copy], {}, forms_.sum(shift[a], 1, shift_[copy][a], -1)};
      for (std::size_t b = 0; b < 3; ++b) {
        e.factor[b] = cube_group.matrix[turn][3 * a + b] - cube_group.matrix[turn_[copy]][3 * a + b];
        if (e.factor[b] != 0) integer_[3 * e.vertex + b] = 1;
      }
      if (e.factor == std::array<int, 3>{})
        equations_.push_back(e.form);
      else
        vertex_equations_.push_back(e);
    }
  }

  // All copies of a vertex by its first one, and what comes of going round.
  void relate_copies() {
    const Array<Link> links = find_links();
    Array<Index> begin(turn_.size() + 1, 0, host_.memory);
    for (const Link& l : links)
      ++begin[l.from + 1];
    base::add_up_counts(std::span(begin));
    Array<Index> first(positions_.size(), no_index, host_.memory);
    Array<std::uint8_t> seen(turn_.size(), 0, host_.memory);
    Array<Index> queue(host_.memory);
    for (Index root = 0; root < turn_.size(); ++root) {
      if (seen[root] != 0) continue;
      seen[root] = 1;
      queue.assign(1, root);
      if (first[cut_.vertex_of_copy[root]]++ != no_index) {
        const Index v = cut_.vertex_of_copy[root];
        throw base::Error("non-manifold-vertex", "tetrahedra meet in vertex " + std::to_string(v) + " alone, at " +
                                                     mesh::place_text(positions_[v]));
      }
      for (std::size_t i = 0; i < queue.size(); ++i) {
        const Index from = queue[i];
        if (i % 1024 == 0) host_.report("system", root, turn_.size());
        for (Index l = begin[from]; l < begin[from + 1]; ++l) {
          const auto& [_, to, face] = links[l];
          const std::uint8_t back = cube_group.inverse[cut_.rotation[face]];
          const std::uint8_t turn = cube_group.product[back][turn_[from]];
          Forms3 shift = turned(back, shift_[from]);
          const Forms3 gap = gap_of(face);
          for (std::size_t a = 0; a < 3; ++a)
            shift[a] = forms_.sum(shift[a], 1, gap[a], 1);
          if (seen[to] == 0) {
            seen[to] = 1;
            turn_[to] = turn;
            shift_[to] = shift;
            queue.push_back(to);
            continue;
          }
          add_loop_equations(to, turn, shift);
        }
      }
    }
  }

  // A coordinate in the chart of a tetrahedron, by that in the first chart of the vertex.
  Node node(Index tetrahedron, Index vertex, std::size_t axis) const {
    const Index copy = cut_.copies[tetrahedron][connectivity_.corner_of(tetrahedron, vertex)];
    return {static_cast<Index>(3 * vertex + Transition::source(turn_[copy], axis)), Transition::sign(turn_[copy], axis),
            shift_[copy][axis]};
  }

  void tie(Index tetrahedron, Index p, Index q, std::size_t axis) {
    const Node a = node(tetrahedron, p, axis), b = node(tetrahedron, q, axis);
    integer_[a.number] = integer_[b.number] = 1;
    // a.sign A + a.form = b.sign B + b.form
    ties_.push_back({a.number, b.number, a.sign * b.sign, forms_.sum(a.form, b.sign, b.form, -b.sign)});
    ties_.push_back({b.number, a.number, a.sign * b.sign, forms_.sum(b.form, a.sign, a.form, -a.sign)});
  }

  void label_boundary() {
    const std::size_t faces = connectivity_.face_count();
    Array<std::uint8_t> border(host_.memory);
    system_.label =
        volume_map::label_boundary(positions_, connectivity_, rings_, cut_.frames, cut_.rotation, border, host_);
    system_.patch.assign(faces, no_index);
    // Neighbors around an edge of the boundary have the same label, or there the plane ends.
    mesh::DisjointSets sets(faces, host_.memory);
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
      if (!rings_.on_boundary(ring) || border[ring] != 0) continue;
      const auto [first, last] = boundary_faces(connectivity_, rings_, ring);
      sets.unite(first, last);
    }
    for (Index face = 0; face < faces; ++face) {
      if (!connectivity_.on_boundary(face)) continue;
      const Index root = sets.find(face);
      system_.patch[face] = root == face ? static_cast<Index>(system_.patches++) : system_.patch[root];
    }
  }

  void tie_boundary() {
    for (Index face = 0; face < connectivity_.face_count(); ++face) {
      if (!connectivity_.on_boundary(face)) continue;
      const auto [a, b, c] = connectivity_.vertices(face);
      tie(face / 4, a, b, system_.label[face] / 2);
      tie(face / 4, a, c, system_.label[face] / 2);
    }
  }

  // Along a singular edge only the coordinate changes about whose axis frames turn.
  void tie_singular_edges() {
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
      if (cut_.singular[ring] == 0) continue;
      const auto [p, q] = rings_.vertices(ring);
      std::uint8_t passed = 0;
      for (const Index face : rings_.faces(ring))
        passed = cube_group.product[passed][cut_.rotation[face]];
      for (std::size_t a = 0; a < 3; ++a) {
        if (cube_group.matrix[passed][4 * a] != 1) tie(rings_.faces(ring).front() / 4, p, q, a);
      }
    }
  }

  // One unknown for all coordinates that are tied to each other.
  void number_nodes() {
    const auto for_each_tie = [&](const auto& visit) {
      for (Index i = 0; i < ties_.size(); ++i)
        visit(ties_[i].from, i);
    };
    const base::Groups<Index, Index> ties_from(integer_.size(), for_each_tie, host_.memory);
    Array<Index> queue(host_.memory);
    for (Index root = 0; root < integer_.size(); ++root) {
      if (integer_[root] == 0 || of_node_[root] != no_index) continue;
      of_node_[root] = forms_.of_unknown(unknowns_++);
      queue.assign(1, root);
      for (std::size_t i = 0; i < queue.size(); ++i) {
        if (i % 1024 == 0) host_.report("system", root, integer_.size());
        for (const Index k : ties_from[queue[i]]) {
          const Tie& t = ties_[k];
          const Index value = forms_.sum(of_node_[t.from], t.sign, t.form, 1);
          if (of_node_[t.to] == no_index) {
            of_node_[t.to] = value;
            queue.push_back(t.to);
            continue;
          }
          const Index rest = forms_.sum(value, 1, of_node_[t.to], -1);
          if (!forms_.is_zero(rest)) equations_.push_back(rest);
        }
      }
    }
    for (const VertexEquation& e : vertex_equations_) {
      Index sum = e.form;
      for (std::size_t a = 0; a < 3; ++a) {
        if (e.factor[a] != 0) sum = forms_.sum(sum, 1, of_node_[3 * e.vertex + a], e.factor[a]);
      }
      equations_.push_back(sum);
    }
  }

  // What solves the equations, and all coordinates by that.
  void solve() {
    const auto less = [&](Index a, Index b) {
      const auto x = forms_.terms(a), y = forms_.terms(b);
      return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(),
                                          [](const IntegerTerm& s, const IntegerTerm& t) {
                                            return std::pair(s.unknown, s.factor) < std::pair(t.unknown, t.factor);
                                          });
    };
    const auto same = [&](Index a, Index b) {
      const auto x = forms_.terms(a), y = forms_.terms(b);
      return std::equal(x.begin(), x.end(), y.begin(), y.end());
    };
    std::sort(equations_.begin(), equations_.end(), less);
    equations_.erase(std::unique(equations_.begin(), equations_.end(), same), equations_.end());
    SolutionLattice lattice(unknowns_, host_.memory);
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      host_.report("system", i, equations_.size());
      if (!forms_.is_zero(equations_[i])) lattice.require_zero(forms_.terms(equations_[i]));
    }
    system_.integers = lattice.dimension();
    Array<Index> expressed(forms_.size(), no_index, host_.memory);
    Array<IntegerTerm> terms(host_.memory);
    const auto express = [&](Index form) {
      if (form >= expressed.size()) expressed.resize(forms_.size(), no_index);
      if (expressed[form] == no_index) {
        lattice.express(forms_.terms(form), terms);
        expressed[form] = system_.forms.add(terms);
      }
      return expressed[form];
    };
    for (const Forms3& gap : gap_)
      system_.gap.push_back({express(gap[0]), express(gap[1]), express(gap[2])});
    const std::size_t copies = cut_.vertex_of_copy.size();
    system_.variable.assign(3 * copies, no_index);
    system_.sign.assign(3 * copies, 0);
    system_.form.assign(3 * copies, 0);
    Array<Index> variable(integer_.size(), no_index, host_.memory);
    for (std::size_t copy = 0; copy < copies; ++copy) {
      if (copy % 1024 == 0) host_.report("system", copy, copies);
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t at = 3 * cut_.vertex_of_copy[copy] + Transition::source(turn_[copy], a);
        const int sign = Transition::sign(turn_[copy], a);
        const std::size_t i = 3 * copy + a;
        if (integer_[at] != 0) {
          system_.form[i] = express(forms_.sum(of_node_[at], sign, shift_[copy][a], 1));
          continue;
        }
        if (variable[at] == no_index) variable[at] = static_cast<Index>(system_.variables++);
        system_.variable[i] = variable[at];
        system_.sign[i] = static_cast<std::int8_t>(sign);
        system_.form[i] = express(shift_[copy][a]);
      }
    }
  }

  std::span<const Vector3> positions_;
  const Connectivity& connectivity_;
  const mesh::EdgeRings& rings_;
  const FrameCut& cut_;
  const base::Host& host_;
  SeamlessSystem system_;
  IntegerForms forms_;  // in the unknowns before they are solved for
  Index unknowns_ = 0;
  Array<Forms3> gap_;
  Array<std::uint8_t> turn_;  // of each copy: coordinates are those of the vertex's first copy, turned and shifted
  Array<Forms3> shift_;
  Array<std::uint8_t> integer_;  // of each node
  Array<Index> equations_;       // forms that are 0
  Array<VertexEquation> vertex_equations_;
  Array<Tie> ties_;
  Array<Index> of_node_;  // forms
};

}  // namespace

SeamlessSystem make_seamless_system(std::span<const Vector3> positions, const Connectivity& connectivity,
                                    const mesh::EdgeRings& rings, const FrameCut& cut, const base::Host& host) {
  return Builder(positions, connectivity, rings, cut, host).build();
}

}  // namespace orbicube::volume_map
