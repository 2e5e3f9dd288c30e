// The page: a worker maps a mesh, the viewer shows the morph from it to its map, and a GLB of both can be downloaded.
import { OrbicubeWorker } from './orbicube/client.js';
import { Camera, product, rotation } from './viewer/camera.js';
import { Renderer } from './viewer/renderer.js';
import { framed, frameOf, normalsOf } from './viewer/surface.js';
import { Viewer } from './viewer/viewer.js';

const find = (id) => document.getElementById(id);
const number = new Intl.NumberFormat('en', { maximumFractionDigits: 3 });
const worker = new OrbicubeWorker();
const camera = new Camera(product(rotation([1, 0, 0], 0.25), rotation([0, 1, 0], 0.45)), 0.86, [0, 0.1]);
const look = { morph: 0, mode: 'checker', edges: false };
const viewer = new Viewer(new Renderer(find('view'), camera, look), {
  keys: { ' ': () => find('play').click() },
  onLost: () => say('The graphics unit was lost; load the page again.', true),
});

let shape = null; // {name, surface, frame, sphere, polycube}
let control = null; // of the work at hand
let playing = 0;

// ---- messages ------------------------------------------------------------------------------------------------------------

function say(text, bad = false) {
  find('status').textContent = text;
  find('status').classList.toggle('bad', bad);
}

function figures(rows) {
  find('figures').replaceChildren(...Object.entries(rows).flatMap(([name, value]) => {
    const [term, figure] = [document.createElement('dt'), document.createElement('dd')];
    term.textContent = name;
    figure.textContent = typeof value === 'number' ? number.format(value) : value;
    return [term, figure];
  }));
}

const causes = {
  'wrong-genus': 'The surface has handles, and only surfaces of genus 0 have a sphere map; choose a polycube.',
  boundary: 'The surface has holes: only closed ones have a sphere map.',
  'not-closed': 'The surface has holes: only closed ones have a sphere map.',
};

/** Runs one task with progress and a button that cancels it; returns null when it was cancelled or failed. */
async function working(title, body) {
  control?.abort();
  const mine = control = new AbortController();
  find('work').hidden = false;
  find('phase').textContent = title;
  find('progress').removeAttribute('value');
  document.body.setAttribute('aria-busy', 'true');
  const onProgress = ({ phase, done, total }) => {
    if (mine !== control) return;
    find('phase').textContent = `${title}: ${phase}`;
    if (total > 0) find('progress').value = done / total;
    else find('progress').removeAttribute('value');
  };
  try {
    return await body({ signal: mine.signal, onProgress });
  } catch (problem) {
    if (problem.name === 'AbortError') {
      if (mine === control) say('Cancelled.');
    } else {
      say(`${causes[problem.kind] ?? ''} ${problem.message}`.trim(), true);
    }
    return null;
  } finally {
    if (mine === control) {
      control = null;
      find('work').hidden = true;
      document.body.removeAttribute('aria-busy');
    }
  }
}

// ---- shapes and their maps -----------------------------------------------------------------------------------------------

const chosen = (name) => document.querySelector(`input[name="${name}"]:checked`).value;

const placed = (positions, { center, scale }) => Float32Array.from(positions, (x, i) => scale * (x - center[i % 3]));

function ready(on) {
  for (const id of ['slider', 'play', 'download']) find(id).disabled = !on;
  find('slider').setAttribute('aria-label', `From the shape to its ${chosen('target')}`);
  find('to').textContent = chosen('target');
}

/** Returns positions of the shape and of its map, and the triangles of both; null before there is a map. */
function shown() {
  const map = shape?.[chosen('target')];
  if (!map) return null;
  if (chosen('target') === 'sphere') {
    return { from: placed(shape.surface.positions, shape.frame), to: map.directions, triangles: shape.surface.triangles };
  }
  return { from: placed(map.positions, shape.frame), to: placed(map.polycube, frameOf(map.polycube)), triangles: map.triangles };
}

/** Shows a shape and its map; the checker of a polycube follows its axes. */
function draw({ from, to, triangles }, polycube) {
  const positions = framed(from);
  viewer.setMesh({ positions, directions: framed(to), normals: normalsOf(positions, triangles), triangles,
    ...(polycube && { facing: [1, 0, 0, 0, 1, 0, 0, 0, 1] }) });
}

function tell() {
  const { vertices, triangles } = { vertices: shape.surface.positions.length / 3, triangles: shape.surface.triangles.length / 3 };
  const rows = { vertices, triangles };
  if (chosen('target') === 'sphere' && shape.sphere) {
    const { report } = shape.sphere;
    rows['flipped'] = report.flipped;
    rows['quasi-conformal distortion, mean'] = report.meanQuasiConformal;
    rows['quasi-conformal distortion, maximum'] = report.maxQuasiConformal;
  }
  if (chosen('target') === 'polycube' && shape.polycube) {
    rows['corners of the polycube'] = shape.polycube.corners;
    rows['vertices added'] = shape.polycube.positions.length / 3 - vertices;
  }
  figures(rows);
}

