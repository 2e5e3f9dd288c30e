#include "volume_map/foldover_energy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::volume_map {
namespace {

constexpr std::size_t piece = 1024;
// Elements between two reports: some milliseconds of one core.
constexpr std::size_t slab = 64 * piece;
constexpr std::size_t dot_piece = 4096;
constexpr double power = 2.0 / 3;

struct Chi {
  double value, rate;  // chi, chi' / chi
};

Chi chi_of(double determinant, double eps) {
  const double root = std::sqrt(eps * eps + determinant * determinant);
  // Without cancellation on the negative side.
  const double value = determinant > 0 ? 0.5 * (determinant + root) : 0.5 * eps * eps / (root - determinant);
  return {value, 1 / root};
}

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
      team_(host),
      curvature_(elements.size(), host.memory),
      force_(elements.size(), host.memory),
      incident_begin_(variables.vertices() + 1, 0, host.memory),
      incident_(4 * elements.size(), host.memory),
      positions_(variables.vertices(), host.memory),
      forces_(variables.vertices(), host.memory),
      inverse_block_(variables.vertices(), host.memory),
      inverse_shared_(variables.free(), 0, host.memory),
      padded_(variables.size(), 0, host.memory),
      partial_((elements.size() + piece - 1) / piece, host.memory),
      residual_(host.memory),
      preconditioned_(host.memory),
      search_(host.memory),
      product_(host.memory),
      partial_dot_(host.memory) {
  for (const Element& element : elements) {
    total_weight_ += element.weight;
    for (const Index v : element.corner)
      ++incident_begin_[v + 1];
  }
  for (std::size_t v = 0; v < variables.vertices(); ++v)
    incident_begin_[v + 1] += incident_begin_[v];
  Array<Index> next(incident_begin_, host.memory);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k)
      incident_[next[elements[i].corner[k]]++] = static_cast<Index>(4 * i + k);
  }
  if (variables.any_shared()) {
    residual_.resize(variables.free());
    preconditioned_ = search_ = product_ = residual_;
    partial_dot_.resize((variables.free() + dot_piece - 1) / dot_piece);
    return;
  }
  Array<std::uint8_t> active(variables.vertices(), 0, host.memory);
  for (std::size_t v = 0; v < active.size(); ++v)
    active[v] = variables.is_own(v, 0) || variables.is_own(v, 1) || variables.is_own(v, 2);
  system_.emplace(elements, active, host);
}

template <class Body>
void FoldoverEnergy::for_elements(const char* phase, const Body& body) const {
  for (std::size_t begin = 0; begin < elements_.size(); begin += slab) {
    host_.report(phase, 0, 0);
    const std::size_t count = std::min(slab, elements_.size() - begin);
    team_.run_pieces(count, piece, [&](std::size_t from, std::size_t to) { body(begin + from, begin + to); });
  }
}

