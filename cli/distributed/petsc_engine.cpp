#include "cli/distributed/petsc_engine.h"

#include <petscksp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "base/catch_all.h"
#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::cli {
namespace {

using untangle::BlockMatrix;
using untangle::Index;

constexpr int block = 3;  // unknowns of a vertex

void check(PetscErrorCode code, const char* what) {
  if (code == 0) return;
  throw base::Error("no-valid-result", std::string("PETSc failed: ") + what + ", error " + std::to_string(code));
}

// What the first process sends to the others before each system.
struct Order {
  PetscInt vertices = 0;  // rows of blocks of all processes; 0: the work is done
  PetscInt max_steps = 0;
  double tolerance = 0;
};

// Rows of blocks, shared out evenly.
PetscInt first_of(PetscInt vertices, int rank, int ranks) {
  return static_cast<PetscInt>(static_cast<PetscInt64>(vertices) * rank / ranks);
}

// Rows of a process: whole blocks, with their columns.
struct Rows {
  std::vector<PetscInt> begin{0}, column;
  std::vector<PetscScalar> values;  // of each block by rows
  std::vector<PetscScalar> right;
};

// The whole matrix, both halves, in blocks. Unknowns that are shared are filled up to blocks.
class WholeMatrix {
 public:
  WholeMatrix(const BlockMatrix& m, std::span<const double> right)
      : m_(m),
        right_(right),
        shared_blocks_((m.shared() + block - 1) / block),
        upper_(std::pmr::get_default_resource()) {
    upper_.assign(m.rows(), [&](const auto& visit) {
      for (Index v = 0; v < m.rows(); ++v) {
        for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i)
          visit(m.column[i], Upper{v, i});
      }
    });
    // What is shared: entries of its blocks by row and column, sorted.
    for (Index s = 0; s < m.shared(); ++s) {
      for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
        for (int a = 0; a < block; ++a)
          add(s, static_cast<std::size_t>(block) * m.border_column[i] + static_cast<std::size_t>(a), m.border[i][a]);
      }
      for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
        add(s, block * m.rows() + m.corner_column[i], m.corner[i]);
      const std::size_t at = block * m.rows() + s;
      entries_.push_back({at, at, m.corner_diagonal[s]});
    }
    for (std::size_t s = m.shared(); s < block * shared_blocks_; ++s)
      entries_.push_back({block * m.rows() + s, block * m.rows() + s, 1});
    const auto order = [](const Entry& p, const Entry& q) {
      return std::pair(p.row / block, p.column / block) < std::pair(q.row / block, q.column / block);
    };
    std::sort(entries_.begin(), entries_.end(), order);
  }

  PetscInt vertices() const { return static_cast<PetscInt>(m_.rows() + shared_blocks_); }

  Rows rows(PetscInt first, PetscInt last) const {
    Rows result;
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), static_cast<std::size_t>(first),
                                  [](const Entry& e, std::size_t row) { return e.row / block < row; });
    for (auto v = static_cast<std::size_t>(first); v < static_cast<std::size_t>(last); ++v) {
      if (v < m_.rows()) {
        for (Index i = m_.row_begin[v]; i < m_.row_begin[v + 1]; ++i)
          add_block(result, m_.column[i], m_.lower[i]);
        add_block(result, v, m_.diagonal[v]);
        for (const Upper& upper : upper_[v])
          add_block(result, upper.row, m_.lower[upper.place].transpose());
      }
      while (entry != entries_.end() && entry->row / block == v) {
        const std::size_t column = entry->column / block;
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (; entry != entries_.end() && entry->row / block == v && entry->column / block == column; ++entry)
          sum(static_cast<Eigen::Index>(entry->row % block), static_cast<Eigen::Index>(entry->column % block)) +=
              entry->value;
        add_block(result, column, sum);
      }
      result.begin.push_back(static_cast<PetscInt>(result.column.size()));
      for (std::size_t a = 0; a < block; ++a)
        result.right.push_back(block * v + a < right_.size() ? right_[block * v + a] : 0);
    }
    return result;
  }

 private:
  struct Entry {
    std::size_t row, column;
    double value;
  };
  struct Upper {
    Index row, place;
  };
  void add(Index s, std::size_t column, double value) {
    entries_.push_back({block * m_.rows() + s, column, value});
    entries_.push_back({column, block * m_.rows() + s, value});
  }
  static void add_block(Rows& rows, std::size_t column, const Eigen::Matrix3d& values) {
    rows.column.push_back(static_cast<PetscInt>(column));
    for (Eigen::Index r = 0; r < block; ++r) {
      for (Eigen::Index c = 0; c < block; ++c)
        rows.values.push_back(values(r, c));
    }
  }

  const BlockMatrix& m_;
  std::span<const double> right_;
  std::size_t shared_blocks_;
  base::Groups<Upper> upper_;
  std::vector<Entry> entries_;
};

