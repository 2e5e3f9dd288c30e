// The page of examples/web and its viewer in headless Chromium, with maps made in JavaScript in place of the package:
// node --test viewer_test.mjs (environment: ORBICUBE_BROWSER; ORBICUBE_SCREENSHOTS, a folder for pictures to look at).
import { writeFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { assert } from './checks.mjs';
import { Page, serve } from './browser.mjs';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
let [server, page] = [];

/** Of the picture: the fraction that is drawn, a sum of its pixels, and the size of the canvas. */
const drawn = () => page.evaluate(`new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const canvas = document.getElementById('view');
  const gl = canvas.getContext('webgl2');
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let [count, sum, colors] = [0, 0, new Set()];
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] > 0) ++count;
    sum = (sum * 31 + pixels[i] + 7 * pixels[i + 1] + 13 * pixels[i + 2]) % 1000003;
    colors.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
  }
  resolve({ fraction: count / (pixels.length / 4), sum, colors: colors.size, width: canvas.width, error: gl.getError() });
})))`);

async function picture(name) {
  if (process.env.ORBICUBE_SCREENSHOTS) await writeFile(join(process.env.ORBICUBE_SCREENSHOTS, `${name}.png`), await page.screenshot());
}

/** Does something to the page, and returns the picture after it, which has to differ from the one before. */
async function changed(what, action) {
  const old = await drawn();
  await action();
  const now = await drawn();
  assert(now.sum !== old.sum && now.error === 0, `${what} changes nothing`);
  return now;
}

const click = (selector) => page.evaluate(`document.querySelector('${selector}').click()`);
const mouse = (type, x, y, more = {}) => page.send('Input.dispatchMouseEvent', { type, x, y, ...more });
const touch = (type, points) => page.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });

before(async () => {
  server = await serve({ '/': here('../../../examples/web'), '/viewer/': here('../../../cli/report_page/viewer'),
    '/orbicube/': here('stand_in') });
  page = await Page.open(process.env.ORBICUBE_BROWSER ?? 'chromium');
  await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  await page.go(`${server.url}/`);
  await page.until("document.body?.dataset.ready === 'true'");
  await click('#sample');
  await page.until("!document.getElementById('slider').disabled");
});

test('the morph goes to the sphere and to a polycube', async () => {
  await picture('shape');
  await page.evaluate("document.getElementById('slider').focus()");
  const sphere = await changed('the slider', () => page.press('End'));
  // The sphere fills 84 % of the shorter side of the canvas, times the page's magnification.
  const { w, h } = await page.evaluate("(({ clientWidth: w, clientHeight: h }) => ({ w, h }))(document.getElementById('view'))");
  const expected = Math.PI / 4 * (0.84 * 0.86 * Math.min(w, h)) ** 2 / (w * h);
  assert(Math.abs(sphere.fraction / expected - 1) < 0.01, `${sphere.fraction} of the picture, not ${expected}`);
  await picture('sphere');
  await changed('the polycube', async () => {
    await click('input[value=polycube]');
    await page.until("!document.getElementById('slider').disabled");
    await page.evaluate("document.getElementById('slider').focus()");
    await page.press('End');
  });
  await picture('polycube');
  const plain = await changed('the pattern', () => click('input[value=plain]'));
  const checker = await changed('the pattern', () => click('input[value=checker]'));
  assert(checker.colors > plain.colors, `${checker.colors} colors with the checker, ${plain.colors} without`);
  await changed('edges', () => click('#edges'));
  await picture('edges');
  await click('#edges');
});

test('keys, mouse and wheel turn, move and zoom', async () => {
  await page.evaluate("document.getElementById('view').focus()");
  await page.press('0', 'Digit0');
  const first = await drawn();
  for (const key of ['ArrowLeft', 'ArrowUp']) await changed(key, () => page.press(key));
  const far = await drawn();
  const near = await changed('+', () => page.press('+'));
  assert(near.fraction > far.fraction, '+ magnifies');
  await changed('dragging', () => page.drag([300, 300], [420, 340]));
  const button = { button: 'middle', buttons: 4, clickCount: 1 };
  await changed('dragging with the middle button', async () => {
    await mouse('mousePressed', 300, 300, button);
    await mouse('mouseMoved', 380, 330, button);
    await mouse('mouseReleased', 380, 330, { button: 'middle' });
  });
  const zoomed = await changed('the wheel', () => mouse('mouseWheel', 400, 300, { deltaX: 0, deltaY: 120 }));
  assert(zoomed.fraction < near.fraction, 'the wheel zooms out');
  await page.press('0', 'Digit0');
  assert((await drawn()).sum === first.sum, '0 resets the view');
});

test('two fingers zoom', async () => {
  const old = await drawn();
  const now = await changed('pinching', async () => {
    await touch('touchStart', [[350, 300], [450, 300]]);
    await touch('touchMove', [[330, 300], [470, 300]]);
    await touch('touchMove', [[300, 300], [500, 300]]);
    await touch('touchEnd', []);
  });
  assert(now.fraction > 1.2 * old.fraction, `${old.fraction} of the picture before, ${now.fraction} after`);
});

test('the canvas has the pixels of the screen', async () => {
  const old = await drawn();
  await page.send('Emulation.setDeviceMetricsOverride', { width: 1180, height: 800, deviceScaleFactor: 2, mobile: false });
  await page.until(`document.getElementById('view').width === ${2 * (old.width - 100)}`);
  await page.send('Emulation.setDeviceMetricsOverride', { width: 1280, height: 800, deviceScaleFactor: 1, mobile: false });
  await page.until(`document.getElementById('view').width === ${old.width}`);
});

test('what is picked is seen at the place pointed at', async () => {
  const far = await page.evaluate(`(async () => {
    const [{ Renderer }, { Camera }, { normalsOf }] = await Promise.all(
      ['renderer', 'camera', 'surface'].map((name) => import(\`/viewer/\${name}.js\`)));
    const canvas = document.createElement('canvas');
    canvas.style = 'position: fixed; inset: 0; width: 700px; height: 300px';
    document.body.append(canvas);
    const positions = Float32Array.from([-1, -1, 0, 0, 1, -1, 0, 0, 0, 1, 0, 0]);
    const triangles = Uint32Array.from([0, 1, 2]);
    const renderer = new Renderer(canvas, new Camera(), { morph: 0, mode: 'plain', edges: true }, { views: 2 });
    renderer.setMesh({ positions, directions: positions.map((x) => 0.9 * x), normals: normalsOf(positions, triangles), triangles });
    renderer.draw();
    const distances = [[200, 190], [520, 180], [160, 205]].map(([x, y]) => {
      const found = renderer.pick(x, y);
      const seen = found && renderer.seenAt(found.index, found.triangle, found.weights);
      return found ? Math.hypot(seen.x - x, seen.y - y) + (found.index !== Number(x > 350)) : 1000;
    });
    const nothing = renderer.pick(5, 5);
    canvas.remove();
    return [...distances, nothing === null ? 0 : 1000];
  })()`);
  assert(far.every((distance) => distance < 0.01), `${far}`);
  assert(page.problems.length === 0, page.problems.join('\n'));
});

after(async () => {
  await page?.close();
  server.close();
});
