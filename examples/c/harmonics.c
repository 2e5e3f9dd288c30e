/* Fits spherical harmonics to scattered samples of a surface, turns the surface, and finds the turn again. */
#include <math.h>
#include <orbicube/harmonics.h>
#include <stdio.h>
#include <stdlib.h>

enum { count = 4000, degree = 12, size = (degree + 1) * (degree + 1) };

static double directions[3 * count];
static double positions[3 * count];
static double rebuilt[3 * count];
static double coefficients[3 * size];
static double turned[3 * size];

/* Directions on a spiral, and a smooth bumpy surface over them. */
static void make_samples(void) {
  int i;
  for (i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double flat = sqrt(1 - z * z), turn = 2.39996322972865332 * i;
    const double x = flat * cos(turn), y = flat * sin(turn);
    const double radius = 1 + 0.3 * x * y + 0.2 * z * z * z + 0.1 * cos(3 * x + y);
    directions[3 * i] = x;
    directions[3 * i + 1] = y;
    directions[3 * i + 2] = z;
    positions[3 * i] = radius * x;
    positions[3 * i + 1] = 1.5 * radius * y;
    positions[3 * i + 2] = 2 * radius * z;
  }
}

static void check(obc_status status, const obc_error* error) {
  if (status == OBC_OK) return;
  fprintf(stderr, "%s: %s\n", error->kind, error->message);
  exit(1);
}

int main(void) {
  const double rotation[9] = {0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6};
  obc_harmonics_fit_options options;
  obc_harmonics_fit_report report;
  obc_harmonics_alignment alignment;
  obc_error error;
  double distance, largest = 0, error_of_fit = 0;
  int i;

  make_samples();
  obc_harmonics_fit_options_init(&options, sizeof options);
  obc_harmonics_fit_report_init(&report, sizeof report);
  options.degree = degree;
  check(obc_harmonics_fit(directions, NULL, positions, count, 3, &options, NULL, coefficients, &report, &error),
        &error);
  check(obc_harmonics_synthesize(coefficients, degree, 3, directions, count, NULL, rebuilt, NULL, &error), &error);
  for (i = 0; i < 3 * count; ++i)
    error_of_fit = fmax(error_of_fit, fabs(rebuilt[i] - positions[i]));
  printf("degree %d: rank %lu of %lu, condition %.2f, largest error %.1e\n", degree, (unsigned long)report.rank,
         (unsigned long)report.unknowns, report.condition, error_of_fit);

  check(obc_harmonics_rotate(coefficients, degree, 3, rotation, NULL, turned, &error), &error);
  check(obc_harmonics_shape_distance(coefficients, degree, turned, degree, 3, 0, degree, &distance, &error), &error);
  obc_harmonics_alignment_init(&alignment, sizeof alignment);
  check(obc_harmonics_align(turned, degree, coefficients, degree, 3, NULL, NULL, &alignment, &error), &error);
  for (i = 0; i < 9; ++i)
    largest = fmax(largest, fabs(alignment.rotation[i] - rotation[i]));
  printf("turned: shape distance %.1e, rotation found to %.1e\n", distance, largest);
  return report.rank == report.unknowns && report.residual < 1e-4 && distance < 1e-20 && largest < 1e-8 ? 0 : 1;
}
