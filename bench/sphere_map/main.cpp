// Quality of maps beside Praun and Hoppe's, and time and memory by size.
//
//   bench-sphere-map quality FOLDER [METHOD]   the models of the table below that FOLDER has
//   bench-sphere-map scaling [VERTICES...]                            a shape made here, at several resolutions
//
// Praun and Hoppe's figures were measured with their program on the same files, CPU seconds on one machine: of the
// times, only the order of magnitude of the quotient counts.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "measured_run.h"
#include "mesh/files/read.h"
#include "mesh/shapes/make_shape.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/rounding.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;

namespace {

const std::map<std::string, sphere_map::Method> methods = {
    {"balanced", sphere_map::Method::balanced},   {"angle-area", sphere_map::Method::angle_area},
    {"isometric", sphere_map::Method::isometric}, {"stretch", sphere_map::Method::stretch},
    {"conformal", sphere_map::Method::conformal}, {"dissertation", sphere_map::Method::dissertation}};

struct PeerRow {
  const char* file;
  double energy, max_quasi_conformal, stretch_efficiency, seconds;
};

// Weights (0.1, 1).
constexpr PeerRow praun_hoppe[] = {
    {"goathead.obj", 22.75, 18.3, 0.671, 4.65},   {"cow.off", 32.99, 82.9, 0.432, 6.77},
    {"spot.obj", 21.63, 8.63, 0.717, 4.50},       {"dino.off", 54.94, 82, 0.285, 8.51},
    {"max-planck.obj", 18.51, 79.7, 0.899, 5.17}, {"homer.obj", 32.19, 69, 0.536, 8.92},
    {"elephant.obj", 26.66, 20.1, 0.594, 9.70},   {"fandisk.obj", 18.87, 7.15, 0.862, 6.88},
    {"octopus.off", 102.61, 280, 0.076, 15.04},   {"frog.obj", 18.96, 11.2, 0.840, 8.34},
    {"b0.obj", 19.51, 5.34, 0.836, 11.04},        {"david.obj", 17.98, 3.39, 0.949, 8.47},
    {"spider.off", 57.10, 82.8, 0.215, 17.26},    {"bimba.obj", 21.03, 12.8, 0.788, 10.87},
    {"hand.off", 28.04, 58.4, 0.502, 16.78},      {"moai.obj", 19.14, 5.73, 0.845, 13.30},
    {"man.off", 51.38, 2.49e4, 0.238, 20.99},     {"bumpy-cube.obj", 18.09, 1.88, 0.929, 13.52},
    {"gargoyle.ply", 21.69, 45.7, 0.737, 23.05},  {"screwdriver.ply", 30.82, 90.3, 0.516, 24.92},
    {"bunny.ply", 22.59, 68.7, 0.713, 26.79},     {"armadillo.ply", 31.26, 84, 0.422, 42.29},
    {"horse.ply", 33.58, 553, 0.396, 42.40},      {"venus.ply", 17.90, 26.1, 0.961, 34.78},
    {"amo.ply", 20.15, 13.1, 0.813, 69.15},       {"igea.ply", 17.90, 2.9, 0.962, 96.47},
};

struct Run {
  bench::MeasuredRun map;
  bool float32_is_valid;
};

Run run(const mesh::Mesh& surface, sphere_map::Method method) {
  sphere_map::Options options;
  options.method = method;
  Run result{bench::measured_run(surface,
                                 [&](const base::Host& host) {
                                   return sphere_map::compute(surface.positions, surface.triangles, options, host);
                                 }),
             false};
  try {
    sphere_map::round_to_float(surface.triangles, result.map.directions, base::Host());
    result.float32_is_valid = true;
  } catch (const base::Error&) {
  }
  return result;
}

int quality(const std::filesystem::path& folder, sphere_map::Method method) {
  constexpr double min_energy = 17.593;
  std::printf("%-16s %8s %7s %8s %8s %8s %7s %9s %9s %7s %7s %7s %6s %s\n", "model", "vertices", "valid", "E_D", "E_A",
              "E", "excess", "K max", "its K", "stretch", "its", "CPU s", "times", "float32");
  double log_excess = 0, worst_excess = 0, log_stretch = 0, log_speed = 0, min_speed = INFINITY;
  int models = 0, valid = 0, quasi_conformal_no_worse = 0;
  for (const PeerRow& peer : praun_hoppe) {
    if (!std::filesystem::exists(folder / peer.file)) continue;
    const mesh::Mesh surface = mesh::read_mesh(folder / peer.file, {}, base::Host());
    const Run r = run(surface, method);
    const auto& m = r.map.figures;
    const double excess = (m.energy - min_energy) / (peer.energy - min_energy);
    std::printf("%-16s %8zu %7s %8.2f %8.3f %8.3f %7.3f %9.4g %9.4g %7.3f %7.3f %7.2f %6.0f %s\n", peer.file,
                surface.positions.size(), m.bijective ? "yes" : "NO", m.energy_angle, m.energy_area, m.energy, excess,
                m.max_quasi_conformal, peer.max_quasi_conformal, m.stretch_efficiency, peer.stretch_efficiency,
                r.map.seconds, peer.seconds / r.map.seconds, r.float32_is_valid ? "valid" : "refused");
    std::fflush(stdout);
    ++models;
    valid += m.bijective;
    quasi_conformal_no_worse += m.max_quasi_conformal <= peer.max_quasi_conformal;
    log_excess += std::log(excess);
    worst_excess = std::max(worst_excess, excess);
    log_stretch += std::log(m.stretch_efficiency / peer.stretch_efficiency);
    log_speed += std::log(peer.seconds / r.map.seconds);
    min_speed = std::min(min_speed, peer.seconds / r.map.seconds);
  }
  if (models == 0) {
    std::fprintf(stderr, "%s has none of the models\n", folder.c_str());
    return 1;
  }
  std::printf(
      "%d of %d are bijections. Excess over the minimum energy relative to Praun and Hoppe's: %.3f (geometric mean), "
      "%.3f (largest).\nLargest quasi-conformal distortion no worse on %d. Stretch efficiency relative to theirs: %.3f "
      "(geometric "
      "mean). "
      "CPU: %.0f times less (geometric mean), %.0f (minimum).\n",
      valid, models, std::exp(log_excess / models), worst_excess, quasi_conformal_no_worse,
      std::exp(log_stretch / models), std::exp(log_speed / models), min_speed);
  return valid == models ? 0 : 1;
}

// The exponent b of y = a x^b by least squares of the logarithms.
class FittedPower {
 public:
  void add(double x, double y) {
    const double u = std::log(x), v = std::log(y);
    count_ += 1;
    u_ += u;
    v_ += v;
    uu_ += u * u;
    uv_ += u * v;
  }
  double exponent() const { return (count_ * uv_ - u_ * v_) / (count_ * uu_ - u_ * u_); }

