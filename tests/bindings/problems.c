/* Runs the problems that every language's tests run, with callbacks, and prints how they end: a line each with a name,
 * the number of evaluations and the bits of the result. The other languages must print the same. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <orbicube/hexmesh.h>
#include <orbicube/mesh.h>
#include <orbicube/projected_gradient.h>
#include <orbicube/sphere_map.h>
#include <orbicube/sphere_optimizer.h>
#include <orbicube/trust_region.h>

enum { UNKNOWNS = 3, MEASUREMENTS = 8, FEEDS = 5, POINTS = 12, COORDINATES = 3 * POINTS };

static void print_result(const char* name, uint64_t evaluations, const double* x, size_t n) {
  size_t i;
  printf("%s %" PRIu64, name, evaluations);
  for (i = 0; i < n; ++i) {
    uint64_t bits;
    memcpy(&bits, x + i, sizeof bits);
    printf(" %016" PRIx64, bits);
  }
  printf("\n");
}

static void check(obc_status status, const obc_error* error) {
  if (status == OBC_OK) return;
  fprintf(stderr, "%s: %s\n", error->kind, error->message);
  exit(1);
}

/* The decay a / (1 + b t) + c through eight measurements. */
static double model(const double* x, size_t i) {
  return x[0] / (1 + x[1] * (0.5 * (double)i)) + x[2];
}

static int32_t misfit(const double* x, size_t n, double* residuals, void* user) {
  static const double truth[UNKNOWNS] = {2.5, 0.7, 0.4};
  size_t i;
  (void)n;
  (void)user;
  for (i = 0; i < MEASUREMENTS; ++i)
    residuals[i] = model(x, i) - model(truth, i);
  return OBC_TRUST_REGION_CONTINUE;
}

static void decay(void) {
  const double lower[UNKNOWNS] = {0, 0, -1}, upper[UNKNOWNS] = {10, 2, 1};
  double x[UNKNOWNS] = {1, 0.1, 0};
  obc_trust_region_problem problem;
  obc_trust_region_result result;
  obc_error error;
  obc_trust_region_problem_init(&problem, sizeof problem);
  problem.n = UNKNOWNS;
  problem.residuals = MEASUREMENTS;
  problem.lower = lower;
  problem.upper = upper;
  result.struct_size = sizeof result;
  check(obc_trust_region_minimize(&problem, NULL, misfit, NULL, x, &result, NULL, &error), &error);
  print_result("decay", result.evaluations, x, UNKNOWNS);
}

/* The cheapest mix of five feeds with a given share of protein. */
static const double price[FEEDS] = {0.9, 0.3, 0.5, 1.4, 0.2};
static const double usual[FEEDS] = {0.2, 0.3, 0.2, 0.1, 0.2};
static const double weight[FEEDS] = {2, 1, 3, 1, 4};

