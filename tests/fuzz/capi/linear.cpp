// The C functions of linear systems on any matrices.
#include "orbicube/linear.h"
#include "entries.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  const std::uint32_t n = static_cast<std::uint32_t>(in.below(24));
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> columns;
  std::vector<double> values;
  const bool tame = !in.one_in(3);  // most matrices are diagonally dominant
  for (std::uint32_t row = 0; row < n; ++row) {
    double sum = 0;
    for (std::uint32_t column = 0; column < row; ++column) {
      if (!in.one_in(4)) continue;
      columns.push_back(in.one_in(200) ? in.index(n) : column);
      values.push_back(tame ? -1.0 : in.number());
      sum += 2;
    }
    columns.push_back(in.one_in(200) ? in.index(n) : row);
    values.push_back(tame ? sum + 24 : in.number());
    begin.push_back(in.one_in(200) ? in.below(columns.size() + 1) : columns.size());
  }
  begin.back() = columns.size();
  const obc_linear_matrix matrix = {n, begin.data(), columns.data(), values.data()};
  std::vector<double> right = in.numbers(2 * n), x(2 * n);

  obc_linear_direct_options direct;
  obc_linear_direct_options_init(&direct, sizeof direct);
  direct.method = static_cast<std::int32_t>(in.below(5));
  obc_linear_direct* factor = nullptr;
  if (ok([&](obc_error* e) { return obc_linear_direct_create(&matrix, &direct, nullptr, &factor, e); })) {
    ok([&](obc_error* e) { return obc_linear_direct_solve(factor, 2, right.data(), x.data(), e); });
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t row = in.index(n);
      const std::vector<double> w = in.numbers(1);
      ok([&](obc_error* e) { return obc_linear_direct_remove_row(factor, row, e); });
      ok([&](obc_error* e) { return obc_linear_direct_update(factor, &row, w.data(), 1, in.one_in(2) ? 1 : -1, e); });
      ok([&](obc_error* e) { return obc_linear_direct_solve(factor, 1, right.data(), x.data(), e); });
    }
    ok([&](obc_error* e) { return obc_linear_direct_refactor(factor, values.data(), values.size(), e); });
  }
  obc_linear_direct_destroy(factor);

  obc_linear_iterative_options iterative;
  obc_linear_iterative_options_init(&iterative, sizeof iterative);
  iterative.method = static_cast<std::int32_t>(in.below(4));
  iterative.block_size = in.one_in(2) ? 3 : 1;
  iterative.max_iterations = 50;
  obc_linear_iterative* solver = nullptr;
  if (ok([&](obc_error* e) { return obc_linear_iterative_create(&matrix, &iterative, nullptr, &solver, e); })) {
    obc_linear_iterative_report report;
    obc_linear_iterative_report_init(&report, sizeof report);
    if (ok([&](obc_error* e) { return obc_linear_iterative_solve(solver, right.data(), x.data(), &report, e); }) &&
        tame)
      require(report.converged == 1 || report.iterations > 0, "a dominant matrix without an iteration");
  }
  obc_linear_iterative_destroy(solver);
  return 0;
}
