// Checks glTF files with Khronos's validator: no error and no warning.
//
//   node validate.mjs FOLDER_WITH_NODE_MODULES FILE...
//
// The folder is one in which `npm install gltf-validator` was run. Answers 77 (skipped) when the package is not there.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const require = createRequire(resolve(folder || '.', 'package.json'));
let validator;
try {
  validator = require('gltf-validator');
} catch {
  console.log(`skipped: gltf-validator is not installed in ${folder}`);
  process.exit(77);
}
let failed = files.length === 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { uri: file, maxIssues: 20 });
  const { numErrors, numWarnings, numInfos, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos`);
  for (const { code, message, pointer } of messages) console.log(`  ${code} ${pointer}: ${message}`);
  failed ||= numErrors > 0 || numWarnings > 0;
}
process.exit(failed ? 1 : 0);
