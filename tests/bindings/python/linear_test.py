"""Sparse symmetric systems from Python, against numpy.linalg: matrices in every form, factors that follow changes, iterations."""

import os
import signal
import threading
import unittest

import numpy as np
import orbicube
from interrupts import interrupted_after
from orbicube import linear

try:
    import scipy.sparse
except ImportError:
    scipy = None


class Csr:
    """What is read of a matrix of scipy.sparse, where scipy is not installed."""

    def __init__(self, shape, rows, columns, values):
        order = np.argsort(rows, kind="stable")
        self.shape, self.indices = shape, np.asarray(columns, np.int32)[order]
        self.data, self.indptr = np.asarray(values, float)[order], np.searchsorted(np.sort(rows), np.arange(shape[0] + 1))

    def tocsr(self):
        return self


def grid(n):
    """The Laplacian of an n by n grid plus 1/100, as rows, columns and values of all entries."""
    number = np.arange(n * n).reshape(n, n)
    pairs = np.concatenate([np.stack([number[1:].ravel(), number[:-1].ravel()], 1),
                            np.stack([number[:, 1:].ravel(), number[:, :-1].ravel()], 1)])
    degree = np.bincount(pairs.ravel(), minlength=n * n)
    rows = np.concatenate([number.ravel(), pairs[:, 0], pairs[:, 1]])
    columns = np.concatenate([number.ravel(), pairs[:, 1], pairs[:, 0]])
    return rows, columns, np.concatenate([degree + 0.01, -np.ones(2 * len(pairs))])


def dense_of(n, rows, columns, values):
    dense = np.zeros((n, n))
    np.add.at(dense, (rows, columns), values)
    return dense


ROWS, COLUMNS, VALUES = grid(8)
N = 64
DENSE = dense_of(N, ROWS, COLUMNS, VALUES)
B = np.random.default_rng(3).normal(size=(N, 4))


class Matrices(unittest.TestCase):
    def test_every_form_of_a_matrix_is_the_same_system(self):
        lower = ROWS >= COLUMNS
        row, column = np.nonzero(np.tril(DENSE))
        forms = {
            "array": DENSE, "lower triangle of an array": np.tril(DENSE), "lists": DENSE.tolist(),
            "by columns": np.asfortranarray(DENSE),
            "sparse": Csr(DENSE.shape, ROWS, COLUMNS, VALUES),
            "lower triangle": Csr(DENSE.shape, ROWS[lower], COLUMNS[lower], VALUES[lower]),
            "entries in halves": Csr(DENSE.shape, np.tile(ROWS, 2), np.tile(COLUMNS, 2), np.tile(VALUES / 2, 2)),
            "the arrays of C": (np.searchsorted(row, np.arange(N + 1)), column, DENSE[row, column]),
        }
        if scipy is not None:
            matrix = scipy.sparse.coo_matrix((VALUES, (ROWS, COLUMNS)), DENSE.shape)
            forms.update({"scipy " + name: matrix.asformat(name) for name in ("coo", "csr", "csc", "lil")})
            forms["scipy lower"] = scipy.sparse.tril(matrix)
        wanted = linear.Direct(DENSE).solve(B[:, 0])
        self.assertLess(np.abs(DENSE @ wanted - B[:, 0]).max(), 1e-13)
        for name, matrix in forms.items():
            with self.subTest(name):
                np.testing.assert_array_equal(linear.Direct(matrix).solve(B[:, 0]), wanted)
                x, report = linear.Iterative(matrix, tolerance=1e-13).solve(B[:, 0])
                np.testing.assert_allclose(x, wanted, rtol=1e-9, atol=1e-11)
                self.assertTrue(report.converged)

    def test_what_is_not_symmetric_is_refused_with_the_entries(self):
        for wrong, said in (([[2, 1], [0.5, 3]], r"A is not symmetric: A\[1, 0\] is 0\.5 and A\[0, 1\] is 1\.0"),
                            ([[2, 1], [0, 3]], r"A is not symmetric: A\[1, 0\] is 0\.0 and A\[0, 1\] is 1\.0"),
                            (Csr((2, 2), [0, 0, 1], [0, 1, 1], [2, 1, 3]), r"A is not symmetric: A\[1, 0\] is 0\.0")):
            for make in (linear.Direct, linear.Iterative):
                with self.subTest(wrong), self.assertRaisesRegex(ValueError, said):
                    make(wrong)

    def test_rounding_is_no_lack_of_symmetry(self):
        factor = np.random.default_rng(5).normal(size=(40, 20))
        product = factor.T @ factor
        product[3, 4] *= 1 + 1e-15
        x = linear.Direct(product).solve(B[:20, 0])
        np.testing.assert_allclose(x, np.linalg.solve(product, B[:20, 0]), rtol=1e-8)
        product[3, 4] *= 1 + 1e-6
        with self.assertRaisesRegex(ValueError, r"A\[4, 3\]"):
            linear.Direct(product)

    def test_a_missing_diagonal_entry_is_refused_with_its_row(self):
        for wrong in ([[2, 1, 0], [1, 0, 0], [0, 0, 0]], Csr((3, 3), [0, 1, 1, 2], [0, 0, 0, 2], [2, 1, 1, 1]),
                      ([0, 1, 2, 3], [0, 0, 2], [2.0, 1, 1])):
            with self.subTest(wrong), self.assertRaisesRegex(ValueError, "A has no entry on the diagonal of row 1"):
                linear.Direct(wrong)

    def test_the_arrays_of_c_are_looked_at(self):
        for wrong, said in ((([0, 1, 3], [0, 1, 0], [2.0, 1, 3]), "A: the columns of row 1 do not ascend"),
                            (([0, 2, 3], [0, 1, 1], [2.0, 1, 3]), r"A: columns\[1\] is 1, right of the diagonal of row 0"),
                            (([0, 2, 1], [0], [2.0]), "A: row_begin must rise"), (([], [], []), "A: row_begin must rise"),
                            (([0, 1], [0], [2.0, 3.0]), "A: columns and values"), (([0, 1], [0], [np.nan]), r"A: values\[0\]"),
                            ([[1.0, 2.0]], r"A: a square matrix is needed, not shape \(1, 2\)"), ([1.0], "A: a square matrix")):
            with self.subTest(said), self.assertRaisesRegex(ValueError, said):
                linear.Direct(wrong)

    def test_nothing_to_solve(self):
        self.assertEqual(linear.Direct(np.empty((0, 0))).solve(np.empty(0)).shape, (0,))
        x, report = linear.Iterative(np.empty((0, 0))).solve([])
        self.assertEqual((x.shape, report.converged, report.residual), ((0,), 1, 0.0))
        self.assertEqual(linear.Direct(DENSE).solve(np.empty((N, 0))).shape, (N, 0))


