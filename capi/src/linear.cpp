#include "orbicube/linear.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "base/version.h"
#include "capi/src/entry.h"
#include "linear/direct/direct_factor.h"
#include "linear/iterative/iterative_solver.h"
#ifdef ORBICUBE_LINEAR_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif

using namespace orbicube;
using linear::Index;

struct obc_linear_direct {
  explicit obc_linear_direct(const obc_host* given) : host(given), place(host.host().memory) {}
  capi::HostAdapter host;
  linear::SparseMatrix matrix;
  linear::Array<int> place;  // in `matrix`, of each entry of the caller's
  std::unique_ptr<linear::DirectFactor> factor;
  bool solvable = false;
};

struct obc_linear_iterative {
  explicit obc_linear_iterative(const obc_host* given) : host(given) {}
  capi::HostAdapter host;
  linear::IterativeOptions options;
  std::unique_ptr<linear::IterativeSolver> solver;
};

namespace {

linear::SymmetricMatrix matrix_of(const obc_linear_matrix* m) {
  capi::require(m != nullptr, "matrix is NULL");
  capi::require(m->row_begin != nullptr, "matrix->row_begin is NULL");
  capi::require(m->size < (std::size_t{1} << 31), "matrix->size must be at most 2^31 - 1");
  const std::size_t count = m->row_begin[m->size];
  capi::require(count == 0 || (m->columns != nullptr && m->values != nullptr), "matrix->columns or ->values is NULL");
  capi::require(count < (std::size_t{1} << 31), "the matrix must have at most 2^31 - 1 entries");
  const linear::SymmetricMatrix matrix{{m->row_begin, m->size + 1}, {m->columns, count}, {m->values, count}};
  linear::require_valid(matrix);
  return matrix;
}

linear::DirectMethod direct_method(std::int32_t method) {
  switch (method) {
    case OBC_LINEAR_AUTO:
      return linear::DirectMethod::automatic;
    case OBC_LINEAR_EIGEN:
      return linear::DirectMethod::eigen;
    case OBC_LINEAR_CHOLMOD_SIMPLICIAL:
      return linear::DirectMethod::cholmod_simplicial;
    case OBC_LINEAR_CHOLMOD_SUPERNODAL:
      return linear::DirectMethod::cholmod_supernodal;
    default:
      throw base::Error("invalid-argument", "unknown method " + std::to_string(method));
  }
}

linear::IterativeMethod iterative_method(std::int32_t method) {
  switch (method) {
    case OBC_LINEAR_ITERATIVE_AUTO:
      return linear::IterativeMethod::automatic;
    case OBC_LINEAR_GAUSS_SEIDEL:
      return linear::IterativeMethod::gauss_seidel;
    case OBC_LINEAR_MULTIGRID:
      return linear::IterativeMethod::multigrid;
    default:
      throw base::Error("invalid-argument", "unknown method " + std::to_string(method));
  }
}

obc_linear_iterative_options default_options() {
  const linear::IterativeOptions defaults;
  obc_linear_iterative_options o{};
  o.struct_size = sizeof o;
  o.method = OBC_LINEAR_ITERATIVE_AUTO;
  o.block_size = 1;
  o.max_iterations = static_cast<std::uint32_t>(defaults.max_iterations);
  o.tolerance = defaults.tolerance;
  return o;
}

void factorize(obc_linear_direct& handle) {
  handle.solvable = handle.factor->factorize(handle.matrix) && handle.factor->is_positive();
  if (!handle.solvable) throw base::Error("no-valid-result", "the matrix is not positive definite");
}

void require_finite(const double* numbers, std::size_t count, const char* what) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(numbers[i]))
      throw base::Error("invalid-argument", std::string(what) + "[" + std::to_string(i) + "] is not finite");
  }
}

// Whether the pattern has an entry for these rows.
bool has_entry(const linear::SparseMatrix& matrix, Index a, Index b) {
  const int row = static_cast<int>(std::max(a, b)), column = static_cast<int>(std::min(a, b));
  const int* const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const int* const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return std::binary_search(begin, end, row);
}

void require_update(const linear::SparseMatrix& matrix, const std::uint32_t* rows, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    capi::require(rows[i] < static_cast<std::uint32_t>(matrix.rows()), "a row is out of range");
    for (std::size_t j = 0; j < i; ++j) {
      capi::require(rows[i] != rows[j], "a row is repeated");
      if (!has_entry(matrix, rows[i], rows[j]))
        throw base::Error("invalid-argument", "the matrix has no entry for rows " + std::to_string(rows[j]) + " and " +
                                                  std::to_string(rows[i]) + "; declare one, of value 0");
    }
  }
}

}  // namespace

obc_status obc_linear_direct_options_init(obc_linear_direct_options* options, size_t struct_size) {
  obc_linear_direct_options defaults{};
  defaults.method = OBC_LINEAR_AUTO;
  return capi::init_versioned(options, struct_size, defaults);
}

