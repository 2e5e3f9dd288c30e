// The C functions of harmonics: what they promise about arguments, memory, cancelling and versions. What the results
// are worth is tested in tests/harmonics/.
#include "orbicube/harmonics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

constexpr std::uint32_t degree = 4;

// Points of a spiral on the sphere, and three smooth functions there.
struct Samples {
  std::vector<double> directions, values;

  explicit Samples(int count) {
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count, flat = std::sqrt(1 - z * z), turn = 2.39996322972865332 * i;
      const double p[3] = {flat * std::cos(turn), flat * std::sin(turn), z};
      directions.insert(directions.end(), p, p + 3);
      values.insert(values.end(), {p[0] + p[1] * p[2], 2 * p[1] - p[0] * p[0], p[2] * p[2] * p[0] + 0.5});
    }
  }
  std::size_t count() const { return directions.size() / 3; }
};

obc_status fit(const Samples& s, const obc_host* host, std::vector<double>& coefficients, std::int32_t method,
               obc_harmonics_fit_report* report = nullptr, obc_error* error = nullptr) {
  obc_harmonics_fit_options options;
  obc_harmonics_fit_options_init(&options, sizeof options);
  options.degree = degree;
  options.method = method;
  return obc_harmonics_fit(s.directions.data(), nullptr, s.values.data(), s.count(), 3, &options, host,
                           coefficients.data(), report, error);
}

std::vector<double> fitted(const Samples& s) {
  std::vector<double> coefficients(3 * obc_harmonics_size(degree));
  REQUIRE(fit(s, nullptr, coefficients, OBC_HARMONICS_AUTOMATIC) == OBC_OK);
  return coefficients;
}

}  // namespace

TEST_CASE("A fit through C reports what it did, and synthesis gives the values back") {
  const Samples s(300);
  std::vector<double> coefficients(3 * obc_harmonics_size(degree)), values(s.values.size()), plain(s.values.size()),
      gradients(3 * s.values.size());
  obc_harmonics_fit_report report;
  REQUIRE(obc_harmonics_fit_report_init(&report, sizeof report) == OBC_OK);
  for (const std::int32_t method : {OBC_HARMONICS_DENSE, OBC_HARMONICS_ITERATIVE}) {
    obc_error error;
    REQUIRE(fit(s, nullptr, coefficients, method, &report, &error) == OBC_OK);
    CHECK(error.status == OBC_OK);
    CHECK(report.method == method);
    CHECK(report.unknowns == 25);
    CHECK(report.rank == 25);
    CHECK(report.condition >= 1);
    CHECK(report.condition < 3);
    CHECK(report.residual < 1e-12);
    CHECK((report.iterations > 0) == (method == OBC_HARMONICS_ITERATIVE));
    REQUIRE(obc_harmonics_synthesize(coefficients.data(), degree, 3, s.directions.data(), s.count(), nullptr,
                                     values.data(), gradients.data(), nullptr) == OBC_OK);
    REQUIRE(obc_harmonics_synthesize(coefficients.data(), degree, 3, s.directions.data(), s.count(), nullptr,
                                     plain.data(), nullptr, nullptr) == OBC_OK);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      largest = std::max({largest, std::abs(values[i] - s.values[i]), std::abs(plain[i] - s.values[i])});
    CHECK(largest < 1e-12);
    // The gradient of x + y z on the sphere: that in space less its part along the direction.
    const double *p = &s.directions[30], *g = &gradients[90], in_space[3] = {1, p[2], p[1]};
    const double along = p[0] + 2 * p[1] * p[2];
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(g[k] == doctest::Approx(in_space[k] - along * p[k]).epsilon(1e-10));
  }
  CHECK(obc_harmonics_size(10) == 121);
  CHECK(obc_harmonics_version() >= 100);
}

