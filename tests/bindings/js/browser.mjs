// A headless Chromium and a server of files for it: what the tests of pages need, without any package.
import { spawn } from 'node:child_process';
import { readFile, mkdtemp, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';

const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm',
  '.css': 'text/css', '.json': 'application/json', '.svg': 'image/svg+xml' };

/** Serves folders ({'/path/': folder}); `isolated` pages may share memory with their workers. */
export async function serve(folders, { isolated = false } = {}) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    const [prefix] = Object.keys(folders).filter((each) => path.startsWith(each)).sort((a, b) => b.length - a.length);
    try {
      const content = await readFile(join(folders[prefix], path.slice(prefix.length) || 'index.html'));
      response.setHeader('Content-Type', kinds[extname(path)] ?? (path.endsWith('/') ? 'text/html' : 'application/octet-stream'));
      if (isolated) {
        response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
        response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
      }
      response.end(content);
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

/** A page of a browser that is driven by the DevTools protocol over a pipe. */
export class Page {
  #browser;
  #profile;
  #session;
  #last = 0;
  #waiting = new Map();
  /** What the page wrote to its console, and errors that nothing caught. */
  problems = [];

  static async open(program, { width = 1280, height = 800 } = {}) {
    const page = new Page();
    page.#profile = await mkdtemp(join(tmpdir(), 'chromium-'));
    page.#browser = spawn(program, ['--headless=new', '--remote-debugging-pipe', '--no-sandbox', '--disable-dev-shm-usage',
      '--disable-extensions', '--no-first-run', '--mute-audio', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      `--window-size=${width},${height}`, `--user-data-dir=${page.#profile}`, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    page.#browser.on('error', (problem) => page.#end(problem));
    page.#browser.on('exit', () => page.#end(new Error('the browser ended')));
    let text = '';
    page.#browser.stdio[4].setEncoding('utf8').on('data', (data) => {
      const messages = (text + data).split('\0');
      text = messages.pop();
      for (const message of messages) page.#receive(JSON.parse(message));
    });
    const { targetInfos } = await page.send('Target.getTargets');
    const { targetId } = targetInfos.find((target) => target.type === 'page');
    page.#session = (await page.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    await page.send('Runtime.enable');
    await page.send('Page.enable');
    await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
    return page;
  }

  #end(problem) {
    for (const { reject } of this.#waiting.values()) reject(problem);
    this.#waiting.clear();
  }

  #receive({ id, result, error, method, params }) {
    if (method === 'Runtime.exceptionThrown') this.problems.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && params.type === 'error') this.problems.push(params.args.map((a) => a.value ?? a.description).join(' '));
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    this.#waiting.delete(id);
    if (error) waiting.reject(new Error(error.message));
    else waiting.resolve(result);
  }

  send(method, params = {}) {
    const id = ++this.#last;
    this.#browser.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.#session })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  async go(url) {
    await this.send('Page.navigate', { url });
  }

  /** The value of an expression in the page; promises are awaited. */
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate',
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until the expression holds. */
  async until(expression, milliseconds = 60000) {
    const end = Date.now() + milliseconds;
    while (!(await this.evaluate(expression).catch(() => false))) {
      if (Date.now() > end) throw new Error(`waited in vain for ${expression}\n${this.problems.join('\n')}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  /** Puts files into an input of the page, as somebody who chooses them. */
  async choose(selector, files) {
    const { root } = await this.send('DOM.getDocument');
    const { nodeId } = await this.send('DOM.querySelector', { nodeId: root.nodeId, selector });
    await this.send('DOM.setFileInputFiles', { nodeId, files });
  }

  async press(key, code = key) {
    const codes = { Tab: 9, Enter: 13, ' ': 32, End: 35, Home: 36, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Escape: 27 };
    const event = { key, code, windowsVirtualKeyCode: codes[key] ?? key.toUpperCase().charCodeAt(0),
      text: key.length === 1 ? key : key === 'Enter' ? '\r' : undefined };
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', ...event });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event, text: undefined });
  }

  async drag(from, to) {
    const event = (type, [x, y]) => this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1 });
    await event('mousePressed', from);
    await event('mouseMoved', [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
    await event('mouseMoved', to);
    await event('mouseReleased', to);
  }

  /** PNG bytes of what is seen. */
  async screenshot() {
    return Buffer.from((await this.send('Page.captureScreenshot', { format: 'png' })).data, 'base64');
  }

  async close() {
    const ended = new Promise((resolve) => this.#browser.once('exit', resolve));
    this.#browser.kill();
    await ended;
    await rm(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