template <class T>
void send(const std::vector<T>& values, int to, MPI_Datatype type) {
  if (values.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw base::Error("no-valid-result",
                      "the part of the system for a process is too large to be sent: start more processes");
  check(MPI_Send(values.data(), static_cast<int>(values.size()), type, to, 0, PETSC_COMM_WORLD), "MPI_Send");
}

template <class T>
std::vector<T> receive(int from, MPI_Datatype type) {
  MPI_Status status;
  check(MPI_Probe(from, 0, PETSC_COMM_WORLD, &status), "MPI_Probe");
  int count = 0;
  check(MPI_Get_count(&status, type, &count), "MPI_Get_count");
  std::vector<T> values(static_cast<std::size_t>(count));
  check(MPI_Recv(values.data(), count, type, from, 0, PETSC_COMM_WORLD, &status), "MPI_Recv");
  return values;
}

// Called at each step by all processes: the first one decides whether the host requests the end.
struct Watch {
  const base::Host* host = nullptr;   // of the first process only
  std::exception_ptr reason_to_stop;  // of the first process only
  bool stopped = false;
  PetscErrorCode converged(KSP ksp, PetscInt step, PetscReal norm, KSPConvergedReason* reason) {
    int stop = 0;
    if (host != nullptr) {
      base::catch_all([&] { host->report("solve", 0, 0); },
                      [&] {
                        reason_to_stop = std::current_exception();
                        stop = 1;
                      });
    }
    if (const int code = MPI_Bcast(&stop, 1, MPI_INT, 0, PETSC_COMM_WORLD); code != 0) return code;
    if (stop != 0) {
      stopped = true;
      *reason = KSP_CONVERGED_ITS;
      return 0;
    }
    return KSPConvergedDefault(ksp, step, norm, reason, default_context);
  }
  void* default_context = nullptr;
};

PetscErrorCode watch_convergence(KSP ksp, PetscInt step, PetscReal norm, KSPConvergedReason* reason, void* context) {
  return static_cast<Watch*>(context)->converged(ksp, step, norm, reason);
}

struct SystemObjects {
  Mat matrix = nullptr;
  Vec right = nullptr, solution = nullptr;
  KSP solver = nullptr;

  SystemObjects() = default;
  SystemObjects(const SystemObjects&) = delete;
  SystemObjects& operator=(const SystemObjects&) = delete;
  ~SystemObjects() {
    KSPDestroy(&solver);
    VecDestroy(&right);
    VecDestroy(&solution);
    MatDestroy(&matrix);
  }
};

void make_matrix(const Order& order, const Rows& rows, SystemObjects& own) {
  const auto local = static_cast<PetscInt>(rows.right.size());
  // Rows of numbers.
  std::vector<PetscInt> begin{0}, column;
  std::vector<PetscScalar> values;
  column.reserve(rows.values.size());
  values.reserve(rows.values.size());
  for (std::size_t v = 0; v + 1 < rows.begin.size(); ++v) {
    for (std::size_t a = 0; a < block; ++a) {
      for (auto i = static_cast<std::size_t>(rows.begin[v]); i < static_cast<std::size_t>(rows.begin[v + 1]); ++i) {
        for (std::size_t b = 0; b < block; ++b) {
          column.push_back(block * rows.column[i] + static_cast<PetscInt>(b));
          values.push_back(rows.values[block * block * i + block * a + b]);
        }
      }
      begin.push_back(static_cast<PetscInt>(column.size()));
    }
  }
  check(MatCreate(PETSC_COMM_WORLD, &own.matrix), "the matrix");
  check(MatSetSizes(own.matrix, local, local, block * order.vertices, block * order.vertices), "the matrix");
  check(MatSetBlockSize(own.matrix, block), "the matrix");
  check(MatSetType(own.matrix, MATAIJ), "the matrix");
  check(MatSeqAIJSetPreallocationCSR(own.matrix, begin.data(), column.data(), values.data()), "the matrix");
  check(MatMPIAIJSetPreallocationCSR(own.matrix, begin.data(), column.data(), values.data()), "the matrix");
  check(MatSetOption(own.matrix, MAT_SPD, PETSC_TRUE), "the matrix");
}

void make_vectors(const Rows& rows, SystemObjects& own) {
  check(MatCreateVecs(own.matrix, &own.solution, &own.right), "vectors");
  PetscScalar* entries = nullptr;
  check(VecGetArray(own.right, &entries), "vectors");
  std::copy(rows.right.begin(), rows.right.end(), entries);
  check(VecRestoreArray(own.right, &entries), "vectors");
}

void make_solver(const Order& order, Watch& watch, SystemObjects& own) {
  check(KSPCreate(PETSC_COMM_WORLD, &own.solver), "the solver");
  check(KSPSetOperators(own.solver, own.matrix, own.matrix), "the solver");
  check(KSPSetType(own.solver, KSPCG), "the solver");
  PC preconditioner = nullptr;
  check(KSPGetPC(own.solver, &preconditioner), "the solver");
  check(PCSetType(preconditioner, PCGAMG), "the solver");
  check(KSPSetNormType(own.solver, KSP_NORM_NATURAL), "the solver");
  check(KSPSetTolerances(own.solver, order.tolerance, PETSC_DEFAULT, PETSC_DEFAULT, order.max_steps), "the solver");
  check(KSPConvergedDefaultCreate(&watch.default_context), "the solver");
  check(KSPSetConvergenceTest(own.solver, watch_convergence, &watch, nullptr), "the solver");
  check(KSPSetFromOptions(own.solver), "the options");
}

// Solves what all processes hold rows of; the solution of these rows goes to `solution`, unless the host stopped it.
int solve_rows(const Order& order, const Rows& rows, Watch& watch, std::vector<PetscScalar>& solution) {
  SystemObjects own;
  make_matrix(order, rows, own);
  make_vectors(rows, own);
  make_solver(order, watch, own);
  const PetscErrorCode code = KSPSolve(own.solver, own.right, own.solution);
  KSPConvergedDefaultDestroy(watch.default_context);
  if (watch.stopped) return 0;
  check(code, "the steps");
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(own.solver, &reason), "the solver");
  if (reason == KSP_DIVERGED_NANORINF || reason == KSP_DIVERGED_PC_FAILED)
    throw base::Error("no-valid-result", "PETSc failed: numbers that are not finite");
  const PetscScalar* answer = nullptr;
  check(VecGetArrayRead(own.solution, &answer), "vectors");
  solution.assign(answer, answer + rows.right.size());
  check(VecRestoreArrayRead(own.solution, &answer), "vectors");
  PetscInt steps = 0;
  check(KSPGetIterationNumber(own.solver, &steps), "the solver");
  return static_cast<int>(steps);
}

