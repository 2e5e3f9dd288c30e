// Figures for the dissertation's Tables 3.1 to 3.4 and Figure 3.2, one record a line, for tables.py.
//
//   bench-sphere-map-tables FOLDER     with the models cow.off, frog.obj, bunny.ply, ..., those that FOLDER has
//
// Tab-separated:
//   map NAME METHOD vertices flipped E_D E_A E max-quasi-conformal stretch-efficiency CPU-seconds bytes-at-the-peak
//   trace NAME iterations vertices E     of the method of the dissertation
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "baselines.h"
#include "measured_run.h"
#include "sphere_map/dissertation/method.h"
#include "sphere_map/hierarchy/normalize.h"
#include "sphere_map/sphere_map.h"
#include "table_models.h"

using namespace orbicube;
using bench::Model;

namespace {

void print(const Model& model, const char* method, const bench::MeasuredRun& run) {
  const sphere_map::Measurement& m = run.figures;
  std::printf("map\t%s\t%s\t%zu\t%zu\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.4f\t%zu\n", model.name, method,
              run.directions.size(), m.flipped + m.degenerate, m.energy_angle, m.energy_area, m.energy,
              m.max_quasi_conformal, m.stretch_efficiency, run.seconds, run.peak_bytes);
  std::fflush(stdout);
}

// In place of sphere_map::compute, for the trace; the model is known to be fit for a map.
bench::MeasuredRun traced_dissertation(const Model& model, const mesh::Mesh& surface) {
  const base::Host plain;
  const auto unit = sphere_map::normalized(surface.positions, surface.triangles, plain.memory);
  std::vector<sphere_map::dissertation::TracePoint> points;
  sphere_map::dissertation::DissertationOptions options;
  options.trace = [&](const sphere_map::dissertation::TracePoint& point) {
    if (!points.empty() && point.iterations <= points.back().iterations) points.clear();  // it began again
    points.push_back(point);
  };
  bench::MeasuredRun run = bench::measured_run(surface, [&](const base::Host& host) {
    return sphere_map::dissertation::compute(unit, surface.triangles, options, host);
  });
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool whole = points[i].vertices == surface.positions.size();
    if (!whole && points[i].iterations < next) continue;
    next = points[i].iterations + points[i].iterations / 50;  // enough for a curve
    std::printf("trace\t%s\t%" PRIu64 "\t%zu\t%.9g\n", model.name, points[i].iterations, points[i].vertices,
                points[i].energy);
  }
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  int found = 0;
  for (const Model& model : bench::table_models) {
    if (!std::filesystem::exists(folder / model.file)) continue;
    ++found;
    const mesh::Mesh surface = bench::read_model(folder, model, model.subdivisions);
    print(model, "dissertation", traced_dissertation(model, surface));
    const auto with = [&](const char* name, sphere_map::Method method) {
      sphere_map::Options options;
      options.method = method;
      print(model, name, bench::measured_run(surface, [&](const base::Host& host) {
              return sphere_map::compute(surface.positions, surface.triangles, options, host);
            }));
    };
    with("balanced", sphere_map::Method::balanced);
    with("angle-area", sphere_map::Method::angle_area);
    if (!model.with_baselines) continue;
    with("conformal", sphere_map::Method::conformal);
    print(model, "harmonic", bench::measured_run(surface, [&](const base::Host& host) {
            return bench::harmonic_baseline(surface, host);
          }));
    print(model, "curvilinear", bench::measured_run(surface, [&](const base::Host& host) {
            return bench::curvilinear_baseline(surface, host);
          }));
  }
  if (found == 0) {
    std::fprintf(stderr, "%s has none of the models\n", folder.c_str());
    return 1;
  }
  return 0;
}
