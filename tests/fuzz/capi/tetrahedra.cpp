// Surfaces, closed or not, filled with tetrahedra.
#include "orbicube/tetrahedra.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape shape = surface(in);
  const obc_surface given = shape.surface();
  std::uint32_t pairs[8];
  std::size_t count = 0;
  ok([&](obc_error* e) { return obc_tetrahedra_check_surface(&given, host.c(), pairs, 4, &count, e); });
  require(count == 0 || pairs[0] < shape.cell_count(), "a triangle that does not exist");
  obc_tetrahedra_options options;
  obc_tetrahedra_options_init(&options, sizeof options);
  const auto places = in.moderates(6), lengths = in.numbers(2);
  if (in.one_in(2)) {
    options.keep_surface = in.choice(2);
    options.quality = in.one_in(2) ? in.number() : 0;
    if (in.one_in(3)) options.max_volume = in.number();
    if (in.one_in(3)) options.edge_length = in.number();
    if (in.one_in(3)) {
      options.size_positions = places.data();
      options.size_lengths = lengths.data();
      options.size_count = 2;
      options.size_growth = in.number();
    }
    // Not millions of tetrahedra: that is the request, but an input must end.
    for (double* length : {&options.max_volume, &options.edge_length}) {
      if (*length > 0 && *length < 0.2) *length = 0.2;
    }
    if (options.size_count > 0 && (lengths[0] < 0.2 || lengths[1] < 0.2)) options.size_count = 0;
    if (options.quality > 0 && options.quality < 1.4 && options.quality >= 1) options.quality = 1.4;
  }
  obc_tetrahedra* solid = nullptr;
  if (!ok([&](obc_error* e) { return obc_tetrahedra_fill(&given, &options, host.c(), &solid, e); })) return 0;
  const std::size_t vertices = obc_tetrahedra_vertex_count(solid);
  std::vector<double> positions(3 * vertices);
  std::vector<std::uint32_t> cells(4 * obc_tetrahedra_count(solid)), boundary(3 * obc_tetrahedra_boundary_count(solid)),
      source(boundary.size() / 3);
  require(ok([&](obc_error* e) {
            return obc_tetrahedra_copy(solid, positions.data(), cells.data(), boundary.data(), source.data(), e);
          }),
          "a solid cannot be copied");
  require_finite(positions, "a position that is not finite");
  require_below(cells, vertices, "a tetrahedron with a vertex that does not exist");
  require_below(boundary, vertices, "a boundary triangle with a vertex that does not exist");
  require_below(source, shape.cell_count(), "a boundary triangle from nowhere");
  require(!cells.empty(), "a solid of nothing");
  obc_tetrahedra_destroy(solid);
  return 0;
}
