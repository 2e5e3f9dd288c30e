#include "frame_field/singularities/curve_search.h"

#include <algorithm>
#include <array>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

using quaternion::cube_group;

// Sweeps in two halves each, and the energy above the old one that the sweeps after the first half, after the second
// and after half of the free ones do not win back.
constexpr std::uint32_t half_of_sweeps = 3;
constexpr double hopeless_early = 1, hopeless = 0.5, hopeless_late = 0.1;
constexpr double min_gain = 1e-4;  // of a move
constexpr std::size_t curves_between_reports = 64;

}  // namespace

CurveSearch::CurveSearch(const DualGraph& graph, const Constraints& constraints,
                         const mesh::TetrahedralConnectivity& connectivity, const mesh::EdgeRings& rings,
                         const base::Host& host)
    : graph_(graph),
      constraints_(constraints),
      connectivity_(connectivity),
      rings_(rings),
      host_(host),
      relaxation_(graph, constraints, connectivity, host),
      at_vertex_(base::cells_around(connectivity.tetrahedra(), connectivity.vertex_count(), host.memory)),
      matchings_(host.memory),
      stamp_(graph.size(), 0, host.memory),
      patch_(host.memory),
      saved_(host.memory),
      changed_(graph.size(), 0, host.memory),
      failed_(host.memory) {}

double CurveSearch::run(std::uint32_t max_passes, Field& field) {
  gain_ = 0;
  matchings_ = matchings(connectivity_, field, host_);
  struct End {
    Index vertex;
    std::size_t ring;
  };
  Array<End> ends(host_.memory);
  for (std::uint32_t pass = 0; pass < max_passes; ++pass) {
    ends.clear();
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (rings_.on_boundary(r) || rotation_of(r) == 0) continue;
      for (const Index v : rings_.vertices(r))
        ends.push_back({v, r});
    }
    std::size_t moved = 0;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (i % curves_between_reports == 0) host_.report("moving curves", i, ends.size());
      moved += move_edge(ends[i].ring, field) ? 1 : 0;
    }
    std::ranges::sort(
        ends, [](const End& a, const End& b) { return a.vertex != b.vertex ? a.vertex < b.vertex : a.ring < b.ring; });
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (i % curves_between_reports == 0) host_.report("moving curves", i, ends.size());
      if (ends[i].vertex == ends[i + 1].vertex) moved += move_vertex(ends[i].ring, ends[i + 1].ring, field) ? 1 : 0;
    }
    if (moved == 0) break;
  }
  return gain_;
}

std::uint8_t CurveSearch::rotation_of(std::size_t ring) const {
  std::uint8_t rotation = 0;
  for (const Index f : rings_.faces(ring))
    rotation = cube_group.product[rotation][matchings_[f]];
  return rotation;
}

// The matching of a face of the ring with which its edge is regular.
std::uint8_t CurveSearch::regular_matching(std::size_t ring, std::size_t place) const {
  const auto faces = rings_.faces(ring);
  // From the tetrahedron behind the face round to the one before it.
  std::uint8_t others = 0;
  for (std::size_t i = 1; i < faces.size(); ++i)
    others = cube_group.product[others][matchings_[faces[(place + i) % faces.size()]]];
  return cube_group.inverse[others];
}

// Tries to make an edge regular through each of its faces.
bool CurveSearch::move_edge(std::size_t ring, Field& field) {
  if (rotation_of(ring) == 0) return false;
  const auto faces = rings_.faces(ring);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Change change{faces[i], regular_matching(ring, i)};
    if (try_changes({&change, 1}, field)) return true;
  }
  return false;
}

// Tries to make two edges at a vertex regular through faces that share a further vertex.
bool CurveSearch::move_vertex(std::size_t ring, std::size_t next, Field& field) {
  if (rotation_of(ring) == 0 || rotation_of(next) == 0) return false;
  const auto third_vertex = [&](Index face, std::size_t of) {
    const mesh::Edge& edge = rings_.vertices(of);
    for (const Index v : connectivity_.vertices(face)) {
      if (v != edge[0] && v != edge[1]) return v;
    }
    return no_index;
  };
  const auto faces = rings_.faces(ring), next_faces = rings_.faces(next);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Index vertex = third_vertex(faces[i], ring);
    for (std::size_t k = 0; k < next_faces.size(); ++k) {
      if (third_vertex(next_faces[k], next) != vertex) continue;
      const Change changes[] = {{faces[i], regular_matching(ring, i)}, {next_faces[k], regular_matching(next, k)}};
      if (try_changes(changes, field)) return true;
    }
  }
  return false;
}

