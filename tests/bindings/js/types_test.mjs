// The types of the package are right, and say what types.mts does with them: node types_test.mjs (environment: ORBICUBE_JS,
// ORBICUBE_TSC).
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = mkdtempSync(join(tmpdir(), 'types-'));
try {
  mkdirSync(join(folder, 'node_modules'));
  symlinkSync(process.env.ORBICUBE_JS, join(folder, 'node_modules', 'orbicube'));
  copyFileSync(fileURLToPath(new URL('types.mts', import.meta.url)), join(folder, 'types.mts'));
  execFileSync(process.env.ORBICUBE_TSC ?? 'tsc', ['--noEmit', '--strict', '--target', 'es2022', '--module', 'node16', '--moduleResolution',
    'node16', '--lib', 'es2022,dom', 'types.mts'], { cwd: folder, stdio: 'inherit', env: { ...process.env, NODE_PATH: '/usr/share/nodejs' } });
} finally {
  rmSync(folder, { recursive: true });
}
