#include "untangle/tetrahedra/foldover_energy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/vector_variants.h"
#include "untangle/foldover.h"

namespace orbicube::untangle {
namespace {

constexpr std::size_t piece = 1024;
// Elements between two reports: some milliseconds of one core.
constexpr std::size_t slab = 64 * piece;
constexpr double power = 2.0 / 3;

using base::Four;

Eigen::Matrix3d cofactors(const Eigen::Matrix3d& j) {
  Eigen::Matrix3d c;
  c.col(0) = j.col(1).cross(j.col(2));
  c.col(1) = j.col(2).cross(j.col(0));
  c.col(2) = j.col(0).cross(j.col(1));
  return c;
}

double power_of(double chi) {
  const double root = std::cbrt(chi);
  return root * root;
}

}  // namespace

FoldoverEnergy::FoldoverEnergy(std::span<const Element> elements, const Variables& variables, double lambda,
                               const base::Host& host)
    : elements_(elements),
      variables_(variables),
      lambda_(lambda),
      host_(host),
      pool_(host),
      curvature_(elements.size(), host.memory),
      force_(elements.size(), host.memory),
      incident_(host.memory),
      positions_(variables.vertices(), host.memory),
      forces_(variables.vertices(), host.memory),
      padded_(variables.size(), 0, host.memory),
      partial_((elements.size() + piece - 1) / piece, host.memory),
      assembly_(elements, variables, host),
      system_(host),
      right_(assembly_.matrix().size(), 0, host.memory),
      solution_(right_, host.memory) {
  for (const Element& element : elements)
    total_weight_ += element.weight;
  incident_.assign(variables.vertices(), [&](const auto& visit) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k)
        visit(elements[i].corner[k], static_cast<Index>(4 * i + k));
    }
  });
}

template <class Body>
void FoldoverEnergy::for_elements(const char* phase, const Body& body) const {
  for (std::size_t begin = 0; begin < elements_.size(); begin += slab) {
    host_.report(phase, 0, 0);
    const std::size_t count = std::min(slab, elements_.size() - begin);
    pool_.run_pieces(count, piece, [&](std::size_t from, std::size_t to) { body(begin + from, begin + to); });
  }
}

template <class Body>
void FoldoverEnergy::for_vertices(const Body& body) const {
  constexpr std::size_t at_once = 8192;
  for (std::size_t begin = 0; begin < forces_.size(); begin += at_once) {
    host_.report("untangle", 0, 0);
    const std::size_t count = std::min(at_once, forces_.size() - begin);
    pool_.run_pieces(count, piece, [&](std::size_t from, std::size_t to) { body(begin + from, begin + to); });
  }
}

EnergyValue FoldoverEnergy::value(std::span<const double> values, double eps) {
  variables_.expand(values, positions_);
  for_elements("untangle", [&](std::size_t begin, std::size_t end) {
    EnergyValue sum{0, std::numeric_limits<double>::infinity(), 0, 0};
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Matrix3d j = elements_[i].jacobian(positions_);
      const double d = j.determinant();
      sum.min_determinant = std::min(sum.min_determinant, d);
      sum.mean_determinant += elements_[i].weight * d;
      if (!(d > 0)) {
        ++sum.inverted;
        if (eps <= 0) {
          sum.energy = std::numeric_limits<double>::infinity();
          continue;
        }
      }
      const double chi = chi_of(d, eps).value;
      sum.energy += elements_[i].weight * (j.squaredNorm() / power_of(chi) + lambda_ * (1 + d * d) / chi);
    }
    partial_[begin / piece] = sum;
  });
  EnergyValue total{0, std::numeric_limits<double>::infinity(), 0, 0};
  for (const EnergyValue& part : partial_) {
    total.energy += part.energy;
    total.min_determinant = std::min(total.min_determinant, part.min_determinant);
    total.inverted += part.inverted;
    total.mean_determinant += part.mean_determinant / total_weight_;
  }
  for (std::size_t v = 0; v < pulls_.size(); ++v)
    total.energy += pulls_[v].value(positions_[v]);
  if (!std::isfinite(total.energy)) total.energy = std::numeric_limits<double>::infinity();
  return total;
}

