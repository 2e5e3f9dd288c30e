"""The solvers as methods of scipy.optimize.minimize: known minima, the words of SciPy, its callbacks, refusals."""

import sys
import unittest
import warnings

import numpy as np
from orbicube import projected_gradient, trust_region

try:
    import scipy.sparse
    from scipy.optimize import Bounds, LinearConstraint, NonlinearConstraint, minimize, rosen, rosen_der
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


class Gradients(unittest.TestCase):
    def test_minimum_is_that_of_the_library_to_the_bit(self):
        start = np.full(50, -0.5)
        own = projected_gradient.minimize(lambda x: (rosen(x), rosen_der(x)), start, lower=-2, upper=0.8)
        for jac, f in ((rosen_der, rosen), (True, lambda x: (rosen(x), rosen_der(x)))):
            found = minimize(f, start, jac=jac, method=projected_gradient.scipy_method, bounds=[(-2, 0.8)] * 50)
            self.assertEqual(found.x.tobytes(), own.x.tobytes())
            self.assertEqual(found.nfev, own.nfev)
            self.assertTrue(found.success)

    def test_linear_equations(self):
        # The nearest point of the simplex's plane, by hand: the center moved along (1, 1, 1).
        center = np.array([3.0, 1.0, -1.0])
        rows = np.ones((1, 3))
        for constraint in (LinearConstraint(rows, 1, 1), [LinearConstraint(scipy.sparse.csr_matrix(rows), [1], [1])]):
            found = minimize(bowl, [0.2, 0.3, 0.5], args=(center,), jac=bowl_der, method=projected_gradient.scipy_method,
                             constraints=constraint, options={"gtol": 1e-10, "maxfun": 100})
            np.testing.assert_allclose(found.x, center - 2 / 3, atol=1e-9)

    def test_refusals(self):
        with self.assertRaisesRegex(ValueError, "jac: a function.*trust_region.scipy_method"):
            minimize(rosen, [0, 0], method=projected_gradient.scipy_method)
        with self.assertRaisesRegex(ValueError, r"constraints\[0\]: lb\[0\] = 0.0 and ub\[0\] = 1.0 differ"):
            minimize(rosen, [0, 0], jac=rosen_der, method=projected_gradient.scipy_method, constraints=LinearConstraint([[1, 1]], 0, 1))
        with self.assertRaisesRegex(TypeError, "LinearConstraint is needed"):
            minimize(rosen, [0, 0], jac=rosen_der, method=projected_gradient.scipy_method,
                     constraints=NonlinearConstraint(rosen, 0, 0))


if __name__ == "__main__":
    unittest.main()
