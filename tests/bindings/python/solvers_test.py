"""The solvers from Python: the bits of C, questions and answers, saved runs, exceptions, failed evaluations, Ctrl-C."""

import math
import os
import signal
import subprocess
import threading
import unittest

import numpy as np
import orbicube
from orbicube import projected_gradient, sphere_optimizer, trust_region

TRUTH = (2.5, 0.7, 0.4)
PRICE, USUAL = (0.9, 0.3, 0.5, 1.4, 0.2), (0.2, 0.3, 0.2, 0.1, 0.2)
WEIGHT, PROTEIN = (2, 1, 3, 1, 4), (0.12, 0.09, 0.35, 0.44, 0.05)
ROWS = {"A": [[1] * 5, PROTEIN], "b": [1, 0.2], "lower": 0, "upper": 0.6}
DECAY = {"lower": [0, 0, -1], "upper": [10, 2, 1]}


def from_c():
    """name -> (evaluations, numbers) of the C program that solves the same problems."""
    printed = subprocess.run([os.environ["ORBICUBE_PROBLEMS"]], check=True, capture_output=True, text=True).stdout
    return {name: (int(evaluations), np.array([int(bits, 16) for bits in rest], dtype=np.uint64).view(np.float64))
            for name, evaluations, *rest in (line.split() for line in printed.splitlines())}


def model(x, i):
    return x[0] / (1 + x[1] * (0.5 * i)) + x[2]


def misfit(x):
    return [model(x, i) - model(TRUTH, i) for i in range(8)]


def cost(x):
    total, gradient = 0.0, []
    for j, value in enumerate(x):
        away = value - USUAL[j]
        total = total + (PRICE[j] * value + 0.5 * WEIGHT[j] * away * away)
        gradient.append(PRICE[j] + WEIGHT[j] * away)
    return total, gradient


def charges(x):
    total, gradient = 0.0, np.zeros((12, 3))
    for i in range(12):
        for j in range(i):
            away = [x[i, k] - x[j, k] for k in range(3)]
            square = 0.0
            for k in range(3):
                square = square + away[k] * away[k]
            term = 1 / square
            total = total + term
            for k in range(3):
                pull = 2 * term * term * away[k]
                gradient[i, k] -= pull
                gradient[j, k] += pull
    return total, gradient


CHARGES = np.array([(i * i * 7 % 37) / 37 - 0.5 for i in range(36)]).reshape(12, 3)


OTHERS = [[j for j in range(12) if j != i] for i in range(12)]


def charge(i, place, points, derivatives):
    """The part of `charges` that has one of them."""
    value, gradient = 0.0, np.zeros(3)
    for j in OTHERS[i]:
        away = place - points[j]
        term = 1 / (away @ away)
        value += term
        gradient -= 2 * term * term * away
    return value, gradient


