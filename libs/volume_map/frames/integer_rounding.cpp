#include "volume_map/frames/integer_rounding.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grouping.h"

namespace orbicube::volume_map {
namespace {

struct InBound {
  Index bound;
  int factor;
};

// The search by branches, depth first: values of each variable in the order of their cost, as long as the cost stays
// below the best.
class Branches {
 public:
  // Variables are chosen in this order; there must be one. `bounds_of` has the bounds of each.
  Branches(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& best, std::span<const Index> order,
           const IntegerForms& forms, std::span<const LowerBound> bounds, const base::Groups<InBound>& bounds_of,
           const base::Host& host)
      : order_(order),
        bounds_(bounds),
        bounds_of_(bounds_of),
        host_(host),
        count_(order.size()),
        centre_(best.size()),
        nothing_(1e-5 * curvature.trace() / static_cast<double>(order.size())),
        value_(count_, 0, host.memory),
        middle_(count_, 0, host.memory),
        above_(count_ + 1, 0, host.memory),
        tried_(count_, 0, host.memory),
        open_(bounds.size(), 0, host.memory),
        sums_(bounds.size(), 0, host.memory) {
    // Of the permuted curvature R' R the last variable is the first to be chosen: the one that was rounded first.
    Eigen::MatrixXd permuted(best.size(), best.size());
    for (std::size_t i = 0; i < count_; ++i) {
      centre_[static_cast<Eigen::Index>(i)] = best[at(i)];
      for (std::size_t j = 0; j < count_; ++j)
        permuted(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = curvature(at(i), at(j));
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(permuted);
    factored_ = factor.info() == Eigen::Success;
    if (factored_) r_ = factor.matrixU();
    for (std::size_t b = 0; b < bounds.size(); ++b)
      open_[b] = forms.terms(bounds[b].form).size();
  }

  // Returns whether the curvature was positive definite in floating point. Otherwise nothing can be searched.
  bool factored() const { return factored_; }

  // Sets `found` to values that meet all bounds at less cost than `least`, and that to their cost, where it finds some.
  // Returns whether it came to its end. May be called once.
  bool search(std::uint64_t max_nodes, double& least, Eigen::VectorXd& found) {
    std::uint64_t nodes = 0;
    std::size_t level = count_ - 1;
    enter(level);
    while (nodes < max_nodes) {
      if (++nodes % 256 == 0) host_.report("round", nodes, max_nodes);
      const int step = choose_next(level);
      const auto row = static_cast<Eigen::Index>(level);
      const double off = r_(row, row) * (value_[level] - middle_[level]);
      const double total = above_[level + 1] + off * off;
      // Where the whole lies costs nothing: one place is as good as another.
      const bool idle = step > 0 && r_(row, row) * r_(row, row) < nothing_;
      if (idle || total >= least * (1 - 1e-12)) {
        if (++level == count_) return true;
        account(level, -1);
        continue;
      }
      if (!account(level, 1)) {
        account(level, -1);
        // Beyond some cells a bound may rule out one side for ever; the cost ends that.
        continue;
      }
      if (level == 0) {
        least = total;
        for (std::size_t i = 0; i < count_; ++i)
          found[at(i)] = value_[i];
        account(0, -1);
        continue;
      }
      above_[level] = total;
      enter(--level);
    }
    return false;
  }

 private:
  Eigen::Index at(std::size_t level) const { return static_cast<Eigen::Index>(order_[count_ - 1 - level]); }

  void enter(std::size_t level) {
    double sum = 0;
    const auto row = static_cast<Eigen::Index>(level);
    for (std::size_t j = level + 1; j < count_; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      sum += r_(row, column) * (value_[j] - centre_[column]);
    }
    middle_[level] = centre_[row] - sum / r_(row, row);
    tried_[level] = 0;
  }

  // Sets the next value around the middle: nearest, then on both sides in turn. Returns how many there were before.
  int choose_next(std::size_t level) {
    const double nearest = std::round(middle_[level]);
    const int step = tried_[level]++;
    const double side = middle_[level] >= nearest ? 1 : -1;
    value_[level] = nearest + (step % 2 == 1 ? side : -side) * ((step + 1) / 2);
    return step;
  }

  // Adds a value to the bounds of its variable, or takes it away. Returns whether those that are complete are met.
  bool account(std::size_t level, int direction) {
    bool met = true;
    const auto variable = static_cast<std::size_t>(at(level));
    for (const auto& [b, times] : bounds_of_[variable]) {
      sums_[b] += direction * times * value_[level];
      open_[b] -= static_cast<std::size_t>(direction);
      met = met && (open_[b] > 0 || sums_[b] >= bounds_[b].least);
    }
    return met;
  }

  std::span<const Index> order_;
  std::span<const LowerBound> bounds_;
  const base::Groups<InBound>& bounds_of_;
  const base::Host& host_;
  std::size_t count_;
  Eigen::VectorXd centre_;
  Eigen::MatrixXd r_;
  bool factored_ = false;
  double nothing_;                        // the curvature of a direction in which all places are as good
  Array<double> value_, middle_, above_;  // of each level, the last one the first to be chosen
  Array<int> tried_;
  Array<std::size_t> open_;  // of each bound: variables that are not chosen
  Array<double> sums_;
};

class Search {
 public:
  Search(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& best, const IntegerForms& forms,
         std::span<const LowerBound> bounds, const base::Host& host)
      : curvature_(curvature),
        best_(best),
        forms_(forms),
        bounds_(bounds),
        host_(host),
        order_(host.memory),
        bounds_of_(host.memory),
        sums_(bounds.size(), 0, host.memory),
        now_(Eigen::VectorXd::Zero(best.size())) {
    bounds_of_.assign(static_cast<std::size_t>(best.size()), [&](const auto& visit) {
      for (Index b = 0; b < bounds.size(); ++b) {
        for (const IntegerTerm& term : forms.terms(bounds[b].form))
          visit(term.unknown, InBound{b, term.factor});
      }
    });
  }

  // One after another is rounded, the nearest to an integer first, and the others take their best positions given
  // those.
  void greedy() {
    const Eigen::Index count = best_.size();
    Eigen::MatrixXd covariance = curvature_.inverse();
    const Eigen::VectorXd whole = covariance.diagonal();
    Eigen::VectorXd place = best_;
    Array<std::uint8_t> done(static_cast<std::size_t>(count), 0, host_.memory);
    Array<std::size_t> open(bounds_.size(), 0, host_.memory);  // variables of each bound that are not rounded yet
    for (std::size_t b = 0; b < bounds_.size(); ++b)
      open[b] = forms_.terms(bounds_[b].form).size();
    for (Eigen::Index round = 0; round < count; ++round) {
      host_.report("round", static_cast<std::uint64_t>(round), static_cast<std::uint64_t>(count));
      Eigen::Index next = -1;
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < count; ++i) {
        const double off = std::abs(place[i] - std::round(place[i]));
        if (done[static_cast<std::size_t>(i)] != 0 || off >= least - 1e-12) continue;
        least = off;
        next = i;
      }
      double value = std::round(place[next]);
      // A bound whose last variable this is says what it may be.
      for (const auto& [b, factor] : bounds_of_[static_cast<std::size_t>(next)]) {
        if (--open[b] > 0) continue;
        const double rest = bounds_[b].least - sums_[b];
        if (factor > 0)
          value = std::max(value, std::ceil(rest / factor));
        else
          value = std::min(value, std::floor(rest / factor));
      }
      set(next, value);
      const double variance = covariance(next, next);
      if (variance > 1e-13 * whole[next]) {  // or nothing depends on it any more, but for rounding
        const Eigen::VectorXd column = covariance.col(next);
        place += column * ((value - place[next]) / variance);
        covariance -= column * (column.transpose() / variance);
      }
      place[next] = value;
      done[static_cast<std::size_t>(next)] = 1;
      order_.push_back(static_cast<Index>(next));
    }
  }

  // Steps of 1 of one variable, or of two of one bound, while bounds or the cost become better.
  void descend() {
    Eigen::VectorXd gradient = curvature_ * (now_ - best_);
    const auto change = [&](Eigen::Index i, double by) {
      set(i, now_[i] + by);
      gradient += by * curvature_.col(i);
    };
    const auto gain = [&](Eigen::Index i, double by, Eigen::Index j, double then) {
      double rise = by * (2 * gradient[i] + by * curvature_(i, i));
      if (j >= 0) rise += then * (2 * gradient[j] + then * curvature_(j, j)) + 2 * by * then * curvature_(i, j);
      return rise;
    };
    double bad = violation();
    const double little = 1e-9 * curvature_.trace() / static_cast<double>(best_.size() + 1);
    const auto attempt = [&](Eigen::Index i, double by, Eigen::Index j, double then) {
      const double rise = gain(i, by, j, then);
      const double worse = violation_change(i, by, j, then);
      // Numbers that are not finite gain nothing, and beyond 2^53 a step of 1 is none.
      if (!(worse < 0 || (worse == 0 && rise <= -little)) || now_[i] + by == now_[i]) return false;
      change(i, by);
      if (j >= 0) change(j, then);
      bad += worse;
      return true;
    };
    for (bool any = true; any;) {
      any = false;
      for (Eigen::Index i = 0; i < best_.size(); ++i) {
        host_.report("round", 0, 0);
        for (const double by : {1.0, -1.0}) {
          while (attempt(i, by, -1, 0)) {
            any = true;
            host_.report("round", 0, 0);
          }
        }
        if (best_.size() > 400) continue;
        for (Eigen::Index j = 0; j < i; ++j) {
          for (const double by : {1.0, -1.0}) {
            for (const double then : {1.0, -1.0})
              any = attempt(i, by, j, then) || any;
          }
        }
      }
    }
  }

  // Returns whether a search by branches came to its end.
  bool branch(std::uint64_t max_nodes) {
    if (best_.size() == 0) return true;
    Branches branches(curvature_, best_, order_, forms_, bounds_, bounds_of_, host_);
    if (!branches.factored()) return false;
    double least = violation() > 0 ? std::numeric_limits<double>::infinity() : cost();
    Eigen::VectorXd found = now_;
    const bool complete = branches.search(max_nodes, least, found);
    for (Eigen::Index i = 0; i < found.size(); ++i)
      now_[i] = 0;
    std::fill(sums_.begin(), sums_.end(), 0.0);
    for (Eigen::Index i = 0; i < found.size(); ++i)
      set(i, found[i]);
    return complete && std::isfinite(least);
  }

  Rounding result(bool optimal) const {
    Rounding r;
    r.integers = now_;
    r.cost = cost();
    r.optimal = optimal;
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      if (sums_[b] >= bounds_[b].least) continue;
      if (r.violated++ == 0) r.first_violated = b;
    }
    return r;
  }

