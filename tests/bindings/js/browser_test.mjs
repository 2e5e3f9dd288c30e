// Runs checks.mjs in headless Chromium: node --test browser_test.mjs (environment: ORBICUBE_JS, ORBICUBE_PROBLEMS, ORBICUBE_BROWSER).
import { execFileSync } from 'node:child_process';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { checks } from './checks.mjs';
import { Page, serve } from './browser.mjs';

const lines = execFileSync(process.env.ORBICUBE_PROBLEMS, { encoding: 'utf8' }).trim().split('\n');
const folders = { '/': fileURLToPath(new URL('.', import.meta.url)), '/orbicube/': process.env.ORBICUBE_JS };
const page = await Page.open(process.env.ORBICUBE_BROWSER ?? 'chromium');
const run = (name) => page.evaluate(`run(${JSON.stringify(name)}, ${JSON.stringify(lines)})`);

async function opened(options) {
  const server = await serve(folders, options);
  await page.go(`${server.url}/page.html`);
  await page.until('window.isReady');
  return server;
}

let server;
before(async () => {
  server = await opened();
});
for (const name of Object.keys(checks)) test(name, () => run(name));

// Above, cancelling ends the thread; here, threads share a flag.
test('a worker of a page that is cross-origin isolated is told to stop', async () => {
  server.close();
  server = await opened({ isolated: true });
  if (!(await page.evaluate('crossOriginIsolated'))) throw new Error('the page is not isolated');
  await run('a worker answers the same, tells of progress and can be cancelled');
  if (page.problems.length > 0) throw new Error(page.problems.join('\n'));
});

after(async () => {
  await page.close();
  server.close();
});
