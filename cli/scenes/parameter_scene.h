// The boundary of a parameterized solid with the grid of its coordinates as texture.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scenes/report_page.h"
#include "session/session.h"
#include "volume_map/frame_map/parameterization.h"

namespace orbicube::cli {

// A vertex for each pair of texture coordinates that it has, which are the two coordinates of its chart that vary along
// the boundary, in cells. Positions and coordinates are those of the map.
struct ParameterSurface {
  explicit ParameterSurface(std::pmr::memory_resource* memory)
      : positions(memory), coordinates(memory), parameters(memory), triangles(memory) {}

  base::Array<mesh::Vector3> positions;
  base::Array<std::array<double, 2>> coordinates;
  base::Array<mesh::Vector3> parameters;  // all three coordinates
  base::Array<mesh::Triangle> triangles;
};

ParameterSurface parameter_surface(std::span<const mesh::Vector3> positions,
                                   std::span<const mesh::Tetrahedron> tetrahedra,
                                   const volume_map::Parameterization& map, const base::Host& host);

// Writes glTF with a checker texture whose squares are cells. Throws what gltf::write throws.
void write_parameter_scene(const std::filesystem::path& path, const ParameterSurface& surface, const std::string& name,
                           const base::Host& host);

// Writes OBJ with texture coordinates, one unit a cell; digits that read as the same doubles. Throws Error "io".
void write_parameter_obj(const std::filesystem::path& path, const ParameterSurface& surface, const base::Host& host);

// Writes a page: the boundary beside its image in the charts, colored by distortion. Throws Failure.
std::size_t write_parameter_page(const std::string& path, const ParameterSurface& surface, const std::string& name,
                                 std::vector<std::pair<std::string, std::string>> figures, Session& session);

}  // namespace orbicube::cli
