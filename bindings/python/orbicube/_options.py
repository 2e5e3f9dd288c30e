"""The options of the C structs: kind, default, range or words, and what the headers say. Written by scripts/bindings.py; not
to be edited."""

from __future__ import annotations

from ._option import Option

OPTIONS: dict[str, tuple[Option, ...]] = {
    "obc_correspondence_options": (
        Option("via", "word", "sphere", words={"sphere": 0, "polycube": 1},
               doc="OBC_CORRESPONDENCE_SPHERE or POLYCUBE. Default: SPHERE."),
        Option("align", "word", "shape", words={"shape": 0, "rotation": 1, "none": 2},
               doc="OBC_CORRESPONDENCE_ALIGN_SHAPE, ROTATION or NONE; unused with a polycube. Default: SHAPE."),
        Option("grid", "word", "both",
               words={"both": 0, "first": 1, "icosphere": 2, "cube": 3, "latitude": 4, "octahedron": 5},
               doc="OBC_CORRESPONDENCE_GRID_BOTH, FIRST or a grid of the sphere. Default: BOTH."),
        Option("placement", "word", "kept", words={"kept": 0, "turned": 1, "scaled": 2},
               doc="OBC_CORRESPONDENCE_KEPT, TURNED or SCALED. Default: KEPT."),
        Option("tolerance", "float", 0.2,
               doc="maximum deviation of an edge of GRID_BOTH from a further surface, in percent of the diagonal of that "
                   "surface's bounding box; longer edges are bisected, up to three times the vertices; 0: no limit; unused "
                   "with a polycube. Default: 0.2."),
        Option("cells", "int", 0, low=0, high=18446744073709551615,
               doc="number of quads of a polycube's grid, at most 100000000; 0: the maximum triangle count of the "
                   "surfaces, 20000 to 400000. Default: 0."),
        Option("corners", "int", 0, low=0, high=18446744073709551615,
               doc="maximum number of polycube corners, at most 1000000; 0: no limit. Default: 0."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="seed of the maps. Default: 0."),
        Option("resolution", "int", 0, low=0, high=18446744073709551615,
               doc="of a grid of the sphere. Default: 0."),
    ),
    "obc_frame_field_options": (
        Option("start", "word", "auto",
               words={"auto": 0, "identity": 1, "propagated": 2, "harmonic": 3, "diffusion": 4, "given": 5},
               doc="initial field, OBC_FRAME_FIELD_AUTO or another; with DISSERTATION AUTO or IDENTITY. Default: AUTO."),
        Option("method", "word", "smooth", words={"smooth": 0, "dissertation": 1},
               doc="OBC_FRAME_FIELD_SMOOTH or DISSERTATION. Default: SMOOTH."),
        Option("weighting", "word", "uniform", words={"uniform": 0, "geometric": 1},
               doc="OBC_FRAME_FIELD_UNIFORM or GEOMETRIC. Default: UNIFORM."),
        Option("align_boundary", "bool", True,
               doc="1: an axis is exactly along the normal of each boundary face; 0: the boundary is free. Default: 1."),
        Option("rounds", "int", 2, low=0, high=4294967295,
               doc="number of improvement rounds of AUTO. Default: 2."),
        Option("feature_angle", "float", 0.0,
               doc="minimum dihedral angle, in degrees, of boundary edges that an axis follows; 0: none. Default: 0."),
        Option("relative_gain", "float", 1e-06,
               doc="smoothing ends with a step that gains less than this fraction of the energy. Default: 1e-6."),
        Option("repair", "word", "no-repair", words={"no-repair": 0, "repair": 1, "single-axis": 2},
               doc="OBC_FRAME_FIELD_NO_REPAIR, REPAIR or SINGLE_AXIS; not with DISSERTATION. Default: NO_REPAIR."),
    ),
    "obc_gltf_read_options": (
        Option("weld_identical", "bool", True,
               doc="1: welds vertices at identical positions where triangles have no indices or the surface is not closed "
                   "as stored (exporters split vertices along seams of normals and texture coordinates); 0: preserves the "
                   "vertices and their order. Default: 1."),
        Option("morph_target", "text", None,
               doc="Name of a morph target to apply with weight 1 (base + delta, added as doubles); NULL: none. Default: "
                   "NULL."),
        Option("keep", "bool", False,
               doc="1: keeps what the file has besides the surface in the handle, for obc_gltf_scene.kept and "
                   "obc_gltf_write_kept; 0: leaves it out, with a note that counts it. Default: 0."),
    ),
    "obc_gltf_scene": (
        Option("smooth_normals", "bool", False,
               doc="1: computes area-weighted normals if `normals` is NULL; 0: does not. Default: 0."),
        Option("scale", "float", 1.0,
               doc="scale of the node, positive. Default: 1."),
        Option("checker_texture", "bool", False,
               doc="1: a checker pattern of 32 by 16 squares if `texture` is NULL; 0: none. Default: 0."),
        Option("morph_normals", "bool", False,
               doc="1: stores normals of morph targets, requires normals; 0: does not. Default: 0."),
        Option("morph_seconds", "float", 0.0,
               doc="Duration, in seconds, from one shape to the next of an animation from the surface to each morph target "
                   "in turn and back; 0: no animation. Default: 0."),
    ),
    "obc_harmonics_fit_options": (
        Option("degree", "int", 16, low=0, high=4294967295,
               doc="maximum degree L, up to 1000. Default: 16."),
        Option("method", "word", "automatic", words={"automatic": 0, "dense": 1, "iterative": 2},
               doc="OBC_HARMONICS_AUTOMATIC, DENSE or ITERATIVE. Default: AUTOMATIC."),
        Option("regularization", "float", None,
               doc="Weight of the integral of the squared Laplacian of the fit, relative to the mean density of the "
                   "weights, in the objective, for samples that do not determine the fit; nonnegative. Default: 0."),
    ),
    "obc_harmonics_align_options": (
        Option("turn_values", "bool", False,
               doc="1: also rotates the values of three channels, for shapes in different poses; 0: does not. Default: 0."),
        Option("search_degree", "int", 12, low=0, high=4294967295,
               doc="degree of the search over all rotations, 1 to 64. Default: 12."),
    ),
    "obc_hexmesh_options": (
        Option("padding", "word", "auto", words={"auto": 0, "with": 1, "without": 2},
               doc="OBC_HEXMESH_PADDING_AUTO, WITH or WITHOUT. Default: AUTO."),
        Option("cells", "int", 10000, low=0, high=18446744073709551615,
               doc="approximate number of hexahedra, 1 to 10 million. Default: 10000."),
        Option("corners", "int", 100, low=0, high=18446744073709551615,
               doc="maximum number of polycube corners per boundary component, as in obc_polycube_options; 0: no limit. "
                   "Default: 100."),
        Option("triangles", "int", 6000, low=0, high=18446744073709551615,
               doc="a surface of more than twice as many triangles is mapped through a coarse one of about that many; 0: "
                   "never. Default: 6000."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="seed of random choices of the polycube. Default: 0."),
        Option("rounds", "int", 40, low=-2147483648, high=2147483647,
               doc="number of smoothing rounds, 0 to 1000. Default: 40."),
        Option("method", "word", "auto", words={"auto": 0, "polycube": 1, "grid": 2, "frames": 3},
               doc="OBC_HEXMESH_METHOD_AUTO, POLYCUBE, GRID or FRAMES. Default: AUTO."),
        Option("max_hausdorff_percent", "float", 1.0,
               doc="Maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum volume "
                   "error, in percent, 0 to 100. While it is exceeded, the cell count is doubled, up to max_cells; the "
                   "closest mesh is returned. 0 disables the check. Default: 1."),
        Option("max_cells", "int", 100000, low=0, high=18446744073709551615,
               doc="approximate maximum cell count of doubling, up to 10 million; below `cells`: no doubling. Default: "
                   "100000."),
        Option("feature_angle", "float", -1.0,
               doc="Minimum dihedral angle, in degrees, 0 to below 180, of surface edges that the mesh follows: those near "
                   "an edge of the polycube, unless hexahedra there would be bad, or those along which an axis of computed "
                   "frames lies. 0: none. -1: 35 with `features` other than OFF, where there are some; else 40, but 0 for "
                   "method FRAMES and for frames of the caller. Default: -1."),
        Option("features", "word", "machined", words={"off": 0, "auto": 1, "tags": 2, "angles": 3, "machined": 4},
               doc="OBC_HEXMESH_FEATURES_OFF, AUTO, TAGS, ANGLES or MACHINED. Default: MACHINED."),
    ),
    "obc_linear_direct_options": (
        Option("method", "word", "auto", words={"auto": 0, "eigen": 1, "cholmod-simplicial": 2, "cholmod-supernodal": 3},
               doc="Engine, OBC_LINEAR_AUTO to OBC_LINEAR_CHOLMOD_SUPERNODAL. Default: OBC_LINEAR_AUTO."),
    ),
    "obc_linear_iterative_options": (
        Option("method", "word", "auto", words={"auto": 0, "gauss-seidel": 1, "multigrid": 2},
               doc="Preconditioner, OBC_LINEAR_ITERATIVE_AUTO to OBC_LINEAR_MULTIGRID. Default: OBC_LINEAR_ITERATIVE_AUTO."),
        Option("block_size", "int", 1, low=-2147483648, high=2147483647,
               doc="Number of consecutive unknowns that form a block, as x, y, z of a point: 1, 2 or 3. Default: 1."),
        Option("max_iterations", "int", 1000, low=0, high=4294967295,
               doc="Maximum number of iterations of a solution. Default: 1000."),
        Option("tolerance", "float", 1e-08,
               doc="Requested relative residual |b - A x| / |b|, 0 to 1, exclusive. Default: 1e-8."),
    ),
    "obc_mesh_read_options": (
        Option("weld_identical", "bool", False,
               doc="1: welds vertices at identical positions if the surface is not closed as read; 0: does not. STL has no "
                   "shared vertices and is always welded. Default: 0."),
    ),
    "obc_mesh_write_options": (
        Option("binary", "bool", True,
               doc="1: PLY, STL, VTK, VTP, VTU, FreeSurfer and GIFTI in binary; 0: as text. The other formats are text. "
                   "Default: 1."),
    ),
    "obc_polycube_options": (
        Option("construction", "word", "auto", words={"auto": 0, "labels": 1, "voxels": 2, "dissertation": 3},
               doc="OBC_POLYCUBE_AUTO, LABELS, VOXELS or DISSERTATION. Default: AUTO."),
        Option("corners", "int", 0, low=0, high=18446744073709551615,
               doc="maximum number of corners, or 8 + 8 g for genus g if that is larger; 0: no limit. Of DISSERTATION the "
                   "maximum number of corner points (obc_polycube_corner_points); 0: 60. Default: 0."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="seed of random choices of LABELS. Default: 0."),
        Option("area_weight", "float", 1.0,
               doc="of DISSERTATION: weight of area relative to angle distortion (alpha of eq. 4.4), nonnegative. Default: "
                   "1."),
        Option("rounds", "int", 40, low=0, high=4294967295,
               doc="of DISSERTATION: maximum number of rounds of Algorithm 3, each of which optimizes proportions and "
                   "corner points; 0: the initial map. Default: 40."),
    ),
    "obc_polycube_domain_options": (
        Option("measure", "word", "surface-mean", words={"surface-mean": 0, "face-mean": 1, "harmonic": 2},
               doc="OBC_POLYCUBE_SURFACE_MEAN, FACE_MEAN or HARMONIC. Default: SURFACE_MEAN."),
        Option("area_weight", "float", 1.0,
               doc="weight of area relative to angle distortion, nonnegative. Default: 1."),
    ),
    "obc_polycube_corner_options": (
        Option("method", "word", "trust-region", words={"trust-region": 0, "gradient": 1},
               doc="OBC_POLYCUBE_TRUST_REGION or OBC_POLYCUBE_GRADIENT. Default: OBC_POLYCUBE_TRUST_REGION."),
        Option("area_weight", "float", 1.0,
               doc="weight of area relative to angle distortion, nonnegative. Default: 1."),
        Option("domain", "bool", False,
               doc="1: alternates with the optimization of proportions (the dissertation's Algorithm 3); 0: the polycube "
                   "is fixed. Default: 0."),
        Option("rounds", "int", 6, low=-2147483648, high=2147483647,
               doc="maximum number of rounds, at least 1. Default: 6."),
    ),
    "obc_polycube_feature_options": (
        Option("feature_angle", "float", 0.0,
               doc="minimum dihedral angle, in degrees, of surface edges that are aligned to nearby polycube edges; 0: "
                   "none. Default: 0."),
    ),
    "obc_polycube_quads_options": (
        Option("quads", "int", 10000, low=0, high=18446744073709551615,
               doc="approximate number of quads, up to 10^7, at least one a rectangle between neighboring planes. Default: "
                   "10000."),
        Option("edge_length", "float", 0.0,
               doc="edge length on the polycube, in place of `quads`; 0: by `quads`. Default: 0."),
    ),
    "obc_polycube_atlas_options": (
        Option("size", "int", 1024, low=0, high=4294967295,
               doc="number of texels along each side, 1 to 16384. Default: 1024."),
        Option("padding", "float", 4.0,
               doc="minimum distance of two patches in texels, nonnegative; half of it is left at the border. Default: 4."),
    ),
    "obc_projected_gradient_options": (
        Option("method", "word", "face", words={"face": 0, "dissertation": 1},
               doc="OBC_PROJECTED_GRADIENT_FACE or DISSERTATION. Default: FACE."),
        Option("line_search", "word", "max-of-last", words={"max-of-last": 0, "average": 1},
               doc="line search of DISSERTATION. Default: MAX_OF_LAST."),
        Option("memory", "int", 10, low=0, high=4294967295,
               doc="number of pairs in the model of FACE, 1 to 1000; 3 times as many are kept for n <= 4 memory with "
                   "bounds only. Default: 10."),
        Option("history", "int", 10, low=0, high=4294967295,
               doc="number of values that MAX_OF_LAST considers. Default: 10."),
        Option("average_weight", "float", 0.85,
               doc="eta of AVERAGE, 0 (monotone) to 1. Default: 0.85."),
        Option("gradient_tolerance", "float", 1e-08,
               doc="tolerance of |P(x - g) - x|inf, the projected gradient. Default: 1e-8."),
        Option("target", "float", float("-inf"),
               doc="ends the run at f <= target. Default: -infinity."),
        Option("max_evaluations", "int", 100000, low=0, high=18446744073709551615,
               doc="maximum number of evaluations. Default: 100000."),
        Option("max_iterations", "int", 100000, low=0, high=18446744073709551615,
               doc="maximum number of iterations. Default: 100000."),
    ),
    "obc_repair_options": (
        Option("weld", "bool", True,
               doc="1: vertices of open edges are welded; 0: not. Default: 1."),
        Option("clean", "bool", True,
               doc="1: degenerate and repeated faces and unused vertices are removed; 0: not. Default: 1."),
        Option("slivers", "bool", True,
               doc="1: near-degenerate triangles are collapsed or flipped, if clean is 1; 0: not. Default: 1."),
        Option("t_junctions", "bool", True,
               doc="1: open edges are split at vertices on them; 0: not. Default: 1."),
        Option("orient", "bool", True,
               doc="1: faces are oriented consistently and outward; 0: not. Default: 1."),
        Option("contacts", "bool", True,
               doc="1: edges of more than two faces and vertices of more than one fan are split; 0: not. Default: 1."),
        Option("drop_parts", "bool", True,
               doc="1: parts are dropped by the members below; 0: not. Default: 1."),
        Option("cavities", "bool", False,
               doc="1: parts inside an odd number of others are kept and bound cavities; 0: they are dropped. Default: 0."),
        Option("fill_holes", "bool", True,
               doc="1: boundary loops are filled; 0: not. Default: 1."),
        Option("fair", "bool", True,
               doc="1: patches of holes are refined and bent to continue the surface; 0: not. Default: 1."),
        Option("find_intersections", "bool", True,
               doc="1: the result is searched for intersecting triangles; 0: not. Default: 1."),
        Option("max_genus", "int", -1, low=-2147483648, high=2147483647,
               doc="handles and tunnels are cut, the shortest loops first, down to this genus, summed over the parts; "
                   "negative: no limit. Default: -1."),
        Option("weld_distance", "float", 0.0,
               doc="maximum distance of welded vertices; 0: the same position and, while edges are open, 1e-6 of the "
                   "diagonal of the bounding box. Default: 0."),
        Option("sliver_ratio", "float", 1e-06,
               doc="maximum height of near-degenerate triangles over their longest side, below 0.5. Default: 1e-6."),
        Option("sliver_move", "float", 0.0,
               doc="bound of the movement of the surface by their removal; 0: 1e-5 of the diagonal. Default: 0."),
        Option("t_junction_distance", "float", 0.0,
               doc="maximum distance of a vertex from the edge that it splits; 0: 1e-6 of the diagonal. Default: 0."),
        Option("contact_gap", "float", 0.0,
               doc="distance by which vertices of split contacts move into their own sheet's inner side. Default: 0."),
        Option("min_area_percent", "float", 0.0,
               doc="minimum area of a part, in percent of that of all; the largest stays. Default: 0."),
        Option("keep_parts", "int", 1, low=0, high=18446744073709551615,
               doc="number of parts to keep, the largest by area; 0: no limit. Default: 1."),
        Option("max_hole_edges", "int", 0, low=0, high=18446744073709551615,
               doc="maximum number of edges of a hole to fill; 0: no limit. Default: 0."),
        Option("max_handle_length", "float", 0.0,
               doc="maximum length of the loop of a handle or tunnel to cut; 0: no limit, and none is cut unless max_genus "
                   "is set. Default: 0."),
        Option("wrap_offset", "float", 0.0,
               doc="distance of a surface around all parts that replaces them, free of self-intersections; 0: none. "
                   "Default: 0."),
    ),
    "obc_repair_label_options": (
        Option("label", "int", 0, low=-2147483648, high=2147483647,
               doc="label whose voxels are the object; 0: the only one besides 0. Default: 0."),
        Option("cavities", "bool", False,
               doc="1: cavities are kept, as surfaces inside, if handles is 1; 0: they are filled. Default: 0."),
        Option("handles", "bool", False,
               doc="1: handles and tunnels are kept; 0: they are removed, so that each part has genus 0. Default: 0."),
        Option("keep_parts", "int", 1, low=0, high=18446744073709551615,
               doc="number of parts to keep, those with the largest number of voxels; 0: all. Default: 1."),
        Option("smoothing", "float", 1.0,
               doc="standard deviation of the Gaussian that smooths the object, in voxels, 0 to 10; 0: none. Default: 1."),
        Option("max_slide", "float", 0.45,
               doc="maximum distance of a vertex from the middle between two voxel centers, as a fraction of their "
                   "distance, below 0.5. Default: 0.45."),
    ),
    "obc_sphere_map_options": (
        Option("method", "word", "balanced",
               words={"balanced": 0, "angle-area": 1, "isometric": 2, "stretch": 3, "conformal": 4, "dissertation": 5},
               doc="OBC_SPHERE_MAP_BALANCED or another. Default: BALANCED."),
        Option("angle_weight", "float", 0.1,
               doc="weight of E_D (lambda of the dissertation's eq. 3.5), nonnegative. Default: 0.1."),
        Option("area_weight", "float", 1.0,
               doc="weight of E_A (mu of eq. 3.5), nonnegative; one of the two weights is positive. Default: 1."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="seed of the order of equally good decimation steps. Default: 0."),
        Option("level_splits", "int", 40, low=0, high=18446744073709551615,
               doc="Parameters of the dissertation's Algorithm 1, which OBC_SPHERE_MAP_DISSERTATION uses and the other "
                   "methods do not. An optimization ends when the mean gain of its last iterations (level_splits of them "
                   "on a level, vertex_count at the end) is below tolerance * E / vertices, or at its maximum number of "
                   "iterations. The dissertation prints the first default only. eta: vertex splits between two "
                   "optimizations, 1 to 1000000000. Default: 40."),
        Option("level_tolerance", "float", 0.0001,
               doc="epsilon^eta, of the optimization of a level, nonnegative; 0: no such end. Default: 1e-4."),
        Option("final_tolerance", "float", 0.0001,
               doc="epsilon^F, of the final optimization, nonnegative; 0: no such end. Default: 1e-4."),
        Option("max_level_iterations", "int", 0, low=0, high=18446744073709551615,
               doc="Iter_max^eta, on a level; 0: 50 * level_splits. Default: 0."),
        Option("max_final_iterations", "int", 0, low=0, high=18446744073709551615,
               doc="Iter_max^F, at the end; 0: 100 * vertex_count. Default: 0."),
    ),
    "obc_sphere_optimizer_options": (
        Option("method", "word", "limited-memory",
               words={"limited-memory": 0, "barzilai-borwein": 1, "great-circle": 2, "dissertation": 3, "truncated-newton": 4},
               doc="OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY or another. Default: LIMITED_MEMORY."),
        Option("memory", "int", 16, low=0, high=4294967295,
               doc="number of pairs of LIMITED_MEMORY, 1 to 1000. Default: 16."),
        Option("history", "int", 10, low=0, high=4294967295,
               doc="number of values that BARZILAI_BORWEIN considers, 1 (monotone) to 1000000. Default: 10."),
        Option("gradient_tolerance", "float", 1e-08,
               doc="tolerance of the longest tangent gradient of a block. Default: 1e-8."),
        Option("target", "float", float("-inf"),
               doc="ends the run at f <= target. Default: -infinity."),
        Option("max_evaluations", "int", 100000, low=0, high=18446744073709551615,
               doc="maximum number of evaluations. Default: 100000."),
        Option("max_iterations", "int", 100000, low=0, high=18446744073709551615,
               doc="maximum number of iterations. Default: 100000."),
        Option("starts", "int", 1, low=0, high=18446744073709551615,
               doc="number of points to start from, at least 1: x0, then random points. A run that CONVERGED, STALLED or "
                   "failed at one continues at the next; the lowest point of all is the result, and all limits are of the "
                   "whole run. Default: 1."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="of the random points. Default: 0."),
        Option("hessian_products", "bool", False,
               doc="for TRUNCATED_NEWTON, 1: requests products of the Hessian (NEED_PRODUCT), 0: evaluates gradients "
                   "nearby and computes products from differences. Default: 0."),
    ),
    "obc_sphere_optimizer_relaxation_options": (
        Option("method", "word", "great-circle", words={"great-circle": 2, "dissertation": 3},
               doc="GREAT_CIRCLE, or DISSERTATION: Algorithm 2 as printed, in the order of eq. 3.6. Default: GREAT_CIRCLE."),
        Option("second_order", "bool", False,
               doc="1: Newton steps, for which f returns Hessians; 0: first-order steps. Default: 0."),
        Option("order", "word", "automatic", words={"automatic": 0, "queue": 1, "sweeps": 2},
               doc="AUTOMATIC, QUEUE or SWEEPS. Default: AUTOMATIC."),
        Option("gradient_tolerance", "float", 1e-06,
               doc="a block with a shorter tangent gradient does not move. Default: 1e-6."),
        Option("relative_gain", "float", 0.0,
               doc="ends when a pass gains at most this fraction of the total gain. Default: 0."),
        Option("over_relaxation", "float", 0.0,
               doc="step length relative to the minimizer along the step, from 1 to below 2; 0: chosen from the rate at "
                   "which gains decrease. Default: 0."),
        Option("max_passes", "int", 10000, low=0, high=18446744073709551615,
               doc="maximum number of passes, each of `count` steps. Default: 10000."),
    ),
    "obc_tetrahedra_options": (
        Option("keep_surface", "bool", True,
               doc="1: every triangle is preserved; 0: TetGen may split edges and triangles, and, if no size is given, "
                   "inserts at most 50,000 vertices and 20 for each vertex of the surface. Default: 1."),
        Option("quality", "float", 1.4,
               doc="maximum ratio of circumradius to shortest edge, at least 1; 0: no vertices are inserted for quality. "
                   "Default: 1.4."),
        Option("max_volume", "float", 0.0,
               doc="maximum volume, in the cubed unit of the surface; 0: no limit. Default: 0."),
        Option("edge_length", "float", 0.0,
               doc="approximate length of inner edges, in the unit of the surface; 0: that of the surface. Default: 0."),
        Option("size_growth", "float", 0.3,
               doc="gradation: edge-length growth per unit distance, at least 0. Default: 0.3."),
    ),
    "obc_trust_region_options": (
        Option("method", "word", "two-radii", words={"two-radii": 0, "dissertation": 1},
               doc="OBC_TRUST_REGION_TWO_RADII or DISSERTATION. Default: TWO_RADII."),
        Option("start", "word", "automatic", words={"automatic": 0, "chain": 1, "cross": 2},
               doc="initial points, OBC_TRUST_REGION_AUTOMATIC, CHAIN or CROSS. Default: AUTOMATIC."),
        Option("points", "int", 0, low=0, high=18446744073709551615,
               doc="Maximum number of interpolation points, n + 2 to (n+1)(n+2)/2. 0: the larger of 6n + 1 and 45, with "
                   "residuals of 2n + 1 and 91, limited to the number for a full quadratic; DISSERTATION 2n + 1. Default: "
                   "0."),
        Option("radius_begin", "float", 0.0,
               doc="initial radius of steps. 0: a tenth of max(1, |x0 / scale|inf), or of 1 for a scale by boxes. Default: "
                   "0."),
        Option("radius_end", "float", 1e-08,
               doc="final resolution, about the accuracy of x / scale. Default: 1e-8."),
        Option("target", "float", float("-inf"),
               doc="ends the run at f <= target. Default: -infinity."),
        Option("noise_absolute", "float", 0.0,
               doc="the error of f is up to max(noise_absolute, noise_relative |f|). Default: 0."),
        Option("noise_relative", "float", 0.0,
               doc="see noise_absolute. Default: 0."),
        Option("restarts", "int", 0, low=0, high=18446744073709551615,
               doc="Number of restarts around the best point with another radius. At the boundary of the domain of f, and "
                   "where noise or the resolution limit ends it, a run also restarts as long as that lowers f by a "
                   "thousandth and by the noise. Default: 0."),
        Option("max_evaluations", "int", 0, low=0, high=18446744073709551615,
               doc="maximum number of evaluations; 0: 500 (n + 1). Default: 0."),
    ),
    "obc_untangle_options": (
        Option("max_steps", "int", 500, low=-2147483648, high=2147483647,
               doc="maximum number of Newton steps in each attempt, while elements are inverted. Default: 500."),
        Option("max_polish_steps", "int", 20, low=-2147483648, high=2147483647,
               doc="maximum number of further steps that lower the distortion and keep all elements positive. Default: 20."),
        Option("free_boundary", "bool", False,
               doc="1: boundary vertices move unless they are in `fixed`; 0: they are fixed where no fixed ones are given. "
                   "Default: 0."),
        Option("volume_weight", "float", 1.0,
               doc="weight of changes of volume, or of area, relative to changes of angles, positive. Default: 1."),
        Option("tolerance", "float", 0.0001,
               doc="polishing ends when a step lowers the energy by less than this fraction of it, 0 to below 1. Default: "
                   "1e-4."),
    ),
    "obc_volume_map_solid_options": (
        Option("corners", "int", 100, low=0, high=18446744073709551615,
               doc="maximum number of polycube corners per boundary component, as in obc_polycube_options; 0: no limit. "
                   "Default: 100."),
        Option("seed", "int", 0, low=0, high=18446744073709551615,
               doc="seed of random choices. Default: 0."),
    ),
    "obc_volume_map_frame_map_options": (
        Option("integer", "bool", False,
               doc="1: gaps, planes of the boundary and singular edges become integers; 0: real numbers. Default: 0."),
        Option("cell_length", "float", 0.0,
               doc="length in space of a step of 1 of the coordinates; 0: that of about 10000 cells. Default: 0."),
        Option("feature_angle", "float", 0.0,
               doc="minimum dihedral angle, in degrees, of boundary edges that computed frames follow; 0: none. Default: "
                   "0."),
    ),
}
