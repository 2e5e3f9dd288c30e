#include "frame_field/graph/graph_solver.h"

#include <algorithm>
#include <cmath>

#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::frame_field {
namespace {

// Of the damped Jacobi steps before and after each coarse correction.
constexpr float damping = 0.65F;
// Corrections from groups of constant values come out too short (Braess 1995, "Towards algebraic multigrid for elliptic
// problems of second order").
constexpr float over_correction = 1.5F;
// Of the links of a constrained node, how much acts as a penalty on its group.
constexpr float penalty_share = 0.7F;
constexpr int coarsest_steps = 8;
// Where the links of every node are worth less than this many times its mass, the diagonal is a good preconditioner.
constexpr float multigrid_from = 24;

}  // namespace

template <std::size_t components>
GraphSolver<components>::GraphSolver(const DualGraph& graph, std::span<const CoarseGraph> hierarchy,
                                     std::span<const Tangent> tangents, const base::Host& host)
    : graph_(graph),
      hierarchy_(hierarchy),
      tangents_(tangents),
      host_(host),
      levels_(host.memory),
      tangent_begin_(chunk_count(graph.size()) + 1, tangents.size(), host.memory),
      residual_(graph.size(), host.memory),
      search_(graph.size(), host.memory),
      image_(graph.size(), host.memory),
      correction_(graph.size(), host.memory),
      partial_(chunk_count(graph.size()), 0.0, host.memory) {
  std::size_t t = 0;
  for (std::size_t c = 0; c + 1 < tangent_begin_.size(); ++c) {
    while (t < tangents.size() && tangents[t].node < c * chunk_size)
      ++t;
    tangent_begin_[c] = t;
  }
  for (std::size_t l = 0; l < hierarchy.size(); ++l) {
    Level level(host.memory);
    const CoarseGraph& coarse = hierarchy[l];
    level.penalty_of.assign(coarse.size(), no_index);
    level.mass.assign(coarse.size(), 0);
    for (Array<Value>* v : {&level.right, &level.x, &level.residual})
      v->resize(coarse.size());
    if (l == 0)
      add_tangents(coarse, level);
    else
      add_penalties(levels_.back(), coarse, level);
    levels_.push_back(std::move(level));
  }
}

// The rows of a group's penalty, which are made where there are none.
template <std::size_t components>
Index GraphSolver<components>::Level::rows_of(Index group) {
  Index& at = penalty_of[group];
  if (at == no_index) {
    at = static_cast<Index>(penalty_size.size());
    penalty_size.push_back(0);
    penalty.resize(penalty.size() + components);
  }
  return at;
}

// Penalties of the first level, from the constrained nodes.
template <std::size_t components>
void GraphSolver<components>::add_tangents(const CoarseGraph& coarse, Level& level) const {
  for (const Tangent& tangent : tangents_) {
    const Index at = level.rows_of(coarse.group[tangent.node]);
    float weight = 0;
    for (const float w : graph_.weights[tangent.node])
      weight += penalty_share * w;
    level.penalty_size[at] += weight;
    for (std::size_t i = 0; i < components; ++i) {
      for (std::size_t j = 0; j < components; ++j) {
        float along = 0;
        for (const Value& d : tangent.direction)
          along += d.at[i] * d.at[j];
        level.penalty[at * components + i].at[j] += weight * ((i == j ? 1.0F : 0.0F) - along);
      }
    }
  }
}

// Those of the other levels, from the next finer one.
template <std::size_t components>
void GraphSolver<components>::add_penalties(const Level& finer, const CoarseGraph& coarse, Level& level) {
  for (Index i = 0; i < finer.penalty_of.size(); ++i) {
    const Index from = finer.penalty_of[i];
    if (from == no_index) continue;
    const Index at = level.rows_of(coarse.group[i]);
    level.penalty_size[at] += finer.penalty_size[from];
    for (std::size_t r = 0; r < components; ++r) {
      for (std::size_t k = 0; k < stride; ++k)
        level.penalty[at * components + r].at[k] += finer.penalty[from * components + r].at[k];
    }
  }
}

template <std::size_t components>
void GraphSolver<components>::project(std::span<Value> v, std::size_t begin, std::size_t end) const {
  for (std::size_t t = tangent_begin_[begin / chunk_size]; t < tangents_.size() && tangents_[t].node < end; ++t) {
    Value& at = v[tangents_[t].node];
    Value result;
    for (const Value& d : tangents_[t].direction) {
      float along = 0;
      for (std::size_t k = 0; k < stride; ++k)
        along += at.at[k] * d.at[k];
      for (std::size_t k = 0; k < stride; ++k)
        result.at[k] += along * d.at[k];
    }
    at = result;
  }
}

