/* Orbicube frame field: smooth octahedral frame fields on tetrahedral meshes, and their singular curves.
 *
 * A field has one frame a tetrahedron: three orthogonal axes without signs or order, represented by a unit quaternion w x y z that
 * rotates the coordinate axes to those of the frame (active, Hamilton). The 24 quaternions q g with a rotation g of the cube represent
 * the same frame. Smooth fields with an axis along the boundary normal guide hexahedral meshing. The energy is the sum of 1 - s0^2
 * over inner faces, s0 the cosine of half the angle between the frames on both sides up to these 24 rotations.
 *
 * Method. Fields start from harmonics of degree 4 (Huang et al. 2011; Ray, Sokolov and Levy 2016), are improved by diffusion and
 * projection (Palmer, Bommes and Solomon 2020) and smoothed by Gauss-Newton steps on the rotations, in which boundary frames rotate
 * about their normals only; see docs/frame_field.md.
 *
 * Arrays are the caller's: positions x y z a vertex (finite doubles), tetrahedra four vertices each with positive volume, frames w x y z
 * a tetrahedron. No function keeps an array unless its description says so.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one handle. Results are the same bits for
 * any number of threads.
 *
 * Example: computes the field of two tetrahedra.
 *
 *   #include <orbicube/frame_field.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const double positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
 *     const uint32_t tetrahedra[] = {0, 1, 2, 3, 1, 2, 3, 4};
 *     const obc_frame_field_solid solid = {positions, 5, tetrahedra, 2};
 *     double frames[8];
 *     obc_error error;
 *     if (obc_frame_field_compute(&solid, NULL, NULL, NULL, frames, NULL, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%g %g %g %g\n", frames[0], frames[1], frames[2], frames[3]);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_FRAME_FIELD_H
#define ORBICUBE_FRAME_FIELD_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- solid and options ----------------------------------------------------------------------------------------------- */

/* A tetrahedral mesh: a view of arrays of the caller. */
typedef struct obc_frame_field_solid {
  const double *positions;    /* x y z a vertex */
  size_t vertex_count;        /* number of vertices */
  const uint32_t *tetrahedra; /* four vertices each, with positive volume */
  size_t tetrahedron_count;   /* number of tetrahedra */
} obc_frame_field_solid;

/* Initial fields. */
enum {
  OBC_FRAME_FIELD_AUTO = 0,       /* several of these, with the best of their results in each region */
  OBC_FRAME_FIELD_IDENTITY = 1,   /* the coordinate axes */
  OBC_FRAME_FIELD_PROPAGATED = 2, /* the nearest boundary frame */
  OBC_FRAME_FIELD_HARMONIC = 3,   /* harmonics that satisfy Laplace's equation, projected */
  OBC_FRAME_FIELD_DIFFUSION = 4,  /* HARMONIC, then diffused and projected with decreasing times */
  OBC_FRAME_FIELD_GIVEN = 5       /* the field in `frames` */
};

/* Methods. */
enum {
  OBC_FRAME_FIELD_SMOOTH = 0, /* as described at the top */
  OBC_FRAME_FIELD_DISSERTATION = 1    /* chapter 6 of the dissertation: identity inside, fixed boundary frames; matchings rounded first, not last */
};

/* Weights of inner faces in the energy. */
enum {
  OBC_FRAME_FIELD_UNIFORM = 0,  /* 1 */
  OBC_FRAME_FIELD_GEOMETRIC = 1 /* area over the distance of the centers, scaled to mean 1 */
};

/* Repairs of a field that no hexahedral mesh can follow. */
enum {
  OBC_FRAME_FIELD_NO_REPAIR = 0, /* none */

  /* Third and half turns are split into quarter turns (Li et al. 2012), short loops and fragments collapse, and the frames
   * around them are smoothed; the result is accepted if fewer edges and vertices are unmeshable. */
  OBC_FRAME_FIELD_REPAIR = 1,

  /* The search starts from IDENTITY and is restricted to fields whose frames rotate about one axis along each curve. */
  OBC_FRAME_FIELD_SINGLE_AXIS = 2
};

