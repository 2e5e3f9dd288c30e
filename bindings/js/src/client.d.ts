import type { MorphedShapes, Progress, Scene, SphereMapOptions, SphereMapResult, Surface, PolycubeOptions } from './index.js';

export interface Works {
  read: { given: { bytes: Uint8Array; name: string; weldIdentical?: boolean }; result: Surface & { notes: string[] } };
  make: { given: { shape: string; triangles: number; seed?: number }; result: Surface };
  sphereMap: { given: { surface: Surface; facing?: boolean } & SphereMapOptions; result: SphereMapResult };
  polycube: {
    given: { surface: Surface } & PolycubeOptions;
    result: Surface & { polycube: Float64Array; labels: Uint8Array; patches: Uint32Array; sources: Uint32Array; corners: number };
  };
  morph: {
    given: { first: Surface; firstDirections: Float64Array; second: Surface; secondDirections: Float64Array };
    result: MorphedShapes;
  };
  sphereGlb: { given: { surface: Surface; directions: Float64Array; name?: string }; result: { bytes: Uint8Array } };
  glb: { given: { scene: Scene }; result: { bytes: Uint8Array } };
}

/** Work in a thread of its own, one piece at a time. */
export class OrbicubeWorker {
  /** Whether cancelled work leaves its thread alive. */
  readonly sharesMemory: boolean;
  /** Rejected with an OrbicubeError, or with an AbortError once the signal is aborted. */
  run<Work extends keyof Works>(work: Work, given: Works[Work]['given'], options?: {
    onProgress?: (at: Progress) => void;
    signal?: AbortSignal;
    transfer?: ArrayBuffer[];
  }): Promise<Works[Work]['result']>;
  /** Ends the thread; the next work starts another one. */
  terminate(): void;
}