class Factors(unittest.TestCase):
    def assert_solves(self, factor, matrix, b=B):
        np.testing.assert_allclose(factor.solve(b), np.linalg.solve(matrix, b), rtol=1e-9, atol=1e-11)

    def test_one_right_side_or_several_in_any_order_of_memory(self):
        for method in ("auto", "eigen"):
            factor = linear.Direct(DENSE, method=method)
            self.assert_solves(factor, DENSE, B[:, 1])
            self.assert_solves(factor, DENSE)
            wanted = factor.solve(B)
            for b in (np.asfortranarray(B), B.tolist(), np.repeat(B, 2, axis=1)[:, ::2]):
                np.testing.assert_array_equal(factor.solve(b), wanted)
            np.testing.assert_array_equal(factor.solve(B[:, 2]), wanted[:, 2])
            self.assertEqual(factor.solve(B[:, :1]).shape, (N, 1))
        given = B[:, 0].copy()
        factor.solve(given)
        np.testing.assert_array_equal(given, B[:, 0])

    def test_the_entries_of_a_factor_are_counted(self):
        self.assertEqual(linear.Direct(np.diag([2.0] * 9)).entry_count, 0)
        path = 2 * np.eye(9) - np.eye(9, k=1) - np.eye(9, k=-1)
        self.assertEqual(linear.Direct(path).entry_count, 8)
        self.assertEqual(linear.Direct(np.eye(9) + 1).entry_count, 36)

    def test_other_values_of_the_same_pattern_or_of_less(self):
        factor = linear.Direct(Csr(DENSE.shape, ROWS, COLUMNS, VALUES))
        other = DENSE + np.diag(np.arange(N))
        factor.refactor(other)
        self.assert_solves(factor, other)
        other[8, 0] = other[0, 8] = 0
        factor.refactor(np.tril(other))
        self.assert_solves(factor, other)
        other[5, 0] = other[0, 5] = 0.25
        with self.assertRaisesRegex(ValueError, r"A\[5, 0\] is not in the pattern"):
            factor.refactor(other)
        with self.assertRaisesRegex(ValueError, "A: 64 rows are needed as before, not 3"):
            factor.refactor(np.eye(3))

    def test_a_row_that_becomes_known(self):
        factor, changed, b = linear.Direct(DENSE), DENSE.copy(), B.copy()
        for row in (7, 0, 63):
            factor.remove_row(row)
            changed[row, :] = changed[:, row] = 0
            changed[row, row] = 1
            self.assert_solves(factor, changed, b)
            np.testing.assert_array_equal(factor.solve(b)[row], b[row])
        for wrong in (-1, 64):
            with self.assertRaisesRegex(ValueError, f"row={wrong}: out of range, 0 to 63"):
                factor.remove_row(wrong)
        factor.refactor(DENSE)
        self.assert_solves(factor, DENSE)

    def test_matrices_of_rank_one_are_added_and_taken_away(self):
        factor, changed = linear.Direct(DENSE), DENSE.copy()
        w = np.zeros(N)
        w[[20, 21]] = 3, -2
        factor.update([21, 20], [-2, 3])
        self.assert_solves(factor, DENSE + np.outer(w, w))
        factor.update([20, 21], [3, -2], sign=-1)
        self.assert_solves(factor, DENSE)
        with self.assertRaisesRegex(orbicube.InvalidArgument, "no entry for rows 0 and 63"):
            factor.update([0, 63], [1, 1])
        for arguments, said in ((([0, 1], [1]), "rows and values"), (([64], [1]), r"rows\[0\] is 64"), (([0], [1], 2), "sign=2"),
                                (([0, 0], [1, 1]), "repeated")):
            with self.assertRaisesRegex(ValueError, said):
                factor.update(*arguments)
        self.assert_solves(factor, changed)

    def test_an_entry_of_value_zero_is_declared_for_an_update_to_come(self):
        path = Csr((3, 3), [0, 1, 1, 2, 2, 2], [0, 0, 1, 0, 1, 2], [2, -1, 2, 0, -1, 2])
        factor = linear.Direct(path)
        factor.update([0, 2], [1, -1])
        self.assert_solves(factor, np.array([[3.0, -1, -1], [-1, 2, -1], [-1, -1, 3]]), B[:3])

    def test_what_is_not_positive_definite_is_no_valid_result(self):
        with self.assertRaises(orbicube.NoValidResult):
            linear.Direct([[1, 2], [2, 1]])
        factor = linear.Direct(DENSE)
        with self.assertRaises(orbicube.NoValidResult):
            factor.update([3], [100], sign=-1)
        with self.assertRaisesRegex(orbicube.InvalidArgument, "refactor first"):
            factor.solve(B)
        factor.refactor(DENSE)
        self.assert_solves(factor, DENSE)

    def test_a_method_that_is_not_in_the_build_is_unsupported_or_solves(self):
        for method in ("cholmod-simplicial", "CHOLMOD_SUPERNODAL"):
            try:
                factor = linear.Direct(DENSE, method=method)
            except orbicube.Unsupported:
                continue
            self.assert_solves(factor, DENSE)


