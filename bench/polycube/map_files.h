// Maps for the benchmarks of what improves them: made, or read.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "mesh/files/read.h"
#include "mesh/topology/orient.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"

namespace orbicube::bench {

constexpr const char* map_ending = ".surface.ply";

// NAME.surface.ply with NAME.polycube.ply beside it.
inline polycube::SurfaceMap read_map(const std::string& file, const base::Host& host) {
  const mesh::Mesh surface = mesh::read_mesh(file, {}, host);
  const std::string other = file.substr(0, file.size() - std::string(map_ending).size()) + ".polycube.ply";
  polycube::SurfaceMap map(host.memory);
  map.positions = surface.positions;
  map.triangles = surface.triangles;
  map.polycube = mesh::read_mesh(other, {}, host).positions;
  polycube::set_unrefined(map);
  const polycube::Certificate certificate = polycube::certify(map, host);
  if (!certificate.valid()) throw base::Error("no-valid-result", certificate.reason);
  return map;
}

inline polycube::SurfaceMap make_map(const std::string& file, polycube::Method method, std::size_t corners,
                                     const base::Host& host) {
  mesh::Mesh surface = mesh::read_mesh(file, {}, host);
  mesh::orient(surface.positions, surface.triangles, host);
  return polycube::construct(surface.positions, surface.triangles, {.method = method, .corners = corners}, host)
      .made.map;
}

inline std::string stem_of(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace orbicube::bench
