// Runs checks.mjs in node: node --test node_test.mjs (environment: ORBICUBE_JS, the package; ORBICUBE_PROBLEMS, problems.c built).
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { checks } from './checks.mjs';

const orbicube = await import(pathToFileURL(join(process.env.ORBICUBE_JS, 'index.js')));
await orbicube.ready;
const lines = execFileSync(process.env.ORBICUBE_PROBLEMS, { encoding: 'utf8' }).trim().split('\n');
for (const [name, check] of Object.entries(checks)) test(name, () => check(orbicube, lines));
