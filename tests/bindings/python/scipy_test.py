"""The solvers as methods of scipy.optimize.minimize: known minima, the words of SciPy, its callbacks, refusals."""

import sys
import unittest
import warnings

import numpy as np
from orbicube import projected_gradient, trust_region

try:
    import scipy.sparse
    from scipy.optimize import Bounds, LinearConstraint, NonlinearConstraint, basinhopping, least_squares, minimize, rosen, rosen_der
except ImportError:
    print("there is no scipy: the methods for it are not tested")
    sys.exit(77)


def bowl(x, center, factor=1.0):
    return factor * float(np.sum((x - center) ** 2))


def bowl_der(x, center, factor=1.0):
    return 2 * factor * (x - center)


class Values(unittest.TestCase):
    def test_minimum_is_that_of_the_library_to_the_bit(self):
        found = minimize(rosen, [-1.2, 1.0], method=trust_region.scipy_method)
        own = trust_region.minimize(rosen, [-1.2, 1.0])
        self.assertEqual(found.x.tobytes(), own.x.tobytes())
        self.assertEqual((found.fun, found.nfev, found.message), (own.fun, own.nfev, own.stop))
        self.assertTrue(found.success)
        np.testing.assert_allclose(found.x, [1, 1], atol=1e-6)

    def test_arguments_and_bounds_in_both_forms(self):
        for bounds in (Bounds([0, -np.inf], [np.inf, 1]), [(0, None), (None, 1)]):
            found = minimize(bowl, [3, 0], args=([-2.0, 5.0], 3.0), method=trust_region.scipy_method, bounds=bounds)
            np.testing.assert_allclose(found.x, [0, 1], atol=1e-7)
            self.assertAlmostEqual(found.fun, 3 * (4 + 16), places=6)

    def test_budget_and_tolerance(self):
        self.assertEqual(minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"maxfev": 9}).nfev, 9)
        coarse = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, tol=1e-2)
        fine = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"rhoend": 1e-10, "rhobeg": 0.5})
        self.assertLess(coarse.nfev, fine.nfev)

    def test_words_for_limits(self):
        few = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"maxiter": 7})
        self.assertEqual((few.nit, few.message, few.success), (7, "iteration budget", False))
        plenty = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"maxiter": 10000})
        self.assertEqual((plenty.message, plenty.status, plenty.success), ("converged", 1, True))
        both = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, tol=1e-2, options={"rhoend": 1e-10})
        fine = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"radius_end": 1e-10})
        self.assertEqual(both.x.tobytes(), fine.x.tobytes())  # an option counts more than tol
        cobyqa = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, options={"initial_tr_radius": 0.5, "f_target": 1e-3})
        own = trust_region.minimize(rosen, [-1.2, 1], radius_begin=0.5, target=1e-3)
        self.assertEqual((cobyqa.x.tobytes(), cobyqa.message), (own.x.tobytes(), "target reached"))
        with self.assertRaisesRegex(TypeError, "rhoend and radius_end both say radius_end"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, options={"rhoend": 1e-3, "radius_end": 1e-4})
        with self.assertRaisesRegex(TypeError, "there is no 'ftol'.*maxfev"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, options={"ftol": 1e-3})
        with self.assertRaisesRegex(ValueError, "maxiter=0: out of range"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, options={"maxiter": 0})
        with self.assertRaisesRegex(TypeError, "callback: a function is needed, not 3"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, callback=3)

    def test_other_callers_of_minimize(self):
        def waves(x):
            return float(np.sum(x ** 2 / 20 + 1 - np.cos(3 * x)))

        found = basinhopping(waves, [3.0, -2.5], niter=30, stepsize=2.0, seed=2, minimizer_kwargs={"method": trust_region.scipy_method})
        np.testing.assert_allclose(found.x, 0, atol=1e-6)

    def test_callback_sees_decreasing_values_and_ends_the_run(self):
        seen = []

        def follow(x):
            seen.append(rosen(x))
            if len(seen) == 12:
                raise StopIteration

        found = minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, callback=follow)
        self.assertEqual(len(seen), 12)
        self.assertTrue(all(later <= before for before, later in zip(seen, seen[1:])))
        self.assertEqual(found.fun, seen[-1])
        self.assertFalse(found.success)

        def whole(intermediate_result):
            seen.append(intermediate_result.fun)
            return len(seen) == 20

        self.assertEqual(minimize(rosen, [-1.2, 1], method=trust_region.scipy_method, callback=whole).fun, seen[-1])
        self.assertEqual(len(seen), 20)

    def test_derivatives_are_not_used_without_a_word(self):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            minimize(rosen, [-1.2, 1], jac=rosen_der, method=trust_region.scipy_method)
        self.assertIn("does not use derivatives (jac)", "".join(str(one.message) for one in said))

    def test_refusals(self):
        with self.assertRaisesRegex(TypeError, "'maxfeval'.*did you mean 'maxfev'"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, options={"maxfeval": 3})
        with self.assertRaisesRegex(ValueError, "projected_gradient.scipy_method"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, constraints=LinearConstraint([[1, 1]], 1, 1))
        with self.assertRaisesRegex(ValueError, "bounds: .* 2 pairs"):
            minimize(rosen, [0, 0], method=trust_region.scipy_method, bounds=[(0, 1)])
        with self.assertRaisesRegex(TypeError, "fun returned None"):
            minimize(lambda x: None, [0, 0], method=trust_region.scipy_method)


