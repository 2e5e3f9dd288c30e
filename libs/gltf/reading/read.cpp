#include "gltf/reading/read.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "gltf/json/asset.h"
#include "gltf/json/uri.h"
#include "gltf/reading/accessor.h"
#include "gltf/reading/scene.h"
#include "gltf/reading/shown_morphs.h"
#include "mesh/files/file.h"
#include "mesh/files/left_out.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/weld.h"

namespace orbicube::gltf {

namespace {

using mesh::Triangle;

// glTF's primitive modes (5.24.4 of the specification).
enum class Mode : std::uint8_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

Mode mode_of(const tiny::Primitive& primitive, const std::string& where) {
  if (primitive.mode < 0 || primitive.mode > static_cast<int>(Mode::triangle_fan))
    throw base::Error("parse", where + ".mode is " + std::to_string(primitive.mode) + ", which is no mode");
  return static_cast<Mode>(primitive.mode);
}

// Whether no edge has a single triangle.
bool is_closed(const mesh::Mesh& surface, const base::Host& host) {
  const mesh::EdgeTable edges(surface.positions.size(), surface.triangles, host);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (edges.half_edges(edge).size() == 1) return false;
  }
  return true;
}

// Gathers the placed primitives of an asset into one mesh.
class SurfaceReader {
 public:
  // What is kept besides the surface goes to `kept`, where that is not null.
  SurfaceReader(Asset& asset, const ReadOptions& options, Kept* kept)
      : asset_(asset),
        options_(options),
        kept_(kept),
        surface_(asset.host().memory),
        shared_vertices_(asset.host().memory) {}

  void read_all() {
    if (asset_.model().meshes.empty()) throw base::Error("empty-mesh", "the file has no meshes");
    const Placements placements = place_meshes(asset_);
    hidden_ = placements.hidden;
    if (hidden_ > 0) first_hidden_ = place_of("nodes", placements.first_hidden);
    for (const Placement& placement : placements.shown)
      read_placed(placement);
    if (placements.shown.empty() && hidden_ > 0)
      throw base::Error("degenerate-geometry", "all meshes of the scene have scale 0, which hides them");
    if (surface_.triangles.empty() && left_out_ > 0)
      throw base::Error("unsupported-mode", "the file has points or lines only, no triangles");
    if (surface_.triangles.empty()) throw base::Error("empty-mesh", "the file's scene has no triangles");
  }

  mesh::Mesh finish(mesh::ReadReport* report) {
    if (report != nullptr) *report = {};
    note_if(mirrored_, "triangle", "triangles", " of mirrored nodes, turned back");
    note_if(dropped_, "triangle", "triangles", " of strips and fans with equal corners, left out");
    note_if(left_out_, "primitive", "primitives", " of points or lines, left out");
    note_if(hidden_, "mesh", "meshes", " of nodes of scale 0, left out; the first is that of " + first_hidden_);
    note_if(skinned_, "skinned mesh", "skinned meshes", ", taken as they are without their skins");
    note_if(weighted_, "mesh", "meshes", " with morph targets, taken with the weights that the file gives them");
    note_decoration();
    if (kept_ != nullptr) keep_corners(*kept_, surface_);
    weld_if_needed(report);
    if (const std::size_t trailing = asset_.container().trailing_bytes; trailing > 0)
      note_if(trailing, "byte", "bytes", " behind the end of the GLB, ignored");
    if (report != nullptr) {
      report->format = asset_.container().binary ? "GLB" : "glTF";
      report->notes = std::move(notes_);
    }
    return std::move(surface_);
  }

 private:
  // Accessors, by number: of the positions, then of the deltas of each morph target that counts; no_accessor for none.
  using VertexKey = base::Array<std::uint64_t>;

  struct Vertices {
    Index first;
    std::size_t count;
  };

  void note_if(std::size_t count, const char* one, const char* many, const std::string& what) {
    if (count > 0) notes_.push_back(base::counted(count, one, many) + what);
  }

