"""Max-cut relaxations (Goemans, Williamson 1995) in the factored form of Burer and Monteiro, beside Pymanopt.

usage: max_cut.py [--graphs NUMBER] [--seed NUMBER]

Random graphs of the kinds of the G-set's first ten: 800 nodes, 19176 edges, of weight 1 (five) and 1 or -1 (five). A row of length 1 a node,
as many columns as the root of twice the nodes. Prints for each solver seconds of the processor, evaluations of value and gradient + products
with the Hessian, and the certificate: a dual solution proves that the bound on the cut is at most this share above the minimum. Needs
numpy, scipy, pymanopt and the Python package. OPENBLAS_NUM_THREADS=1 makes seconds comparable."""
import argparse
import math
import time

import numpy as np
import pymanopt
import scipy.linalg
import scipy.sparse
from pymanopt.manifolds import Oblique
from pymanopt.optimizers import ConjugateGradient, TrustRegions

import orbicube.sphere_optimizer

NODES, EDGES = 800, 19176


def random_graph(signed, seed):
    random = np.random.default_rng(seed)
    chosen = random.choice(NODES * (NODES - 1) // 2, EDGES, replace=False)
    rows, columns = np.triu_indices(NODES, 1)
    weights = random.choice([-1.0, 1.0], EDGES) if signed else np.ones(EDGES)
    upper = scipy.sparse.csr_matrix((weights, (rows[chosen], columns[chosen])), shape=(NODES, NODES))
    return (upper + upper.T).tocsr()


class Relaxation:
    """The bound on the cut is (total weight - f) / 2 at the least f = 1/2 <X, W X>."""

    def __init__(self, weights):
        self.weights, self.total = weights, weights.sum() / 2
        self.evaluations = self.products = 0
        self.last = None

    def product(self, rows):
        """The value and W X; value and gradient at the same point are computed once."""
        if self.last is None or not np.array_equal(self.last[0], rows):
            gradient = self.weights @ rows
            self.evaluations += 1
            self.last = rows.copy(), 0.5 * float(np.vdot(rows, gradient)), gradient
        return self.last[1:]

    def hessian(self, direction):
        self.products += 1
        return self.weights @ direction

    def bound(self, rows):
        return 0.5 * (self.total - self.product(rows)[0])

    def certificate(self, rows):
        """How far the bound can be above the minimum, as a share of it: from the smallest eigenvalue of W less its products with the rows."""
        multipliers = np.einsum("ij,ij->i", rows, self.product(rows)[1])
        least = scipy.linalg.eigh(self.weights.toarray() - np.diag(multipliers), eigvals_only=True, subset_by_index=[0, 0])[0]
        return max(0.0, -least) * NODES / 4 / self.bound(rows)


def with_orbicube(relaxation, start):
    return orbicube.sphere_optimizer.minimize(relaxation.product, start, gradient_tolerance=TOLERANCE).x


def with_products(relaxation, start):
    return orbicube.sphere_optimizer.minimize(relaxation.product, start, gradient_tolerance=TOLERANCE,
                                              hessian_product=lambda x, direction: relaxation.hessian(direction)).x


def with_differences(relaxation, start):
    return orbicube.sphere_optimizer.minimize(relaxation.product, start, gradient_tolerance=TOLERANCE, method="truncated-newton").x


def with_pymanopt(optimizer):
    def run(relaxation, start):
        manifold = Oblique(start.shape[1], len(start))  # its spheres are columns

        @pymanopt.function.numpy(manifold)
        def cost(point):
            return relaxation.product(point.T)[0]

        @pymanopt.function.numpy(manifold)
        def gradient(point):
            return relaxation.product(point.T)[1].T

        @pymanopt.function.numpy(manifold)
        def hessian(point, direction):
            return relaxation.hessian(direction.T).T

        problem = pymanopt.Problem(manifold, cost, euclidean_gradient=gradient, euclidean_hessian=hessian)
        solver = optimizer(max_iterations=20000, max_time=300, min_gradient_norm=TOLERANCE, min_step_size=1e-16, verbosity=0)
        return np.ascontiguousarray(solver.run(problem, initial_point=np.ascontiguousarray(start.T)).point.T)
    return run


TOLERANCE = 1e-8  # of the gradient
SOLVERS = {"TRUNCATED_NEWTON, products": with_products, "TRUNCATED_NEWTON, differences": with_differences, "default": with_orbicube,
           "Pymanopt, trust regions": with_pymanopt(TrustRegions), "Pymanopt, CG": with_pymanopt(ConjugateGradient)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--graphs", type=int, default=10, help="number of graphs [default: 10]")
    parser.add_argument("--seed", type=int, default=1, help="of the first graph [default: 1]")
    options = parser.parse_args()
    rank = math.ceil(math.sqrt(2 * NODES))
    print("| weights | " + " | ".join(SOLVERS) + " |\n" + "|---" * (1 + len(SOLVERS)) + "|")
    total = dict.fromkeys(SOLVERS, 0.0)
    for number in range(options.graphs):
        signed = number >= 5
        weights = random_graph(signed, options.seed + number)
        start = np.random.default_rng(options.seed + number).standard_normal((NODES, rank))
        start /= np.linalg.norm(start, axis=1, keepdims=True)
        cells = []
        for name, solve in SOLVERS.items():
            relaxation = Relaxation(weights)
            before = time.process_time()
            rows = solve(relaxation, start)
            seconds = time.process_time() - before
            total[name] += seconds
            count = f"{relaxation.evaluations}" + (f" + {relaxation.products}" if relaxation.products else "")
            cells.append(f"{seconds:.2f} s, {count}, {relaxation.certificate(rows):.0e}")
        print(f"| {'1, -1' if signed else '1'} | " + " | ".join(cells) + " |", flush=True)
    print("| all | " + " | ".join(f"{seconds:.2f} s" for seconds in total.values()) + " |")


if __name__ == "__main__":
    main()
