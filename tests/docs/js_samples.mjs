// Runs the JavaScript of a page, all blocks as one program in a folder of its own: node js_samples.mjs PAGE.md (environment:
// ORBICUBE_JS).
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const blocks = [...readFileSync(process.argv[2], 'utf8').matchAll(/^```js\n(.*?)^```/gms)].map((match) => match[1]);
if (blocks.length === 0) throw new Error(`no JavaScript in ${process.argv[2]}`);
const folder = mkdtempSync(join(tmpdir(), 'samples-'));
try {
  mkdirSync(join(folder, 'node_modules'));
  symlinkSync(process.env.ORBICUBE_JS, join(folder, 'node_modules', 'orbicube'));
  writeFileSync(join(folder, 'samples.mjs'), blocks.join('\n'));
  execFileSync(process.execPath, ['samples.mjs'], { cwd: folder, stdio: 'inherit' });
} finally {
  rmSync(folder, { recursive: true });
}