def misfit(x, t, measured, *, weight=1.0):
    return weight * (x[0] / (1 + x[1] * t) + x[2] - measured)


TIMES = 0.5 * np.arange(8)
MEASURED = 2.5 / (1 + 0.7 * TIMES) + 0.4 + 0.01 * np.cos(5 * TIMES)


class Residuals(unittest.TestCase):
    def test_a_sum_of_magnitudes_and_a_maximum(self):
        outlying = MEASURED + 3 * (np.arange(8) == 4)
        for objective, norm in (("sum-of-magnitudes", 1), ("max-magnitude", np.inf), ("max-value", None)):
            fit = trust_region.minimize_residuals(lambda x: misfit(x, TIMES, outlying), [1, 0.1, 0], 8, objective, lower=[0, 0, -1],
                                                  upper=[10, 2, 1])
            final = misfit(fit.x, TIMES, outlying)
            self.assertTrue(fit.success)
            self.assertAlmostEqual(fit.value, np.linalg.norm(final, norm) if norm else final.max(), places=12)
        robust = trust_region.minimize_residuals(lambda x: misfit(x, TIMES, outlying), [1, 0.1, 0], 8, "sum-of-magnitudes")
        np.testing.assert_allclose(robust.x, [2.5, 0.7, 0.4], atol=0.1)  # as without the outlier
        with self.assertRaisesRegex(ValueError, "objective='max'"):
            trust_region.minimize_residuals(lambda x: x, [1.0], 1, "max")

    def test_minimum_is_that_of_scipy_and_of_the_library(self):
        for bounds in ((-np.inf, np.inf), ([0, 0, -1], [2, 2, 1]), Bounds([0, 0, -1], [2, 2, 1])):
            # SciPy 1.10 asks for pairs of arrays where it knows no Bounds.
            pair = (bounds.lb, bounds.ub) if isinstance(bounds, Bounds) else bounds
            known = least_squares(misfit, [1, 0.1, 0], bounds=pair, args=(TIMES, MEASURED), xtol=1e-12, ftol=1e-14, gtol=1e-12)
            found = trust_region.scipy_least_squares(misfit, [1, 0.1, 0], bounds=bounds, args=(TIMES, MEASURED), xtol=1e-10)
            np.testing.assert_allclose(found.x, known.x, rtol=1e-5)
            np.testing.assert_allclose(found.cost, known.cost, rtol=1e-8)
            self.assertEqual(found.fun.tobytes(), misfit(found.x, TIMES, MEASURED).tobytes())
            self.assertEqual(found.active_mask.tolist(), [0, 0, 0] if pair[1] is np.inf else [1, 0, 0])
            self.assertTrue(found.success)
            own = trust_region.least_squares(lambda x: misfit(x, TIMES, MEASURED), [1, 0.1, 0], 8, lower=pair[0], upper=pair[1],
                                             radius_end=1e-10)
            self.assertEqual(found.x.tobytes(), own.x.tobytes())

    def test_each_point_is_evaluated_once(self):
        called = []

        def counted(x, t, measured, weight):
            called.append(x.tobytes())
            return misfit(x, t, measured, weight=weight)

        found = trust_region.scipy_least_squares(counted, [1, 0.1, 0], args=(TIMES, MEASURED), kwargs={"weight": 3.0}, max_nfev=20)
        self.assertEqual((found.nfev, len(called), len(set(called))), (20, 20, 20))
        self.assertFalse(found.success)

    def test_callback(self):
        seen = []

        def follow(intermediate_result):
            seen.append(intermediate_result.cost)
            if len(seen) == 5:
                raise StopIteration

        found = trust_region.scipy_least_squares(misfit, [1, 0.1, 0], args=(TIMES, MEASURED), callback=follow)
        self.assertEqual(found.cost, seen[-1])
        self.assertEqual(len(seen), 5)
        few = trust_region.scipy_least_squares(misfit, [1, 0.1, 0], args=(TIMES, MEASURED), maxiter=3)
        self.assertEqual((few.nit, few.message), (3, "iteration budget"))

    def test_refusals(self):
        def call(**named):
            return trust_region.scipy_least_squares(misfit, [1, 0.1, 0], args=(TIMES, MEASURED), **named)

        call(loss="linear", ftol=None, f_scale=1.0, jac="2-point", maxiter=2)
        for named, error, message in (
                ({"loss": "huber"}, TypeError, "loss: this method has no use"),
                ({"gtol": 1e-3}, TypeError, "gtol: this method has no use.* xtol"),
                ({"x_scale": "jac"}, TypeError, "x_scale: one number"),
                ({"max_nfevs": 3}, TypeError, "'max_nfevs'; did you mean 'max_nfev'"),
                ({"bounds": [(0, 1)] * 3}, ValueError, r"bounds: \(lower, upper\)"),
                ({"bounds": ([0, 0], [1, 1])}, ValueError, r"bounds\[0\]: one number or 3")):
            with self.subTest(named), self.assertRaisesRegex(error, message):
                call(**named)
        with self.assertRaisesRegex(ValueError, "fun returned no numbers"):
            trust_region.scipy_least_squares(lambda x: [], [0.0])
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            call(jac=lambda x: x, maxiter=1)
        self.assertIn("does not use derivatives (jac)", "".join(str(one.message) for one in said))