/* Options of a field. Fill with _init. */
typedef struct obc_frame_field_options {
  uint32_t struct_size;

  int32_t start;          /* initial field, OBC_FRAME_FIELD_AUTO or another; with DISSERTATION AUTO or IDENTITY. Default: AUTO. */
  int32_t method;         /* OBC_FRAME_FIELD_SMOOTH or DISSERTATION. Default: SMOOTH. */
  int32_t weighting;      /* OBC_FRAME_FIELD_UNIFORM or GEOMETRIC. Default: UNIFORM. */
  int32_t align_boundary; /* 1: an axis is exactly along the normal of each boundary face; 0: the boundary is free. Default: 1. */
  uint32_t rounds;        /* number of improvement rounds of AUTO. Default: 2. */
  double feature_angle;   /* minimum dihedral angle, in degrees, of boundary edges that an axis follows; 0: none. Default: 0. */
  double relative_gain;   /* smoothing ends with a step that gains less than this fraction of the energy. Default: 1e-6. */
  int32_t repair;         /* OBC_FRAME_FIELD_NO_REPAIR, REPAIR or SINGLE_AXIS; not with DISSERTATION. Default: NO_REPAIR. */
  int32_t reserved;
} obc_frame_field_options;

/* Constraints of a field. Frames and directions have length 1. A positive, possibly infinite weight may soften each constraint: a finite
 * weight w acts like w neighbors with the required frame, an infinite one fixes it. Fill with _init. */
typedef struct obc_frame_field_constraints {
  uint32_t struct_size;
  int32_t reserved;

  const uint32_t *frame_tetrahedra; /* tetrahedra with a fixed frame. Default: NULL. */
  const double *frames;             /* the frames, w x y z each. Default: NULL. */
  size_t frame_count;               /* number of fixed frames. Default: 0. */

  const uint32_t *axis_tetrahedra; /* tetrahedra with one axis fixed along a direction. Default: NULL. */
  const double *axes;              /* the directions, x y z each. Default: NULL. */
  size_t axis_count;               /* number of fixed axes. Default: 0. */

  const double *frame_weights; /* weight of each frame; NULL: all infinite. Default: NULL. */
  const double *axis_weights;  /* weight of each axis; NULL: all infinite. Default: NULL. */
} obc_frame_field_constraints;

/* Figures of a field. Angles are in degrees, over inner faces: mean, standard deviation, median, 99th percentile, maximum. */
typedef struct obc_frame_field_report {
  uint32_t struct_size;
  int32_t start; /* initial field of most of the result; 0 for _measure */
  double energy; /* energy of the field */

  double symmetric_mean, symmetric_deviation, symmetric_median, symmetric_p99, symmetric_max; /* up to the 24 rotations, at most 62.80 */
  double plain_mean, plain_deviation, plain_median, plain_p99, plain_max; /* between the quaternions, at most 180 */
  uint64_t inner_faces, boundary_faces, above_30; /* numbers of faces; of inner faces with a symmetric angle above 30 */

  /* Maximum angle between a boundary normal and the nearest axis: over tetrahedra with one boundary face, and over those with several
   * for the best and the worst of their faces (the best is not 0 for an axis between two normals). */
  double one_face_max, several_best_max, several_worst_max;

  /* Numbers of singular edges, around which the frames turn by a rotation of the cube: all, quarter and half turns about an axis,
   * third turns about a space diagonal and half turns about a face diagonal; no hexahedral mesh has the latter two. */
  uint64_t singular_edges, singular_quarter, singular_half, singular_third, singular_diagonal;

  /* Numbers of curves (chains of singular edges through inner vertices with two of them), of closed ones, of nodes (inner vertices with
   * three or more singular edges), of ends on the boundary, and of ends inside, which is 0 for every solid. */
  uint64_t curves, closed_curves, nodes, boundary_ends, dead_ends;

  double singular_length, edge_length; /* total length of singular edges and of all inner edges */
  int64_t boundary_index_quarters;     /* four times the index sum of the boundary cross field */
  int64_t euler_characteristic;        /* of the boundary: a quarter of boundary_index_quarters */
  uint64_t smoothing_steps, solver_iterations; /* numbers of smoothing steps and of iterations of linear solvers */

  /* 1 if a hexahedral mesh could have the field around every inner edge and vertex, otherwise 0; numbers of edges that are not
   * quarter turns, of vertices at which a curve of valence 3 becomes one of valence 5, and of nodes that no hexahedral mesh has. */
  uint64_t locally_meshable, improper_edges, turning_points, improper_nodes;

  uint64_t fragments; /* number of closed curves of up to six edges, and of curves of one edge */

  uint64_t repair_rounds, unmeshable_before, fragments_before; /* with repairs: number of rounds, and counts before them */
  double energy_before_repair;                                 /* with repairs: energy before them */
} obc_frame_field_report;

