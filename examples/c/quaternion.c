/* Two frames on either side of a face: their distance up to the rotations of the cube, the rotation that matches them,
 * and what is left once they are matched, which is the same angle.
 */
#include <math.h>
#include <stdio.h>

#include <orbicube/quaternion.h>

int main(void) {
  const double axis[3] = {1, 2, -1}, x[3] = {1, 0, 0}, degree = 3.14159265358979323846 / 180;
  double from[4], small[4], quarter[4], to[4], element[4], matched[4], between[4], left[3], mean[4], turned[3];
  double both[8], distance, angle, agreement;
  uint32_t g;
  obc_error error;
  int i;

  /* `to` is `from` turned a little and then named differently: its axes are permuted by a quarter turn about y. */
  if (obc_quaternion_from_axis_angle(axis, 70 * degree, from, &error) != OBC_OK ||
      obc_quaternion_from_axis_angle(x, 12 * degree, small, &error) != OBC_OK ||
      obc_quaternion_cube_element(6, quarter, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  obc_quaternion_multiply(from, small, to);
  obc_quaternion_multiply(to, quarter, to);

  distance = obc_quaternion_symmetric_distance(from, to);
  g = obc_quaternion_symmetric_matching(from, to);
  printf("the frames are %.10f degrees apart; rotation %u of the cube matches them\n", distance / degree, (unsigned)g);

  obc_quaternion_cube_element(g, element, &error);
  obc_quaternion_multiply(from, element, matched);
  obc_quaternion_inverse(matched, between);
  obc_quaternion_multiply(between, to, between);
  obc_quaternion_to_axis_angle(between, left, &angle);
  printf("once matched, %.10f degrees about (%.3f, %.3f, %.3f) are left\n", angle / degree, left[0], left[1], left[2]);

  for (i = 0; i < 4; ++i) {
    both[i] = matched[i];
    both[4 + i] = to[i];
  }
  if (obc_quaternion_average(both, NULL, 2, mean, &agreement, &error) != OBC_OK) return 1;
  obc_quaternion_rotate(mean, x, turned);
  printf("the frame in the middle has its first axis along (%.6f, %.6f, %.6f)\n", turned[0], turned[1], turned[2]);
  angle = obc_quaternion_symmetric_distance(mean, from);
  return g == 6 && fabs(distance - 12 * degree) < 1e-14 && fabs(angle - 6 * degree) < 1e-14 ? 0 : 1;
}