 private:
  void set(Eigen::Index i, double value) {
    for (const auto& [b, factor] : bounds_of_[static_cast<std::size_t>(i)])
      sums_[b] += factor * (value - now_[i]);
    now_[i] = value;
  }
  double cost() const { return (now_ - best_).dot(curvature_ * (now_ - best_)); }
  double violation() const {
    double sum = 0;
    for (std::size_t b = 0; b < bounds_.size(); ++b)
      sum += std::max(0.0, bounds_[b].least - sums_[b]);
    return sum;
  }
  double violation_change(Eigen::Index i, double by, Eigen::Index j, double then) const {
    double change = 0;
    const auto factor_of = [&](Index bound, Eigen::Index of) {
      for (const IntegerTerm& term : forms_.terms(bounds_[bound].form)) {
        if (static_cast<Eigen::Index>(term.unknown) == of) return term.factor;
      }
      return 0;
    };
    const auto add = [&](Index b, double move) {
      change += std::max(0.0, bounds_[b].least - sums_[b] - move) - std::max(0.0, bounds_[b].least - sums_[b]);
    };
    for (const auto& [b, factor] : bounds_of_[static_cast<std::size_t>(i)])
      add(b, factor * by + (j >= 0 ? factor_of(b, j) * then : 0));
    if (j < 0) return change;
    for (const auto& [b, factor] : bounds_of_[static_cast<std::size_t>(j)]) {
      if (factor_of(b, i) == 0) add(b, factor * then);
    }
    return change;
  }

  const Eigen::MatrixXd& curvature_;
  const Eigen::VectorXd& best_;
  const IntegerForms& forms_;
  std::span<const LowerBound> bounds_;
  const base::Host& host_;
  Array<Index> order_;               // in which greedy() rounded
  base::Groups<InBound> bounds_of_;  // of each variable
  Array<double> sums_;               // of each bound
  Eigen::VectorXd now_;
};

}  // namespace

Rounding round_integers(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& best, const IntegerForms& forms,
                        std::span<const LowerBound> bounds, const RoundingOptions& options, const base::Host& host) {
  Search search(curvature, best, forms, bounds, host);
  search.greedy();
  search.descend();
  return search.result(search.branch(options.max_nodes));
}

}  // namespace orbicube::volume_map
