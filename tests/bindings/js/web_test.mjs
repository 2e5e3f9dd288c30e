// The page of examples/web in headless Chromium, as somebody uses it: node --test web_test.mjs (environment: ORBICUBE_JS, beside
// whose folder is that of the page; ORBICUBE_BROWSER; ORBICUBE_SCREENSHOTS, a folder for pictures to look at).
import { mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { assert } from './checks.mjs';
import { Page, serve } from './browser.mjs';

const orbicube = await import(pathToFileURL(join(process.env.ORBICUBE_JS, 'index.js')));
await orbicube.ready;
let [server, page, folder] = [];

const status = () => page.evaluate("document.getElementById('status').textContent");
const disabled = (id) => page.evaluate(`document.getElementById('${id}').disabled`);
const done = "!document.getElementById('slider').disabled && document.getElementById('work').hidden";

/** How much of the picture is drawn, 0 to 1. */
const drawn = () => page.evaluate(`new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const canvas = document.getElementById('view');
  const gl = canvas.getContext('webgl2');
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let count = 0;
  let sum = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] > 0) ++count;
    sum = (sum * 31 + pixels[i] + pixels[i + 1]) % 1000003;
  }
  resolve({ share: count / (pixels.length / 4), sum });
})))`);

async function picture(name) {
  if (process.env.ORBICUBE_SCREENSHOTS) await writeFile(join(process.env.ORBICUBE_SCREENSHOTS, `${name}.png`), await page.screenshot());
}

async function file(name, bytes) {
  const path = join(folder, name);
  await writeFile(path, bytes);
  return path;
}

before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'web-test-'));
  server = await serve({ '/': join(dirname(process.env.ORBICUBE_JS), 'web') });
  page = await Page.open(process.env.ORBICUBE_BROWSER ?? 'chromium');
  await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  await page.send('Page.setDownloadBehavior', { behavior: 'allow', downloadPath: folder });
  await page.go(`${server.url}/`);
  await page.until("document.body?.dataset.ready === 'true'");
});

test('everything that can be used has a name', async () => {
  const { nodes } = await page.send('Accessibility.getFullAXTree');
  const used = nodes.filter((node) => !node.ignored && ['button', 'slider', 'radio', 'textbox', 'progressbar', 'img', 'image'].includes(node.role?.value));
  assert(used.length >= 8, `${used.length} things`);
  for (const node of used) assert(node.name?.value, `${node.role.value} without a name`);
  assert(await disabled('slider') && await disabled('download'));
});

test('a file becomes a sphere that the slider goes to', async () => {
  const mesh = orbicube.Mesh.make('creature', 3000);
  await page.choose('#file', [await file('creature.ply', orbicube.writeMesh(mesh, 'ply'))]);
  await page.until(done);
  assert(/creature\.ply.*none is flipped/.test(await status()), await status());
  assert(await page.evaluate("document.getElementById('hint').hidden"));
  const before = await drawn();
  assert(before.share > 0.03, `${before.share} of the picture`);
  await picture('shape');
  await page.evaluate("document.getElementById('slider').focus()");
  await page.press('End');
  assert(await page.evaluate("document.getElementById('slider').value") === '1000');
  const after = await drawn();
  assert(after.share > before.share && after.sum !== before.sum, 'the sphere is larger');
  await picture('sphere');
});

test('keys and mouse turn the picture', async () => {
  await page.evaluate("document.getElementById('view').focus()");
  const sums = [(await drawn()).sum];
  for (const key of ['ArrowLeft', 'ArrowUp', '+']) {
    await page.press(key);
    sums.push((await drawn()).sum);
  }
  await page.drag([300, 300], [420, 340]);
  sums.push((await drawn()).sum);
  assert(new Set(sums).size === sums.length, `${sums}`);
  await page.press(' ', 'Space');
  await page.until("document.getElementById('slider').value === '0'");
});

test('the GLB that is downloaded has the sphere as a morph target', async () => {
  await page.evaluate("document.getElementById('download').click()");
  await page.until("/MB/.test(document.getElementById('status').textContent)");
  const end = Date.now() + 10000;
  while (!(await readdir(folder)).includes('creature-sphere.glb')) {
    assert(Date.now() < end, 'no file came');
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  const { positions } = orbicube.readGltf(await readFile(join(folder, 'creature-sphere.glb')), { morphTarget: 'sphere', weldIdentical: false });
  for (let v = 0; v < positions.length; v += 3) {
    const length = Math.hypot(positions[v], positions[v + 1], positions[v + 2]);
    assert(Math.abs(length - 1) < 1e-5, `a vertex at ${length}`);
  }
});

test('what has no sphere is said, and goes to a polycube', async () => {
  const torus = orbicube.Mesh.make('torus', 600);
  await page.choose('#file', [await file('torus.obj', orbicube.writeMesh(torus, 'obj'))]);
  await page.until("document.getElementById('status').classList.contains('bad')");
  assert(/handles/.test(await status()), await status());
  assert(await disabled('download'));
  await page.evaluate("document.querySelector('input[value=polycube]').click()");
  await page.until(done, 120000);
  await page.evaluate("document.getElementById('slider').focus()");
  await page.press('End');
  assert((await drawn()).share > 0.03);
  await picture('polycube');
  await page.choose('#file', [await file('broken.off', 'OFF\nno numbers\n')]);
  await page.until("/broken|line|parse|OFF|number/.test(document.getElementById('status').textContent)");
});

test('work can be cancelled, and more can be done afterwards', async () => {
  await page.evaluate("document.querySelector('input[value=sphere]').click()");
  const big = orbicube.grid('icosphere', 6);
  await page.choose('#file', [await file('big.ply', orbicube.writeMesh(big, 'ply'))]);
  await page.until("/Sphere map/.test(document.getElementById('phase').textContent) && !document.getElementById('work').hidden");
  await page.evaluate("document.getElementById('cancel').click()");
  await page.until("document.getElementById('work').hidden && document.getElementById('status').textContent === 'Cancelled.'");
  await page.evaluate("document.getElementById('sample').click()");
  await page.until(done);
  assert(/creature/.test(await status()));
  assert(page.problems.length === 0, page.problems.join('\n'));
});

after(async () => {
  await page.close();
  server.close();
  await rm(folder, { recursive: true, force: true });
});
