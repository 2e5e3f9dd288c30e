// Smooth octahedral frame fields on tetrahedral meshes, and their singular curves: docs/frame_field.md.
//
// A solid is any object with `positions` and `tetrahedra` (four vertices each), as Mesh.read(...).solid has them. Frames are
// quaternions w x y z, one a tetrahedron.
import { call, make, object, options, raw, scratched, view, withHost } from './module.js';

const split = ({ onProgress, signal, ...chosen }) => [{ onProgress, signal }, chosen];

/** Runs body(scratch, address of the solid, host). */
const onSolid = ({ positions, tetrahedra }, host, body) => withHost(host, (lent) => scratched((scratch) => {
  if (positions.length % 3 !== 0 || tetrahedra.length % 4 !== 0) throw new RangeError('positions come in threes, tetrahedra in fours');
  return body(scratch, scratch.struct('obc_frame_field_solid', {
    positions: scratch.array('f64', positions, positions.length), vertex_count: positions.length / 3,
    tetrahedra: scratch.array('u32', tetrahedra, tetrahedra.length), tetrahedron_count: tetrahedra.length / 4,
  }), lent);
}));

/** What is fixed: `tetrahedra`, what each has, and weights; as members of the struct of constraints. */
function held(scratch, one, many, width, given) {
  if (!given) return {};
  const { tetrahedra, weights } = given;
  return {
    [`${one}_tetrahedra`]: scratch.array('u32', tetrahedra, tetrahedra.length),
    [many]: scratch.array('f64', given[many], width * tetrahedra.length, many), [`${one}_count`]: tetrahedra.length,
    ...(weights && { [`${one}_weights`]: scratch.array('f64', weights, tetrahedra.length, 'weights') }),
  };
}

/**
 * A field of small energy, and its figures. `startFrames` with start "given"; `heldFrames` { tetrahedra, frames, weights } and
 * `heldAxes` { tetrahedra, axes, weights } are kept. Other options: start, method, weighting, alignBoundary, rounds, featureAngle,
 * relativeGain, repair ("noRepair", "repair", "singleAxis").
 */
export function frameField(solid, given = {}) {
  const [host, { startFrames, heldFrames, heldAxes, alignBoundary, ...chosen }] = split(given);
  return onSolid(solid, host, (scratch, at, lent) => {
    const length = solid.tetrahedra.length;
    const frames = scratch.room('f64', length);
    if (startFrames) view('f64', frames, length).set(startFrames);
    else view('f64', frames, length).fill(0);
    const picked = options(scratch, 'obc_frame_field_options',
      { ...chosen, alignBoundary: alignBoundary === undefined ? undefined : Number(alignBoundary) });
    const constraints = scratch.struct('obc_frame_field_constraints',
      { ...held(scratch, 'frame', 'frames', 4, heldFrames), ...held(scratch, 'axis', 'axes', 3, heldAxes) });
    const report = scratch.struct('obc_frame_field_report');
    call('obc_frame_field_compute', at, picked, constraints, lent, frames, report);
    return { frames: view('f64', frames, length).slice(), report: object('obc_frame_field_report', report) };
  });
}

const framesAt = (scratch, solid, frames) => scratch.array('f64', frames, solid.tetrahedra.length, 'frames');

/** Figures of any field. */
export const measureFrames = (solid, frames, host = {}) => onSolid(solid, host, (scratch, at, lent) => {
  const report = scratch.struct('obc_frame_field_report');
  call('obc_frame_field_measure', at, framesAt(scratch, solid, frames), lent, report);
  return object('obc_frame_field_report', report);
});

/** For each tetrahedron and corner, the rotation of the cube across the face opposite. */
export const matchings = (solid, frames, host = {}) => onSolid(solid, host, (scratch, at, lent) => {
  const found = scratch.bytes(solid.tetrahedra.length);
  call('obc_frame_field_matchings', at, framesAt(scratch, solid, frames), lent, found);
  return view('u8', found, solid.tetrahedra.length).slice();
});

/**
 * Singular edges (two vertices each) with their rotation of the cube and their turn (1 where hexahedra would meet in threes, -1 in
 * fives), the curves that they form (numbers of edges in order), nodes (vertices), and where no hexahedral mesh has such a field.
 */
export const singularities = (solid, frames, host = {}) => onSolid(solid, host, (scratch, at, lent) => {
  const handle = make('obc_frame_field_singularities_create', at, framesAt(scratch, solid, frames), lent);
  try {
    const count = (of) => raw(`obc_frame_field_${of}_count`, handle);
    const [edgeCount, curveCount, nodeCount] = ['singular_edge', 'singular_curve', 'singular_node'].map(count);
    const rooms = {
      edges: [scratch.room('u32', 2 * edgeCount), 'u32', 2 * edgeCount], rotations: [scratch.bytes(edgeCount), 'u8', edgeCount],
      turns: [scratch.bytes(edgeCount), 'u8', edgeCount], begin: [scratch.room('u32', curveCount + 1), 'u32', curveCount + 1],
      along: [scratch.room('u32', edgeCount), 'u32', edgeCount], nodes: [scratch.room('u32', nodeCount), 'u32', nodeCount],
      unmeshableEdges: [scratch.room('u32', count('unmeshable_edge')), 'u32', count('unmeshable_edge')],
      unmeshableVertices: [scratch.room('u32', count('unmeshable_vertex')), 'u32', count('unmeshable_vertex')],
    };
    const { unmeshableEdges, unmeshableVertices, ...others } = rooms;
    call('obc_frame_field_singularities_copy', handle, ...Object.values(others).map(([address]) => address));
    call('obc_frame_field_unmeshable_copy', handle, unmeshableEdges[0], unmeshableVertices[0]);
    const { begin, along, turns, ...found } =
      Object.fromEntries(Object.entries(rooms).map(([name, [address, type, length]]) => [name, view(type, address, length).slice()]));
    return { ...found, turns: new Int8Array(turns.buffer),
      curves: Array.from({ length: curveCount }, (_, i) => along.slice(begin[i], begin[i + 1])) };
  } finally {
    raw('obc_frame_field_singularities_destroy', handle);
  }
});
