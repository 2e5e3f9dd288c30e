/* Orbicube: smooth octahedral frame fields on tetrahedral meshes.
 *
 * A field has one frame a tetrahedron: three orthogonal axes without signs or order, held as a unit quaternion w x y z that
 * rotates the axes of space to the frame's (active, Hamilton); the 24 quaternions q g with a rotation g of the cube stand for
 * the same frame. Smooth fields that have an axis along the normal at the boundary guide hexahedral meshing. The energy is
 * sum 1 - s0^2 over inner faces, s0 the cosine of half the angle between the frames on both sides up to those 24 rotations.
 *
 * Fields start from harmonics of degree 4 (Huang et al. 2011; Ray, Sokolov and Levy 2016), are rearranged by diffusion and
 * projection (Palmer, Bommes and Solomon 2020) and smoothed by Gauss-Newton steps on the rotations, with the frames at the
 * boundary turning about their normals only; docs/frame_field.md tells how.
 *
 * Arrays are the caller's: positions x y z a vertex (finite doubles), tetrahedra four vertices each, positive: the fourth on
 * the side that the first three look away from. frames are w x y z a tetrahedron. Nothing is kept after a call unless the
 * function says so.
 *
 * Thread safety: all functions may be called at the same time; a handle may be read by several threads. Results are the same
 * bits for any number of threads.
 */
#ifndef ORBICUBE_FRAME_FIELD_H
#define ORBICUBE_FRAME_FIELD_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A solid of tetrahedra: a view, kept by no function. */
typedef struct obc_frame_field_solid {
  const double *positions;
  size_t vertex_count;
  const uint32_t *tetrahedra;
  size_t tetrahedron_count;
} obc_frame_field_solid;

/* Where a field comes from before it is smoothed. */
enum {
  OBC_FRAME_FIELD_AUTO = 0,       /* several of these; of what they end in the best, region by region */
  OBC_FRAME_FIELD_IDENTITY = 1,   /* the axes of space */
  OBC_FRAME_FIELD_PROPAGATED = 2, /* the nearest boundary frame */
  OBC_FRAME_FIELD_HARMONIC = 3,   /* harmonics that satisfy Laplace's equation, projected */
  OBC_FRAME_FIELD_DIFFUSION = 4,  /* harmonic, then diffused and projected with falling times */
  OBC_FRAME_FIELD_GIVEN = 5       /* the field in `frames` */
};

enum {
  OBC_FRAME_FIELD_SMOOTH = 0,
  OBC_FRAME_FIELD_SEED = 1 /* identity inside, boundary frames held, matchings frozen: chapter 6 of the dissertation as printed */
};

enum {
  OBC_FRAME_FIELD_UNIFORM = 0,  /* every inner face counts alike */
  OBC_FRAME_FIELD_GEOMETRIC = 1 /* by area over the distance of the centres, scaled to mean 1 */
};

/* What is done where a field cannot be that of a hexahedral mesh. */
enum {
  OBC_FRAME_FIELD_NO_REPAIR = 0,
  /* Third and half turns are zipped apart into quarter turns (Li et al. 2012), short loops and fragments collapse, and the
   * frames around are smoothed to fit; kept where fewer edges and vertices are unmeshable. */
  OBC_FRAME_FIELD_REPAIR = 1,
  /* The search starts from identity and stays among fields whose frames turn about one axis along each curve. */
  OBC_FRAME_FIELD_SINGLE_AXIS = 2
};

