#include "report/grid_choice.h"

#include <array>
#include <charconv>

#include "session/failure.h"

namespace orbicube::cli {
namespace {

struct Known {
  const char* name;
  sphere_map::GridKind kind;
  std::size_t usual;
};
constexpr std::array known = {
    Known{"icosphere", sphere_map::GridKind::icosphere, 6}, Known{"cube", sphere_map::GridKind::cube, 96},
    Known{"latitude", sphere_map::GridKind::latitude, 128}, Known{"octahedron", sphere_map::GridKind::octahedron, 256}};

}  // namespace

GridChoice grid_choice(const std::string& text, const char* option) {
  const auto refuse = [&](const std::string& why) {
    throw Failure(Exit::wrong_input, "", "usage", std::string(option) + ": '" + text + "' " + why);
  };
  const std::size_t colon = text.find(':');
  for (const Known& grid : known) {
    if (text.substr(0, colon) != grid.name) continue;
    GridChoice choice{grid.kind, grid.usual};
    if (colon == std::string::npos) return choice;
    const auto [end, problem] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), choice.resolution);
    const auto [least, greatest] = sphere_map::resolutions(grid.kind);
    if (problem != std::errc() || end != text.data() + text.size() || choice.resolution < least ||
        choice.resolution > greatest) {
      refuse("needs a whole number from " + std::to_string(least) + " to " + std::to_string(greatest) +
             " behind the colon");
    }
    if (grid.kind == sphere_map::GridKind::octahedron && choice.resolution % 2 != 0) refuse("needs an even number");
    return choice;
  }
  refuse("is no grid; there are icosphere, cube, latitude and octahedron");
  return {};
}

std::string name_of(const GridChoice& choice) {
  for (const Known& grid : known) {
    if (grid.kind == choice.kind) return std::string(grid.name) + ":" + std::to_string(choice.resolution);
  }
  return "";
}

}  // namespace orbicube::cli