class Gradients(unittest.TestCase):
    def test_minimum_is_that_of_the_library_to_the_bit(self):
        start = np.full(50, -0.5)
        own = projected_gradient.minimize(lambda x: (rosen(x), rosen_der(x)), start, lower=-2, upper=0.8)
        for jac, f in ((rosen_der, rosen), (True, lambda x: (rosen(x), rosen_der(x)))):
            found = minimize(f, start, jac=jac, method=projected_gradient.scipy_method, bounds=[(-2, 0.8)] * 50)
            self.assertEqual(found.x.tobytes(), own.x.tobytes())
            self.assertEqual((found.nfev, found.njev, found.status), (own.nfev, own.nfev, own.status))
            self.assertTrue(found.success)

    def test_linear_equations(self):
        # The nearest point of the simplex's plane, by hand: the center moved along (1, 1, 1).
        center = np.array([3.0, 1.0, -1.0])
        rows = np.ones((1, 3))
        for constraint in (LinearConstraint(rows, 1, 1), [LinearConstraint(scipy.sparse.csr_matrix(rows), [1], [1])]):
            found = minimize(bowl, [0.2, 0.3, 0.5], args=(center,), jac=bowl_der, method=projected_gradient.scipy_method,
                             constraints=constraint, options={"gtol": 1e-10, "maxfun": 100})
            np.testing.assert_allclose(found.x, center - 2 / 3, atol=1e-9)

    def test_inequalities_are_met_and_hold_where_they_must(self):
        # The nearest point of the half-space x0 + x1 + x2 <= 1, and of a slab that the center is in; both by hand.
        center = np.array([3.0, 1.0, -1.0])
        rows = np.ones((1, 3))
        for matrix in (rows, scipy.sparse.csr_matrix(rows)):
            found = minimize(bowl, np.zeros(3), args=(center,), jac=bowl_der, method=projected_gradient.scipy_method,
                             constraints=[LinearConstraint(matrix, -np.inf, 1), LinearConstraint([[0, 1, -1]], -5, 5)])
            self.assertTrue(found.success)
            np.testing.assert_allclose(found.x, center - 2 / 3, atol=1e-7)
            inside = minimize(bowl, np.zeros(3), args=(center,), jac=bowl_der, method=projected_gradient.scipy_method,
                              constraints=LinearConstraint(matrix, 0, 4))
            np.testing.assert_allclose(inside.x, center, atol=1e-7)

    def test_linear_programs_of_hock_and_schittkowski(self):
        def hs24(x):
            return ((x[0] - 3) ** 2 - 9) * x[1] ** 3 / (27 * np.sqrt(3))

        def hs24_der(x):
            scale = 1 / (27 * np.sqrt(3))
            return scale * np.array([2 * (x[0] - 3) * x[1] ** 3, 3 * ((x[0] - 3) ** 2 - 9) * x[1] ** 2])

        root = np.sqrt(3)
        seen = []
        found = minimize(hs24, [1, 0.5], jac=hs24_der, method=projected_gradient.scipy_method, bounds=[(0, None)] * 2,
                         constraints=LinearConstraint([[1 / root, -1], [1, root], [-1, -root]], [0, 0, -6], np.inf),
                         callback=lambda x: seen.append(x.size))
        np.testing.assert_allclose(found.x, [3, root], atol=1e-6)
        self.assertAlmostEqual(found.fun, -1, places=10)
        self.assertEqual(set(seen), {2})  # without slacks

        def hs76(x):
            return x[0] ** 2 + 0.5 * x[1] ** 2 + x[2] ** 2 + 0.5 * x[3] ** 2 - x[0] * x[2] + x[2] * x[3] - x[0] - 3 * x[1] + x[2] - x[3]

        rows = LinearConstraint([[1, 2, 1, 1], [3, 1, 2, -1], [0, 1, 4, 0]], [-np.inf, -np.inf, 1.5], [5, 4, np.inf])
        for kind in ("2-point", "3-point"):
            found = minimize(hs76, np.full(4, 0.5), method=projected_gradient.scipy_method, bounds=[(0, None)] * 4, constraints=rows,
                             options={"differences": kind})
            self.assertTrue(found.success)
            self.assertAlmostEqual(found.fun, -4.681818181, places=7)

    def test_differences_stay_within_the_bounds_and_are_counted(self):
        called = []

        def f(x):
            called.append(x.copy())
            return rosen(x)

        lower, upper = np.array([-2.0, -1.0, 0.3]), np.array([0.5, 1e-9 - 1.0, 0.3])  # one narrow, one empty interval
        counts = []
        for kind in ("2-point", "3-point"):
            called.clear()
            found = minimize(f, [0.2, -1, 0.3], method=projected_gradient.scipy_method, bounds=Bounds(lower, upper),
                             options={"differences": kind})
            self.assertEqual(found.nfev, len(called))
            counts.append(found.nfev / found.njev)
            self.assertTrue(all(np.all(x >= lower) and np.all(x <= upper) for x in called))
            exact = minimize(rosen, [0.2, -1, 0.3], jac=rosen_der, method=projected_gradient.scipy_method,
                             bounds=Bounds(lower, upper))
            np.testing.assert_allclose(found.x, exact.x, atol=1e-5)
        self.assertLess(counts[0], counts[1])
        self.assertEqual(projected_gradient.scipy_method(rosen, [0.2, -1, 0.3], jac="3-point", bounds=Bounds(lower, upper)).nfev, found.nfev)
        limited = minimize(rosen, [-1.2, 1], method=projected_gradient.scipy_method, options={"maxfun": 30})
        self.assertLessEqual(limited.nfev, 30)
        self.assertEqual(limited.message, "evaluation budget")

    def test_words_for_the_memory_and_the_tolerance(self):
        start = np.linspace(-1, 1, 60)
        own = projected_gradient.minimize(lambda x: (rosen(x), rosen_der(x)), start, memory=4, gradient_tolerance=1e-6)
        found = minimize(rosen, start, jac=rosen_der, method=projected_gradient.scipy_method, options={"maxcor": 4, "gtol": 1e-6})
        self.assertEqual((found.x.tobytes(), found.nfev), (own.x.tobytes(), own.nfev))

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "jac: a function.*'3-point' is needed, not 'cs'"):
            projected_gradient.scipy_method(rosen, [0, 0], jac="cs")
        with self.assertRaisesRegex(ValueError, r"constraints\[0\]: lb\[0\] = 2.0 is not below ub\[0\] = 1.0"):
            minimize(rosen, [0, 0], jac=rosen_der, method=projected_gradient.scipy_method, constraints=LinearConstraint([[1, 1]], 2, 1))
        with self.assertRaisesRegex(TypeError, "LinearConstraint is needed"):
            minimize(rosen, [0, 0], jac=rosen_der, method=projected_gradient.scipy_method,
                     constraints=NonlinearConstraint(rosen, 0, 0))


if __name__ == "__main__":
    unittest.main()
