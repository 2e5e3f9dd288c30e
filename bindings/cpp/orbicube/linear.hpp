// Sparse symmetric positive definite systems; wraps orbicube/linear.h.
#ifndef ORBICUBE_LINEAR_HPP
#define ORBICUBE_LINEAR_HPP

#include <stdexcept>
#include <vector>

#include <orbicube/linear.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace linear {

// A view: the lower triangle by rows.
using Matrix = obc_linear_matrix;
using DirectOptions = detail::Filled<obc_linear_direct_options, obc_linear_direct_options_init>;
using IterativeOptions = detail::Filled<obc_linear_iterative_options, obc_linear_iterative_options_init>;
using IterativeReport = detail::Filled<obc_linear_iterative_report, obc_linear_iterative_report_init>;

// A factor L D L' of a matrix.
class Direct {
 public:
  explicit Direct(const Matrix& matrix, const DirectOptions& options = {})
      : size_(matrix.size),
        handle_(detail::take<obc_linear_direct, obc_linear_direct_destroy>(
            nullptr, [&](obc_linear_direct** made, obc_error* error) {
              return obc_linear_direct_create(&matrix, &options, nullptr, made, error);
            })) {}

  // Solves for right.size() / size right sides, one behind the other.
  std::vector<double> solve(const std::vector<double>& right) const {
    if (size_ == 0 || right.size() % size_ != 0)
      throw std::invalid_argument("the length of right is no multiple of the size of the matrix");
    std::vector<double> solution(right.size());
    detail::call(nullptr, [&](obc_error* error) {
      return obc_linear_direct_solve(handle_.get(), right.size() / size_, right.data(), solution.data(), error);
    });
    return solution;
  }
  // Factorizes a matrix of the same pattern with these values.
  void refactor(const std::vector<double>& values) {
    detail::call(nullptr, [&](obc_error* error) {
      return obc_linear_direct_refactor(handle_.get(), values.data(), values.size(), error);
    });
  }
  void remove_row(std::uint32_t row) {
    detail::call(nullptr, [&](obc_error* error) { return obc_linear_direct_remove_row(handle_.get(), row, error); });
  }
  // Adds sign (1 or -1) times w w'.
  void update(const std::vector<std::uint32_t>& rows, const std::vector<double>& values, int sign = 1) {
    if (rows.size() != values.size()) throw std::invalid_argument("rows and values differ in length");
    detail::call(nullptr, [&](obc_error* error) {
      return obc_linear_direct_update(handle_.get(), rows.data(), values.data(), rows.size(), sign, error);
    });
  }
  std::size_t entry_count() const { return obc_linear_direct_entry_count(handle_.get()); }

 private:
  std::size_t size_;
  detail::Handle<obc_linear_direct, obc_linear_direct_destroy> handle_;
};

// Conjugate gradients with Gauss-Seidel or multigrid. The host must outlive it.
class Iterative {
 public:
  explicit Iterative(const Matrix& matrix, const IterativeOptions& options = {}, Host* host = nullptr)
      : size_(matrix.size),
        host_(host),
        handle_(detail::take<obc_linear_iterative, obc_linear_iterative_destroy>(
            host, [&](obc_linear_iterative** made, obc_error* error) {
              return obc_linear_iterative_create(&matrix, &options, detail::c(host), made, error);
            })) {}

  std::vector<double> solve(const std::vector<double>& right, IterativeReport* report = nullptr) {
    if (right.size() != size_) throw std::invalid_argument("the length of right is not the size of the matrix");
    std::vector<double> solution(right.size());
    detail::call(host_, [&](obc_error* error) {
      return obc_linear_iterative_solve(handle_.get(), right.data(), solution.data(),
                                        report == nullptr ? nullptr : &*report, error);
    });
    return solution;
  }

 private:
  std::size_t size_;
  Host* host_;
  detail::Handle<obc_linear_iterative, obc_linear_iterative_destroy> handle_;
};

}  // namespace linear
}  // namespace api
}  // namespace orbicube

#endif