void FoldoverEnergy::linearise(std::span<const double> values, double eps, std::span<double> gradient) {
  variables_.expand(values, positions_);
  for_elements("untangle", [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Element& element = elements_[i];
      Curvature& curvature = curvature_[i];
      const Eigen::Matrix3d j = element.jacobian(positions_);
      const Eigen::Matrix3d c = cofactors(j);
      const double d = j.col(0).dot(c.col(0));
      const auto [chi, root] = chi_of(d, eps);
      const double t = 1 / root;  // chi' / chi
      const double angle = element.weight / power_of(chi);
      const double volume = element.weight * lambda_ / chi;
      const double squares = j.squaredNorm();
      for (std::size_t k = 0; k < 4; ++k) {
        Eigen::Map<Vector3>(&curvature.entries[3 * k]).noalias() = j * element.gradient[k];
        Eigen::Map<Vector3>(&curvature.entries[Curvature::cofactors + 3 * k]).noalias() = c * element.gradient[k];
      }
      curvature.entries[Curvature::identity] = 2 * angle;
      curvature.entries[Curvature::mixed] = -2 * power * t * angle;
      curvature.entries[Curvature::squared] =
          power * (power + 1) * t * t * squares * angle + 2 * volume * ((1 - d * t) * (1 - d * t) + t * t);
      const Eigen::Matrix3d derivative =
          2 * angle * j + (-power * squares * t * angle + volume * (2 * d - (1 + d * d) * t)) * c;
      for (std::size_t k = 0; k < 4; ++k)
        force_[i][k].noalias() = derivative * element.gradient[k];
    }
  });
  // positions_ stay as they are until the next product.
  gather(gradient, [&](std::size_t v) -> Vector3 {
    return 2 * (pulls_[v].square * (positions_[v] - pulls_[v].at) - pulls_[v].linear);
  });
  set_system();
}

void FoldoverEnergy::solve(std::span<const double> gradient, int max_steps, double tolerance,
                           std::span<double> direction) {
  for (std::size_t i = 0; i < gradient.size(); ++i)
    direction[i] = -gradient[i];
  assembly_.scatter(direction, right_);
  system_.solve(right_, max_steps, tolerance, solution_);
  assembly_.gather(solution_, direction);
}

void FoldoverEnergy::multiply(std::span<const double> direction, std::span<double> product) {
  std::copy(direction.begin(), direction.end(), padded_.begin());
  variables_.expand_change(padded_, positions_);
  for_elements("untangle", [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Element& element = elements_[i];
      const Curvature& h = curvature_[i];
      const Eigen::Matrix3d change = element.jacobian(positions_);
      double along_jacobian = 0, along_cofactors = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        along_jacobian += h.of_jacobian(k).dot(positions_[element.corner[k]]);
        along_cofactors += h.of_cofactors(k).dot(positions_[element.corner[k]]);
      }
      const double mixed = h.entries[Curvature::mixed], squared = h.entries[Curvature::squared];
      for (std::size_t k = 0; k < 4; ++k)
        force_[i][k] = h.entries[Curvature::identity] * (change * element.gradient[k]) +
                       mixed * along_cofactors * h.of_jacobian(k) +
                       (mixed * along_jacobian + squared * along_cofactors) * h.of_cofactors(k);
    }
  });
  gather(product, [&](std::size_t v) -> Vector3 { return 2 * (pulls_[v].square * positions_[v]); });
}

// Adds up what the elements around each vertex say, in their order, and what it has of its own where there are pulls.
template <class Own>
void FoldoverEnergy::gather(std::span<double> sums, const Own& own) {
  for_vertices([&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vector3 sum = Vector3::Zero();
      if (!pulls_.empty()) sum = own(v);
      for (const Index corner : incident_[v])
        sum += force_[corner / 4][corner % 4];
      forces_[v] = sum;
    }
  });
  variables_.reduce(forces_, sums);
}

// What the elements around a vertex add to its row of blocks.
struct FoldoverEnergy::Row {
  // Blocks left of the diagonal that are worked on at once. Rows of hexahedra have some thirteen.
  static constexpr std::size_t most = 48;

  std::size_t vertex;
  std::span<const Index> incident;
  const Element* elements;
  const Curvature* curvature;
  const BlockAssembly* assembly;
  Index begin, end;                   // of the blocks left of the diagonal
  Eigen::Matrix3d *diagonal, *lower;  // `lower` of the whole matrix
};

