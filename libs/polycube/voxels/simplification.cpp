#include "polycube/voxels/simplification.h"

#include <algorithm>
#include <cmath>

#include "polycube/voxels/grid_rectangles.h"
#include "polycube/voxels/local_thickness.h"

namespace orbicube::polycube {
namespace {

constexpr const char* simplification_phase = "simplification";

VoxelSolid copy_of(const VoxelSolid& solid, const base::Host& host) {
  std::array<Array<double>, 3> planes = {Array<double>(host.memory), Array<double>(host.memory),
                                         Array<double>(host.memory)};
  for (std::size_t a = 0; a < 3; ++a)
    planes[a].assign(solid.planes(a).begin(), solid.planes(a).end());
  VoxelSolid copy(std::move(planes), host.memory);
  for (std::size_t i = 0; i < solid.size(); ++i)
    copy.set(i, solid.inside(i));
  return copy;
}

}  // namespace

Simplification::Simplification(const Voxelisation& voxels, const base::Host& host)
    : host_(host),
      solid_(copy_of(voxels.solid, host)),
      weight_(solid_.size(), host.memory),
      pushes_(host.memory),
      squares_(host.memory),
      marks_(host.memory),
      candidates_(host.memory),
      flipped_(host.memory),
      waiting_(host.memory),
      refused_(host.memory) {
  const Array<float> thickness = local_thickness(solid_, host);
  const float thickest = *std::max_element(thickness.begin(), thickness.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < solid_.size(); ++i)
    count += solid_.inside(i);
  for (std::size_t i = 0; i < solid_.size(); ++i) {
    const float thin = thickest / std::max(thickness[i], 1.5F);
    weight_[i] = (1 - 2 * voxels.fraction[i]) * thin * thin / static_cast<float>(count);
  }
  corners_ = static_cast<std::int64_t>(solid_.corners());
  fit_cells();
}

void Simplification::fit_cells() {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < solid_.size(); ++i) {
      if (i % 65536 == 0) host_.report(simplification_phase, 0, 0);
      const float cost = solid_.inside(i) ? -weight_[i] : weight_[i];
      if (cost < -1e-12F && solid_.flip_if_simple(solid_.cell(i), corners_)) changed = true;
    }
    if (!changed) break;
  }
}

Cell Simplification::cell_of(const Push& push, const Square& square, int depth) const {
  Cell c{};
  // Outward the first cells are those in front of the face, inward those behind it.
  c[push.axis] = push.inward ? push.layer - push.sign * depth : push.layer + push.sign * (depth + 1);
  c[(push.axis + 1) % 3] = square[0];
  c[(push.axis + 2) % 3] = square[1];
  return c;
}

void Simplification::add_pushes(std::size_t axis, int sign, int layer, std::size_t begin, std::size_t end) {
  pushes_.push_back({axis, sign, layer, false, begin, end});
  pushes_.push_back({axis, sign, layer, true, begin, end});
}

// Faces by flooding, and the slabs of each in both directions.
void Simplification::find_pushes() {
  constexpr std::size_t max_slabs = 40;
  pushes_.clear();
  squares_.clear();
  Array<std::size_t> face(host_.memory);
  Array<Square> turned(host_.memory);
  Array<GridRectangle> slabs(host_.memory);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int sign : {-1, 1}) {
      host_.report(simplification_phase, 0, 0);
      marks_.assign(solid_.size(), 0);
      const auto exposed = [&, axis = axis](std::size_t place) {
        return solid_.inside(place) && !solid_.inside(solid_.neighbor(place, axis, sign));
      };
      const std::size_t first = solid_.stride(0);
      for (std::size_t start = first; start + first < solid_.size(); ++start) {
        if (!solid_.inside(start) || marks_[start] || !exposed(start)) continue;
        face.assign(1, start);
        marks_[start] = 1;
        for (std::size_t i = 0; i < face.size(); ++i) {
          for (const std::size_t there : {face[i] + solid_.stride(u), face[i] - solid_.stride(u),
                                          face[i] + solid_.stride(v), face[i] - solid_.stride(v)}) {
            if (marks_[there] || !exposed(there)) continue;
            marks_[there] = 1;
            face.push_back(there);
          }
        }
        const int layer = solid_.cell(start)[axis];
        const std::size_t begin = squares_.size();
        for (const std::size_t place : face) {
          const Cell c = solid_.cell(place);
          squares_.push_back({c[u], c[v]});
        }
        std::sort(squares_.begin() + static_cast<std::ptrdiff_t>(begin), squares_.end());
        const std::size_t end = squares_.size();
        add_pushes(axis, sign, layer, begin, end);
        for (const bool swapped : {false, true}) {
          turned.clear();
          for (std::size_t i = begin; i < end; ++i)
            turned.push_back(swapped ? Square{squares_[i][1], squares_[i][0]} : squares_[i]);
          if (swapped) std::sort(turned.begin(), turned.end());
          slabs.clear();
          cut_into_slabs(turned, slabs);
          if (slabs.size() < 2 || slabs.size() >= max_slabs) continue;
          for (const GridRectangle& slab : slabs) {
            const std::size_t slab_begin = squares_.size();
            for (int i = slab.low[0]; i < slab.high[0]; ++i)
              for (int j = slab.low[1]; j < slab.high[1]; ++j)
                squares_.push_back(swapped ? Square{j, i} : Square{i, j});
            add_pushes(axis, sign, layer, slab_begin, squares_.size());
          }
        }
      }
    }
  }
}

