// One map with its figures, CPU time and memory.
#pragma once

#include <cstddef>
#include <functional>

#include "base/host.h"
#include "bench/measuring.h"
#include "mesh/mesh.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::bench {

struct MeasuredRun {
  sphere_map::Array<mesh::Vector3> directions;
  sphere_map::Measurement figures;  // at weights (0.1, 1)
  double seconds = 0;               // of CPU, one thread
  std::size_t peak_bytes = 0;
};

// `map` returns the directions of the surface, computed with the host that it is given.
inline MeasuredRun measured_run(const mesh::Mesh& surface,
                                const std::function<sphere_map::Array<mesh::Vector3>(const base::Host&)>& map) {
  CountingMemory memory;
  base::Host host;
  host.memory = &memory;
  host.thread_count = 1;
  MeasuredRun result;
  const double start = cpu_seconds();
  {
    const auto directions = map(host);
    result.seconds = cpu_seconds() - start;
    result.directions.assign(directions.begin(), directions.end());
  }
  result.peak_bytes = memory.peak();
  result.figures = sphere_map::measure(surface.positions, surface.triangles, result.directions, 0.1, 1, base::Host());
  return result;
}

}  // namespace orbicube::bench