/* Fill with _init. */
typedef struct obc_frame_field_options {
  uint32_t struct_size;
  int32_t start;          /* OBC_FRAME_FIELD_AUTO, ...; auto by default */
  int32_t method;         /* OBC_FRAME_FIELD_SMOOTH by default */
  int32_t weighting;      /* OBC_FRAME_FIELD_UNIFORM by default */
  int32_t align_boundary; /* 1: an axis along the normal of a boundary face, exactly; default 1 */
  uint32_t rounds;        /* of improvement by the start auto; default 2 */
  double feature_angle;   /* boundary edges that turn by more (radians) are followed by an axis; 0, the default: none */
  double relative_gain;   /* smoothing ends with a step that gains less than this part of the energy; default 1e-6 */
  int32_t repair;         /* OBC_FRAME_FIELD_NO_REPAIR, ...; none by default; not with the method seed */
  int32_t reserved;
} obc_frame_field_options;

/* What the caller asks for. Fill with _init, then set what there is. Frames and directions must be of length 1. With weights,
 * which are positive and may be infinite, those with a finite one are not held but pulled at, like by so many neighbours that
 * have what is wanted. */
typedef struct obc_frame_field_constraints {
  uint32_t struct_size;
  int32_t reserved;
  const uint32_t *frame_tetrahedra; /* tetrahedra whose frame is held */
  const double *frames;             /* w x y z each */
  size_t frame_count;
  const uint32_t *axis_tetrahedra;  /* tetrahedra of whose frame one axis is held along a direction */
  const double *axes;               /* x y z each */
  size_t axis_count;
  const double *frame_weights;      /* one each, or NULL: all are held */
  const double *axis_weights;
} obc_frame_field_constraints;

/* Figures of a field. Angles in degrees; symmetric ones are up to the 24 rotations, at most 62.80; plain ones between the
 * quaternions as they stand, at most 180. Over inner faces: mean, standard deviation, median, value at 99 per cent, largest. */
typedef struct obc_frame_field_report {
  uint32_t struct_size;
  int32_t start;              /* that most of the field comes from; of _measure 0 */
  double energy;
  double symmetric_mean, symmetric_deviation, symmetric_median, symmetric_p99, symmetric_max;
  double plain_mean, plain_deviation, plain_median, plain_p99, plain_max;
  uint64_t inner_faces, boundary_faces, above_30; /* above_30: inner faces with a greater symmetric angle */
  /* Between boundary normals and the axes nearest to them: over tetrahedra with one boundary face, and over those with
   * several, for the best and for the worst of their faces (the best is not 0 where an axis lies between two normals). */
  double one_face_max, several_best_max, several_worst_max;
  /* Edges around which the frames turn by a rotation of the cube: quarter and half turns about an axis, third turns about a
   * corner and half turns about an edge's middle, which no hexahedral mesh can have. Curves are chains of such edges through
   * inner vertices with two of them, nodes inner vertices with three or more; dead_ends is 0 for every solid. */
  uint64_t singular_edges, singular_quarter, singular_half, singular_third, singular_diagonal;
  uint64_t curves, closed_curves, nodes, boundary_ends, dead_ends;
  double singular_length, edge_length; /* of singular and of all inner edges */
  int64_t boundary_index_quarters;     /* four times the sum of the boundary cross field's indices */
  int64_t euler_characteristic;        /* of the boundary: equal to a quarter of that */
  uint64_t smoothing_steps, solver_iterations;
  /* Whether the field is that of a hexahedral mesh around every inner edge and vertex, and if not, why: edges that are no
   * quarter turns, vertices where a curve of threes becomes one of fives, nodes that no hexahedral mesh has. */
  uint64_t locally_meshable, improper_edges, turning_points, improper_nodes;
  uint64_t fragments; /* closed curves of at most six edges, and curves of one edge */
  /* With repairs: rounds, and what was there before them. The energy after them is `energy`. */
  uint64_t repair_rounds, unmeshable_before, fragments_before;
  double energy_before_repair;
} obc_frame_field_report;

/* Fill options, constraints and reports with the defaults, no constraints, and zeros. */
OBC_API obc_status obc_frame_field_options_init(obc_frame_field_options *options, size_t struct_size);
OBC_API obc_status obc_frame_field_constraints_init(obc_frame_field_constraints *constraints, size_t struct_size);
OBC_API obc_status obc_frame_field_report_init(obc_frame_field_report *report, size_t struct_size);

