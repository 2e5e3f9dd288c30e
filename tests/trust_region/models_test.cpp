// The family of models without memory, which is updated as points come and go: it must stay the interpolant of least
// norm. Eigenvectors, and what the coordinates made of them save.
#include "trust_region/models.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "runs.h"
#include "trust_region/dense.h"
#include "trust_region/tridiagonal.h"

using namespace orbicube;
using namespace orbicube::test;
using trust_region::Interpolation;
using trust_region::Models;
using trust_region::Tridiagonal;

TEST_CASE("Updated point by point, the models without memory are those of minimum norm on the points of now") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const std::size_t n = 4, full = 15;
  auto* memory = std::pmr::get_default_resource();
  Interpolation set(n, memory);
  Models models(n, 1, false, {}, true, memory);
  set.allocate(full, true);
  models.allocate(full, true);
  std::vector<double> x(n), d(n), gradient(n), hessian(n * n), work(2 * (n + full));
  const auto f = [&](const double* p) { return std::sin(p[0] + 2 * p[1]) + p[2] * p[2] * p[3] + std::exp(0.3 * p[3]); };
  std::vector<double> values(full);
  set.resize(7);
  for (std::size_t j = 0; j < 7; ++j) {
    for (double& value : x)
      value = normal(random);
    set.place(j, x.data());
    values[j] = f(x.data());
    models.store(j, &values[j]);
  }
  set.set_best(0);
  REQUIRE(set.rebuild());
  models.meet(set);
  int compared = 0;
  for (int update = 0; update < 200; ++update) {
    for (double& value : d)
      value = normal(random);
    REQUIRE(set.prepare(d.data()));
    const std::size_t best = set.best();
    for (std::size_t i = 0; i < n; ++i)
      x[i] = set.point(best)[i] + d[i];
    const double value = f(x.data());
    const std::size_t kind = random() % 3;
    std::size_t j = set.size();
    if (kind == 0 && set.size() < full) {
      models.expect(d.data(), &value, best);
      REQUIRE(set.append());
    } else {
      j = best == 0 ? 1 : 0;
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (k != best && std::abs(set.denominator(k)) > std::abs(set.denominator(j))) j = k;
      }
      models.leave(set, j);
      if (kind == 1 && set.size() > n + 3 && set.alpha(j) > 1e-2) {
        values[j] = values[set.size() - 1];
        models.move(set.size() - 1, j);
        REQUIRE(set.remove(j));
        continue;
      }
      models.expect(d.data(), &value, best);
      REQUIRE(set.replace(j));
    }
    values[j] = value;
    models.store(j, &value);
    models.learn(set, j);
    if (update % 7 == 0) {
      set.set_best(j);
      models.shift(d.data());
    }
    set.interpolant(values.data(), gradient.data(), hessian.data(), work.data());
    const auto predicted = [&](const double* step) {
      return trust_region::dot(gradient.data(), step, n) + 0.5 * trust_region::quadratic_form(hessian.data(), n, step);
    };
    // What the minimum norm predicts is supplied as the truth: then the models without memory are the better family.
    for (double& entry : d)
      entry = normal(random);
    const double told = values[set.best()] + predicted(d.data());
    for (int twice = 0; twice < 60; ++twice)
      models.judge(d.data(), &told, set.best());
    for (double& entry : d)
      entry = normal(random);
    CHECK(models.change(d.data(), set.best()) == doctest::Approx(predicted(d.data())).epsilon(1e-5));
    ++compared;
  }
  CHECK(compared > 80);
}

