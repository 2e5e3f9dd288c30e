// Loads each file with three.js and prints one line of JSON for it: what is in the first mesh of triangles.
//
//   node three.mjs FOLDER_OF_NODE_MODULES FILE...
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

// What the loader takes from a browser: it only needs to believe that images can be decoded.
globalThis.self = globalThis;
globalThis.ProgressEvent ??= class extends Event {};
globalThis.createImageBitmap = async (blob) => ({ width: 1, height: 1, bytes: blob.size, close() {} });

const [folder, ...files] = process.argv.slice(2);
const loaderFile = resolve(folder, 'node_modules/three/examples/jsm/loaders/GLTFLoader.js');
const { GLTFLoader } = await import(pathToFileURL(loaderFile));
for (const file of files) {
  const bytes = readFileSync(file);
  const content = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const { scene } = await new GLTFLoader().parseAsync(content, '');
  let found;
  let lines = 0;
  scene.traverse((node) => {
    if (node.isLine) lines += node.geometry.index.count / 2;
    if (node.isMesh) found ??= node;
  });
  const { geometry, material } = found;
  console.log(JSON.stringify({
    vertices: geometry.attributes.position.count,
    triangles: geometry.index.count / 3,
    attributes: Object.keys(geometry.attributes).sort(),
    morphTargets: Object.keys(found.morphTargetDictionary ?? {}),
    morphVertices: (geometry.morphAttributes.position ?? []).map((attribute) => attribute.count),
    texture: material.map?.image?.width === 1,
    edges: lines,
  }));
}