void tell(Order& order) {
  check(MPI_Bcast(&order, static_cast<int>(sizeof order), MPI_BYTE, 0, PETSC_COMM_WORLD), "MPI_Bcast");
}

// The others wait for what this process has not sent, and it for theirs: all have to end.
[[noreturn]] void give_up(const std::exception& error) {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  std::fprintf(stderr, "orbicube: process %d: %s\n", rank, error.what());
  MPI_Abort(PETSC_COMM_WORLD, 1);
  std::abort();
}

class PetscEngine : public untangle::BlockEngine {
 public:
  ~PetscEngine() override {
    Order done;
    MPI_Bcast(&done, static_cast<int>(sizeof done), MPI_BYTE, 0, PETSC_COMM_WORLD);
    PetscFinalize();
  }

  int solve(const BlockMatrix& matrix, std::span<const double> right, int max_steps, double tolerance,
            std::span<double> solution, const base::Host& host) override {
    const WholeMatrix whole(matrix, right);
    host.report("solve", 0, 0);
    Watch watch;
    watch.host = &host;
    int steps = 0;
    try {
      steps = solve_on_all(whole, {whole.vertices(), max_steps, tolerance}, watch, solution);
    } catch (const std::exception& error) {
      int ranks = 1;
      MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
      if (ranks > 1) give_up(error);
      throw;
    }
    if (watch.stopped) std::rethrow_exception(watch.reason_to_stop);
    return steps;
  }

