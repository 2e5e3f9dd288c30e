// The energy of a map of tetrahedra that is finite where they are inverted and drives them back (Garanzha, Kaporin,
// Kudryavtseva, Protais, Ray and Sokolov 2021, "Foldover-free maps in 50 lines of code"), with its gradient and a
// positive semidefinite part of its Hessian.
//
//   sum over elements of weight [ |J|^2 / chi^(2/3) + lambda (1 + D^2) / chi ],  D = det J,
//   chi(D, eps) = (D + sqrt(eps^2 + D^2)) / 2.
//
// With eps = 0 chi is D: a barrier, infinite unless every element is positive. With p = 2/3, t = chi' / chi, a = vec J
// and c = vec cof J the block of an element is
//   2 / chi^p [I - p t (a c' + c a')] + [p (p + 1) t^2 |a|^2 / chi^p + 2 lambda / chi ((1 - D t)^2 + t^2)] c c',
// the identity and two vectors: products with it need no matrix.
#pragma once

#include <span>

#include "base/grouping.h"
#include "base/threads/thread_pool.h"
#include "untangle/tetrahedra/block_assembly.h"
#include "untangle/tetrahedra/elements.h"

namespace orbicube::untangle {

// What a vertex is pulled to: the quadratic d' square d - 2 linear' d + constant of d = position - at.
struct Pull {
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Vector3 linear = Vector3::Zero(), at = Vector3::Zero();
  double constant = 0;

  // weight times the square of the distance to the plane through q with the unit normal n.
  void to_plane(const Vector3& n, const Vector3& q, double weight) {
    const double distance = n.dot(q - at);
    square += weight * n * n.transpose();
    linear += weight * distance * n;
    constant += weight * distance * distance;
  }
  void to_point(const Vector3& q, double weight) {
    square.diagonal().array() += weight;
    linear += weight * (q - at);
    constant += weight * (q - at).squaredNorm();
  }
  double value(const Vector3& position) const {
    const Vector3 d = position - at;
    return d.dot(square * d) - 2 * linear.dot(d) + constant;
  }
};

struct EnergyValue {
  double energy;
  double min_determinant;
  std::size_t inverted;     // elements with D <= 0
  double mean_determinant;  // by weights
};

class FoldoverEnergy {
 public:
  // Keeps views of elements and variables. About 600 bytes an element. `lambda` is how much changes of volume count.
  FoldoverEnergy(std::span<const Element> elements, const Variables& variables, double lambda, const base::Host& host);

  // Added to the energy from now on: one for each vertex, or none. Keeps a view.
  void set_pulls(std::span<const Pull> pulls) { pulls_ = pulls; }

  // Solves the linear systems from now on; none: this library does.
  void set_engine(BlockEngine* engine) { system_.set_engine(engine); }

  // At values of all variables. With eps 0 infinite unless every element is positive.
  EnergyValue value(std::span<const double> values, double eps);

  // Sets where the Hessian is taken; the gradient goes to `gradient`, an entry a free variable.
  void linearise(std::span<const double> values, double eps, std::span<double> gradient);
  // Where the Hessian's part times `direction` is -gradient, by conjugate gradients: at most the given number of steps,
  // or until the preconditioned residual is `tolerance` of what it was.
  void solve(std::span<const double> gradient, int max_steps, double tolerance, std::span<double> direction);
  // The product of the Hessian's part with `direction`, both with an entry a free variable.
  void multiply(std::span<const double> direction, std::span<double> product);

  const Variables& variables() const { return variables_; }
  const base::ThreadPool& pool() const { return pool_; }
  // Of the last linearise().
  const BlockMatrix& matrix() const { return assembly_.matrix(); }
  const BlockAssembly& assembly() const { return assembly_; }

 private:
  // Of an element: J times the gradient of each corner, then cof J times these, then the factors of I, a c' + c a',
  // c c'. A block of the Hessian is made of those of its two corners.
  struct Curvature {
    static constexpr std::size_t cofactors = 12, identity = 24, mixed = 25, squared = 26;
    std::array<double, 27> entries;

    Eigen::Map<const Vector3> of_jacobian(std::size_t corner) const {
      return Eigen::Map<const Vector3>(&entries[3 * corner]);
    }
    Eigen::Map<const Vector3> of_cofactors(std::size_t corner) const {
      return Eigen::Map<const Vector3>(&entries[cofactors + 3 * corner]);
    }
  };

  template <class Body>
  void for_elements(const char* phase, const Body& body) const;
  template <class Body>
  void for_vertices(const Body& body) const;
  template <class Own>
  void gather(std::span<double> sums, const Own& own);
  void set_system();
  struct Row;
  static void add_elements(const Row& row);

  std::span<const Element> elements_;
  std::span<const Pull> pulls_;
  const Variables& variables_;
  double lambda_;
  double total_weight_ = 0;
  const base::Host& host_;
  base::ThreadPool pool_;
  Array<Curvature> curvature_;
  Array<std::array<Vector3, 4>> force_;  // on the corners of each element
  base::Groups<Index, Index> incident_;  // of each vertex: 4 element + corner
  Array<Vector3> positions_, forces_;    // of each vertex
  Array<double> padded_;                 // a direction, with 0 for what stays
  Array<EnergyValue> partial_;
  BlockAssembly assembly_;
  BlockSolver system_;
  Array<double> right_, solution_;  // of the system
};

}  // namespace orbicube::untangle