class Iterations(unittest.TestCase):
    def test_the_residual_that_is_reported_is_that_of_the_matrix(self):
        for method in ("auto", "gauss-seidel", "multigrid"):
            for tolerance in (1e-3, 1e-12):
                x, report = linear.Iterative(DENSE, method=method, tolerance=tolerance).solve(B[:, 0])
                residual = np.linalg.norm(B[:, 0] - DENSE @ x) / np.linalg.norm(B[:, 0])
                self.assertLessEqual(residual, tolerance * 1.001 + 1e-15)
                self.assertAlmostEqual(report.residual, residual, delta=1e-3 * residual + 1e-15)
                self.assertEqual((report.converged, report.iterations > 0), (1, True))

    def test_iterations_that_are_used_up_are_reported(self):
        x, report = linear.Iterative(DENSE, method="gauss-seidel", max_iterations=2).solve(B[:, 0])
        self.assertEqual((report.converged, report.iterations), (0, 2))
        self.assertGreater(report.residual, 1e-8)
        self.assertEqual(x.shape, (N,))

    def test_blocks_of_three(self):
        blocks = np.kron(DENSE, np.array([[2.0, 0.5, 0], [0.5, 2, 0], [0, 0, 1]]))
        b = np.random.default_rng(1).normal(size=3 * N)
        for method in ("gauss-seidel", "multigrid"):
            x, report = linear.Iterative(blocks, method=method, block_size=3, tolerance=1e-12).solve(b)
            np.testing.assert_allclose(x, np.linalg.solve(blocks, b), rtol=1e-6, atol=1e-8)
            self.assertTrue(report.converged)
        with self.assertRaisesRegex(ValueError, "block_size=4: 1, 2 or 3"):
            linear.Iterative(blocks, block_size=4)
        with self.assertRaisesRegex(ValueError, "block_size=3: A has 64 rows"):
            linear.Iterative(DENSE, block_size=3)

    def test_results_are_the_same_bits_for_any_number_of_threads(self):
        rows, columns, values = grid(160)
        matrix = Csr((160 * 160,) * 2, rows, columns, values)
        b = np.random.default_rng(2).normal(size=160 * 160)
        one, two = (linear.Iterative(matrix, threads=threads).solve(b)[0] for threads in (1, 2))
        np.testing.assert_array_equal(one, two)