static int32_t cost(const double* x, size_t n, double* value, double* gradient, void* user) {
  double sum = 0;
  size_t j;
  (void)user;
  for (j = 0; j < n; ++j) {
    const double away = x[j] - usual[j];
    sum = sum + (price[j] * x[j] + 0.5 * weight[j] * away * away);
    gradient[j] = price[j] + weight[j] * away;
  }
  *value = sum;
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

static void feeds(void) {
  const double lower[FEEDS] = {0, 0, 0, 0, 0}, upper[FEEDS] = {0.6, 0.6, 0.6, 0.6, 0.6};
  const size_t row_start[3] = {0, FEEDS, 2 * FEEDS};
  const uint32_t column[2 * FEEDS] = {0, 1, 2, 3, 4, 0, 1, 2, 3, 4};
  const double value[2 * FEEDS] = {1, 1, 1, 1, 1, 0.12, 0.09, 0.35, 0.44, 0.05};
  const double b[2] = {1, 0.2};
  double x[FEEDS] = {0, 0, 0, 0, 0};
  obc_projected_gradient_problem problem;
  obc_projected_gradient_result result;
  obc_error error;
  obc_projected_gradient_problem_init(&problem, sizeof problem);
  problem.n = FEEDS;
  problem.m = 2;
  problem.lower = lower;
  problem.upper = upper;
  problem.row_start = row_start;
  problem.column = column;
  problem.value = value;
  problem.b = b;
  result.struct_size = sizeof result;
  check(obc_projected_gradient_minimize(&problem, NULL, cost, NULL, x, &result, NULL, &error), &error);
  print_result("feeds", result.evaluations, x, FEEDS);
}

/* Twelve points on a sphere that repel each other by 1 / distance^2. */
static int32_t charges(const double* x, size_t count, size_t dimension, double* value, double* gradient, void* user) {
  double sum = 0;
  size_t i, j, k;
  (void)user;
  for (i = 0; i < count * dimension; ++i)
    gradient[i] = 0;
  for (i = 0; i < count; ++i) {
    for (j = 0; j < i; ++j) {
      double away[3], square = 0, term;
      for (k = 0; k < 3; ++k) {
        away[k] = x[3 * i + k] - x[3 * j + k];
        square = square + away[k] * away[k];
      }
      term = 1 / square;
      sum = sum + term;
      for (k = 0; k < 3; ++k) {
        const double pull = 2 * term * term * away[k];
        gradient[3 * i + k] = gradient[3 * i + k] - pull;
        gradient[3 * j + k] = gradient[3 * j + k] + pull;
      }
    }
  }
  *value = sum;
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

static void icosahedron(void) {
  double x[COORDINATES];
  obc_sphere_optimizer_result result;
  obc_error error;
  size_t i;
  for (i = 0; i < COORDINATES; ++i)
    x[i] = (double)(i * i * 7 % 37) / 37 - 0.5;
  result.struct_size = sizeof result;
  check(obc_sphere_optimizer_minimize(POINTS, 3, NULL, charges, NULL, x, &result, NULL, &error), &error);
  print_result("icosahedron", result.evaluations, x, COORDINATES);
}

/* A creature on the sphere; the first and the last vertex, and all together in one number. */
static void creature(void) {
  obc_mesh* mesh = NULL;
  obc_surface surface;
  obc_error error;
  double* directions;
  double ends[7];
  size_t i;
  check(obc_mesh_make("creature", 400, 0, NULL, &mesh, &error), &error);
  check(obc_mesh_surface(mesh, &surface, &error), &error);
  directions = malloc(3 * surface.vertex_count * sizeof *directions);
  if (directions == NULL) exit(1);
  check(obc_sphere_map_compute(&surface, NULL, NULL, directions, NULL, &error), &error);
  memcpy(ends, directions, 3 * sizeof *ends);
  memcpy(ends + 3, directions + 3 * surface.vertex_count - 3, 3 * sizeof *ends);
  ends[6] = 0;
  for (i = 0; i < 3 * surface.vertex_count; ++i)
    ends[6] = 0.5 * ends[6] + directions[i];
  print_result("creature", surface.vertex_count, ends, 7);
  free(directions);
  obc_mesh_destroy(mesh);
}

/* A cube of six tetrahedra around its diagonal, filled with hexahedra along frames; the positions, and how many
 * hexahedra. */
static void cube(void) {
  const double corners[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  const uint32_t tetrahedra[24] = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  obc_hexmesh_options options;
  obc_hexmesh* hexes = NULL;
  obc_error error;
  double* positions;
  obc_hexmesh_options_init(&options, sizeof options);
  options.method = OBC_HEXMESH_METHOD_FRAMES;
  options.cells = 8;
  check(obc_hexmesh_compute_solid(corners, 8, tetrahedra, 6, NULL, &options, NULL, NULL, &hexes, &error), &error);
  positions = malloc(3 * obc_hexmesh_vertex_count(hexes) * sizeof *positions);
  if (positions == NULL) exit(1);
  check(obc_hexmesh_copy(hexes, positions, NULL, NULL, NULL, &error), &error);
  print_result("cube", obc_hexmesh_count(hexes), positions, 3 * obc_hexmesh_vertex_count(hexes));
  free(positions);
  obc_hexmesh_destroy(hexes);
}

int main(void) {
  decay();
  feeds();
  icosahedron();
  creature();
  cube();
  return 0;
}
