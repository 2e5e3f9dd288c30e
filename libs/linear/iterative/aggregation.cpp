#include "linear/iterative/aggregation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/grouping.h"

namespace orbicube::linear {
namespace {

constexpr std::size_t aggregate_size = 8;
constexpr double weak = 0.1;  // of the strongest coupling of an aggregate's first row

// The neighbors of each row and how strongly they are coupled to it, relative to the diagonal, so that contrasts of the
// coefficients do not matter by themselves.
struct Couplings {
  template <int block>
  Couplings(const BlockMatrix<block>& m, const base::Host& host)
      : begin(m.rows() + 1, host.memory),
        neighbor(2 * m.column.size(), host.memory),
        strength(neighbor.size(), host.memory) {
    base::group_by_key(
        std::span(begin), [&](const auto& visit) { for_each_coupling(m, host, visit); }, [](Index) {},
        [&](Index at, Index other, float c) {
          neighbor[at] = other;
          strength[at] = c;
        });
  }

  Array<Index> begin, neighbor;
  Array<float> strength;

 private:
  template <int block, class Visit>
  static void for_each_coupling(const BlockMatrix<block>& m, const base::Host& host, const Visit& visit) {
    for (Index v = 0; v < m.rows(); ++v) {
      if (v % base::items_between_reports == 0) host.report("solve", 0, 0);
      for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
        const Index w = m.column[i];
        const double size = std::sqrt(m.diagonal[v].trace() * m.diagonal[w].trace());
        const auto c = static_cast<float>(size > 0 ? std::max(0.0, -m.lower[i].trace()) / size : 0.0);
        visit(v, w, c);
        visit(w, v, c);
      }
    }
  }
};

// Grows one aggregate after the other.
class Aggregation {
 public:
  Aggregation(const Couplings& couplings, const Array<std::uint8_t>& own, Array<Index>& aggregate,
              const base::Host& host)
      : couplings_(couplings),
        own_(own),
        aggregate_(aggregate),
        candidates_(host.memory),
        place_(own.size(), no_index, host.memory) {}

  bool is_free(Index v) const { return own_[v] != 0 && aggregate_[v] == no_index; }

  // Grows aggregate `number` from a free row; returns its size. The row that came last goes to `added`.
  std::size_t grow(Index seed, Index number, Index& added) {
    candidates_.clear();
    added = seed;
    const double least = weak * strongest_coupling(seed);
    std::size_t size = 0;
    while (true) {
      aggregate_[added] = number;
      if (++size == aggregate_size) break;
      couple(added);
      const Candidate* best = nullptr;
      for (const Candidate& c : candidates_) {
        if (aggregate_[c.row] == no_index && (best == nullptr || c.coupling > best->coupling)) best = &c;
      }
      if (best == nullptr || best->coupling < least) break;
      added = best->row;
    }
    for (const Candidate& c : candidates_)
      place_[c.row] = no_index;
    return size;
  }

  // Of the aggregates other than `number` that row v is coupled to: takes the one of the strongest coupling into `best`
  // when that is above `most`.
  void look_around(Index v, Index number, float& most, Index& best) const {
    for (Index i = couplings_.begin[v]; i < couplings_.begin[v + 1]; ++i) {
      const Index other = aggregate_[couplings_.neighbor[i]];
      if (other == no_index || other == number || !(couplings_.strength[i] > most)) continue;
      most = couplings_.strength[i];
      best = other;
    }
  }

 private:
  struct Candidate {
    Index row;
    float coupling;
  };

  double strongest_coupling(Index v) const {
    double strongest = 0;
    for (Index i = couplings_.begin[v]; i < couplings_.begin[v + 1]; ++i)
      strongest = std::max(strongest, static_cast<double>(couplings_.strength[i]));
    return strongest;
  }

  // Adds the couplings of a row to the candidates.
  void couple(Index added) {
    for (Index i = couplings_.begin[added]; i < couplings_.begin[added + 1]; ++i) {
      const Index w = couplings_.neighbor[i];
      if (!is_free(w) || !(couplings_.strength[i] > 0)) continue;
      if (place_[w] == no_index) {
        place_[w] = static_cast<Index>(candidates_.size());
        candidates_.push_back({w, 0});
      }
      candidates_[place_[w]].coupling += couplings_.strength[i];
    }
  }

  const Couplings& couplings_;
  const Array<std::uint8_t>& own_;
  Array<Index>& aggregate_;
  Array<Candidate> candidates_;  // coupled to the aggregate that grows
  Array<Index> place_;           // of a row among them
};

}  // namespace

template <int block>
std::size_t make_aggregates(const BlockMatrix<block>& matrix, Array<Index>& aggregate, const base::Host& host) {
  const Couplings couplings(matrix, host);
  aggregate.assign(matrix.rows(), no_index);
  Aggregation aggregation(couplings, matrix.own, aggregate, host);
  std::size_t count = 0;
  for (Index seed = 0; seed < matrix.rows(); ++seed) {
    if (seed % base::items_between_reports == 0) host.report("solve", 0, 0);
    if (!aggregation.is_free(seed)) continue;
    const auto number = static_cast<Index>(count);
    Index added = seed;
    const std::size_t size = aggregation.grow(seed, number, added);
    if (size > 2) {
      ++count;
      continue;
    }
    // Too few: where their strongest coupling leads, or an aggregate of their own.
    Index best = no_index;
    float most = 0;
    aggregation.look_around(seed, number, most, best);
    if (size == 2) aggregation.look_around(added, number, most, best);
    if (best == no_index) {
      ++count;
      continue;
    }
    aggregate[seed] = best;
    if (size == 2) aggregate[added] = best;
  }
  return count;
}

template std::size_t make_aggregates<1>(const BlockMatrix<1>&, Array<Index>&, const base::Host&);
template std::size_t make_aggregates<2>(const BlockMatrix<2>&, Array<Index>&, const base::Host&);
template std::size_t make_aggregates<3>(const BlockMatrix<3>&, Array<Index>&, const base::Host&);

}  // namespace orbicube::linear