template <std::size_t components>
float GraphSolver<components>::diagonal(const Equation& e, std::size_t node) const {
  const auto& w = graph_.weights[node];
  const float sum = e.tau * ((w[0] + w[1]) + (w[2] + w[3])) + (e.mass.empty() ? 0.0F : e.mass[node]);
  return sum > 0 ? sum : 1;
}

namespace {

// The sum over components, in double.
template <class Value>
double inner(const Value& a, const Value& b) {
  std::array<double, 4> lane{};
  for (std::size_t k = 0; k < a.at.size(); ++k)
    lane[k % 4] += static_cast<double>(a.at[k]) * static_cast<double>(b.at[k]);
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

}  // namespace

template <std::size_t components>
double GraphSolver<components>::apply(const Equation& e, std::span<const Value> x, std::span<Value> y) {
  sweep([&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& other = graph_.others[i];
      const auto& w = graph_.weights[i];
      const float own = e.tau * ((w[0] + w[1]) + (w[2] + w[3])) + (e.mass.empty() ? 0.0F : e.mass[i]);
      const Value &a = x[other[0]], &b = x[other[1]], &c = x[other[2]], &d = x[other[3]];
      const float wa = e.tau * w[0], wb = e.tau * w[1], wc = e.tau * w[2], wd = e.tau * w[3];
      for (std::size_t k = 0; k < stride; ++k)
        y[i].at[k] = own * x[i].at[k] - ((wa * a.at[k] + wb * b.at[k]) + (wc * c.at[k] + wd * d.at[k]));
    }
    project(y, begin, end);
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += inner(x[i], y[i]);
    partial_[chunk] = sum;
  });
  return sum_chunks();
}

template <std::size_t components>
double GraphSolver<components>::sum_chunks() const {
  double sum = 0;
  for (const double p : partial_)
    sum += p;
  return sum;
}

template <std::size_t components>
void GraphSolver<components>::restrict_mass(const Equation& e) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Array<float>& mass = levels_[l].mass;
    std::ranges::fill(mass, 0.0F);
    if (e.mass.empty()) continue;
    const Array<Index>& group = hierarchy_[l].group;
    for (std::size_t i = 0; i < group.size(); ++i)
      mass[group[i]] += l == 0 ? e.mass[i] : levels_[l - 1].mass[i];
  }
}

// residual = right - A x of a coarse level.
template <std::size_t components>
void GraphSolver<components>::coarse_residual(const Equation& e, std::size_t l) {
  Level& level = levels_[l];
  const CoarseGraph& graph = hierarchy_[l];
  const auto body = [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Value own = level.x[i];
      Value sum;
      for (Index n = graph.begin[i]; n < graph.begin[i + 1]; ++n) {
        const Value& other = level.x[graph.other[n]];
        const float w = graph.weight[n];
        for (std::size_t k = 0; k < stride; ++k)
          sum.at[k] += w * other.at[k];
      }
      const float scale = level.mass[i] + e.tau * graph.total_weight[i];
      Value result;
      for (std::size_t k = 0; k < stride; ++k)
        result.at[k] = level.right[i].at[k] - scale * own.at[k] + e.tau * sum.at[k];
      if (const Index at = level.penalty_of[i]; at != no_index) {
        for (std::size_t r = 0; r < components; ++r) {
          const float along = e.tau * own.at[r];
          const Value& row = level.penalty[at * components + r];
          for (std::size_t k = 0; k < stride; ++k)
            result.at[k] -= along * row.at[k];
        }
      }
      level.residual[i] = result;
    }
  };
  for_each_chunk(host_, graph.size(), body, least_of_little);
}

// x += damping residual / diagonal.
template <std::size_t components>
void GraphSolver<components>::coarse_smooth(const Equation& e, std::size_t l) {
  Level& level = levels_[l];
  const CoarseGraph& graph = hierarchy_[l];
  for (std::size_t i = 0; i < graph.size(); ++i) {
    float size = level.mass[i] + e.tau * graph.total_weight[i];
    if (const Index at = level.penalty_of[i]; at != no_index) size += e.tau * level.penalty_size[at];
    const float factor = size > 0 ? damping / size : 0;
    for (std::size_t k = 0; k < stride; ++k)
      level.x[i].at[k] += factor * level.residual[i].at[k];
  }
}