class SameBits(unittest.TestCase):
    """Every way of running a solver ends in the bits of the C callback."""

    @classmethod
    def setUpClass(cls):
        cls.expected = from_c()

    def same(self, name, result):
        evaluations, x = self.expected[name]
        self.assertEqual(result.evaluations, evaluations)
        self.assertEqual(result.x.tobytes(), x.tobytes())
        self.assertTrue(result.converged)

    def test_callbacks(self):
        self.same("decay", trust_region.least_squares(misfit, [1, 0.1, 0], 8, **DECAY))
        self.same("feeds", projected_gradient.minimize(cost, np.zeros(5), **ROWS))
        self.same("icosahedron", sphere_optimizer.minimize(charges, CHARGES))

    def test_questions_and_answers_with_a_save_after_each(self):
        solver = trust_region.Solver([1, 0.1, 0], 8, **DECAY)
        while (x := solver.ask()) is not None:
            solver.tell(misfit(x))
            solver = trust_region.Solver.load(solver.save(), np.empty(3), 8, **DECAY)
        self.same("decay", solver.result)
        np.testing.assert_array_equal(solver.outputs, misfit(solver.result.x))

        solver = projected_gradient.Solver(np.zeros(5), **ROWS)
        while (x := solver.ask()) is not None:
            solver.tell(*cost(x))
            solver = projected_gradient.Solver.load(solver.save(), np.empty(5), **ROWS)
        self.same("feeds", solver.result)

        solver = sphere_optimizer.Solver(CHARGES)
        while (x := solver.ask()) is not None:
            solver.tell(*charges(x))
            solver = sphere_optimizer.Solver.load(solver.save())
        self.same("icosahedron", solver.result)

    def test_products_of_the_hessian(self):
        stiffness = np.array([[3.0, 1, 0, 0], [1, 4, 1, 0], [0, 1, 5, 1], [0, 0, 1, 6]])
        least = float(np.linalg.eigvalsh(stiffness)[0])
        start = [[1.0, -2, 3, -4]]

        def quotient(x):
            return float(np.vdot(x, x @ stiffness)), 2 * x @ stiffness

        def product(x, direction):
            self.assertAlmostEqual(float(np.vdot(x, direction)), 0)
            return 2 * direction @ stiffness
        result = sphere_optimizer.minimize(quotient, start, hessian_product=product)
        self.assertTrue(result.converged)
        self.assertAlmostEqual(result.value, least, places=12)
        self.assertGreater(result.report.products, 0)
        differenced = sphere_optimizer.minimize(quotient, start, method="truncated-newton")
        self.assertAlmostEqual(differenced.value, least, places=12)

        solver = sphere_optimizer.Solver(start, method="truncated-newton", hessian_products=True)
        while (x := solver.ask()) is not None:
            if (direction := solver.direction) is None:
                solver.tell(*quotient(x))
            else:
                solver.tell_product(product(x, direction))
            solver = sphere_optimizer.Solver.load(solver.save())
        np.testing.assert_array_equal(solver.result.x, result.x)

        def stopping(x, direction):
            raise sphere_optimizer.Stop(1)
        stopped = sphere_optimizer.minimize(quotient, start, hessian_product=stopping)
        self.assertEqual(stopped.stop, "cancelled")

        def failing(x, direction):
            raise sphere_optimizer.EvaluationFailed
        self.assertLess(sphere_optimizer.minimize(quotient, start, hessian_product=failing, max_evaluations=500).value, least + 1e-3)
        with self.assertRaisesRegex(TypeError, "hessian_product returned None"):
            sphere_optimizer.minimize(quotient, start, hessian_product=lambda x, direction: None)
        with self.assertRaisesRegex(ValueError, "hessian_product: method 'great-circle' takes none"):
            sphere_optimizer.minimize(quotient, start, hessian_product=product, method="great-circle")

    def test_sparse_rows_in_three_forms(self):
        starts, columns, values = [0, 5, 10], list(range(5)) * 2, [1.0] * 5 + list(PROTEIN)

        class Csr:
            indptr, indices, data, shape = np.array(starts), np.array(columns), np.array(values), (2, 5)

            def tocsr(self):
                return self

        for rows in ((starts, columns, values), Csr()):
            self.same("feeds", projected_gradient.minimize(cost, np.zeros(5), **{**ROWS, "A": rows}))