EnergyValue FoldoverEnergy::value(std::span<const double> values, double eps) {
  variables_.expand(values, positions_);
  for_elements("untangle", [&](std::size_t begin, std::size_t end) {
    EnergyValue sum{0, std::numeric_limits<double>::infinity(), 0, 0};
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Matrix3d j = elements_[i].jacobian(positions_);
      const double d = j.determinant();
      sum.least_determinant = std::min(sum.least_determinant, d);
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
    total.least_determinant = std::min(total.least_determinant, part.least_determinant);
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
      const auto [chi, t] = chi_of(d, eps);
      const double angle = element.weight / power_of(chi);
      const double volume = element.weight * lambda_ / chi;
      const double squares = j.squaredNorm();
      curvature.jacobian = j;
      curvature.cofactors = c;
      curvature.identity = 2 * angle;
      curvature.mixed = -2 * power * t * angle;
      curvature.squared =
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
  if (system_)
    set_system();
  else
    set_blocks();
}

void FoldoverEnergy::solve(std::span<const double> gradient, int most_steps, double tolerance,
                           std::span<double> direction) {
  if (!system_) {
    solve_by_products(gradient, most_steps, tolerance, direction);
    return;
  }
  for (std::size_t i = 0; i < gradient.size(); ++i)
    padded_[i] = -gradient[i];
  variables_.expand(padded_, forces_);
  system_->solve(forces_, most_steps, tolerance, positions_);
  variables_.reduce(positions_, direction);
}

double FoldoverEnergy::dot(std::span<const double> a, std::span<const double> b) {
  team_.run_pieces(a.size(), dot_piece, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += a[i] * b[i];
    partial_dot_[begin / dot_piece] = sum;
  });
  double total = 0;
  for (const double part : partial_dot_)
    total += part;
  return total;
}

// Conjugate gradients (Hestenes and Stiefel 1952), from 0.
void FoldoverEnergy::solve_by_products(std::span<const double> gradient, int most_steps, double tolerance,
                                       std::span<double> direction) {
  const std::size_t count = gradient.size();
  for (std::size_t i = 0; i < count; ++i) {
    direction[i] = 0;
    residual_[i] = -gradient[i];
  }
  precondition(residual_, preconditioned_);
  search_ = preconditioned_;
  double rz = dot(residual_, preconditioned_);
  const double enough = tolerance * tolerance * rz;
  for (int k = 0; k < most_steps && rz > enough; ++k) {
    multiply(search_, product_);
    const double curvature = dot(search_, product_);
    if (!(curvature > 0) || !std::isfinite(curvature)) break;
    const double length = rz / curvature;
    for (std::size_t i = 0; i < count; ++i) {
      direction[i] += length * search_[i];
      residual_[i] -= length * product_[i];
    }
    precondition(residual_, preconditioned_);
    const double next = dot(residual_, preconditioned_);
    const double beta = next / rz;
    rz = next;
    for (std::size_t i = 0; i < count; ++i)
      search_[i] = preconditioned_[i] + beta * search_[i];
  }
}

void FoldoverEnergy::multiply(std::span<const double> direction, std::span<double> product) {
  std::copy(direction.begin(), direction.end(), padded_.begin());
  variables_.expand(padded_, positions_);
  for_elements("untangle", [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Element& element = elements_[i];
      const Curvature& h = curvature_[i];
      const Eigen::Matrix3d change = element.jacobian(positions_);
      const double along_jacobian = h.jacobian.cwiseProduct(change).sum();
      const double along_cofactors = h.cofactors.cwiseProduct(change).sum();
      const Eigen::Matrix3d answer = h.identity * change + h.mixed * along_cofactors * h.jacobian +
                                     (h.mixed * along_jacobian + h.squared * along_cofactors) * h.cofactors;
      for (std::size_t k = 0; k < 4; ++k)
        force_[i][k].noalias() = answer * element.gradient[k];
    }
  });
  gather(product, [&](std::size_t v) -> Vector3 { return 2 * (pulls_[v].square * positions_[v]); });
}

// Adds up what the elements around each vertex say, in their order, and what it has of its own where there are pulls.
template <class Own>
void FoldoverEnergy::gather(std::span<double> sums, const Own& own) {
  team_.run_pieces(forces_.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vector3 sum = Vector3::Zero();
      if (!pulls_.empty()) sum = own(v);
      for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i)
        sum += force_[incident_[i] / 4][incident_[i] % 4];
      forces_[v] = sum;
    }
  });
  variables_.reduce(forces_, sums);
}

void FoldoverEnergy::set_blocks() {
  team_.run_pieces(forces_.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      if (!pulls_.empty()) block = 2 * pulls_[v].square;
      for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i) {
        const Curvature& h = curvature_[incident_[i] / 4];
        const Vector3& g = elements_[incident_[i] / 4].gradient[incident_[i] % 4];
        const Vector3 a = h.jacobian * g, c = h.cofactors * g;
        block.diagonal().array() += h.identity * g.squaredNorm();
        block.noalias() += h.mixed * (a * c.transpose() + c * a.transpose()) + h.squared * c * c.transpose();
      }
      forces_[v] = block.diagonal();
      for (Eigen::Index a = 0; a < 3; ++a) {
        if (variables_.is_own(v, static_cast<std::size_t>(a))) continue;
        block.row(a).setZero();
        block.col(a).setZero();
        block(a, a) = 1;
      }
      block.diagonal() *= 1 + 1e-9;
      block.diagonal().array() += 1e-300;
      Eigen::Matrix3d inverse = block.inverse();
      if (!inverse.allFinite()) inverse = block.diagonal().cwiseInverse().asDiagonal();
      for (Eigen::Index a = 0; a < 3; ++a) {
        if (variables_.is_own(v, static_cast<std::size_t>(a))) continue;
        inverse.row(a).setZero();
        inverse.col(a).setZero();
      }
      inverse_block_[v] = inverse;
    }
  });
  variables_.reduce(forces_, inverse_shared_);
  for (double& entry : inverse_shared_)
    entry = entry > 0 ? 1 / entry : 1;
}

