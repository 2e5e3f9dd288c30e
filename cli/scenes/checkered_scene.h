// A scene of a shape that shows a texture coordinate by a checker pattern.
#pragma once

#include <string>
#include <utility>

#include "gltf/writing/checker.h"
#include "gltf/writing/float_frame.h"
#include "gltf/writing/write.h"

namespace orbicube::cli {

struct CheckeredScene {
  // The pattern has the given number of squares along either side of the texture. The scene has a view of the texture.
  CheckeredScene(const gltf::FloatFrame& frame, std::string name, std::uint32_t squares,
                 std::pmr::memory_resource* memory)
      : texture(gltf::checker_png({.columns = squares, .rows = squares}, memory)) {
    scene.translation = frame.translation;
    scene.scale = frame.scale;
    scene.base_color = {1, 1, 1, 1};
    scene.texture = texture;
    scene.name = std::move(name);
  }
  CheckeredScene(const CheckeredScene&) = delete;
  CheckeredScene& operator=(const CheckeredScene&) = delete;

  base::Array<std::byte> texture;
  gltf::Scene scene;
};

}  // namespace orbicube::cli