/* Fill options with the defaults, constraints with none, and a report with zeros. */
OBC_API obc_status obc_frame_field_options_init(obc_frame_field_options *options, size_t struct_size);
OBC_API obc_status obc_frame_field_constraints_init(obc_frame_field_constraints *constraints, size_t struct_size);
OBC_API obc_status obc_frame_field_report_init(obc_frame_field_report *report, size_t struct_size);

/* ---- fields ---------------------------------------------------------------------------------------------------------- */

/* Computes a field of low energy. frames: 4 * tetrahedron_count doubles, read for OBC_FRAME_FIELD_GIVEN, and written on success only.
 * options, constraints, host and report may be NULL. O(n), up to 1 KB a tetrahedron. Errors: invalid argument (NULL, NaN, index out
 * of range, options), degenerate (a repeated vertex), not manifold (a face with three tetrahedra, neighbors on the same side of a
 * face), out of memory, cancelled. */
OBC_API obc_status obc_frame_field_compute(const obc_frame_field_solid *solid, const obc_frame_field_options *options,
                                           const obc_frame_field_constraints *constraints, const obc_host *host,
                                           double *frames, obc_frame_field_report *report, obc_error *error);

/* Measures any field: frames, 4 * tetrahedron_count doubles, normalized before use. host may be NULL. O(n). Errors: as _compute. */
OBC_API obc_status obc_frame_field_measure(const obc_frame_field_solid *solid, const double *frames, const obc_host *host,
                                           obc_frame_field_report *report, obc_error *error);

/* Computes the matching of each face: 4 * tetrahedron_count numbers, entry 4 t + k for the face of tetrahedron t opposite its vertex k. It
 * is the rotation of the cube (numbered as in obc_quaternion_cube_element) that, in its own axes, brings frame t nearest to that of the
 * neighbor; 0 on the boundary. O(n). Errors: as _compute. */
OBC_API obc_status obc_frame_field_matchings(const obc_frame_field_solid *solid, const double *frames,
                                             const obc_host *host, uint8_t *matchings, obc_error *error);

/* ---- singular curves ------------------------------------------------------------------------------------------------- */

/* Singular edges of a field and the curves they form. */
typedef struct obc_frame_field_singularities obc_frame_field_singularities;

/* Finds the singular edges and curves of a field. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: as
 * _compute. */
OBC_API obc_status obc_frame_field_singularities_create(const obc_frame_field_solid *solid, const double *frames,
                                                        const obc_host *host, obc_frame_field_singularities **out,
                                                        obc_error *error);

/* Destroys the singularities; NULL is allowed. */
OBC_API void obc_frame_field_singularities_destroy(obc_frame_field_singularities *singularities);

/* Return the numbers of singular edges, curves and nodes; 0 for NULL. */
OBC_API size_t obc_frame_field_singular_edge_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_singular_curve_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_singular_node_count(const obc_frame_field_singularities *singularities);

/* Copies to arrays of the caller, each of which may be NULL: for each edge two vertices, the rotation of the cube around it, and its
 * turn: 1 for valence 3 of a hexahedral mesh, -1 for valence 5, 2 for a half turn, 0 where no hexahedral mesh exists. curve_begin (curve
 * count + 1) are offsets of the curves into curve_edges (edge count), the edges in order along each. nodes are vertices. Errors:
 * invalid argument. */
OBC_API obc_status obc_frame_field_singularities_copy(const obc_frame_field_singularities *singularities,
                                                      uint32_t *edge_vertices, uint8_t *edge_rotations,
                                                      int8_t *edge_turns, size_t *curve_begin, uint32_t *curve_edges,
                                                      uint32_t *nodes, obc_error *error);

/* Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
 * singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL. */
OBC_API size_t obc_frame_field_unmeshable_edge_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_unmeshable_vertex_count(const obc_frame_field_singularities *singularities);

/* Copies the unmeshable elements to arrays of the caller, each of which may be NULL: edges as indices of singular edges, vertices as
 * indices of the solid, both ascending. Errors: invalid argument. */
OBC_API obc_status obc_frame_field_unmeshable_copy(const obc_frame_field_singularities *singularities, uint32_t *edges,
                                                   uint32_t *vertices, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_frame_field_version(void);

#ifdef __cplusplus
}
#endif

#endif