  void weld_if_needed(mesh::ReadReport* report) {
    if (!options_.weld_identical) return;
    const char* why = ": triangles without indices";
    if (!without_indices_) {
      if (is_closed(surface_, asset_.host())) return;
      why = ": the surface was not closed";
    }
    if (kept_ != nullptr) weld_corners(*kept_, surface_, asset_.host());
    const mesh::WeldReport welded = mesh::weld(surface_, asset_.host());
    if (report != nullptr) report->welded_vertices = welded.vertices;
    note_if(welded.vertices, "vertex", "vertices", std::string(" joined to others at the same position") + why);
    note_if(welded.triangles, "triangle", "triangles", " with two corners at the same position, left out");
    if (surface_.triangles.empty()) throw base::Error("degenerate-geometry", "every triangle has two equal corners");
  }

  void read_placed(const Placement& placement) {
    shared_vertices_.clear();
    if (placement.skinned) ++skinned_;
    const base::Array<Morph> morphs = morphs_of(asset_, placement, options_.morph_target);
    if (options_.morph_target.empty()) weighted_ += !morphs.empty();
    const std::vector<tiny::Primitive>& primitives = mesh_of(placement).primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const std::string where = place_of("meshes", placement.mesh) + '.' + place_of("primitives", i);
      const Mode mode = mode_of(primitives[i], where);
      if (mode < Mode::triangles) {
        ++left_out_;
        continue;
      }
      const std::size_t first_triangle = surface_.triangles.size();
      const Vertices vertices = read_primitive(primitives[i], mode, placement, morphs, where);
      if (kept_ == nullptr) continue;
      kept_->primitives.push_back({placement.mesh, i, placement.node, placement.to_world, placement.mirrored,
                                   placement.skinned, vertices.first, vertices.count, first_triangle,
                                   surface_.triangles.size() - first_triangle});
    }
  }

  const tiny::Mesh& mesh_of(const Placement& placement) const { return asset_.model().meshes[placement.mesh]; }

  Vertices read_primitive(const tiny::Primitive& primitive, Mode mode, const Placement& placement,
                          std::span<const Morph> morphs, const std::string& where) {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) throw base::Error("missing-attribute", where + " has no POSITION");
    const tiny::Accessor& accessor = asset_.accessor(position->second, where + ".attributes.POSITION");
    if (primitive.extensions.contains("KHR_draco_mesh_compression") && accessor.bufferView < 0)
      throw base::Error("unsupported-extension", where + " is compressed with KHR_draco_mesh_compression");
    VertexKey key(asset_.host().memory);
    key.push_back(static_cast<std::uint64_t>(position->second));
    for (const Morph& morph : morphs)
      key.push_back(morph_accessor(asset_, primitive, morph, options_.morph_target, where));
    count_decoration(primitive);
    const Vertices vertices = vertices_of(key, morphs, placement);