 private:
  static int solve_on_all(const WholeMatrix& whole, Order order, Watch& watch, std::span<double> solution) {
    int ranks = 1;
    check(MPI_Comm_size(PETSC_COMM_WORLD, &ranks), "MPI_Comm_size");
    tell(order);
    for (int rank = 1; rank < ranks; ++rank) {
      const Rows rows = whole.rows(first_of(order.vertices, rank, ranks), first_of(order.vertices, rank + 1, ranks));
      send(rows.begin, rank, MPIU_INT);
      send(rows.column, rank, MPIU_INT);
      send(rows.values, rank, MPIU_SCALAR);
      send(rows.right, rank, MPIU_SCALAR);
    }
    const Rows rows = whole.rows(0, first_of(order.vertices, 1, ranks));
    std::vector<PetscScalar> part;
    const int steps = solve_rows(order, rows, watch, part);
    if (watch.stopped) return steps;
    std::size_t at = 0;
    const auto take = [&] {
      for (const PetscScalar value : part) {
        if (at < solution.size()) solution[at++] = value;
      }
    };
    take();
    for (int rank = 1; rank < ranks; ++rank) {
      part = receive<PetscScalar>(rank, MPIU_SCALAR);
      take();
    }
    return steps;
  }
};

void work() {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
  while (true) {
    Order order;
    tell(order);
    if (order.vertices == 0) return;
    Rows rows;
    rows.begin = receive<PetscInt>(0, MPIU_INT);
    rows.column = receive<PetscInt>(0, MPIU_INT);
    rows.values = receive<PetscScalar>(0, MPIU_SCALAR);
    rows.right = receive<PetscScalar>(0, MPIU_SCALAR);
    Watch watch;
    std::vector<PetscScalar> solution;
    solve_rows(order, rows, watch, solution);
    if (!watch.stopped) send(solution, 0, MPIU_SCALAR);
  }
}

}  // namespace
}  // namespace orbicube::cli

extern "C" __attribute__((visibility("default"))) orbicube::untangle::BlockEngine* orbicube_petsc_start() {
  using namespace orbicube::cli;
  // The command line is the command's own; PETSc's options come from the variable PETSC_OPTIONS, and not from a file
  // .petscrc in the current folder, whose options could load libraries.
  const char* const given = std::getenv("PETSC_OPTIONS");
  if (given != nullptr && std::strstr(given, "-dll_") != nullptr)
    throw orbicube::base::Error("usage", "PETSC_OPTIONS must not load libraries (-dll_append, -dll_prepend)");
  static char name[] = "orbicube", no_file[] = "-skip_petscrc";
  static char* words[] = {name, no_file, nullptr};
  int count = 2;
  char** arguments = words;
  if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0)
    throw orbicube::base::Error("no-valid-result", "PETSc could not be started");
  PetscPopSignalHandler();
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank == 0) return new PetscEngine;
  try {
    work();
    PetscFinalize();
  } catch (const std::exception& error) {
    give_up(error);
  }
  return nullptr;
}
