// Compiled, not run: the types say what the package does.
import { Mesh, OrbicubeError, OrbicubeWorker, Polycube, SphereMapResult, TrustRegion, c, commonPolycube, ready, sphereMap, trustRegion, vertexAreas,
  projectedGradient, writeGlb, HeapArray, Hexahedra, Solid, frameField, harmonics, hexahedra, singularities, solidMap, untangle } from 'orbicube';
import { constants, layouts } from 'orbicube/raw.js';
import { trustRegion as alone } from 'orbicube/trust_region';

async function use(): Promise<number> {
  await ready;
  const mesh: Mesh = Mesh.make('creature', 1000, { seed: 1 });
  const map: SphereMapResult = sphereMap(mesh, { method: 'isometric', onProgress: ({ done, total }) => done < total });
  const held = new HeapArray('float64', 3);
  held.array[0] = map.report.meanQuasiConformal;
  const end = trustRegion.minimize((x) => x[0] ** 2, [1], { lower: 0, radiusEnd: 1e-6 });
  alone.minimize((x) => x[0] ** 2, [1], { lower: 0, radiusEnd: 1e-6 });
  projectedGradient.minimize((x, g) => { g[0] = 2 * x[0]; return x[0] ** 2; }, [1], { A: [[1]], b: [1] });
  const solver = new TrustRegion([1, 2], { residuals: 2 });
  for (let x = solver.ask(); x !== null; x = solver.ask()) solver.tell([x[0], x[1]]);
  const [first]: Polycube[] = commonPolycube([mesh, mesh], { corners: 8, areaWeight: 0.5 });
  const worker = new OrbicubeWorker();
  const { directions } = await worker.run('sphereMap', { surface: mesh.arrays }, { signal: new AbortController().signal });
  const { bytes } = await worker.run('glb', { scene: { positions: directions, triangles: mesh.triangles } });
  writeGlb({ positions: directions, triangles: mesh.triangles, morphTargets: [{ name: 'a', positions: directions }] });
  const { coefficients } = harmonics.fit(directions, mesh.positions, { degree: 8, method: 'dense', weights: vertexAreas(mesh) });
  const turned: Float64Array = harmonics.rotate(coefficients, harmonics.align(coefficients, coefficients, { turnValues: true }).rotation);
  const solid: Solid = mesh.solid;
  const { frames } = frameField(solid, { start: 'harmonic', repair: 'singleAxis', heldAxes: { tetrahedra: [0], axes: [0, 0, 1] } });
  const curves: Uint32Array[] = singularities(solid, frames).curves;
  const filled: Hexahedra = hexahedra(mesh, { cells: 1000, padding: 'auto' });
  const unfolded = untangle(solidMap(solid, { corners: 8 }), { fixed: [true], maxPolishSteps: 5 });
  console.log(turned.length, curves.length, filled.quads, unfolded.report.inverted);
  const status: -3 = constants.OBC_NOT_CLOSED;
  const version: number = c.obc_base_version();
  try {
    first.close();
  } catch (problem) {
    if (problem instanceof OrbicubeError) console.log(problem.kind, problem.status);
  }
  return end.x[0] + bytes.length + status + version + layouts.obc_surface.size;
}

// @ts-expect-error there is no such method
sphereMap(Mesh.make('cube', 100), { method: 'best' });
// @ts-expect-error nor such a work
new OrbicubeWorker().run('dance', {});
void use;