    base::Array<Index> corners(asset_.host().memory);
    if (primitive.indices >= 0) {
      asset_.accessor(primitive.indices, where + ".indices");
      const auto indices = static_cast<std::size_t>(primitive.indices);
      account(element_count(asset_, indices));
      corners = read_indices(asset_, indices, vertices.count);
    } else {
      without_indices_ = true;
      corners.resize(vertices.count);
      for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = static_cast<Index>(i);
    }
    for (Index& corner : corners)
      corner += vertices.first;
    add_triangles(corners, mode, placement.mirrored, where);
    return vertices;
  }

  // Adds the vertices of a primitive to the surface. Primitives of one mesh often share an accessor: then they share
  // the vertices, so that the surface does not fall apart between materials.
  Vertices vertices_of(const VertexKey& key, std::span<const Morph> morphs, const Placement& placement) {
    const auto found = shared_vertices_.find(key);
    if (found != shared_vertices_.end()) return found->second;

    const auto accessor = static_cast<std::size_t>(key[0]);
    account(element_count(asset_, accessor));
    base::Array<Vector3> positions = read_vectors(asset_, accessor);
    for (std::size_t i = 0; i < morphs.size(); ++i) {
      if (key[i + 1] != no_accessor)
        add_morph(positions, static_cast<std::size_t>(key[i + 1]), morphs[i].weight, accessor);
    }
    if (positions.size() >= mesh::no_index - surface_.positions.size())
      throw base::Error("unsupported", "the file has more vertices than 32-bit indices can count");
    const Vertices vertices{static_cast<Index>(surface_.positions.size()), positions.size()};
    if (placement.to_world.matrix() == Eigen::Matrix4d::Identity()) {
      if (surface_.positions.empty()) {
        surface_.positions = std::move(positions);
      } else {
        surface_.positions.insert(surface_.positions.end(), positions.begin(), positions.end());
      }
    } else {
      add_transformed(positions, placement, accessor);
    }
    shared_vertices_.emplace(key, vertices);
    return vertices;
  }

  void add_morph(base::Array<Vector3>& positions, std::size_t morph, double weight, std::size_t accessor) {
    account(element_count(asset_, morph));
    const base::Array<Vector3> deltas = read_vectors(asset_, morph);
    if (deltas.size() != positions.size())
      throw base::Error("accessor-range",
                        place_of("accessors", morph) + " has another number of elements than its base");
    for (std::size_t i = 0; i < positions.size(); ++i) {
      positions[i] += weight * deltas[i];
      if (!positions[i].allFinite()) {
        throw base::Error("non-finite", place_of("accessors", accessor) + ": element " + std::to_string(i) +
                                            " is beyond the range of numbers with its morph targets");
      }
    }
  }

  // What a primitive has besides its shape, for the note.
  void count_decoration(const tiny::Primitive& primitive) {
    texture_coordinates_ += primitive.attributes.contains("TEXCOORD_0");
    colors_ += primitive.attributes.contains("COLOR_0");
    targets_ = std::max(targets_, primitive.targets.size());
  }

  void note_decoration() {
    const auto count = [&](const char* name) {
      const JsonValue array = asset_.root().member(name);
      return array && array.kind() == JsonKind::array ? array.size() : 0;
    };
    const bool taken = !options_.morph_target.empty() || weighted_ > 0;
    std::vector<std::string> decoration;
    mesh::note_left_out({{count("materials"), "material", "materials"},
                         {count("textures"), "texture", "textures"},
                         {texture_coordinates_, "primitive's texture coordinates", "primitives' texture coordinates"},
                         {colors_, "primitive's colors", "primitives' colors"},
                         {count("skins"), "skin", "skins"},
                         {count("animations"), "animation", "animations"},
                         {taken ? 0 : targets_, "morph target", "morph targets"},
                         {count("cameras"), "camera", "cameras"}},
                        decoration);
    if (kept_ != nullptr) {
      std::vector<std::string> replaced;
      mesh::note_left_out({{taken ? 0 : targets_, "morph target", "morph targets"}}, replaced);
      if (!decoration.empty()) kept_->decoration = decoration.front();
      if (!replaced.empty()) kept_->replaced = replaced.front();
      return;
    }
    notes_.insert(notes_.end(), decoration.begin(), decoration.end());
  }

  void add_transformed(const base::Array<Vector3>& positions, const Placement& placement, std::size_t accessor) {
    surface_.positions.reserve(surface_.positions.size() + positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (i % base::items_between_reports == 0) asset_.host().report("placing vertices", i, positions.size());
      const Vector3 placed = placement.to_world * positions[i];
      if (!placed.allFinite()) {
        throw base::Error("non-finite", place_of("accessors", accessor) + ": element " + std::to_string(i) +
                                            " is beyond the range of numbers once placed");
      }
      surface_.positions.push_back(placed);
    }
  }

  void add_triangles(std::span<const Index> corners, Mode mode, bool mirrored, const std::string& where) {
    const bool separate = mode == Mode::triangles;
    if (separate && corners.size() % 3 != 0) {
      throw base::Error("parse", where + " has " + base::counted(corners.size(), "corner") +
                                     " of triangles, which is no multiple of 3");
    }
    const std::size_t count = separate ? corners.size() / 3 : corners.size() < 3 ? 0 : corners.size() - 2;
    if (mirrored) mirrored_ += count;
    // Growth stays geometric over many small primitives.
    if (surface_.triangles.capacity() - surface_.triangles.size() < count)
      surface_.triangles.reserve(std::max(surface_.triangles.size() + count, 2 * surface_.triangles.size()));
    for (std::size_t i = 0; i < count; ++i) {
      if (i % base::items_between_reports == 0) asset_.host().report("reading triangles", i, count);
      Triangle triangle = corners_of(corners, mode, i);
      if (!separate && mesh::has_repeated_corner(triangle)) {
        ++dropped_;  // strips go on elsewhere through triangles without area
        continue;
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      surface_.triangles.push_back(triangle);
    }
  }

  // The i-th triangle of a primitive (3.7.2.1 of the specification).
  static Triangle corners_of(std::span<const Index> corners, Mode mode, std::size_t i) {
    switch (mode) {
      case Mode::triangle_strip:
        return {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]};
      case Mode::triangle_fan:
        return {corners[i + 1], corners[i + 2], corners[0]};
      default:
        return {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
    }
  }

  // A file may show the same data any number of times, with a few bytes each. Bounds what that can grow into.
  void account(std::uint64_t elements) {
    constexpr std::uint64_t always_allowed = std::uint64_t{1} << 21U, allowed_per_byte = 4;
    const std::uint64_t allowed = always_allowed + allowed_per_byte * asset_.stored_bytes();
    // A count beyond what is stored is refused where its values are read.
    if (elements > allowed) return;
    used_ += elements;
    if (used_ > allowed)
      throw base::Error("unsupported", "the file repeats its data into more than " + std::to_string(allowed) +
                                           " vertices and corners");
  }

  Asset& asset_;
  const ReadOptions& options_;
  Kept* kept_;
  mesh::Mesh surface_;
  std::pmr::map<VertexKey, Vertices> shared_vertices_;  // already read for the mesh at hand
  std::uint64_t used_ = 0;
  bool without_indices_ = false;
  std::size_t mirrored_ = 0, dropped_ = 0, left_out_ = 0, skinned_ = 0, hidden_ = 0, weighted_ = 0;
  std::size_t texture_coordinates_ = 0, colors_ = 0, targets_ = 0;  // of what is left out
  std::string first_hidden_;                                        // node of scale 0
  std::vector<std::string> notes_;
};

}  // namespace

