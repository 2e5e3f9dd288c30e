#include "gltf/read.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "gltf/accessor.h"
#include "gltf/asset.h"
#include "gltf/scene.h"
#include "gltf/uri.h"
#include "mesh/edge_table.h"
#include "mesh/file.h"
#include "mesh/weld.h"

namespace orbicube::gltf {

namespace {

using mesh::Triangle;

constexpr std::size_t items_between_reports = std::size_t{1} << 16U;

// glTF's primitive modes (5.24.4 of the specification).
enum class Mode : std::uint64_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

Mode mode_of(JsonValue primitive) {
  const JsonValue given = primitive.member("mode");
  const std::uint64_t mode = given ? given.unsigned_integer() : static_cast<std::uint64_t>(Mode::triangles);
  if (mode > static_cast<std::uint64_t>(Mode::triangle_fan))
    throw base::Error("parse", given.path() + " is " + std::to_string(mode) + ", which is no mode");
  return static_cast<Mode>(mode);
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
  SurfaceReader(Asset& asset, const ReadOptions& options)
      : asset_(asset), options_(options), surface_(asset.host().memory), shared_vertices_(asset.host().memory) {}

  void read_all() {
    if (asset_.meshes().size() == 0) throw base::Error("empty-mesh", "the file has no meshes");
    for (const Placement& placement : place_meshes(asset_)) {
      read_placed(placement);
    }
    if (surface_.triangles.empty() && left_out_ > 0)
      throw base::Error("unsupported-mode", "the file has points or lines only, no triangles");
    if (surface_.triangles.empty()) throw base::Error("empty-mesh", "the file's scene has no triangles");
  }

  mesh::Mesh finish(mesh::ReadReport* report) {
    if (report != nullptr) *report = {};
    note_if(mirrored_, " triangles of mirrored nodes, turned back");
    note_if(dropped_, " triangles of strips and fans with equal corners, left out");
    note_if(left_out_, " primitives of points or lines, left out");
    note_if(skinned_, " skinned meshes, taken as they are without their skins");
    weld_if_needed(report);
    if (const std::size_t trailing = asset_.container().trailing_bytes; trailing > 0)
      note_if(trailing, " bytes behind the end of the GLB, ignored");
    if (report != nullptr) {
      report->format = asset_.container().binary ? "GLB" : "glTF";
      report->notes = std::move(notes_);
    }
    return std::move(surface_);
  }

 private:
  // Accessors, by number: of the positions and of the morph target's deltas.
  using VertexKey = std::pair<std::uint64_t, std::uint64_t>;
  static constexpr std::uint64_t no_morph = UINT64_MAX;

  struct Vertices {
    Index first;
    std::size_t count;
  };

  void note_if(std::size_t count, const char* what) {
    if (count > 0) notes_.push_back(std::to_string(count) + what);
  }

  void weld_if_needed(mesh::ReadReport* report) {
    if (!options_.weld_identical) return;
    const char* why = ": triangles without indices";
    if (!without_indices_) {
      if (is_closed(surface_, asset_.host())) return;
      why = ": the surface was not closed";
    }
    const mesh::WeldReport welded = mesh::weld(surface_, asset_.host());
    if (report != nullptr) report->welded_vertices = welded.vertices;
    note_if(welded.vertices, (std::string(" vertices joined to others at the same position") + why).c_str());
    note_if(welded.triangles, " triangles with two corners at the same position, left out");
    if (surface_.triangles.empty()) throw base::Error("degenerate-geometry", "every triangle has two equal corners");
  }

  void read_placed(const Placement& placement) {
    shared_vertices_.clear();
    if (placement.skinned) ++skinned_;
    const std::uint64_t target = find_target(placement.mesh);
    placement.mesh.required("primitives").for_each_element([&](JsonValue primitive) {
      const Mode mode = mode_of(primitive);
      if (mode < Mode::triangles) {
        ++left_out_;
      } else {
        read_primitive(primitive, mode, placement, target);
      }
    });
  }

  // The number of the wanted morph target, or no_morph.
  std::uint64_t find_target(JsonValue mesh) const {
    if (options_.morph_target.empty()) return no_morph;
    const JsonValue extras = mesh.member("extras");
    const JsonValue names = extras && extras.kind() == JsonKind::object ? extras.member("targetNames") : JsonValue();
    std::uint64_t wanted = no_morph, number = 0;
    if (names && names.kind() == JsonKind::array) {
      names.for_each_element([&](JsonValue name) {
        if (wanted == no_morph && name.kind() == JsonKind::string && name.string() == options_.morph_target)
          wanted = number;
        ++number;
      });
    }
    if (wanted == no_morph)
      throw base::Error("missing-attribute", mesh.path() + " has no morph target " + in_quotes(options_.morph_target));
    return wanted;
  }

  void read_primitive(JsonValue primitive, Mode mode, const Placement& placement, std::uint64_t target) {
    const JsonValue attributes = primitive.required("attributes");
    const JsonValue position = attributes.member("POSITION");
    if (!position) throw base::Error("missing-attribute", primitive.path() + " has no POSITION");
    const JsonValue accessor = asset_.accessors().at(position, "index-range");
    refuse_compressed(primitive, accessor);
    const VertexKey key(position.unsigned_integer(), morph_accessor(primitive, target));
    const Vertices vertices = vertices_of(key, placement);

    const JsonValue indices = primitive.member("indices");
    base::Array<Index> corners(asset_.host().memory);
    if (indices) {
      const JsonValue index_accessor = asset_.accessors().at(indices, "index-range");
      account(element_count(index_accessor));
      corners = read_indices(asset_, index_accessor, vertices.count);
    } else {
      without_indices_ = true;
      corners.resize(vertices.count);
      for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = static_cast<Index>(i);
    }
    for (Index& corner : corners)
      corner += vertices.first;
    add_triangles(corners, mode, placement.mirrored, indices ? indices : position);
  }

  static void refuse_compressed(JsonValue primitive, JsonValue accessor) {
    const JsonValue extensions = primitive.member("extensions");
    if (extensions && extensions.member("KHR_draco_mesh_compression") && !accessor.member("bufferView"))
      throw base::Error("unsupported-extension", primitive.path() + " is compressed with KHR_draco_mesh_compression");
  }

  // The number of the accessor with the positions of a morph target.
  std::uint64_t morph_accessor(JsonValue primitive, std::uint64_t target_number) const {
    if (target_number == no_morph) return no_morph;
    JsonValue target;
    std::uint64_t number = 0;
    if (const JsonValue targets = primitive.member("targets")) {
      targets.for_each_element([&](JsonValue each) {
        if (number++ == target_number) target = each;
      });
    }
    const JsonValue accessor = target ? target.member("POSITION") : JsonValue();
    if (!accessor) {
      throw base::Error("missing-attribute", primitive.path() + " has no positions for the morph target " +
                                                 in_quotes(options_.morph_target));
    }
    asset_.accessors().at(accessor, "index-range");
    return accessor.unsigned_integer();
  }

  // Adds the vertices of a primitive to the surface. Primitives of one mesh often share an accessor: then they share
  // the vertices, so that the surface does not fall apart between materials.
  Vertices vertices_of(const VertexKey& key, const Placement& placement) {
    const auto found = shared_vertices_.find(key);
    if (found != shared_vertices_.end()) return found->second;

    const JsonValue accessor = asset_.accessors()[static_cast<std::size_t>(key.first)];
    account(element_count(accessor));
    base::Array<Vector3> positions = read_vectors(asset_, accessor);
    if (key.second != no_morph) add_morph(positions, asset_.accessors()[static_cast<std::size_t>(key.second)]);
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

  void add_morph(base::Array<Vector3>& positions, JsonValue morph) {
    account(element_count(morph));
    const base::Array<Vector3> deltas = read_vectors(asset_, morph);
    if (deltas.size() != positions.size())
      throw base::Error("accessor-range", morph.path() + " has another number of elements than its base");
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] += deltas[i];
  }

  void add_transformed(const base::Array<Vector3>& positions, const Placement& placement, JsonValue accessor) {
    surface_.positions.reserve(surface_.positions.size() + positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (i % items_between_reports == 0) asset_.host().report("placing vertices", i, positions.size());
      const Vector3 placed = placement.to_world * positions[i];
      if (!placed.allFinite()) {
        throw base::Error("non-finite", accessor.path() + ": element " + std::to_string(i) +
                                            " is beyond the range of numbers once placed");
      }
      surface_.positions.push_back(placed);
    }
  }

  void add_triangles(std::span<const Index> corners, Mode mode, bool mirrored, JsonValue where) {
    const bool separate = mode == Mode::triangles;
    if (separate && corners.size() % 3 != 0) {
      throw base::Error("parse", where.path() + " has " + std::to_string(corners.size()) +
                                     " corners of triangles, which is no multiple of 3");
    }
    const std::size_t count = separate ? corners.size() / 3 : corners.size() < 3 ? 0 : corners.size() - 2;
    if (mirrored) mirrored_ += count;
    // Growth stays geometric over many small primitives.
    if (surface_.triangles.capacity() - surface_.triangles.size() < count)
      surface_.triangles.reserve(std::max(surface_.triangles.size() + count, 2 * surface_.triangles.size()));
    for (std::size_t i = 0; i < count; ++i) {
      if (i % items_between_reports == 0) asset_.host().report("reading triangles", i, count);
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
  mesh::Mesh surface_;
  std::pmr::map<VertexKey, Vertices> shared_vertices_;  // already read for the mesh at hand
  std::uint64_t used_ = 0;
  bool without_indices_ = false;
  std::size_t mirrored_ = 0, dropped_ = 0, left_out_ = 0, skinned_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace

mesh::Mesh read(std::span<const std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                const ReadOptions& options, const base::Host& host, mesh::ReadReport* report) {
  Asset asset(bytes, folder, host);
  SurfaceReader reader(asset, options);
  reader.read_all();
  return reader.finish(report);
}

mesh::Mesh read(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
                mesh::ReadReport* report) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  return read(bytes, path.parent_path(), options, host, report);
}

}  // namespace orbicube::gltf