// The blocks of all rows; of coordinates that stay only the diagonal.
void FoldoverEnergy::set_system() {
  team_.run_pieces(forces_.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Eigen::Matrix3d& diagonal = system_->diagonal()[v];
      diagonal.setZero();
      for (Eigen::Matrix3d& block : system_->off_diagonal_of(v))
        block.setZero();
      if (!pulls_.empty()) diagonal = 2 * pulls_[v].square;
      for (Index i = incident_begin_[v]; i < incident_begin_[v + 1]; ++i) {
        const Index at = incident_[i] / 4;
        const std::size_t corner = incident_[i] % 4;
        const Curvature& h = curvature_[at];
        const Element& e = elements_[at];
        const Vector3& g = e.gradient[corner];
        const Vector3 a = h.jacobian * g, c = h.cofactors * g;
        // The rows of this corner are identity g' and p a' + q c' over the others.
        const Vector3 p = h.mixed * c, q = h.mixed * a + h.squared * c;
        diagonal.diagonal().array() += h.identity * g.squaredNorm();
        diagonal.noalias() += p * a.transpose() + q * c.transpose();
        for (std::size_t other = 0; other < 4; ++other) {
          if (e.corner[other] >= v) continue;
          const Index place = system_->place(at, corner, other);
          if (place == no_index) continue;
          Eigen::Matrix3d& block = system_->off_diagonal()[place];
          const Vector3& f = e.gradient[other];
          block.diagonal().array() += h.identity * g.dot(f);
          block.noalias() += p * (h.jacobian * f).transpose() + q * (h.cofactors * f).transpose();
        }
      }
      // What stays has the size of the rest, or 1.
      const double trace = diagonal.trace();
      for (Eigen::Index a = 0; a < 3; ++a) {
        if (variables_.is_own(v, static_cast<std::size_t>(a))) continue;
        diagonal.row(a).setZero();
        diagonal.col(a).setZero();
        diagonal(a, a) = trace > 0 ? trace : 1;
      }
      const auto columns = system_->columns_of(v);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        for (std::size_t a = 0; a < 3; ++a) {
          const auto at = static_cast<Eigen::Index>(a);
          if (!variables_.is_own(v, a)) system_->off_diagonal_of(v)[k].row(at).setZero();
          if (!variables_.is_own(columns[k], a)) system_->off_diagonal_of(v)[k].col(at).setZero();
        }
      }
    }
  });
  system_->factor();
}

void FoldoverEnergy::precondition(std::span<const double> direction, std::span<double> result) const {
  for (std::size_t i = 0; i < direction.size(); ++i)
    result[i] = inverse_shared_[i] * direction[i];
  team_.run_pieces(inverse_block_.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vector3 x = Vector3::Zero();
      bool any = false;
      for (std::size_t a = 0; a < 3; ++a) {
        if (!variables_.is_own(v, a)) continue;
        x[static_cast<Eigen::Index>(a)] = direction[variables_.of(v, a)];
        any = true;
      }
      if (!any) continue;
      const Vector3 y = inverse_block_[v] * x;
      for (std::size_t a = 0; a < 3; ++a) {
        if (variables_.is_own(v, a)) result[variables_.of(v, a)] = y[static_cast<Eigen::Index>(a)];
      }
    }
  });
}

}  // namespace orbicube::volume_map