ORBICUBE_VECTOR_VARIANTS void FoldoverEnergy::add_elements(const Row& row) {
  // The columns of the blocks, with an entry to spare: those of the diagonal last.
  std::array<Four, 3 * (Row::most + 1)> columns;
  constexpr std::array<Four, 3> axes = {Four{1, 0, 0, 0}, Four{0, 1, 0, 0}, Four{0, 0, 1, 0}};
  const auto add = [&](std::size_t block, double identity, Four p, const double* a, Four q, const double* c)
      __attribute__((always_inline)) {
    for (std::size_t j = 0; j < 3; ++j) {
      Four& column = columns[3 * block + j];
      column = column + identity * axes[j] + p * a[j] + q * c[j];
    }
  };
  const auto put = [](Eigen::Matrix3d& block, Eigen::Index j, const Four& column) {
    std::memcpy(&block(0, j), &column, 3 * sizeof(double));
  };
  const Index count = row.end - row.begin;
  for (Index first = 0; first == 0 || first < count; first += Row::most) {
    const Index some = std::min(count - first, static_cast<Index>(Row::most));
    std::fill_n(columns.begin(), 3 * some, Four{0, 0, 0, 0});
    for (Eigen::Index j = 0; j < 3; ++j) {
      const auto own = row.diagonal->col(j);
      columns[3 * some + static_cast<std::size_t>(j)] = Four{own[0], own[1], own[2], 0};
    }
    for (const Index own : row.incident) {
      const Index at = own / 4;
      const std::size_t corner = own % 4;
      const double* const h = row.curvature[at].entries.data();
      const Element& e = row.elements[at];
      const Vector3& g = e.gradient[corner];
      const double* const own_a = h + 3 * corner;
      const double* const own_c = own_a + Curvature::cofactors;
      const Four a = base::load(own_a), c = base::load(own_c);
      // The rows of this corner are identity g' and p a' + q c' over the others.
      const Four p = h[Curvature::mixed] * c, q = h[Curvature::mixed] * a + h[Curvature::squared] * c;
      if (first == 0) add(some, h[Curvature::identity] * g.squaredNorm(), p, own_a, q, own_c);
      for (std::size_t other = 0; other < 4; ++other) {
        if (e.corner[other] >= row.vertex) continue;
        const Index place = row.assembly->place(at, corner, other);
        if (place == no_index) continue;
        const Index block = place - row.begin - first;
        if (block >= some) continue;
        add(block, h[Curvature::identity] * g.dot(e.gradient[other]), p, h + 3 * other, q,
            h + Curvature::cofactors + 3 * other);
      }
    }
    for (Index i = 0; i < some; ++i) {
      for (Eigen::Index j = 0; j < 3; ++j)
        put(row.lower[row.begin + first + i], j, columns[3 * i + static_cast<std::size_t>(j)]);
    }
    for (Eigen::Index j = 0; j < 3; ++j)
      put(*row.diagonal, j, columns[3 * some + static_cast<std::size_t>(j)]);
  }
}

// The blocks of all rows.
void FoldoverEnergy::set_system() {
  BlockMatrix& matrix = assembly_.matrix();
  for_vertices([&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Eigen::Matrix3d& diagonal = matrix.diagonal[v];
      diagonal.setZero();
      if (!pulls_.empty()) diagonal = 2 * pulls_[v].square;
      add_elements({v, incident_[v], elements_.data(), curvature_.data(), &assembly_, matrix.row_begin[v],
                    matrix.row_begin[v + 1], &diagonal, matrix.lower.data()});
      // By the variables of coordinates, which may have the other sign.
      for (Eigen::Index a = 0; variables_.any_flipped() && a < 3; ++a) {
        if (variables_.is_flipped(v, static_cast<std::size_t>(a))) {
          diagonal.row(a) *= -1;
          diagonal.col(a) *= -1;
        }
        for (Index i = matrix.row_begin[v]; i < matrix.row_begin[v + 1]; ++i) {
          if (variables_.is_flipped(v, static_cast<std::size_t>(a))) matrix.lower[i].row(a) *= -1;
          if (variables_.is_flipped(matrix.column[i], static_cast<std::size_t>(a))) matrix.lower[i].col(a) *= -1;
        }
      }
    }
  });
  assembly_.finish(pool_);
  system_.factor(matrix);
}

}  // namespace orbicube::untangle