void CurveSearch::collect_patch(std::span<const Change> changes) {
  ++patches_;
  patch_.clear();
  const auto add_around = [&](Index vertex) {
    for (const Index t : at_vertex_[vertex]) {
      if (stamp_[t] == patches_) continue;
      stamp_[t] = patches_;
      patch_.push_back(t);
    }
  };
  for (const Change& change : changes) {
    for (const Index v : connectivity_.vertices(change.face))
      add_around(v);
  }
  // And those across the patch's faces, twice.
  std::size_t from = 0;
  for (int layer = 0; layer < 2; ++layer) {
    const std::size_t end = patch_.size();
    for (; from < end; ++from) {
      for (Index k = 0; k < 4; ++k) {
        const Index other = connectivity_.neighbor(patch_[from], k);
        if (other == no_index || stamp_[other] == patches_) continue;
        stamp_[other] = patches_;
        patch_.push_back(other);
      }
    }
  }
}

// Of all links that have an end in the patch.
double CurveSearch::patch_energy(const Field& field) const {
  double sum = 0;
  for (const Index t : patch_) {
    for (Index k = 0; k < 4; ++k) {
      const Index other = connectivity_.neighbor(t, k);
      if (other == no_index || (stamp_[other] == patches_ && other < t)) continue;
      sum += static_cast<double>(graph_.weights[t][k]) * quaternion::symmetric_sine_square(field[t], field[other]);
    }
    if (!constraints_.pulls.empty()) {
      for (const Pull& pull : constraints_.pulls_at(t))
        sum += worth(pull, field[t]);
    }
  }
  return sum;
}

// The number of the last accepted move that changed what a move in this patch depends on.
std::uint32_t CurveSearch::last_change() const {
  std::uint32_t last = 0;
  for (const Index t : patch_) {
    last = std::max(last, changed_[t]);
    for (Index k = 0; k < 4; ++k) {
      const Index other = connectivity_.neighbor(t, k);
      if (other != no_index) last = std::max(last, changed_[other]);
    }
  }
  return last;
}

void CurveSearch::set(const Change& change) {
  matchings_[change.face] = change.matching;
  matchings_[connectivity_.opposite(change.face)] = cube_group.inverse[change.matching];
}

bool CurveSearch::try_changes(std::span<const Change> changes, Field& field) {
  collect_patch(changes);
  // What failed fails again while nothing around changes.
  std::array<std::uint64_t, 2> key{};
  for (std::size_t i = 0; i < changes.size(); ++i)
    key[i] = std::uint64_t{changes[i].face} * cube_group.element.size() + changes[i].matching + 1;
  const auto before_now = failed_.find(key);
  if (before_now != failed_.end() && before_now->second >= last_change()) return false;
  saved_.clear();
  for (const Index t : patch_)
    saved_.push_back(field[t]);
  const double before = patch_energy(field);
  std::array<Change, 2> old;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    old[i] = {changes[i].face, matchings_[changes[i].face]};
    set(changes[i]);
  }
  double after = before;
  const auto relax = [&](std::span<const std::uint8_t> matchings, double bound) {
    relaxation_.relax(patch_, matchings, half_of_sweeps, field);
    after = patch_energy(field);
    return after < before + bound;
  };
  if (relax(matchings_, hopeless_early) && relax(matchings_, hopeless) && relax({}, hopeless_late)) relax({}, 0);
  if (!(after < before - min_gain)) {
    for (std::size_t i = 0; i < changes.size(); ++i)
      set(old[i]);
    for (std::size_t i = 0; i < patch_.size(); ++i)
      field[patch_[i]] = saved_[i];
    failed_[key] = accepted_;
    return false;
  }
  gain_ += before - after;
  ++accepted_;
  for (const Index t : patch_)
    changed_[t] = accepted_;
  for (const Index t : patch_) {
    for (Index k = 0; k < 4; ++k) {
      const Index f = 4 * t + k, other = connectivity_.opposite(f);
      if (other == no_index) continue;
      const auto low = std::min(f, other), high = std::max(f, other);
      const std::uint32_t g = quaternion::symmetric_matching(field[low / 4], field[high / 4]);
      matchings_[low] = static_cast<std::uint8_t>(g);
      matchings_[high] = cube_group.inverse[g];
    }
  }
  return true;
}

}  // namespace orbicube::frame_field