// x of a coarse level becomes about A^-1 right: twice the coarser level for each time on this one, for the coarsest are
// small.
template <std::size_t components>
void GraphSolver<components>::cycle(const Equation& e, std::size_t l) {
  Level& level = levels_[l];
  std::ranges::fill(level.x, Value{});
  level.residual = level.right;
  coarse_smooth(e, l);
  if (l + 1 == levels_.size()) {
    for (int step = 0; step < coarsest_steps; ++step) {
      coarse_residual(e, l);
      coarse_smooth(e, l);
    }
    return;
  }
  Level& coarser = levels_[l + 1];
  const Array<Index>& group = hierarchy_[l + 1].group;
  for (int visit = 0; visit < 2; ++visit) {
    coarse_residual(e, l);
    std::ranges::fill(coarser.right, Value{});
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t k = 0; k < stride; ++k)
        coarser.right[group[i]].at[k] += level.residual[i].at[k];
    }
    cycle(e, l + 1);
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t k = 0; k < stride; ++k)
        level.x[i].at[k] += over_correction * coarser.x[group[i]].at[k];
    }
    coarse_residual(e, l);
    coarse_smooth(e, l);
    if (visit == 0) {
      // Keeps the cycle symmetric: the second visit begins with a step as it ends with one.
      coarse_residual(e, l);
      coarse_smooth(e, l);
    }
  }
}

template <std::size_t components>
double GraphSolver<components>::precondition(const Equation& e, std::span<const Value> r, std::span<Value> z) {
  if (multigrid_) {
    apply(e, z, image_);
    Level& coarse = levels_.front();
    const Array<Index>& group = hierarchy_.front().group;
    std::ranges::fill(coarse.right, Value{});
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t k = 0; k < stride; ++k)
        coarse.right[group[i]].at[k] += r[i].at[k] - image_[i].at[k];
    }
    cycle(e, 0);
    sweep([&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i)
        image_[i] = coarse.x[group[i]];
      project(image_, begin, end);
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < stride; ++k)
          z[i].at[k] += over_correction * image_[i].at[k];
      }
    });
    apply(e, z, image_);
  }
  sweep([&](std::size_t begin, std::size_t end, std::size_t chunk) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (multigrid_) {
        const float scale = damping / diagonal(e, i);
        for (std::size_t k = 0; k < stride; ++k)
          z[i].at[k] += scale * (r[i].at[k] - image_[i].at[k]);
      }
      sum += inner(r[i], z[i]);
    }
    partial_[chunk] = sum;
  });
  return sum_chunks();
}

// What conjugate gradients work on.
template <std::size_t components>
struct GraphSolver<components>::System {
  GraphSolver& own;
  const Equation& e;
  std::span<const Value> right;
  std::span<Value> x;
  float first_step;  // of the preconditioner: damped when a coarse correction follows
  std::uint64_t step;

  double start() {
    own.apply(e, x, own.image_);
    own.sweep([&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < stride; ++k)
          own.residual_[i].at[k] = (right.empty() ? 0.0F : right[i].at[k]) - own.image_[i].at[k];
      }
      own.project(own.residual_, begin, end);
      for (std::size_t i = begin; i < end; ++i) {
        const float scale = first_step / own.diagonal(e, i);
        for (std::size_t k = 0; k < stride; ++k)
          own.correction_[i].at[k] = scale * own.residual_[i].at[k];
      }
    });
    const double product = own.precondition(e, own.residual_, own.correction_);
    own.search_ = own.correction_;
    return product;
  }
  double multiply() {
    own.host_.report(e.phase, step++, 0);
    return own.apply(e, own.search_, own.image_);
  }
  double advance(double length) {
    const auto by = static_cast<float>(length);
    own.sweep([&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        const float scale = first_step / own.diagonal(e, i);
        for (std::size_t k = 0; k < stride; ++k) {
          x[i].at[k] += by * own.search_[i].at[k];
          own.residual_[i].at[k] -= by * own.image_[i].at[k];
          own.correction_[i].at[k] = scale * own.residual_[i].at[k];
        }
      }
    });
    return own.precondition(e, own.residual_, own.correction_);
  }
  void turn(double share) {
    const auto keep = static_cast<float>(share);
    own.sweep([&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t k = 0; k < stride; ++k)
          own.search_[i].at[k] = own.correction_[i].at[k] + keep * own.search_[i].at[k];
      }
    });
  }
};

template <std::size_t components>
typename GraphSolver<components>::Outcome GraphSolver<components>::solve(const Equation& e,
                                                                         std::span<const Value> right,
                                                                         std::span<Value> x) {
  multigrid_ = !levels_.empty() && (e.mass.empty() || e.tau * 4 > multigrid_from * *std::ranges::min_element(e.mass));
  if (multigrid_) restrict_mass(e);
  System system{*this, e, right, x, multigrid_ ? damping : 1, 0};
  const auto solved = linear::conjugate_gradients(system, static_cast<int>(e.max_iterations), e.tolerance);
  return {static_cast<std::uint32_t>(solved.steps),
          solved.start > 0 ? std::sqrt(std::max(solved.end, 0.0) / solved.start) : 0};
}

template class GraphSolver<3>;
template class GraphSolver<9>;

}  // namespace orbicube::frame_field