 private:
  double count_ = 0, u_ = 0, v_ = 0, uu_ = 0, uv_ = 0;
};

// The map on `threads` threads, and its time on the clock.
struct TimedMap {
  sphere_map::Array<mesh::Vector3> directions;
  double seconds;
};

TimedMap timed_map(const mesh::Mesh& surface, unsigned threads) {
  base::Host host;
  host.thread_count = threads;
  const auto start = std::chrono::steady_clock::now();
  auto directions = sphere_map::compute(surface.positions, surface.triangles, {}, host);
  return {std::move(directions), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

int scaling(const std::vector<std::size_t>& sizes) {
  std::printf("%10s %8s %9s %12s %9s %11s %9s %9s %8s %9s\n", "vertices", "valid", "CPU s", "us a vertex", "peak MB",
              "B a vertex", "1 thread", "2 threads", "speed-up", "same bits");
  FittedPower time, memory;
  bool all_valid = true;
  for (const std::size_t size : sizes) {
    mesh::ShapeOptions options;
    options.triangles = 2 * size;
    const mesh::Mesh surface = mesh::make_shape("creature", options, base::Host());
    const bench::MeasuredRun r = run(surface, sphere_map::Method::balanced).map;
    const auto n = static_cast<double>(surface.positions.size());
    const auto bytes = static_cast<double>(r.peak_bytes);
    const TimedMap one = timed_map(surface, 1);
    const TimedMap two = timed_map(surface, 2);
    const bool same = one.directions == two.directions;
    std::printf("%10zu %8s %9.2f %12.2f %9.1f %11.0f %9.2f %9.2f %8.2f %9s\n", surface.positions.size(),
                r.figures.bijective ? "yes" : "NO", r.seconds, 1e6 * r.seconds / n, 1e-6 * bytes, bytes / n,
                one.seconds, two.seconds, one.seconds / two.seconds, same ? "yes" : "NO");
    std::fflush(stdout);
    all_valid = all_valid && r.figures.bijective && same;
    time.add(n, r.seconds);
    memory.add(n, bytes);
  }
  if (sizes.size() > 1) {
    std::printf("time grows as n^%.2f, memory as n^%.2f\n", time.exponent(), memory.exponent());
  }
  return all_valid ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "quality" && argc > 2) {
    const auto method = methods.find(argc > 3 ? argv[3] : "balanced");
    if (method != methods.end()) return quality(argv[2], method->second);
  }
  if (what == "scaling") {
    std::vector<std::size_t> sizes;
    for (int i = 2; i < argc; ++i)
      sizes.push_back(std::strtoul(argv[i], nullptr, 10));
    if (sizes.empty()) sizes = {10'000, 30'000, 100'000, 300'000, 1'000'000, 2'000'000};
    return scaling(sizes);
  }
  std::fprintf(stderr, "usage: %s quality FOLDER [METHOD] | scaling [VERTICES...]\n", argv[0]);
  return 2;
}
