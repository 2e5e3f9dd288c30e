import type { RawFunctions } from './raw/raw.js';
export { OrbicubeWorker } from './client.js';

/** Fulfilled once the module can be used; nothing else can be used before. */
export const ready: Promise<void>;

/** What a library could not do. */
export class OrbicubeError extends Error {
  /** A word as "not-closed". */
  readonly kind: string;
  /** That of C, negative. */
  readonly status: number;
}

/** Throw it in a function that a solver calls where it has no value. */
export class EvaluationFailed extends Error {}
/** Throw it in a function that a solver calls to end the run; a value, or residuals, at x count. */
export class StopRun extends Error {
  constructor(message?: string, told?: { value?: number | ArrayLike<number> });
  value?: number | ArrayLike<number>;
}

export type Numbers = ArrayLike<number>;

export interface Progress {
  phase: string;
  done: number;
  /** 0 where it is not known. */
  total: number;
  /** Of the objective so far, NaN where there is none. */
  best: number;
}

/** What a computation is lent. */
export interface Host {
  /** Return false to cancel. */
  onProgress?: (at: Progress) => boolean | void;
  signal?: AbortSignal;
}

// ---- solvers ---------------------------------------------------------------------------------------------------------------

export interface RunResult {
  x: Float64Array;
  value: number;
  /** Why it ended, as "converged". */
  stop: string;
  converged: boolean;
  evaluations: number;
  /** All members of the result of C, in camel case. */
  report: Record<string, number>;
}

declare class Run {
  readonly result: RunResult;
  /** Bytes from which load() goes on to the same bits. */
  save(): Uint8Array;
  close(): void;
}

/** One number for all unknowns, or one each. */
export type Each = number | Numbers;

export interface TrustRegionProblem {
  residuals?: number;
  lower?: Each;
  upper?: Each;
  scale?: Each;
  sign?: Each;
}

export interface TrustRegionOptions extends TrustRegionProblem {
  method?: 'twoRadii' | 'dissertation';
  start?: 'automatic' | 'chain' | 'cross';
  points?: number;
  radiusBegin?: number;
  radiusEnd?: number;
  target?: number;
  noiseAbsolute?: number;
  noiseRelative?: number;
  restarts?: number;
  maxEvaluations?: number;
}

export class TrustRegion extends Run {
  constructor(x0: Numbers, options?: TrustRegionOptions);
  static load(saved: Uint8Array, x0: Numbers, problem?: TrustRegionProblem): TrustRegion;
  ask(): Float64Array | null;
  askAll(): Float64Array[] | null;
  tell(outputs: number | Numbers | null): void;
  give(points: Numbers[], outputs: number[] | number[][]): void;
  run(f: (x: Float64Array) => number | Numbers, host?: Host): RunResult;
}

export namespace trustRegion {
  function minimize(f: (x: Float64Array) => number, x0: Numbers, options?: TrustRegionOptions & Host): RunResult;
  function leastSquares(f: (x: Float64Array) => Numbers, x0: Numbers, count: number, options?: TrustRegionOptions & Host): RunResult;
}

/** Writes the gradient and returns the value. */
export type WithGradient = (x: Float64Array, gradient: Float64Array) => number;

export interface ProjectedGradientProblem {
  lower?: Each;
  upper?: Each;
  /** Rows of linear equations A x = b. */
  A?: Numbers[];
  b?: Numbers;
}

export interface ProjectedGradientOptions extends ProjectedGradientProblem {
  method?: 'face' | 'dissertation';
  lineSearch?: 'maxOfLast' | 'average';
  memory?: number;
  history?: number;
  averageWeight?: number;
  gradientTolerance?: number;
  target?: number;
  maxEvaluations?: number;
  maxIterations?: number;
}

export class ProjectedGradient extends Run {
  constructor(x0: Numbers, options?: ProjectedGradientOptions);
  static load(saved: Uint8Array, x0: Numbers, problem?: ProjectedGradientProblem): ProjectedGradient;
  readonly multipliers: Float64Array;
  ask(): Float64Array | null;
  tell(value: number, gradient?: Numbers): void;
  run(f: WithGradient, host?: Host): RunResult;
}

