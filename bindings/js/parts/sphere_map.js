// orbicube/sphere_map: what of the package is for surfaces and their maps to the sphere, over a module of its own.
export { OrbicubeError } from './errors.js';
export { HeapArray, ready } from './module.js';
export { Mesh, checkClosedGenusZero, formatOf, formats, meanDistance, orient, topology, vertexAreas, vertexNormals, writeMesh } from './mesh.js';
export { Locator, bestRotation, faceDistortion, grid, measure, overlay, roundToFloat, sphereMap } from './sphere_map.js';