namespace {

mesh::Mesh read_asset(Asset& asset, const ReadOptions& options, mesh::ReadReport* report, Kept* kept) {
  SurfaceReader reader(asset, options, kept);
  reader.read_all();
  return reader.finish(report);
}

// Reads and keeps. Null, with the reason, if the document does not allow it.
mesh::Mesh read_and_keep(base::Array<std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                         const ReadOptions& options, const base::Host& host, mesh::ReadReport* report,
                         std::unique_ptr<Kept>& kept) {
  kept = std::make_unique<Kept>(std::move(bytes), folder, host);
  mesh::Mesh surface = read_asset(kept->asset, options, report, kept.get());
  std::string problem = kept->asset.problem();
  if (problem.empty()) {
    try {
      check_kept(*kept);
      return surface;
    } catch (const base::Error& error) {
      if (error.status() == base::Status::cancelled) throw;
      problem = error.what();
    }
  }
  if (report != nullptr) {
    if (!kept->decoration.empty()) report->notes.push_back(kept->decoration);
    report->notes.push_back("materials, textures, skins and the like cannot be kept: " + problem);
  }
  kept.reset();
  return surface;
}

}  // namespace

mesh::Mesh read(std::span<const std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                const ReadOptions& options, const base::Host& host, mesh::ReadReport* report) {
  Asset asset(bytes, folder, Extent::surface, host);
  return read_asset(asset, options, report, nullptr);
}

mesh::Mesh read(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
                mesh::ReadReport* report) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  return read(bytes, path.parent_path(), options, host, report);
}

mesh::Mesh read(std::span<const std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                const ReadOptions& options, const base::Host& host, mesh::ReadReport* report,
                std::unique_ptr<Kept>* kept) {
  if (kept == nullptr) return read(bytes, folder, options, host, report);
  base::Array<std::byte> copy(bytes.begin(), bytes.end(), host.memory);
  return read_and_keep(std::move(copy), folder, options, host, report, *kept);
}

mesh::Mesh read(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
                mesh::ReadReport* report, std::unique_ptr<Kept>* kept) {
  if (kept == nullptr) return read(path, options, host, report);
  return read_and_keep(mesh::read_file(path, host), path.parent_path(), options, host, report, *kept);
}

}  // namespace orbicube::gltf