export namespace projectedGradient {
  function minimize(f: WithGradient, x0: Numbers, options?: ProjectedGradientOptions & Host): RunResult;
  function project(y: Numbers, problem: ProjectedGradientProblem): { x: Float64Array; stop: string; report: Record<string, number> };
}

export interface SphereOptimizerOptions {
  /** Numbers of a unit vector, 3 if it is not said. */
  dimension?: number;
  method?: 'limitedMemory' | 'barzilaiBorwein' | 'greatCircle' | 'dissertation' | 'truncatedNewton';
  memory?: number;
  history?: number;
  gradientTolerance?: number;
  target?: number;
  maxEvaluations?: number;
  maxIterations?: number;
  starts?: number;
  seed?: number;
  hessianProducts?: boolean;
}

/** Writes the product of the Hessian at x, as a function of all numbers of x, and a direction. */
export type HessianProduct = (x: Float64Array, direction: Float64Array, product: Float64Array) => void;

export class SphereOptimizer extends Run {
  constructor(x0: Numbers, options?: SphereOptimizerOptions);
  static load(saved: Uint8Array, x0: Numbers): SphereOptimizer;
  /** The vector whose product with the Hessian is requested; null where value and gradient are. */
  readonly direction: Float64Array | null;
  ask(): Float64Array | null;
  tell(value: number, gradient?: Numbers): void;
  tellProduct(product: Numbers | null): void;
  run(f: WithGradient, host?: Host & { hessianProduct?: HessianProduct }): RunResult;
}

export namespace sphereOptimizer {
  function minimize(f: WithGradient, x0: Numbers, options?: SphereOptimizerOptions & { hessianProduct?: HessianProduct } & Host): RunResult;
}

// ---- surfaces --------------------------------------------------------------------------------------------------------------

/** x y z a vertex, and three vertices a triangle, counter-clockwise seen from outside. */
export interface Surface {
  positions: Float64Array;
  triangles: Uint32Array;
}

export type SurfaceLike = Mesh | { positions: Numbers; triangles: Numbers };
/** A `format` of formats(). */
export type Format = string;

export class Mesh implements Surface {
  private constructor();
  static read(bytes: Uint8Array | ArrayBuffer, format: Format, options?: { weldIdentical?: boolean } & Host): Mesh;
  static make(shape: string, triangles: number, options?: { seed?: number } & Host): Mesh;
  static from(surface: { positions: Numbers; triangles: Numbers; regions?: Numbers | null }): Mesh;
  static readonly shapes: string[];
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** A view of the library's memory, which ends when that memory grows. */
  readonly positions: Float64Array;
  readonly triangles: Uint32Array;
  /** The number of the region of each triangle, 0 for none, as a copy; null if there are none. */
  readonly regions: Int32Array | null;
  /** Copies that stay. */
  readonly arrays: Surface;
  readonly tetrahedronCount: number;
  readonly solid: Solid;
  readonly format: string;
  readonly notes: string[];
  close(): void;
}

/** The formats of files: `format` for Mesh.read, the `ending`, and whether files hold polygons, cells, binary contents and regions. */
export function formats(): { format: Format; ending: string; polygons: boolean; cells: boolean; binary: boolean; regions: boolean }[];
/** The format that the name of a file requires. */
export function formatOf(name: string): Format;
export function writeMesh(surface: SurfaceLike, ending: string, options?: { binary?: boolean } & Host): Uint8Array;
export function vertexNormals(surface: SurfaceLike, host?: Host): Float64Array;
export function vertexAreas(surface: SurfaceLike, host?: Host): Float64Array;
export function meanDistance(a: Numbers, b: Numbers, host?: Host): number;
export function topology(surface: SurfaceLike, host?: Host): Record<string, number> & { low: number[]; high: number[] };
export function checkClosedGenusZero(surface: SurfaceLike, host?: Host): void;
export function orient(surface: { positions: Numbers; triangles: Numbers }, host?: Host): Uint32Array;

/** An array in the module's memory, which calls take without a copy. */
export class HeapArray<Type extends 'float64' | 'float32' | 'uint32' | 'uint8' = 'float64'> {
  constructor(type: Type, length: number);
  readonly length: number;
  readonly array: { float64: Float64Array; float32: Float32Array; uint32: Uint32Array; uint8: Uint8Array }[Type];
  close(): void;
}

// ---- maps ------------------------------------------------------------------------------------------------------------------

