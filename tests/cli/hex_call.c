/* hex_call IN OUT CELLS: one call of the library, for a comparison with `orbicube hex IN -o OUT --cells CELLS`. */
#include <orbicube/hexmesh.h>
#include <orbicube/tetrahedra.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(const obc_error* error) {
  fprintf(stderr, "%s: %s\n", error->kind, error->message);
  return EXIT_FAILURE;
}

static obc_status compute(const obc_mesh* input, const obc_hexmesh_options* options, obc_hexmesh_report* report,
                          obc_hexmesh** hexes, obc_error* error) {
  const size_t n = obc_mesh_vertex_count(input), m = obc_mesh_tetrahedron_count(input);
  obc_surface surface;
  obc_status status;
  double* positions;
  uint32_t* tetrahedra;
  if (m == 0) {
    status = obc_mesh_surface(input, &surface, error);
    return status != OBC_OK ? status : obc_hexmesh_compute(&surface, options, NULL, report, hexes, error);
  }
  positions = malloc(3 * n * sizeof *positions);
  tetrahedra = malloc(4 * m * sizeof *tetrahedra);
  if (positions == NULL || tetrahedra == NULL) exit(EXIT_FAILURE);
  status = obc_mesh_copy(input, positions, NULL, tetrahedra, NULL, error);
  if (status == OBC_OK)
    status = obc_hexmesh_compute_solid(positions, n, tetrahedra, m, NULL, options, NULL, report, hexes, error);
  free(positions);
  free(tetrahedra);
  return status;
}

int main(int argc, char** argv) {
  obc_mesh *input = NULL, *output = NULL;
  obc_hexmesh_options options;
  obc_hexmesh_report report;
  obc_hexmesh* hexes = NULL;
  obc_mesh_cells cells;
  obc_error error;
  double* positions;
  uint32_t* hexahedra;
  if (argc != 4) return EXIT_FAILURE;
  if (obc_mesh_read(argv[1], NULL, NULL, &input, &error) != OBC_OK) return failed(&error);
  obc_hexmesh_options_init(&options, sizeof options);
  options.cells = strtoul(argv[3], NULL, 10);
  options.fill = obc_tetrahedra_fill_mesh;
  report.struct_size = sizeof report;
  if (compute(input, &options, &report, &hexes, &error) != OBC_OK) return failed(&error);
  obc_mesh_cells_init(&cells, sizeof cells);
  cells.vertex_count = obc_hexmesh_vertex_count(hexes);
  cells.hexahedron_count = obc_hexmesh_count(hexes);
  positions = malloc(3 * cells.vertex_count * sizeof *positions);
  hexahedra = malloc(8 * cells.hexahedron_count * sizeof *hexahedra);
  if (positions == NULL || hexahedra == NULL) return EXIT_FAILURE;
  if (obc_hexmesh_copy(hexes, positions, hexahedra, NULL, NULL, &error) != OBC_OK) return failed(&error);
  cells.positions = positions;
  cells.hexahedra = hexahedra;
  if (obc_mesh_create(&cells, NULL, &output, &error) != OBC_OK) return failed(&error);
  if (obc_mesh_write(argv[2], output, NULL, NULL, &error) != OBC_OK) return failed(&error);
  printf("%d %.17g\n", (int)report.method, report.min_scaled_jacobian);
  free(positions);
  free(hexahedra);
  obc_mesh_destroy(output);
  obc_hexmesh_destroy(hexes);
  obc_mesh_destroy(input);
  return EXIT_SUCCESS;
}