TEST_CASE("The rows of the basis, norms, distance and filter are those of the header") {
  const double direction[3] = {0, 0, 2};
  double row[4];
  REQUIRE(obc_harmonics_evaluate(direction, 1, 1, nullptr, row, nullptr) == OBC_OK);
  const double pi = std::acos(-1.0);
  CHECK(row[0] == doctest::Approx(1 / std::sqrt(4 * pi)));
  CHECK(row[2] == doctest::Approx(std::sqrt(3 / (4 * pi))));
  CHECK(row[1] == 0);
  CHECK(row[3] == 0);

  const double f[] = {1, 3, 0, 4}, g[] = {3};
  double norms[2], distance;
  REQUIRE(obc_harmonics_degree_norms(f, 1, 1, norms, nullptr) == OBC_OK);
  CHECK(norms[0] == 1);
  CHECK(norms[1] == 5);
  REQUIRE(obc_harmonics_shape_distance(f, 1, g, 0, 1, 0, 5, &distance, nullptr) == OBC_OK);
  CHECK(distance == 4 + 25);
  double filtered[] = {1, 3, 0, 4};
  REQUIRE(obc_harmonics_filter(filtered, 1, 1, 1, 9, 0, 0, nullptr) == OBC_OK);
  CHECK(filtered[0] == 0);
  CHECK(filtered[3] == 4);
  CHECK(obc_harmonics_filter(filtered, 1, 1, 2, 1, 0, 0, nullptr) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("A map is refined in place, or left as it is when something is wrong") {
  const double octahedron[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const double shape[] = {1.4, 0, 0, -1, 0.1, 0, 0, 1, 0, 0, -1, 0.2, 0.3, 0, 1, 0, 0, -2};
  const std::uint32_t triangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  std::vector<double> directions(octahedron, octahedron + 18);
  const std::vector<double> given = directions;
  obc_harmonics_fit_options options;
  obc_harmonics_refinement_report report;
  obc_error error;
  REQUIRE(obc_harmonics_fit_options_init(&options, sizeof options) == OBC_OK);
  REQUIRE(obc_harmonics_refinement_report_init(&report, sizeof report) == OBC_OK);
  options.degree = 1;
  REQUIRE(obc_harmonics_refine_map(shape, 6, triangles, 8, nullptr, &options, 5, nullptr, directions.data(), &report,
                                   &error) == OBC_OK);
  CHECK(report.rounds > 0);
  CHECK(report.residual < report.residual_before);
  CHECK(directions != given);
  directions = given;
  REQUIRE(obc_harmonics_refine_map(shape, 6, triangles, 8, nullptr, &options, 0, nullptr, directions.data(), nullptr,
                                   nullptr) == OBC_OK);
  CHECK(directions == given);
  const std::uint32_t wrong[] = {0, 2, 6};
  CHECK(obc_harmonics_refine_map(shape, 6, wrong, 1, nullptr, &options, 5, nullptr, directions.data(), &report,
                                 &error) == OBC_MALFORMED_FILE);
  CHECK(obc_harmonics_refine_map(nullptr, 6, triangles, 8, nullptr, &options, 5, nullptr, directions.data(), &report,
                                 &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_refine_map(shape, 6, nullptr, 8, nullptr, &options, 5, nullptr, directions.data(), &report,
                                 &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_refine_map(shape, 6, triangles, 8, nullptr, &options, 5, nullptr, nullptr, &report, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(directions == given);
}

TEST_CASE("Rotation and alignment take and give matrices by rows") {
  const Samples s(300);
  const std::vector<double> coefficients = fitted(s);
  const double quarter[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};  // x goes to y
  std::vector<double> turned(coefficients.size());
  REQUIRE(obc_harmonics_rotate(coefficients.data(), degree, 3, quarter, nullptr, turned.data(), nullptr) == OBC_OK);
  const double x[3] = {0.6, 0, 0.8}, y[3] = {0, 0.6, 0.8};
  double before[3], after[3];
  REQUIRE(obc_harmonics_synthesize(coefficients.data(), degree, 3, x, 1, nullptr, before, nullptr, nullptr) == OBC_OK);
  REQUIRE(obc_harmonics_synthesize(turned.data(), degree, 3, y, 1, nullptr, after, nullptr, nullptr) == OBC_OK);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(after[k] == doctest::Approx(before[k]).epsilon(1e-13));

  obc_harmonics_alignment alignment;
  REQUIRE(obc_harmonics_alignment_init(&alignment, sizeof alignment) == OBC_OK);
  REQUIRE(obc_harmonics_align(turned.data(), degree, coefficients.data(), degree, 3, nullptr, nullptr, &alignment,
                              nullptr) == OBC_OK);
  for (std::size_t k = 0; k < 9; ++k) {
    CHECK(std::abs(alignment.rotation[k] - quarter[k]) < 1e-8);
    CHECK(alignment.values[k] == (k % 4 == 0 ? 1 : 0));
  }
  CHECK(alignment.correlation == doctest::Approx(1));
  obc_harmonics_align_options options;
  REQUIRE(obc_harmonics_align_options_init(&options, sizeof options) == OBC_OK);
  options.search_degree = 0;
  CHECK(obc_harmonics_align(turned.data(), degree, coefficients.data(), degree, 3, &options, nullptr, &alignment,
                            nullptr) == OBC_INVALID_ARGUMENT);
  const std::vector<double> constant(coefficients.size());
  CHECK(obc_harmonics_align(constant.data(), degree, coefficients.data(), degree, 3, nullptr, nullptr, &alignment,
                            nullptr) == OBC_NO_VALID_RESULT);
}

TEST_CASE("Files: written, read, and refused with the path in front") {
  const std::vector<double> coefficients = fitted(Samples(300));
  const std::string folder = (std::filesystem::temp_directory_path() / "orbicube-harmonics-capi").string();
  std::filesystem::create_directories(folder);
  for (const std::string& name : {folder + "/a.sh", folder + "/a.coef"}) {
    REQUIRE(obc_harmonics_write(name.c_str(), OBC_HARMONICS_BY_ENDING, coefficients.data(), degree, 3, nullptr) ==
            OBC_OK);
    obc_harmonics_coefficients* read = nullptr;
    REQUIRE(obc_harmonics_read(name.c_str(), OBC_HARMONICS_BY_ENDING, nullptr, &read, nullptr) == OBC_OK);
    CHECK(obc_harmonics_coefficients_degree(read) == degree);
    CHECK(obc_harmonics_coefficients_channels(read) == 3);
    std::vector<double> values(coefficients.size());
    REQUIRE(obc_harmonics_coefficients_copy(read, values.data(), nullptr) == OBC_OK);
    double largest = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      largest = std::max(largest, std::abs(values[k] - coefficients[k]));
    CHECK(largest < 1e-15);
    obc_harmonics_coefficients_destroy(read);
    CHECK(test::fail_each_allocation([&](const obc_host& host) {
            obc_harmonics_coefficients* again = nullptr;
            const obc_status status = obc_harmonics_read(name.c_str(), OBC_HARMONICS_BY_ENDING, &host, &again, nullptr);
            obc_harmonics_coefficients_destroy(again);
            return status;
          }).problem == "");
  }
  const std::string bad = folder + "/bad.sh";
  std::FILE* file = std::fopen(bad.c_str(), "w");
  REQUIRE(file != nullptr);
  std::fputs("0, 0, 1, 0\n1, 0, x, 0\n", file);
  std::fclose(file);
  obc_error error;
  auto* untouched = reinterpret_cast<obc_harmonics_coefficients*>(&error);
  CHECK(obc_harmonics_read(bad.c_str(), OBC_HARMONICS_BY_ENDING, nullptr, &untouched, &error) == OBC_MALFORMED_FILE);
  CHECK(untouched == nullptr);
  CHECK(std::string(error.message).rfind(bad + ": line 2", 0) == 0);
  CHECK(obc_harmonics_write((folder + "/a.obj").c_str(), OBC_HARMONICS_BY_ENDING, coefficients.data(), degree, 3,
                            &error) == OBC_UNSUPPORTED);
  CHECK(obc_harmonics_write((folder + "/no/a.sh").c_str(), OBC_HARMONICS_BY_ENDING, coefficients.data(), degree, 3,
                            &error) == OBC_IO);
  CHECK(obc_harmonics_write((folder + "/a.sh").c_str(), 9, coefficients.data(), degree, 3, &error) ==
        OBC_INVALID_ARGUMENT);
  std::filesystem::remove_all(folder);
}

TEST_CASE("Analysis through C is the transpose of synthesis") {
  // Below and above the degree from which both go through Fourier transforms.
  for (const std::uint32_t at : {degree, 90U}) {
    const Samples s(900);
    std::vector<double> x(2 * obc_harmonics_size(at)), sums(x.size()), ax(2 * s.count()), y(ax.size()),
        weights(s.count());
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = std::sin(1.0 + 7.0 * static_cast<double>(k));
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = std::cos(3.0 * static_cast<double>(i));
      weights[i / 2] = 1 + 0.5 * std::sin(static_cast<double>(i / 2));
    }
    REQUIRE(obc_harmonics_synthesize(x.data(), at, 2, s.directions.data(), s.count(), nullptr, ax.data(), nullptr,
                                     nullptr) == OBC_OK);
    REQUIRE(obc_harmonics_analyze(s.directions.data(), weights.data(), y.data(), s.count(), 2, at, nullptr, sums.data(),
                                  nullptr) == OBC_OK);
    double left = 0, right = 0, size = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      left += weights[i / 2] * y[i] * ax[i];
      size += std::abs(weights[i / 2] * y[i] * ax[i]);
    }
    for (std::size_t k = 0; k < x.size(); ++k)
      right += x[k] * sums[k];
    CHECK(std::abs(left - right) < 1e-13 * size);
  }
}

TEST_CASE("Each failing allocation ends in out of memory with nothing leaked, and every report can cancel") {
  const Samples s(120);
  const std::vector<double> coefficients = fitted(s);
  const double rotation[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0};
  std::vector<double> out(3 * s.directions.size() + coefficients.size());
  // Enough points of a degree that is high enough for the Fourier transforms.
  const Samples many(700);
  constexpr std::uint32_t high_degree = 80;
  const std::vector<double> high(obc_harmonics_size(high_degree), 1.0);
  std::vector<double> sums(many.count(), 1.0), analyzed(high.size());
  obc_harmonics_align_options align_options;
  obc_harmonics_align_options_init(&align_options, sizeof align_options);
  align_options.search_degree = 2;
  obc_harmonics_alignment alignment;
  obc_harmonics_alignment_init(&alignment, sizeof alignment);
  const test::Call calls[] = {
      [&](const obc_host& host) { return fit(s, &host, out, OBC_HARMONICS_DENSE); },
      [&](const obc_host& host) { return fit(s, &host, out, OBC_HARMONICS_ITERATIVE); },
      [&](const obc_host& host) {
        return obc_harmonics_synthesize(coefficients.data(), degree, 3, s.directions.data(), 3, &host, out.data(),
                                        nullptr, nullptr);
      },
      [&](const obc_host& host) {
        return obc_harmonics_synthesize(high.data(), high_degree, 1, many.directions.data(), many.count(), &host,
                                        sums.data(), nullptr, nullptr);
      },
      [&](const obc_host& host) {
        return obc_harmonics_analyze(many.directions.data(), nullptr, sums.data(), many.count(), 1, high_degree, &host,
                                     analyzed.data(), nullptr);
      },
      [&](const obc_host& host) {
        return obc_harmonics_rotate(coefficients.data(), degree, 3, rotation, &host, out.data(), nullptr);
      },
      [&](const obc_host& host) {
        return obc_harmonics_align(coefficients.data(), degree, coefficients.data(), degree, 3, &align_options, &host,
                                   &alignment, nullptr);
      },
  };
  for (const test::Call& call : calls) {
    CHECK(test::fail_each_allocation(call).problem == "");
    CHECK(test::cancel_everywhere(call).problem == "");
  }
}

TEST_CASE("Arguments that are wrong are refused") {
  const Samples s(50);
  std::vector<double> out(1000);
  obc_error error;
  CHECK(obc_harmonics_fit(nullptr, nullptr, s.values.data(), 50, 3, nullptr, nullptr, out.data(), nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.kind) == "invalid-argument");
  CHECK(obc_harmonics_fit(s.directions.data(), nullptr, nullptr, 50, 3, nullptr, nullptr, out.data(), nullptr,
                          nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_fit(s.directions.data(), nullptr, s.values.data(), 50, 0, nullptr, nullptr, out.data(), nullptr,
                          nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_fit(s.directions.data(), nullptr, s.values.data(), 50, 3, nullptr, nullptr, nullptr, nullptr,
                          nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_analyze(s.directions.data(), nullptr, s.values.data(), 1, 1, 1001, nullptr, out.data(),
                              nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_analyze(s.directions.data(), nullptr, nullptr, 1, 1, 2, nullptr, out.data(), nullptr) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_analyze(s.directions.data(), nullptr, s.values.data(), 1, 0, 2, nullptr, out.data(), nullptr) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_evaluate(s.directions.data(), 1, 1001, nullptr, out.data(), nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_synthesize(nullptr, 1, 1, s.directions.data(), 1, nullptr, out.data(), nullptr, nullptr) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_rotate(out.data(), 1, 1, nullptr, nullptr, out.data(), nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_degree_norms(nullptr, 1, 1, out.data(), nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_read(nullptr, 0, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_harmonics_coefficients_degree(nullptr) == 0);
  CHECK(obc_harmonics_coefficients_channels(nullptr) == 0);
  obc_harmonics_coefficients_destroy(nullptr);
  CHECK(obc_harmonics_fit_options_init(nullptr, 100) == OBC_INVALID_ARGUMENT);
}