TEST_CASE("Models of residuals meet all points after each move of the best one, and expand as differences say") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const std::size_t n = 3, m = 4, size = 8;
  auto* memory = std::pmr::get_default_resource();
  for (const bool two_families : {false, true}) {
    Interpolation set(n, memory);
    Models models(n, m, true, {}, two_families, memory);
    set.allocate(size, true);
    models.allocate(size, true);
    const auto outputs_at = [&](const double* x) {
      return std::vector<double>{std::sin(x[0] + x[1]), x[1] * x[2] - 1, std::exp(0.2 * x[2]), x[0] * x[0] + x[2]};
    };
    std::vector<double> x(n), d(n), gradient(n), hessian(n * n), other(n), above(n), below(n), ignored(n * n);
    set.resize(size);
    for (std::size_t j = 0; j < size; ++j) {
      for (double& value : x)
        value = normal(random);
      set.place(j, x.data());
      models.store(j, outputs_at(x.data()).data());
    }
    set.set_best(0);
    REQUIRE(set.rebuild());
    models.meet(set);
    for (int update = 0; update < 60; ++update) {
      for (double& value : d)
        value = normal(random);
      const std::size_t best = set.best();
      for (std::size_t i = 0; i < n; ++i)
        x[i] = set.point(best)[i] + d[i];
      REQUIRE(set.prepare(d.data()));
      // Every third time the best point itself is replaced.
      std::size_t j = best;
      for (std::size_t k = 0; update % 3 != 0 && k < size; ++k) {
        if (k != best && (j == best || std::abs(set.denominator(k)) > std::abs(set.denominator(j)))) j = k;
      }
      const std::vector<double> outputs = outputs_at(x.data());
      models.leave(set, j);
      models.expect(d.data(), outputs.data(), best);
      if (!set.replace(j)) continue;
      models.store(j, outputs.data());
      if (j == best) models.shift(d.data());
      models.learn(set, j);
      if (j != best && update % 2 == 0) {
        set.set_best(j);
        models.shift(d.data());
      }
      const double at_best = models.objective(models.row(set.best()));
      for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t i = 0; i < n; ++i)
          other[i] = set.point(k)[i] - set.point(set.best())[i];
        const double difference = models.objective(models.row(k)) - at_best;
        // Updates of both families round; their values are some units large.
        CHECK(models.change(other.data(), set.best()) == doctest::Approx(difference).epsilon(1e-6).scale(10));
      }
      models.expand(d.data(), set.best(), gradient.data(), hessian.data());
      const double value = models.change(d.data(), set.best()), step = 1e-4;
      CHECK(std::isfinite(value));
      for (std::size_t i = 0; i < n; ++i) {
        d[i] += step;
        const double up = models.change(d.data(), set.best());
        models.expand(d.data(), set.best(), above.data(), ignored.data());
        d[i] -= 2 * step;
        const double down = models.change(d.data(), set.best());
        models.expand(d.data(), set.best(), below.data(), ignored.data());
        d[i] += step;
        const double size_of = 1 + std::abs(gradient[i]) + std::abs(hessian[i * n + i]);
        // Differences have an error of the square of the step in parts of derivatives that may be larger.
        CHECK(std::abs((up - down) / (2 * step) - gradient[i]) < 1e-5 * size_of);
        for (std::size_t k = 0; k < n; ++k)
          CHECK(std::abs((above[k] - below[k]) / (2 * step) - hessian[i * n + k]) < 1e-4 * size_of);
      }
    }
  }
}

TEST_CASE("Eigenvectors are orthonormal and solve A v = lambda v, with eigenvalues that repeat or vanish as well") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (const std::size_t n : {1U, 2U, 3U, 10U, 40U}) {
    for (const char kind : {'r', 'l', 'd', 'z'}) {
      CAPTURE(n);
      CAPTURE(kind);
      std::vector<double> a(n * n), values(n), vectors(n * n);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
          const double entry = kind == 'r'   ? normal(random)
                               : kind == 'l' ? 1.0  // rank one
                               : kind == 'd' ? (i == k ? static_cast<double>(i / 2) - 1 : 0.0)
                                             : 0.0;
          a[i * n + k] = a[k * n + i] = entry;
        }
      }
      Tridiagonal solver(n, std::pmr::get_default_resource());
      std::copy(a.begin(), a.end(), solver.matrix());
      REQUIRE(solver.eigen(n, values.data(), vectors.data()));
      const double scale = 1 + trust_region::norm(a.data(), n * n);
      for (std::size_t k = 0; k < n; ++k) {
        const double* v = vectors.data() + k * n;
        for (std::size_t i = 0; i < n; ++i)
          CHECK(std::abs(trust_region::dot(a.data() + i * n, v, n) - values[k] * v[i]) < 1e-13 * scale);
        for (std::size_t l = 0; l <= k; ++l)
          CHECK(std::abs(trust_region::dot(v, vectors.data() + l * n, n) - (k == l ? 1 : 0)) < 1e-13);
      }
      std::vector<double> alone(n);
      std::copy(a.begin(), a.end(), solver.matrix());
      REQUIRE(solver.eigen(n, alone.data(), nullptr));
      CHECK(same_bits(alone, values));
    }
  }
  Tridiagonal solver(3, std::pmr::get_default_resource());
  std::fill_n(solver.matrix(), 9, std::nan(""));
  std::vector<double> values(3);
  solver.eigen(3, values.data(), nullptr);  // comes to an end
}

TEST_CASE("Turned coordinates save a fifth of the evaluations where scales differ along diagonals") {
  // Curved valleys with scales that differ by a thousand. A box that is never reached keeps the coordinates.
  Case c{"scaled valleys",
         std::vector<double>(4, 0.0),
         0,
         [](std::span<const double> x) {
           const double p = x[0] + x[1], q = 1e3 * (x[0] - x[1]), s = x[2] + x[3], t = 1e3 * (x[2] - x[3]);
           return std::vector<double>{sum_of_squares({10 * (q - p * p + 1), 1 - p, 10 * (t - s * s - p), 2 - s})};
         },
         0,
         {},
         {},
         {},
         {}};
  Options options;
  options.target = 1e-6;
  options.max_evaluations = 20000;
  options.start = Start::chain;
  options.points = 9;
  const Run turned = run(c, options);
  c.lower.assign(4, -1e6);
  c.upper.assign(4, 1e6);
  const Run fixed = run(c, options);
  CHECK(turned.result.stop == Stop::target_reached);
  CHECK(5 * turned.result.evaluations < 4 * fixed.result.evaluations);
}