async function show() {
  if (!shape) return;
  const target = chosen('target');
  stop();
  setShare(0);
  ready(false);
  if (!shape[target]) {
    const { surface } = shape;
    // Until there is a map, the shape alone.
    const alone = placed(surface.positions, shape.frame);
    look.mode = 'plain';
    draw({ from: alone, to: alone, triangles: surface.triangles }, false);
    tell();
    say(target === 'sphere' ? 'Computing the sphere map.' : 'Computing a polycube; this can take a minute.');
    const began = performance.now();
    const of = shape;
    const map = await working(target === 'sphere' ? 'Sphere map' : 'Polycube',
      (host) => (target === 'sphere' ? worker.run('sphereMap', { surface, facing: true }, host) : worker.run('polycube', { surface }, host)));
    if (!map || shape !== of) return;
    of[target] = map;
    if (chosen('target') !== target) return;
    say(`${of.name}: all triangles mapped to the ${target}, none is flipped; ${number.format((performance.now() - began) / 1000)} s.`);
  }
  look.mode = chosen('pattern');
  draw(shown(), target === 'polycube');
  tell();
  ready(true);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) play();
}

async function take(name, work, given, transfer) {
  stop();
  const surface = await working(`Reading ${name}`, (host) => worker.run(work, given, { ...host, transfer }));
  if (!surface) return;
  find('hint').hidden = true;
  viewer.reset();
  shape = { name, surface, frame: frameOf(surface.positions) };
  await show();
}

async function open(file) {
  if (!file) return;
  const bytes = new Uint8Array(await file.arrayBuffer());
  await take(file.name, 'read', { bytes, name: file.name, weldIdentical: true }, [bytes.buffer]);
}

// ---- the morph -------------------------------------------------------------------------------------------------------------

function setShare(share) {
  look.morph = share;
  find('slider').value = Math.round(1000 * share);
  viewer.redraw();
}

function stop() {
  playing = 0;
  find('play').setAttribute('aria-pressed', 'false');
}

/** Morphs to the other end. */
function play() {
  const began = performance.now();
  const from = look.morph;
  const to = from < 0.5 ? 1 : 0;
  const mine = playing = began;
  find('play').setAttribute('aria-pressed', 'true');
  const step = () => {
    if (playing !== mine) return;
    const t = Math.min(1, (performance.now() - began) / 2200);
    setShare(from + (to - from) * t * t * (3 - 2 * t));
    if (t < 1) requestAnimationFrame(step);
    else stop();
  };
  requestAnimationFrame(step);
}

async function download() {
  const { from, to, triangles } = shown();
  const target = chosen('target');
  const stem = shape.name.replace(/\.\w+$/, '');
  const made = await working('Writing', (host) => (target === 'sphere'
    ? worker.run('sphereGlb', { surface: shape.surface, directions: to, name: stem }, host)
    : worker.run('glb', { scene: { positions: from, triangles, name: stem, morphTargets: [{ name: target, positions: to }] } }, host)));
  if (!made) return;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([made.bytes], { type: 'model/gltf-binary' }));
  link.download = `${stem}-${target}.glb`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  say(`${link.download}: ${number.format(made.bytes.length / 1e6)} MB, with the ${target} as a morph target.`);
}

// ---- controls --------------------------------------------------------------------------------------------------------------

find('file').addEventListener('change', (event) => {
  open(event.target.files[0]);
  event.target.value = '';
});
find('sample').addEventListener('click', () => take('creature', 'make',
  { shape: 'creature', triangles: 12000, seed: Math.floor(Math.random() * 1000) }));
find('cancel').addEventListener('click', () => control?.abort());
find('slider').addEventListener('input', (event) => {
  stop();
  setShare(event.target.value / 1000);
});
find('play').addEventListener('click', () => (playing ? stop() : play()));
find('download').addEventListener('click', download);
for (const each of document.querySelectorAll('input[name="target"]')) each.addEventListener('change', show);
for (const each of document.querySelectorAll('input[name="pattern"]')) {
  each.addEventListener('change', () => {
    if (shown()) look.mode = chosen('pattern');
    viewer.redraw();
  });
}
find('edges').addEventListener('change', (event) => {
  look.edges = event.target.checked;
  viewer.redraw();
});
for (const [name, over] of [['dragover', true], ['dragleave', false], ['drop', false]]) {
  document.addEventListener(name, (event) => {
    event.preventDefault();
    find('stage').classList.toggle('over', over);
    if (name === 'drop') open(event.dataTransfer.files[0]);
  });
}
document.body.dataset.ready = 'true';