export interface SphereMapOptions {
  method?: 'balanced' | 'angleArea' | 'isometric' | 'stretch' | 'conformal' | 'dissertation';
  angleWeight?: number;
  areaWeight?: number;
  seed?: number;
  /** Of the method `dissertation`, as the next four. */
  levelSplits?: number;
  levelTolerance?: number;
  finalTolerance?: number;
  maxLevelIterations?: number;
  maxFinalIterations?: number;
}

export interface SphereMapReport {
  bijective: number;
  mirrored: number;
  flipped: number;
  degenerate: number;
  zeroAreaFaces: number;
  degree: number;
  energyAngle: number;
  energyArea: number;
  energy: number;
  maxQuasiConformal: number;
  meanQuasiConformal: number;
  minAreaRatio: number;
  maxAreaRatio: number;
  stretchEfficiency: number;
  isometricMean: number;
  equation31: number;
  equation32: number;
  equation33: number;
  equation34: number;
}

export interface SphereMapResult {
  /** Unit vectors in the order of the vertices. */
  directions: Float64Array;
  report: SphereMapReport;
}

export function sphereMap(surface: SurfaceLike, options?: SphereMapOptions & Host & { out?: Float64Array }): SphereMapResult;
export function measure(surface: SurfaceLike, directions: Numbers, options?: SphereMapOptions & Host): SphereMapReport;
export function faceDistortion(surface: SurfaceLike, directions: Numbers, host?: Host): { quasiConformal: Float64Array; areaRatio: Float64Array };
export function roundToFloat(surface: SurfaceLike, directions: Numbers, host?: Host): Float32Array;
export function bestRotation(from: Numbers, to: Numbers): Float64Array;

export type Grid = 'icosphere' | 'cube' | 'latitude' | 'octahedron';
export function grid(kind: Grid, resolution: number, host?: Host): Mesh;

export class Locator {
  constructor(surface: SurfaceLike, directions: Numbers, host?: Host);
  locate(directions: Numbers, host?: Host): { triangles: Uint32Array; weights: Float64Array };
  sample(directions: Numbers, values: Numbers, options?: { unit?: boolean } & Host): Float64Array;
  remesh(positions: Numbers, grid: Grid, resolution: number, host?: Host): Mesh;
  close(): void;
}

export function overlay(first: SurfaceLike, firstDirections: Numbers, second: SurfaceLike, secondDirections: Numbers, host?: Host):
  { mesh: Mesh; secondVertex: Uint32Array };

export interface PolycubeOptions {
  construction?: 'auto' | 'labels' | 'voxels';
  /** Maximum; 0: no limit. */
  corners?: number;
  seed?: number;
}

export interface DomainOptions {
  measure?: 'surfaceMean' | 'faceMean' | 'harmonic';
  areaWeight?: number;
}

export interface AtlasOptions {
  /** Texels along each side, up to 16384. */
  size?: number;
  /** Minimum distance of two patches in texels. */
  padding?: number;
}

export class Atlas {
  private constructor();
  /** Texels along each side. */
  readonly size: number;
  /** u and v of the three corners of each triangle, 0 to 1, from the top left. */
  readonly coordinates: Float64Array;
  /** Texels along a unit of the polycube. */
  readonly texelsPerUnit: number;
  /** The fraction of the square in patches. */
  readonly coverage: number;
  /** What each texel shows, row by row from the top: a triangle of the map (0xFFFFFFFF: none), the weights of its three corners, and
   *  whether it has the middle of the texel (1); others show the nearest texel in a patch. */
  sample(host?: Host): { triangles: Uint32Array; weights: Float64Array; covered: Uint8Array };
  close(): void;
}

export class Polycube {
  private constructor();
  readonly corners: number;
  readonly patches: number;
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly arrays: Surface & { polycube: Float64Array };
  readonly triangleParts: { labels: Uint8Array; patches: Uint32Array; sources: Uint32Array };
  optimizeDomain(options?: DomainOptions & Host): Polycube;
  /** The patches packed into a square, for textures. */
  atlas(options?: AtlasOptions & Host): Atlas;
  /** A mesh of about the given number of quads, the same for maps to one polycube: where its vertices are on surface and polycube. */
  quads(count?: number, host?: Host): { positions: Float64Array; polycube: Float64Array; corners: Uint32Array; patches: Uint32Array };
  close(): void;
}