class Behaviour(unittest.TestCase):
    def test_the_points_asked_about_stay_what_they_were(self):
        seen = []

        def f(x):
            seen.append((x, x.copy()))
            return (x[0] - 1) ** 2 + (x[1] + 2) ** 2

        result = trust_region.minimize(f, [0.0, 0.0])
        del result
        self.assertGreater(len(seen), 5)
        for x, copy in seen:
            np.testing.assert_array_equal(x, copy)

    def test_a_cross_is_asked_for_at_once(self):
        solver = trust_region.Solver([0.5] * 4, start="cross", lower=0, upper=1)
        points = solver.ask_all()
        self.assertEqual(points.shape[1], 4)
        self.assertGreater(len(points), 4)
        for x in points:
            np.testing.assert_array_equal(x, solver.ask())
            solver.tell(((x - 0.3) ** 2).sum())
        while (x := solver.ask()) is not None:
            solver.tell(((x - 0.3) ** 2).sum())
        np.testing.assert_allclose(solver.result.x, 0.3, atol=1e-6)  # radius_end is 1e-8, f is quadratic

    def test_evaluations_made_before_are_used(self):
        solver = trust_region.Solver([0, 0])
        solver.give([[3, 4], [0.5, 0.5]], [10.0, 0.0])
        np.testing.assert_array_equal(solver.result.x, [0.5, 0.5])

    def test_where_f_has_no_value_the_method_goes_on_elsewhere(self):
        calls = []

        def f(x):
            calls.append(len(calls))
            if len(calls) == 5:
                raise orbicube.EvaluationFailed
            return math.nan if len(calls) == 7 else (x[0] - 1) ** 2 + (x[1] + 2) ** 2

        result = trust_region.minimize(f, [0, 0])
        self.assertEqual(result.report.failed_evaluations, 2)
        np.testing.assert_allclose(result.x, [1, -2], atol=1e-6)  # as above

    def test_an_exception_comes_out_as_it_is(self):
        class Mine(Exception):
            pass

        for run in (lambda f: trust_region.minimize(f, [0, 0]), lambda f: projected_gradient.minimize(f, [0, 0]),
                    lambda f: sphere_optimizer.minimize(f, [[1, 0]]),
                    lambda f: sphere_optimizer.relax(f, [[1, 0], [0, 1]], [[1], [0]])):
            def f(*_):
                raise Mine("here")

            with self.assertRaisesRegex(Mine, "here"):
                run(f)

    def test_a_gradient_is_checked(self):
        def f(x):
            return float(((x - 1) ** 2).sum()), 2 * (x - 1) * wrong

        wrong = np.ones(3)
        self.assertTrue(projected_gradient.check_gradient(f, [3, 4, 5]).agrees)
        wrong[1] = -1
        found = projected_gradient.check_gradient(f, [3, 4, 5], lower=0, upper=5)
        self.assertFalse(found.agrees)
        self.assertEqual((found.worst, found.told), (1, -6))
        self.assertAlmostEqual(found.difference, 6, 6)
        with self.assertRaises(ZeroDivisionError):
            projected_gradient.check_gradient(lambda x: 1 / 0, [1])

    def test_stop_hands_out_the_best_point(self):
        count = [0]

        def f(x):
            count[0] += 1
            if count[0] > 20:
                raise orbicube.Stop
            return 100 * (x[1] - x[0] ** 2) ** 2 + (1 - x[0]) ** 2

        result = trust_region.minimize(f, [-1.2, 1])
        self.assertEqual(result.stop, "cancelled")
        self.assertEqual(result.evaluations, 20)
        self.assertLess(result.value, 24.2)  # f at the start

    def test_a_value_that_comes_with_stop_counts(self):
        good = np.array([1e-3, 2e-3])

        def stopping(after, *told):
            calls = []

            def f(*_):
                calls.append(1)
                if len(calls) == after:
                    raise orbicube.Stop(*told)
                return 1.0 if f.gradient is None else (1.0, f.gradient)
            f.gradient = None
            return f

        result = trust_region.minimize(stopping(4, 1e-9), [3.0, 4.0])
        self.assertEqual((result.stop, result.value, result.evaluations), ("cancelled", 1e-9, 4))
        result = trust_region.least_squares(stopping(1, good), [3.0, 4.0], 2)
        self.assertEqual((result.stop, result.evaluations), ("cancelled", 1))
        self.assertAlmostEqual(result.value, 5e-6, places=20)
        for told in ((1e-9,), (1e-9, [0.0, 1.0]), ((1e-9, [0.0, 1.0]),)):
            f = stopping(2, *told)
            f.gradient = np.ones(2)
            result = projected_gradient.minimize(f, [3.0, 4.0])
            self.assertEqual((result.stop, result.value, result.evaluations), ("cancelled", 1e-9, 2))
        f = stopping(2, -7.0)
        f.gradient = np.tile([0, 0.1, 1.0], (2, 1))
        result = sphere_optimizer.minimize(f, np.eye(3)[:2])
        self.assertEqual((result.stop, result.value, result.evaluations), ("cancelled", -7.0, 2))
        self.assertEqual(trust_region.minimize(stopping(4, 2.0), [3.0, 4.0]).value, 1.0)  # the best, not the last
        with self.assertRaisesRegex(TypeError, "f returned None"):
            trust_region.minimize(stopping(4, None), [3.0, 4.0])

    def test_progress_can_stop_a_run(self):
        told = []
        result = sphere_optimizer.minimize(charges, CHARGES, progress=lambda *what: told.append(what) or len(told) == 3)
        self.assertEqual((result.stop, len(told)), ("cancelled", 3))

    def test_what_is_infeasible_has_a_certificate(self):
        solver = projected_gradient.Solver(np.zeros(2), lower=0, upper=1, A=[[1, 1]], b=[3])
        self.assertIsNone(solver.ask())
        self.assertEqual(solver.result.stop, "infeasible")
        c = solver.certificate[0]
        self.assertLess(max(0, 2 * c), 3 * c)  # c'A x < c'b for every x in the box

    def test_a_projection_of_the_callers_own(self):
        def onto_disc(y):
            return y / max(1.0, math.hypot(*y))

        result = projected_gradient.minimize(lambda x: (((x - [3, 4]) ** 2).sum(), 2 * (x - [3, 4])), [0.0, 0.0],
                                             project=onto_disc)
        np.testing.assert_allclose(result.x, [0.6, 0.8], atol=1e-7)  # gradient_tolerance is 1e-8
        with self.assertRaises(ZeroDivisionError):
            projected_gradient.minimize(cost, np.zeros(5), project=lambda y: 1 / 0)

    def test_the_projection_alone(self):
        found = projected_gradient.project([2, 2], lower=0, upper=3, A=[[1, 1]], b=[1])
        np.testing.assert_allclose(found.x, [0.5, 0.5], atol=1e-15)  # of a root of a linear function
        np.testing.assert_allclose(found.multipliers, [-1.5], atol=1e-15)
        self.assertEqual(found.stop, "converged")

    def test_multipliers_close_the_optimality_conditions(self):
        solver = projected_gradient.Solver(np.zeros(5), **ROWS)
        result = solver.run(cost)
        _, gradient = cost(result.x)
        slope = np.array(gradient) - np.array(ROWS["A"]).T @ solver.multipliers
        inside = (result.x > 0) & (result.x < 0.6)
        self.assertLess(np.abs(slope[inside]).max(), 1e-7)  # gradient_tolerance is 1e-8
        self.assertTrue(np.all(slope[result.x <= 0] >= 0) and np.all(slope[result.x >= 0.6] <= 0))

    def test_block_by_block(self):
        def part(i, place, points, derivatives):
            self.assertIn(derivatives, (0, 1))
            return charge(i, place, points, derivatives)

        result = sphere_optimizer.relax(part, CHARGES, OTHERS)
        self.assertAlmostEqual(charges(result.x)[0], 39, delta=1e-9)
        np.testing.assert_allclose(np.linalg.norm(result.x, axis=1), 1, atol=4e-16)  # two units of the last place

    def test_block_by_block_in_parts_that_are_broken_off_saved_and_loaded(self):
        whole = sphere_optimizer.relax(charge, CHARGES, OTHERS)
        relaxation = sphere_optimizer.Relaxation(CHARGES, OTHERS)
        self.assertEqual(relaxation.result.stop, "running")
        self.assertEqual(relaxation.run(charge, 10).report.steps, 10)
        for reason in (ZeroDivisionError, sphere_optimizer.Stop):
            def refuse(*_):
                raise reason

            if reason is sphere_optimizer.Stop:
                self.assertEqual(relaxation.run(refuse, 10).stop, "cancelled")
            else:
                with self.assertRaises(reason):
                    relaxation.run(refuse, 10)
        again = sphere_optimizer.Relaxation.load(relaxation.save(), CHARGES, OTHERS)
        for one in (relaxation, again):
            while one.run(charge, 25).stop == "running":
                pass
            self.assertEqual(one.result.x.tobytes(), whole.x.tobytes())
            self.assertEqual((one.result.stop, one.result.report.steps), (whole.stop, whole.report.steps))
        with self.assertRaises(orbicube.InvalidArgument):
            sphere_optimizer.Relaxation.load(relaxation.save(), CHARGES, [[]] * 12)  # others
        with self.assertRaises(ValueError):
            relaxation.run(charge, -1)
        again.close()
        again.close()

    def test_wrong_arguments_are_refused(self):
        with self.assertRaisesRegex(TypeError, "no argument 'radius'; did you mean 'radius_end'.*There are: f, x0, .*max_evaluations"):
            trust_region.minimize(misfit, [0], radius=1)
        with self.assertRaisesRegex(ValueError, "method='two-radius': one of 'two-radii', 'dissertation' is needed; did you mean 'two-radii'"):
            trust_region.minimize(misfit, [0], method="two-radius")
        with self.assertRaisesRegex(ValueError, r"x0\[0\] is nan"):
            trust_region.Solver([math.nan])
        with self.assertRaises(orbicube.InvalidArgument) as caught:
            trust_region.Solver([0.0], radius_end=-1)
        self.assertEqual(caught.exception.status, orbicube.raw.base.OBC_INVALID_ARGUMENT)
        solver = trust_region.Solver([0.0])
        with self.assertRaises(orbicube.InvalidArgument):
            solver.tell(1.0)  # nothing was asked
        with self.assertRaises(orbicube.MalformedFile):
            trust_region.Solver.load(b"nothing", [0.0])
        with self.assertRaises(ValueError):
            projected_gradient.minimize(cost, np.zeros(5), A=[[1, 2]], b=[1])
        with self.assertRaises(ValueError):
            projected_gradient.minimize(cost, np.zeros(5), A=([0, 3], [1, 2], [1.0, 1.0]), b=[1])

    def test_ctrl_c_stops_a_run(self):
        """The signal comes while f runs, as most do."""
        calls = []

        def f(x):
            calls.append(1)
            if len(calls) == 10:
                os.kill(os.getpid(), signal.SIGINT)
            return (x[0] - 1) ** 2 + 1e-3 * math.sin(50 * x[0])

        with self.assertRaises(KeyboardInterrupt):
            trust_region.minimize(f, [0])
        self.assertEqual(len(calls), 10)

    def test_distinct_runs_at_the_same_time(self):
        expected = trust_region.least_squares(misfit, [1, 0.1, 0], 8, **DECAY).x.tobytes()
        found = []
        threads = [threading.Thread(target=lambda: found.append(
            trust_region.least_squares(misfit, [1, 0.1, 0], 8, **DECAY).x.tobytes())) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * 4)


if __name__ == "__main__":
    unittest.main()
