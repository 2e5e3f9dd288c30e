#include "morphs/morph_states.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <utility>

#include "base/counted.h"
#include "correspondence/morph.h"
#ifdef ORBICUBE_WITH_POLYCUBE
#include "files/quad_file.h"
#endif
#include "files/surface_file.h"
#include "gltf/writing/float_frame.h"
#include "gltf/writing/write.h"
#include "mesh/search/measures.h"

namespace orbicube::cli {
namespace {

using mesh::Triangle;
using mesh::Vector3;

using Floats = base::Array<float>;

// A scene of the shape that stands there, with what was kept of the first one's file.
gltf::Scene scene_of(const MorphStates& morph, std::span<const float> positions, const gltf::FloatFrame& frame) {
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = morph.triangles;
  scene.smooth_normals = true;
  scene.translation = frame.translation;
  scene.scale = frame.scale;
  scene.name = std::filesystem::path(morph.output).stem().string();
  scene.kept = morph.kept;
  scene.kept_surface = morph.kept_surface;
  scene.kept_triangles = morph.kept_triangles;
  return scene;
}

void write_targets(const MorphStates& morph, Session& session) {
  const base::Host& host = session.host();
  const std::span<const Triangle> triangles = morph.triangles;
  const std::span<const base::Array<Vector3>> states = morph.states;
  Vector3 low = states[0][triangles[0][0]];
  Vector3 high = low;
  for (const auto& state : states) {
    const mesh::Measures box = mesh::measures(state, triangles, host);
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  const gltf::FloatFrame frame = about(morph.output, Role::output, [&] { return gltf::float_frame(low, high); });
  std::deque<Floats> floats;
  std::vector<gltf::MorphTarget> targets;
  for (std::size_t i = 0; i < states.size(); ++i) {
    floats.push_back(gltf::stored_positions(states[i], frame, host.memory));
    if (i > 0) targets.push_back({morph.names[i], floats.back()});
  }
  gltf::Scene scene = scene_of(morph, floats[0], frame);
  scene.morph_targets = targets;
  scene.morph_normals = true;
  scene.morph_seconds = morph.seconds;
  about(morph.output, Role::output, [&] { gltf::write(session.stage(morph.output), scene, host); });
}

// OUT-01.glb and so on: `steps` intermediate shapes from each shape to the next.
void write_steps(const MorphStates& morph, Session& session) {
  const std::filesystem::path out(morph.output);
  const std::size_t count = morph.steps * (morph.states.size() - 1);
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
  mesh::Mesh step(session.host().memory);
  step.triangles.assign(morph.triangles.begin(), morph.triangles.end());
  std::size_t number_of_step = 0;
  for (std::size_t i = 0; i + 1 < morph.states.size(); ++i) {
    for (std::size_t k = 1; k <= morph.steps; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(morph.steps + 1);
      step.positions = correspondence::intermediate(morph.states[i], morph.states[i + 1], share, session.host().memory);
      std::string text = std::to_string(++number_of_step);
      text.insert(0, digits - text.size(), '0');
      const std::filesystem::path path =
          out.parent_path() / (out.stem().string() + "-" + text + out.extension().string());
      if (morph.kept == nullptr) {
        write_output(path, step, true, session);
        continue;
      }
      about(path, Role::output, [&] {
        const mesh::Measures box = mesh::measures(step.positions, step.triangles, session.host());
        const gltf::FloatFrame frame = gltf::float_frame(box.low, box.high);
        const Floats positions = gltf::stored_positions(step.positions, frame, session.host().memory);
        gltf::write(session.stage(path), scene_of(morph, positions, frame), session.host());
      });
    }
  }
  session.figures()["intermediates"] = count;
}

}  // namespace

void require_weights(const ShapeBlend& blend, std::size_t shapes) {
  if (blend.weights.empty() || blend.weights.size() == shapes) return;
  throw Failure(
      Exit::wrong_input, "", "usage",
      "--blend has " + base::counted(blend.weights.size(), "weight") + " for " + base::counted(shapes, "shape"));
}

void write_blend(const MorphStates& morph, const ShapeBlend& blend, std::span<const std::array<mesh::Index, 4>> quads,
                 Session& session) {
  const base::Host& host = session.host();
  mesh::Mesh blended(host.memory);
  blended.triangles.assign(morph.triangles.begin(), morph.triangles.end());
  blended.positions =
      about(morph.output, Role::output, [&] { return correspondence::blend(morph.states, blend.weights, host); });
  write_output(morph.output, blended, true, session);
  session.figures()["blend"] = blend.weights;
#ifdef ORBICUBE_WITH_POLYCUBE
  if (blend.quads.empty()) return;
  about(blend.quads, Role::output, [&] { write_quads(session.stage(blend.quads), blended.positions, quads, host); });
  session.figures()["quads"] = quads.size();
  session.say("wrote " + blend.quads + ": " + std::to_string(quads.size()) + " quads");
#else
  (void)quads;
#endif
}

void write_morph(const MorphStates& morph, Session& session) {
  write_targets(morph, session);
  if (morph.steps > 0) write_steps(morph, session);
}

}  // namespace orbicube::cli