bool Simplification::still_a_face(const Push& push) const {
  for (std::size_t i = push.begin; i < push.end; ++i) {
    Cell c{};
    c[push.axis] = push.layer;
    c[(push.axis + 1) % 3] = squares_[i][0];
    c[(push.axis + 2) % 3] = squares_[i][1];
    const std::size_t here = solid_.place(c);
    if (!solid_.inside(here) || solid_.inside(solid_.neighbor(here, push.axis, push.sign))) return false;
  }
  return true;
}

bool Simplification::flip_layer(const Push& push, int depth, Outcome& outcome) {
  waiting_.clear();
  for (std::size_t i = push.begin; i < push.end; ++i) {
    const Cell c = cell_of(push, squares_[i], depth);
    if (solid_.in_outermost_layer(c)) return false;
    if (solid_.inside(c) == push.inward) waiting_.push_back(c);
  }
  if (waiting_.empty() && depth > 0) return false;
  while (!waiting_.empty()) {
    refused_.clear();
    for (const Cell& c : waiting_) {
      const std::size_t here = solid_.place(c);
      const double cost = solid_.inside(here) ? -weight_[here] : weight_[here];
      if (solid_.flip_if_simple(c, outcome.corners)) {
        outcome.cost += cost;
        flipped_.push_back(c);
      } else {
        refused_.push_back(c);
      }
    }
    if (refused_.size() == waiting_.size()) return false;
    waiting_.assign(refused_.rbegin(), refused_.rend());
  }
  return true;
}

void Simplification::undo() {
  for (const Cell& c : flipped_) {
    const std::size_t here = solid_.place(c);
    solid_.set(here, !solid_.inside(here));
  }
  flipped_.clear();
}

bool Simplification::apply(const Push& push, int max_layers, Outcome& outcome) {
  constexpr std::int64_t max_more_corners = 8;  // on the way; more is a wall that is not worth the flips
  flipped_.clear();
  outcome = {};
  for (int depth = 0; depth < max_layers; ++depth) {
    if (!flip_layer(push, depth, outcome)) break;
    if (outcome.corners < 0) return true;
    if (outcome.corners > max_more_corners) break;
  }
  undo();
  return false;
}

// Cost for each corner removed; what makes the fit better counts as free but for a little.
double Simplification::rate(const Outcome& outcome) {
  constexpr double max_gain = 0.02;
  return std::max(outcome.cost, -max_gain) / static_cast<double>(-outcome.corners);
}

// Pushes by one layer that fit better and add no corner.
void Simplification::fit_faces() {
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    find_pushes();
    for (const Push& push : pushes_) {
      if (!still_a_face(push)) continue;
      flipped_.clear();
      Outcome outcome;
      if (flip_layer(push, 0, outcome) && outcome.corners <= 0 && outcome.cost < -1e-7) {
        corners_ += outcome.corners;
        changed = true;
      } else {
        undo();
      }
    }
    if (!changed) break;
  }
}

bool Simplification::reduce(std::size_t corners) {
  constexpr std::int64_t many = 700, some = 400, few = 150, fitted = 100;
  const auto target = static_cast<std::int64_t>(corners);
  while (corners_ > target) {
    find_pushes();
    const int max_layers = corners_ > some  ? 2
                           : corners_ > few ? 6
                                            : std::max({solid_.count(0), solid_.count(1), solid_.count(2)});
    candidates_.clear();
    for (std::size_t i = 0; i < pushes_.size(); ++i) {
      if (i % 16 == 0) host_.report(simplification_phase, 0, 0, static_cast<double>(corners_));
      Outcome outcome;
      if (!apply(pushes_[i], max_layers, outcome)) continue;
      undo();
      candidates_.push_back({rate(outcome), i});
    }
    if (candidates_.empty()) return false;
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.rate != b.rate ? a.rate < b.rate : a.push < b.push;
    });
    // A sixth of them at once while there are many corners; then fewer, since each changes what the others do.
    const auto sixth = static_cast<std::int64_t>(candidates_.size()) / 6;
    const std::int64_t most = std::max<std::int64_t>(1, corners_ > many ? sixth : std::min(sixth, corners_ / 60));
    std::int64_t done = 0;
    for (const Candidate& candidate : candidates_) {
      if (done >= most || corners_ <= target) break;
      const Push& push = pushes_[candidate.push];
      if (!still_a_face(push)) continue;
      Outcome outcome;
      if (!apply(push, max_layers, outcome)) continue;
      if (rate(outcome) > 1.3 * candidate.rate + 1e-6 && done > 0) {
        undo();
        continue;
      }
      corners_ += outcome.corners;
      ++done;
    }
    if (done == 0) return false;
    if (corners_ <= fitted) fit_faces();
  }
  return true;
}

}  // namespace orbicube::polycube