export function polycube(surface: SurfaceLike, options?: PolycubeOptions & Host): Polycube;
export function commonPolycube(surfaces: SurfaceLike[], options?: PolycubeOptions & DomainOptions & Host): Polycube[];

// ---- spherical harmonics ---------------------------------------------------------------------------------------------------

/** Coefficients: (degree + 1)^2 rows, Y_lm in row l*l + l + m, with a column a channel; 3 channels if it is not said. */
export namespace harmonics {
  interface Channels {
    channels?: number;
  }
  interface FitOptions extends Channels {
    degree?: number;
    method?: 'automatic' | 'dense' | 'iterative';
    regularization?: number;
    /** One a direction, as vertexAreas() has them. */
    weights?: Numbers;
  }
  interface FitReport {
    method: number;
    unknowns: number;
    rank: number;
    condition: number;
    residual: number;
    iterations: number;
  }
  function degreeOf(coefficients: Numbers, channels: number): number;
  function evaluate(directions: Numbers, degree: number, host?: Host): Float64Array;
  function fit(directions: Numbers, values: Numbers, options?: FitOptions & Host): { coefficients: Float64Array; report: FitReport };
  function synthesize(coefficients: Numbers, directions: Numbers, options?: Channels & { gradients?: boolean } & Host):
    { values: Float64Array; gradients: Float64Array | null };
  interface RefinementOptions extends FitOptions {
    rounds?: number;
  }
  function refineMap(surface: SurfaceLike, directions: Numbers, options?: RefinementOptions & Host):
    { directions: Float64Array; report: { rounds: number; residualBefore: number; residual: number } };
  function degreeNorms(coefficients: Numbers, channels?: number): Float64Array;
  function shapeDistance(f: Numbers, g: Numbers, options?: Channels & { first?: number; last?: number }): number;
  function filter(coefficients: Numbers, low: number, high: number, options?: Channels & { width?: number; keepMean?: boolean }): Float64Array;
  function rotate(coefficients: Numbers, rotation: Numbers, options?: Channels & Host): Float64Array;
  function align(fixed: Numbers, moving: Numbers, options?: Channels & { turnValues?: boolean; searchDegree?: number } & Host):
    { rotation: number[]; values: number[]; correlation: number };
  /** The bytes of a file of SHTOOLS ("sh") or SPHARM-PDM ("coef"). */
  function writeCoefficients(coefficients: Numbers, ending?: 'sh' | 'shtools' | 'txt' | 'coef', channels?: number): Uint8Array;
}

// ---- solids ----------------------------------------------------------------------------------------------------------------

/** x y z a vertex, and four vertices a tetrahedron, the fourth on the side that the first three look away from. */
export interface Solid {
  positions: Float64Array;
  tetrahedra: Uint32Array;
}

export type SolidLike = { positions: Numbers; tetrahedra: Numbers };

export interface FrameFieldOptions {
  start?: 'auto' | 'identity' | 'propagated' | 'harmonic' | 'diffusion' | 'given';
  method?: 'smooth' | 'dissertation';
  weighting?: 'uniform' | 'geometric';
  alignBoundary?: boolean;
  rounds?: number;
  /** Radians; 0: none. */
  featureAngle?: number;
  relativeGain?: number;
  repair?: 'noRepair' | 'repair' | 'singleAxis';
  /** With start "given". */
  startFrames?: Numbers;
  heldFrames?: { tetrahedra: Numbers; frames: Numbers; weights?: Numbers };
  heldAxes?: { tetrahedra: Numbers; axes: Numbers; weights?: Numbers };
}

/** Frames: w x y z a tetrahedron. The report has the members of obc_frame_field_report in camel case. */
export function frameField(solid: SolidLike, options?: FrameFieldOptions & Host): { frames: Float64Array; report: Record<string, number> };
export function measureFrames(solid: SolidLike, frames: Numbers, host?: Host): Record<string, number>;
/** For each tetrahedron and corner, the rotation of the cube across the face opposite. */
export function matchings(solid: SolidLike, frames: Numbers, host?: Host): Uint8Array;
export function singularities(solid: SolidLike, frames: Numbers, host?: Host): {
  edges: Uint32Array;
  rotations: Uint8Array;
  /** 1 where hexahedra would meet in threes, -1 in fives. */
  turns: Int8Array;
  curves: Uint32Array[];
  nodes: Uint32Array;
  unmeshableEdges: Uint32Array;
  unmeshableVertices: Uint32Array;
};

