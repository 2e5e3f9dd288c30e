#include "tetrahedra/tetgen_call.h"

#define TETLIBRARY
#include <tetgen.h>

#include <Eigen/Geometry>
#include <cmath>
#include <csignal>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "base/catch_all.h"
#include "base/error.h"
#include "tetrahedra/child_process.h"

namespace orbicube::tetrahedra {
namespace {

constexpr const char* tetgen_call_phase = "filling with tetrahedra";

// What the child writes before the arrays. TetGen's list of the tetrahedra beside faces is of no use: outside is 0 in
// it.
struct Header {
  TetgenOutcome::Kind kind = TetgenOutcome::Kind::done;
  std::int32_t number = 0;
  std::uint64_t positions = 0, tetrahedra = 0, faces = 0;
};

// TetGen frees what its input points to with delete[]: these arrays are ours, so they are taken away from it again.
struct Input : tetgenio {
  std::vector<double> coordinates;
  std::vector<int> corners, markers;
  std::vector<polygon> polygons;
  std::vector<facet> facets;

  Input(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles)
      : markers(triangles.size()), polygons(triangles.size()), facets(triangles.size()) {
    for (const mesh::Vector3& p : positions)
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    for (const mesh::Triangle& t : triangles)
      corners.insert(corners.end(), t.begin(), t.end());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      markers[i] = static_cast<int>(i) + 1;  // 0 means none
      init(&polygons[i]);
      polygons[i].vertexlist = &corners[3 * i];
      polygons[i].numberofvertices = 3;
      init(&facets[i]);
      facets[i].polygonlist = &polygons[i];
      facets[i].numberofpolygons = 1;
    }
    pointlist = coordinates.data();
    numberofpoints = static_cast<int>(positions.size());
    facetlist = facets.data();
    facetmarkerlist = markers.data();
    numberoffacets = static_cast<int>(facets.size());
  }
  ~Input() { initialize(); }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
};

// TetGen's test of a tetrahedron, without an argument for the caller: a child has one mesh only, so this is the
// child's.
const TetgenOptions* options_of_child = nullptr;

bool is_too_large(double* a, double* b, double* c, double* d, double*, double) {
  const auto at = [](const double* p) { return mesh::Vector3(p[0], p[1], p[2]); };
  const mesh::Vector3 u = at(b) - at(a), v = at(c) - at(a), w = at(d) - at(a);
  const mesh::Vector3 center = at(a) + 0.25 * (u + v + w);
  return std::abs(u.cross(v).dot(w)) > 6 * options_of_child->max_volume_at(center);
}

void set(tetgenbehavior& to, const TetgenOptions& options) {
  // A polygonal surface; numbers from 0; neighbors; no merging of vertices or facets; quiet.
  std::string switches = "pznMQ";
  if (options.keep_surface) switches += 'Y';
  if (options.radius_edge_ratio > 0) switches += 'q';
  to.parse_commandline(switches.data());
  // Numbers by hand: they would be parsed in the program's locale.
  if (options.radius_edge_ratio > 0) to.minratio = options.radius_edge_ratio;
  if (options.max_volume > 0) {
    to.fixedvolume = 1;
    to.maxvolume = options.max_volume;
  }
  if (options.max_volume > 0 || options.max_volume_at) {
    to.quality = 1;
    if (options.radius_edge_ratio <= 0) to.minratio = std::numeric_limits<float>::max();
  }
  to.steinerleft = options.max_added;
  to.epsilon = options.tolerance;
}

void work(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
          const TetgenOptions& options, const ChildProcess::Output& output) {
  Input input(positions, triangles);
  tetgenbehavior behaviour;
  set(behaviour, options);
  if (options.max_volume_at) {
    options_of_child = &options;
    input.tetunsuitable = is_too_large;
  }
  auto* made = new tetgenio;  // ends with the process
  tetrahedralize(&behaviour, &input, made);
  const auto size = [](int count) { return static_cast<std::size_t>(count); };
  const Header header{.positions = size(made->numberofpoints),
                      .tetrahedra = size(made->numberoftetrahedra),
                      .faces = size(made->numberoftrifaces)};
  output.write_values(&header, 1);
  output.write_values(made->pointlist, 3 * header.positions);
  output.write_values(made->tetrahedronlist, 4 * header.tetrahedra);
  output.write_values(made->neighborlist, 4 * header.tetrahedra);
  output.write_values(made->trifacelist, 3 * header.faces);
  output.write_values(made->trifacemarkerlist, header.faces);
}

// TetGen throws numbers, and frees what it has again while they are on their way: they are read before that.
void tell(const ChildProcess::Output& output) {
  Header header;
  const auto known = [&] {
    try {
      throw;
    } catch (int number) {
      header.kind = number == 1 ? TetgenOutcome::Kind::out_of_memory : TetgenOutcome::Kind::refused;
      header.number = number;
    } catch (const std::bad_alloc&) {
      header.kind = TetgenOutcome::Kind::out_of_memory;
    }
  };
  base::catch_all(known, [&] { header.kind = TetgenOutcome::Kind::refused; });
  output.write_values(&header, 1);
}

}  // namespace

TetgenOutcome call_tetgen(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                          const TetgenOptions& options, const base::Host& host, TetgenMesh& result) {
  if (positions.size() > std::numeric_limits<int>::max() / 4 || triangles.size() > std::numeric_limits<int>::max() / 4)
    throw base::Error("unsupported", "more vertices or triangles than TetGen can count");
  ChildProcess child([&](const ChildProcess::Output& output) { work(positions, triangles, options, output); }, tell);
  const auto crashed = [&] {
    host.report(tetgen_call_phase, 1, 1);  // what ended the child, as Ctrl-C, may be meant for the parent as well
    const int signal = child.wait();
    if (signal == SIGKILL) return TetgenOutcome{TetgenOutcome::Kind::out_of_memory, signal};
    return TetgenOutcome{TetgenOutcome::Kind::crashed, signal};
  };
  const auto read = [&](auto& values) {
    return child.read(std::as_writable_bytes(std::span(values.data(), values.size())), host, tetgen_call_phase);
  };
  std::array<Header, 1> header;
  if (!read(header)) return crashed();
  const Header& h = header[0];
  if (h.kind != TetgenOutcome::Kind::done) return {h.kind, h.number};
  result.positions.resize(h.positions);
  result.tetrahedra.resize(h.tetrahedra);
  result.neighbors.resize(h.tetrahedra);
  result.faces.resize(h.faces);
  result.face_sources.resize(h.faces);
  if (!(read(result.positions) && read(result.tetrahedra) && read(result.neighbors) && read(result.faces) &&
        read(result.face_sources)))
    return crashed();
  for (std::int32_t& source : result.face_sources)
    --source;  // from the marker
  return {};
}

}  // namespace orbicube::tetrahedra