obc_status obc_linear_direct_create(const obc_linear_matrix* matrix, const obc_linear_direct_options* options,
                                    const obc_host* host, obc_linear_direct** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    const obc_linear_direct_options o = capi::copy_versioned(options, obc_linear_direct_options{});
#ifdef ORBICUBE_LINEAR_CHOLMOD
    linear::provide_cholmod(&linear::make_cholmod_factor);
#endif
    const linear::SymmetricMatrix given = matrix_of(matrix);
    auto made = std::make_unique<obc_linear_direct>(host);
    made->matrix = linear::by_columns(given, made->place);
    made->factor = linear::make_direct_factor(direct_method(o.method));
    made->factor->analyze(made->matrix);
    factorize(*made);
    *out = made.release();
  });
}

void obc_linear_direct_destroy(obc_linear_direct* factor) {
  delete factor;
}

obc_status obc_linear_direct_refactor(obc_linear_direct* factor, const double* values, size_t count, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(factor != nullptr, "factor is NULL");
    capi::require(count == factor->place.size(), "count is not the number of entries of the matrix");
    capi::require(values != nullptr || count == 0, "values is NULL");
    require_finite(values, count, "values");
    for (std::size_t i = 0; i < count; ++i)
      factor->matrix.valuePtr()[factor->place[i]] = values[i];
    factorize(*factor);
  });
}

obc_status obc_linear_direct_solve(obc_linear_direct* factor, size_t columns, const double* right, double* solution,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(factor != nullptr, "factor is NULL");
    capi::require(factor->solvable, "the last refactor or update failed; refactor first");
    const auto size = static_cast<std::size_t>(factor->matrix.rows());
    if (columns == 0 || size == 0) return;
    capi::require(right != nullptr && solution != nullptr, "right or solution is NULL");
    capi::require(columns <= PTRDIFF_MAX / sizeof(double) / size, "columns is too large");
    const std::size_t count = columns * size;
    require_finite(right, count, "right");
    factor->factor->solve({right, count}, columns, {solution, count});
  });
}

obc_status obc_linear_direct_remove_row(obc_linear_direct* factor, uint32_t row, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(factor != nullptr, "factor is NULL");
    capi::require(factor->solvable, "the last refactor or update failed; refactor first");
    capi::require(row < static_cast<std::uint32_t>(factor->matrix.rows()), "row is out of range");
    factor->factor->remove_row(row);
  });
}

obc_status obc_linear_direct_update(obc_linear_direct* factor, const uint32_t* rows, const double* values, size_t count,
                                    int32_t sign, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(factor != nullptr, "factor is NULL");
    capi::require(sign == 1 || sign == -1, "sign must be 1 or -1");
    capi::require(factor->solvable, "the last refactor or update failed; refactor first");
    if (count == 0) return;
    capi::require(rows != nullptr && values != nullptr, "rows or values is NULL");
    capi::require(count <= static_cast<std::size_t>(factor->matrix.rows()), "count is larger than the matrix");
    require_update(factor->matrix, rows, count);
    require_finite(values, count, "values");
    factor->solvable = factor->factor->update({rows, count}, {values, count}, sign);
    if (!factor->solvable) throw base::Error("no-valid-result", "the updated matrix is not positive definite");
  });
}

size_t obc_linear_direct_entry_count(const obc_linear_direct* factor) {
  return factor == nullptr ? 0 : factor->factor->entries();
}

obc_status obc_linear_iterative_options_init(obc_linear_iterative_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_linear_iterative_report_init(obc_linear_iterative_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_linear_iterative_report{});
}

obc_status obc_linear_iterative_create(const obc_linear_matrix* matrix, const obc_linear_iterative_options* options,
                                       const obc_host* host, obc_linear_iterative** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    const obc_linear_iterative_options o = capi::copy_versioned(options, default_options());
    capi::require(o.tolerance > 0 && o.tolerance < 1, "tolerance must be between 0 and 1");
    capi::require(o.max_iterations <= INT32_MAX, "max_iterations must be at most 2^31 - 1");
    const linear::SymmetricMatrix given = matrix_of(matrix);
    auto made = std::make_unique<obc_linear_iterative>(host);
    made->options = {o.tolerance, static_cast<int>(o.max_iterations)};
    made->solver = linear::make_iterative_solver(given, o.block_size, iterative_method(o.method), made->host.host());
    *out = made.release();
  });
}

void obc_linear_iterative_destroy(obc_linear_iterative* solver) {
  delete solver;
}

obc_status obc_linear_iterative_solve(obc_linear_iterative* solver, const double* right, double* solution,
                                      obc_linear_iterative_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(solver != nullptr, "solver is NULL");
    const std::size_t size = solver->solver->size();
    capi::require(size == 0 || (right != nullptr && solution != nullptr), "right or solution is NULL");
    require_finite(right, size, "right");
    const base::Host& host = solver->host.host();
    host.restart();
    linear::Array<double> x(size, host.memory);
    const linear::IterativeReport done = solver->solver->solve({right, size}, solver->options, x);
    obc_linear_iterative_report r{};
    r.converged = done.converged ? 1 : 0;
    r.iterations = static_cast<std::uint64_t>(done.iterations);
    r.residual = done.residual;
    capi::write_versioned(report, r);
    std::copy(x.begin(), x.end(), solution);
  });
}

uint32_t obc_linear_version() {
  return base::version_number;
}