export interface UntangleOptions {
  rest?: Numbers;
  /** A flag a vertex, or a coordinate; default: boundary vertices are fixed. */
  fixed?: ArrayLike<number | boolean>;
  /** A group a coordinate, of which all are to be equal, or 2^32 - 1. */
  ties?: Numbers;
  maxSteps?: number;
  maxPolishSteps?: number;
  freeBoundary?: boolean | number;
  volumeWeight?: number;
  tolerance?: number;
}

/** Where some stay inverted, what is thrown has what was found as its `best`. */
export function untangle(solid: SolidLike, options?: UntangleOptions & Host): { positions: Float64Array; report: Record<string, number> };
export function solidMap(solid: SolidLike, options?: { corners?: number; seed?: number } & Host): Solid & { polycube: Float64Array };

export interface HexahedraOptions {
  /** Cells of a polycube, of a grid in space, or of that where the polycube's are far from the surface or poor. Default auto. */
  method?: 'auto' | 'polycube' | 'grid' | 'frames';
  cells?: number;
  padding?: 'auto' | 'with' | 'without';
  corners?: number;
  triangles?: number;
  seed?: number;
  rounds?: number;
  /** In percent, of the diagonal and of the volume; more cells where a mesh differs more. Default 1, 0 for as it comes. */
  maxHausdorffPercent?: number;
  maxCells?: number;
  /** In degrees: sharper edges are followed where the polycube has edges nearby; 0: none. Default 40. */
  featureAngle?: number;
}

export interface Hexahedra {
  positions: Float64Array;
  /** Eight vertices each, in the order of VTK. */
  hexahedra: Uint32Array;
  quads: Uint32Array;
  /** Of each quad the patch of the polycube that it lies on. */
  quadPatches: Uint32Array;
  report: Record<string, number>;
}

export function hexahedra(surface: SurfaceLike, options?: HexahedraOptions & Host): Hexahedra;

// ---- files for engines -----------------------------------------------------------------------------------------------------

export interface Scene {
  positions: Numbers;
  triangles: Numbers;
  normals?: Numbers;
  /** Where the vertices are, not deltas. */
  morphTargets?: { name: string; positions: Numbers }[];
  textureCoordinates?: Numbers;
  colors?: Numbers;
  edges?: Numbers;
  translation?: number[];
  scale?: number;
  baseColor?: number[];
  /** A PNG file. */
  texture?: Uint8Array;
  checker?: boolean;
  smoothNormals?: boolean;
  morphNormals?: boolean;
  name?: string;
  extras?: string | object;
  morphSeconds?: number;
}

export function writeGlb(scene: Scene, host?: Host): Uint8Array;
export function readGltf(bytes: Uint8Array | ArrayBuffer, options?: { weldIdentical?: boolean; morphTarget?: string } & Host):
  Surface & { notes: string[] };

export interface MorphedShapes {
  first: Float64Array;
  second: Float64Array;
  directions: Float64Array;
  triangles: Uint32Array;
}

export function morph(first: SurfaceLike, firstDirections: Float64Array, second: SurfaceLike, secondDirections: Float64Array, host?: Host): MorphedShapes;
/** The map turned so that the straight way from the shape to its sphere is a short one. */
export function facing(surface: SurfaceLike, directions: Float64Array, host?: Host): Float64Array;
export function sphereGlb(surface: SurfaceLike, directions: Float64Array, options?: { name?: string } & Host): Uint8Array;
export function boxOf(positions: Numbers): { centre: number[]; halfSize: number };
export function normalized(positions: Numbers, box?: { centre: number[]; halfSize: number }): Float64Array;
export function octahedronCoordinates(directions: Float64Array): Float32Array;

/** Constants, layouts of structs and types of functions. */
export * as raw from './raw/raw.js';

/** The C functions as they are, and the memory they work on. */
export const c: RawFunctions & { readonly memory: ArrayBuffer; malloc(size: number): number; free(address: number): void };

/** major * 10000 + minor * 100 + patch. */
export function version(): number;
