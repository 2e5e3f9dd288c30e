// Prints a table: millions of entries a second on one core, of the array functions through the C interface, and of the
// same work with Eigen's Quaternion (for distances and matchings a search over the 24 rotations of the cube).
#include <orbicube/quaternion.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace {

constexpr std::size_t count = 4096;  // entries that stay in the cache nearest but one
using Quaternion = Eigen::Quaterniond;

// Millions of entries a second, the best of several runs of a tenth of a second.
template <class Work>
double rate(const Work& work) {
  using Clock = std::chrono::steady_clock;
  double best = 0;
  for (int run = 0; run < 7; ++run) {
    std::size_t done = 0;
    const auto start = Clock::now();
    double seconds = 0;
    while (seconds < 0.1) {
      for (int repeat = 0; repeat < 16; ++repeat)
        work();
      done += 16 * count;
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    best = std::max(best, static_cast<double>(done) / seconds / 1e6);
  }
  return best;
}

Quaternion at(const std::vector<double>& q, std::size_t i) {
  return {q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]};
}

}  // namespace

int main() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> p(4 * count), q(4 * count), v(3 * count), t(count), out(4 * count), value(count), peer(count),
      matrices(9 * count), turned(3 * count);
  std::vector<std::uint8_t> matching(count), peer_matching(count);
  for (std::size_t k = 0; k < 4 * count; ++k) {
    p[k] = normal(random);
    q[k] = normal(random);
    v[3 * k / 4] = normal(random);
    t[k / 4] = std::abs(std::fmod(normal(random), 1.0));
  }
  obc_quaternion_normalize_array(p.data(), count, p.data());
  obc_quaternion_normalize_array(q.data(), count, q.data());
  std::vector<Quaternion> a, b, product(count), group;
  std::vector<Eigen::Vector3d> vectors, rotated(count);
  for (std::size_t i = 0; i < count; ++i) {
    a.push_back(at(p, i));
    b.push_back(at(q, i));
    vectors.emplace_back(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
  }
  for (std::uint32_t g = 0; g < OBC_QUATERNION_CUBE_ORDER; ++g) {
    double element[4];
    obc_quaternion_cube_element(g, element, nullptr);
    group.emplace_back(element[0], element[1], element[2], element[3]);
  }
  // |r . g| for r = q^-1 p: the peer's search.
  const auto search = [&](std::size_t i, std::uint8_t& which) {
    const Eigen::Vector4d r = (b[i].conjugate() * a[i]).coeffs();
    double best = -1;
    for (std::size_t g = 0; g < group.size(); ++g) {
      const double along = std::abs(r.dot(group[g].coeffs()));
      if (along > best) {
        best = along;
        which = static_cast<std::uint8_t>(g);
      }
    }
    return std::min(best, 1.0);
  };

  std::printf("| millions a second on one core | orbicube | Eigen |\n|---|---|---|\n");
  const auto row = [](const char* name, double ours, double theirs) {
    std::printf("| %s | %.0f | %.1f |\n", name, ours, theirs);
    std::fflush(stdout);
  };
  row("symmetric distance",
      rate([&] { obc_quaternion_symmetric_distance_array(p.data(), q.data(), count, value.data()); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          peer[i] = 2 * std::acos(search(i, peer_matching[i]));
      }));
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i)
    worst = std::max(worst, std::abs(value[i] - peer[i]));
  row("sin^2 of half the symmetric distance",
      rate([&] { obc_quaternion_symmetric_sine_square_array(p.data(), q.data(), count, value.data()); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i) {
          const double cosine = search(i, peer_matching[i]);
          peer[i] = 1 - cosine * cosine;
        }
      }));
  row("symmetric matching",
      rate([&] { obc_quaternion_symmetric_matching_array(q.data(), p.data(), count, matching.data()); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          search(i, peer_matching[i]);
      }));
  const bool same = matching == peer_matching;
  row("product", rate([&] { obc_quaternion_multiply_array(p.data(), q.data(), count, out.data()); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          product[i] = a[i] * b[i];
      }));
  row("rotation of a vector", rate([&] { obc_quaternion_rotate_array(q.data(), v.data(), count, turned.data()); }),
      rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          rotated[i] = b[i] * vectors[i];
      }));
  row("slerp", rate([&] { obc_quaternion_slerp_array(p.data(), q.data(), t.data(), count, out.data()); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          product[i] = a[i].slerp(t[i], b[i]);
      }));
  row("matrix of a quaternion", rate([&] { obc_quaternion_to_matrix_array(q.data(), count, matrices.data()); }),
      rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          Eigen::Matrix3d::Map(matrices.data() + 9 * i) = b[i].toRotationMatrix();
      }));
  obc_quaternion_to_matrix_array(q.data(), count, matrices.data());
  row("quaternion of a matrix",
      rate([&] { obc_quaternion_from_matrix_array(matrices.data(), count, out.data(), nullptr); }), rate([&] {
        for (std::size_t i = 0; i < count; ++i)
          product[i] = Quaternion(Eigen::Matrix3d::Map(matrices.data() + 9 * i).transpose());
      }));
  std::printf("\nDistances differ by at most %.1e (acos near 1 has that error); matchings are %s.\n", worst,
              same ? "the same" : "different");
  return same ? 0 : 1;
}
