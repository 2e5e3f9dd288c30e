// The C interface of sphere_optimizer with products of the Hessian: by a callback and by steps, arguments, memory,
// cancelling.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "charges.h"
#include "failing_allocations.h"
#include "solver_checks.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

obc_sphere_optimizer_options second_order() {
  obc_sphere_optimizer_options options;
  REQUIRE(obc_sphere_optimizer_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.hessian_products == 0);
  options.method = OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON;
  options.hessian_products = 1;
  return options;
}

}  // namespace

TEST_CASE("With products by a callback and by steps a run ends in the same bits, in the minimum without them") {
  Points plain = start(), gradient;
  REQUIRE(obc_sphere_optimizer_minimize(charges, 3, nullptr, callback, nullptr, plain.data(), nullptr, nullptr,
                                        nullptr) == OBC_OK);
  int calls = 0;
  Points x = start();
  auto result = empty<obc_sphere_optimizer_result>();
  REQUIRE(obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, callback, product_callback, &calls, x.data(),
                                                     &result, nullptr, nullptr) == OBC_OK);
  CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
  CHECK(result.gradient_norm <= 1e-8);
  CHECK(result.products > 0);
  CHECK(static_cast<std::uint64_t>(calls) == result.evaluations + result.products);
  CHECK(result.value == doctest::Approx(evaluate(plain.data(), gradient.data())).epsilon(1e-10));

  const obc_sphere_optimizer_options options = second_order();
  obc_sphere_optimizer* solver = nullptr;
  const Points x0 = start();
  REQUIRE(obc_sphere_optimizer_create(charges, 3, &options, x0.data(), nullptr, &solver, nullptr) == OBC_OK);
  const double *at = nullptr, *direction = nullptr;
  std::uint64_t products = 0;
  for (std::int32_t request; (request = obc_sphere_optimizer_step(solver, &at)) != OBC_SPHERE_OPTIMIZER_DONE;) {
    if (request == OBC_SPHERE_OPTIMIZER_NEED_FG) {
      CHECK(obc_sphere_optimizer_get_direction(solver, &direction, nullptr) == OBC_INVALID_ARGUMENT);
      CHECK(obc_sphere_optimizer_tell_product(solver, gradient.data(), nullptr) == OBC_INVALID_ARGUMENT);
      const double value = evaluate(at, gradient.data());
      REQUIRE(obc_sphere_optimizer_tell(solver, value, gradient.data(), nullptr) == OBC_OK);
    } else if (request == OBC_SPHERE_OPTIMIZER_NEED_PRODUCT) {
      REQUIRE(obc_sphere_optimizer_get_direction(solver, &direction, nullptr) == OBC_OK);
      CHECK(obc_sphere_optimizer_tell(solver, 0, gradient.data(), nullptr) == OBC_INVALID_ARGUMENT);
      product_callback(at, direction, charges, 3, gradient.data(), nullptr);
      REQUIRE(obc_sphere_optimizer_tell_product(solver, gradient.data(), nullptr) == OBC_OK);
      ++products;
    }
  }
  Points end;
  REQUIRE(obc_sphere_optimizer_get_result(solver, nullptr, end.data(), nullptr) == OBC_OK);
  CHECK(end == x);
  CHECK(products == result.products);
  obc_sphere_optimizer_destroy(solver);
}

TEST_CASE("A callback for products can stop the run or have none") {
  struct Plan {
    int calls = 0, at = -1;
    std::int32_t reply = OBC_SPHERE_OPTIMIZER_CONTINUE;
  };
  const obc_sphere_optimizer_function f = [](const double* x, std::size_t, std::size_t, double* value, double* gradient,
                                             void*) -> std::int32_t {
    *value = evaluate(x, gradient);
    return OBC_SPHERE_OPTIMIZER_CONTINUE;
  };
  const obc_sphere_optimizer_product_function product = [](const double* x, const double* direction, std::size_t count,
                                                           std::size_t dimension, double* out,
                                                           void* user) -> std::int32_t {
    Plan& plan = *static_cast<Plan*>(user);
    if (plan.calls++ == plan.at) return plan.reply;
    return product_callback(x, direction, count, dimension, out, nullptr);
  };
  auto result = empty<obc_sphere_optimizer_result>();
  Plan plan{0, 4, OBC_SPHERE_OPTIMIZER_STOP};
  Points x = start(), gradient;
  CHECK(obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, f, product, &plan, x.data(), &result, nullptr,
                                                   nullptr) == OBC_OK);
  CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED);
  CHECK(plan.calls == 5);
  CHECK(evaluate(x.data(), gradient.data()) == result.value);
  // Also what says that it has set a product and has not.
  for (const std::int32_t reply : {OBC_SPHERE_OPTIMIZER_FAILED, OBC_SPHERE_OPTIMIZER_CONTINUE}) {
    plan = {0, 3, reply};
    x = start();
    CHECK(obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, f, product, &plan, x.data(), &result, nullptr,
                                                     nullptr) == OBC_OK);
    CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
    CHECK(result.failed_evaluations == 0);
  }
}

TEST_CASE("Arguments of products that cannot be are refused") {
  Points x = start();
  const obc_sphere_optimizer_options options = second_order();
  obc_error error;
  CHECK(obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, callback, nullptr, nullptr, x.data(), nullptr,
                                                   nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, nullptr, product_callback, nullptr, x.data(),
                                                   nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_minimize(charges, 3, &options, callback, nullptr, x.data(), nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("_second_order") != std::string::npos);
  CHECK(obc_sphere_optimizer_get_direction(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_tell_product(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  obc_sphere_optimizer_options wrong = options;
  wrong.hessian_products = 2;
  CHECK(obc_sphere_optimizer_minimize_second_order(charges, 3, &wrong, callback, product_callback, nullptr, x.data(),
                                                   nullptr, nullptr, nullptr) == OBC_OK);
  obc_sphere_optimizer* solver = nullptr;
  CHECK(obc_sphere_optimizer_create(charges, 3, &wrong, x.data(), nullptr, &solver, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(solver == nullptr);
}

TEST_CASE("Each allocation of a run with products fails in turn, and a host can cancel at any report") {
  const auto minimized = [](const obc_host& host, obc_sphere_optimizer_result* result) {
    Points x = start();
    return obc_sphere_optimizer_minimize_second_order(charges, 3, nullptr, callback, product_callback, nullptr,
                                                      x.data(), result, &host, nullptr);
  };
  const auto failing = test::fail_each_allocation([&](const obc_host& host) { return minimized(host, nullptr); });
  CHECK(failing.problem == "");
  CHECK(failing.runs > 10);
  const auto cancelled = test::cancel_everywhere([&](const obc_host& host) {
    auto result = empty<obc_sphere_optimizer_result>();
    const obc_status status = minimized(host, &result);
    const bool stopped = result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED;
    return stopped == (status == OBC_CANCELLED) ? status : static_cast<obc_status>(OBC_INTERNAL);
  });
  CHECK(cancelled.problem == "");
  CHECK(cancelled.runs > 10);
}