class Progress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rows, columns, values = grid(300)
        cls.matrix, cls.b = Csr((300 * 300,) * 2, rows, columns, values), np.ones(300 * 300)

    def test_each_call_reports_to_its_own_function(self):
        made, first, second = [], [], []
        solver = linear.Iterative(self.matrix, progress=lambda *at: made.append(at))
        count = len(made)
        self.assertGreater(count, 0)
        solver.solve(self.b, progress=lambda *at: first.append(at))
        solver.solve(self.b, progress=lambda *at: second.append(at))
        solver.solve(self.b)
        self.assertEqual(len(made), count)
        self.assertGreater(len(first), 0)
        self.assertGreater(len(second), 0)
        self.assertEqual({at[0] for at in first}, {at[0] for at in second})

    def test_a_solution_can_be_cancelled_and_the_solver_used_again(self):
        solver = linear.Iterative(self.matrix)
        with self.assertRaises(orbicube.Cancelled):
            solver.solve(self.b, progress=lambda *at: True)
        with self.assertRaises(orbicube.Cancelled):
            linear.Iterative(self.matrix, progress=lambda *at: True)

        def fails(*at):
            raise ZeroDivisionError("mine")

        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            solver.solve(self.b, progress=fails)
        self.assertTrue(solver.solve(self.b)[1].converged)

    @unittest.skipIf(os.name == "nt", "signals of POSIX")
    def test_control_c_stops_the_iterations(self):
        # A thousand solutions take far longer than the signal.
        solver = linear.Iterative(self.matrix, method="gauss-seidel", tolerance=1e-15)
        with self.assertRaises(KeyboardInterrupt), interrupted_after(0.02):
            for _ in range(1000):
                solver.solve(self.b)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        x, _ = solver.solve(self.b)
        self.assertTrue(np.isfinite(x).all())


class Lifetimes(unittest.TestCase):
    def test_a_factor_does_not_need_the_arrays_that_it_was_made_of(self):
        matrix = DENSE.copy()
        factor, solver = linear.Direct(matrix), linear.Iterative(matrix, tolerance=1e-12)
        wanted = np.linalg.solve(DENSE, B[:, 0])
        matrix[:] = np.nan
        del matrix
        np.testing.assert_allclose(factor.solve(B[:, 0]), wanted, rtol=1e-9, atol=1e-11)
        np.testing.assert_allclose(solver.solve(B[:, 0])[0], wanted, rtol=1e-7, atol=1e-9)

    def test_handles_go_with_their_objects(self):
        from refusals_test import Counted
        with Counted(orbicube.raw.linear, "obc_linear_direct_destroy") as factors, \
                Counted(orbicube.raw.linear, "obc_linear_iterative_destroy") as solvers:
            factor, solver = linear.Direct(DENSE), linear.Iterative(DENSE)
            solver.solve(B[:, 0])
            self.assertEqual((factors.calls, solvers.calls), (0, 0))
            del factor, solver
            self.assertEqual((factors.calls, solvers.calls), (1, 1))
            with self.assertRaises(orbicube.NoValidResult):
                linear.Direct([[1, 2], [2, 1]])
            self.assertEqual(factors.calls, 1)  # there was none

    def test_several_threads_may_solve_with_one_factor(self):
        factor, wanted = linear.Direct(DENSE, method="eigen"), linear.Direct(DENSE).solve(B)
        found = [None] * 4

        def solve(k):
            for _ in range(50):
                found[k] = factor.solve(B)

        threads = [threading.Thread(target=solve, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for each in found:
            np.testing.assert_array_equal(each, wanted)


if __name__ == "__main__":
    unittest.main()