/* Computes a field of small energy. frames: 4 * tetrahedron_count doubles, read with the start given, and written on success
 * only. options, constraints, host and report may be NULL. O(n), at most 1 KB a tetrahedron.
 * Errors: invalid argument (NULL, NaN, index out of range, options), degenerate (a repeated vertex), not manifold (a face of
 * three tetrahedra, neighbours on the same side of a face), out of memory, cancelled. */
OBC_API obc_status obc_frame_field_compute(const obc_frame_field_solid *solid, const obc_frame_field_options *options,
                                           const obc_frame_field_constraints *constraints, const obc_host *host,
                                           double *frames, obc_frame_field_report *report, obc_error *error);

/* Figures of any field: frames, 4 * tetrahedron_count doubles, normalised before use. host may be NULL. O(n).
 * Errors: as _compute. */
OBC_API obc_status obc_frame_field_measure(const obc_frame_field_solid *solid, const double *frames, const obc_host *host,
                                           obc_frame_field_report *report, obc_error *error);

/* How the frames on both sides of the faces match: 4 * tetrahedron_count numbers, that at 4 t + k for the face of
 * tetrahedron t opposite its corner k: the rotation of the cube (its number in obc_quaternion_cube_element) that, in its own
 * axes, brings frame t next to that of the neighbour; 0 on the boundary. Errors: as _compute. O(n). */
OBC_API obc_status obc_frame_field_matchings(const obc_frame_field_solid *solid, const double *frames,
                                             const obc_host *host, uint8_t *matchings, obc_error *error);

/* ---- singular curves -------------------------------------------------------------------------------------------------- */

typedef struct obc_frame_field_singularities obc_frame_field_singularities;

/* The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
 * until _destroy. Errors: as _compute. O(n). */
OBC_API obc_status obc_frame_field_singularities_create(const obc_frame_field_solid *solid, const double *frames,
                                                        const obc_host *host, obc_frame_field_singularities **out,
                                                        obc_error *error);
OBC_API void obc_frame_field_singularities_destroy(obc_frame_field_singularities *singularities);

/* Numbers; 0 for NULL. */
OBC_API size_t obc_frame_field_singular_edge_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_singular_curve_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_singular_node_count(const obc_frame_field_singularities *singularities);

/* Copies to the caller's arrays, each of which may be NULL. Edges: two vertices each; their rotation of the cube around the
 * edge; their turn, 1 where hexahedra would meet in threes, -1 in fives, 2 for half turns, 0 where they cannot. Curves:
 * curve_begin (curve count + 1) says where each begins in curve_edges (edge count), the edges in order along it. Nodes: their
 * vertices. Errors: invalid argument. */
OBC_API obc_status obc_frame_field_singularities_copy(const obc_frame_field_singularities *singularities,
                                                      uint32_t *edge_vertices, uint8_t *edge_rotations,
                                                      int8_t *edge_turns, size_t *curve_begin, uint32_t *curve_edges,
                                                      uint32_t *nodes, obc_error *error);

/* Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
 * vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
 * is locally meshable, and for NULL. */
OBC_API size_t obc_frame_field_unmeshable_edge_count(const obc_frame_field_singularities *singularities);
OBC_API size_t obc_frame_field_unmeshable_vertex_count(const obc_frame_field_singularities *singularities);

/* Copies them to the caller's arrays, each of which may be NULL: the edges as numbers of singular edges, the vertices as
 * indices of the solid's, both ascending. Errors: invalid argument. */
OBC_API obc_status obc_frame_field_unmeshable_copy(const obc_frame_field_singularities *singularities, uint32_t *edges,
                                                   uint32_t *vertices, obc_error *error);

/* Version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_frame_field_version(void);

#ifdef __cplusplus
}
#endif

#endif
