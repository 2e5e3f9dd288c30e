#include "studies/subject_file.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "base/files/file.h"
#include "base/hash.h"
#include "files/surface_file.h"
#include "images/label_surface.h"
#include "studies/kept_subject.h"

namespace orbicube::cli {
namespace {

constexpr std::array<std::string_view, 6> image_endings = {".nii.gz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd"};

// Returns the ending of a label image, or an empty text.
std::string_view image_ending(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const std::string_view ending : image_endings)
    if (name.size() > ending.size() && name.ends_with(ending)) return ending;
  return {};
}

LabelFile labels_of(const std::filesystem::path& file, Session& session) {
  return about(file, Role::input, [&] { return read_labels(file, session); });
}

}  // namespace

bool is_label_image(const std::filesystem::path& file) {
  return !image_ending(file.filename().string()).empty();
}

std::string name_of_subject(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const std::string_view ending = image_ending(name);
  return ending.empty() ? file.stem().string() : name.substr(0, name.size() - ending.size());
}

ClosedSurface read_subject(const std::filesystem::path& file, std::int32_t label, Session& session) {
  if (!is_label_image(file)) return read_closed_surface(file.string(), {.weld = false, .repair = true}, session);
  const LabelFile image = labels_of(file, session);
  repair::LabelOptions options;
  options.label = label;
  repair::LabelSurface surface =
      about(file, Role::input, [&] { return extract_label(image, options, session.host()); });
  if (surface.report.border_voxels > 0) session.note("the label reaches the border of the image, where it is closed");
  ClosedSurface result{mesh::Mesh(session.host().memory), Json::object()};
  result.mesh.positions = std::move(surface.positions);
  result.mesh.triangles = std::move(surface.triangles);
  return result;
}

std::string hash_of_input(const std::filesystem::path& file, const std::string& key, Session& session) {
  base::Hash hash;
  hash.add(std::as_bytes(std::span(key.data(), key.size())));
  if (is_label_image(file)) {
    const LabelFile image = labels_of(file, session);
    hash.add(std::as_bytes(std::span<const std::size_t>(image.header.size)));
    hash.add(std::as_bytes(std::span<const double>(image.header.to_world)));
    hash.add(std::as_bytes(std::span<const std::int32_t>(image.labels)));
  } else if (is_gltf(file)) {
    const InputMesh input = read_input(file, false, session);
    hash.add(std::as_bytes(std::span<const mesh::Vector3>(input.mesh.positions)));
    hash.add(std::as_bytes(std::span<const mesh::Triangle>(input.mesh.triangles)));
  } else {
    hash.add(about(file, Role::input, [&] { return base::read_file(file, session.host()); }));
  }
  return text_of_hash(hash.value());
}

}  // namespace orbicube::cli
