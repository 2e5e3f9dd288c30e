#include "frame_field/singularities/measurement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sums.h"
#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

// Leaves `angles` in another order.
AngleStatistics statistics(Array<float>& angles, const base::CompensatedSum& sum) {
  AngleStatistics s;
  const std::size_t n = angles.size();
  if (n == 0) return s;
  s.mean = sum.value() / static_cast<double>(n);
  base::CompensatedSum squares;
  float largest = 0;
  for (const float a : angles) {
    const double d = static_cast<double>(a) - s.mean;
    squares.add(d * d);
    largest = std::max(largest, a);
  }
  s.deviation = std::sqrt(squares.value() / static_cast<double>(n));
  s.largest = static_cast<double>(largest);
  const auto at = [&](std::size_t k) {
    std::nth_element(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(k), angles.end());
    return static_cast<double>(angles[k]);
  };
  s.p99 = at(std::min(n - 1, 99 * n / 100));
  s.median = 0.5 * (at((n - 1) / 2) + at(n / 2));
  return s;
}

// Degrees between a line and the nearest axis of a frame.
double misalignment(const Quaternion& frame, const Vector3& normal) {
  const Vector local =
      quaternion::rotate(quaternion::conjugate(quaternion::normalized(frame)), {normal[0], normal[1], normal[2]});
  const double x = std::abs(local.x), y = std::abs(local.y), z = std::abs(local.z);
  const double along = std::max({x, y, z});
  const double across = x == along ? std::hypot(y, z) : y == along ? std::hypot(x, z) : std::hypot(x, y);
  return std::atan2(across, along) * degrees;
}

}  // namespace

Measurement measure(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                    std::span<const Quaternion> field, const base::Host& host) {
  Measurement m;
  Array<float> symmetric(host.memory), plain(host.memory);
  const std::size_t inner = (connectivity.face_count() - connectivity.boundary_face_count()) / 2;
  symmetric.reserve(inner);
  plain.reserve(inner);
  base::CompensatedSum energy, symmetric_sum, plain_sum, alignment_sum;
  for (Index t = 0; t < field.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report("measuring", t, field.size());
    const Quaternion q = quaternion::normalized(field[t]);
    m.norm_error = std::max(m.norm_error, std::abs(std::sqrt(quaternion::dot(field[t], field[t])) - 1));
    std::size_t faces = 0;
    double worst = 0, best = 180;
    for (Index k = 0; k < 4; ++k) {
      const Index face = 4 * t + k;
      if (connectivity.on_boundary(face)) {
        ++m.boundary_faces;
        const mesh::Triangle v = connectivity.vertices(face);
        const Vector3 normal =
            (positions[v[1]] - positions[v[0]]).cross(positions[v[2]] - positions[v[0]]).stableNormalized();
        if (!(normal.norm() > 0.5)) continue;  // a face without area has none
        const double angle = misalignment(q, normal);
        worst = std::max(worst, angle);
        best = std::min(best, angle);
        ++faces;
        continue;
      }
      if (connectivity.opposite(face) < face) continue;
      const Quaternion other = quaternion::normalized(field[connectivity.neighbor(t, k)]);
      const double sine_square = quaternion::symmetric_sine_square(q, other);
      energy.add(sine_square);
      const double angle = quaternion::symmetric_distance(q, other) * degrees;
      symmetric_sum.add(angle);
      symmetric.push_back(static_cast<float>(angle));
      ++m.histogram[std::min<std::size_t>(static_cast<std::size_t>(angle), m.histogram.size() - 1)];
      m.above_30 += angle > 30 ? 1 : 0;
      const Quaternion turn = quaternion::relative(q, other);
      const double raw = 2 * std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w)) * degrees;
      plain_sum.add(raw);
      plain.push_back(static_cast<float>(raw));
    }
    if (faces == 1) {
      ++m.one_face_tetrahedra;
      m.one_face_max = std::max(m.one_face_max, worst);
      alignment_sum.add(worst);
    } else if (faces > 1) {
      ++m.several_face_tetrahedra;
      m.several_best_max = std::max(m.several_best_max, best);
      m.several_worst_max = std::max(m.several_worst_max, worst);
    }
  }
  m.inner_faces = symmetric.size();
  m.energy = energy.value();
  m.symmetric = statistics(symmetric, symmetric_sum);
  m.plain = statistics(plain, plain_sum);
  if (m.one_face_tetrahedra > 0) m.one_face_mean = alignment_sum.value() / static_cast<double>(m.one_face_tetrahedra);
  return m;
}

}  // namespace orbicube::frame_field
