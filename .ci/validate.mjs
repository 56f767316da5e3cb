// Compares the official glTF validator's verdict on files before and after an edit.
//
//     npm install gltf-validator        (anywhere; NODE_PATH or the current folder must lead to it)
//     node .ci/validate.mjs BEFORE AFTER [BEFORE AFTER ...]
//     node .ci/validate.mjs --clean FILE...
//
// Fails, naming file, code and JSON pointer, on every code that occurs more often after than before as an error or
// a warning. With --clean each file is alone and must have no error and no warning.

import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join } from 'node:path';

const require = createRequire(join(process.cwd(), 'x.js'));
const { validateBytes } = require('gltf-validator');

const ERROR = 0;
const WARNING = 1;

async function issues(path) {
  const report = await validateBytes(new Uint8Array(readFileSync(path)), {
    uri: basename(path),
    maxIssues: 0,
    externalResourceFunction: async (uri) => {
      const file = join(dirname(path), decodeURIComponent(uri));
      // A texture that the test file never came with is as absent before as after.
      if (!existsSync(file)) throw new Error(`no ${uri}`);
      return new Uint8Array(readFileSync(file));
    },
  });
  const counts = new Map();
  for (const { code, severity, pointer } of report.issues.messages) {
    if (severity > WARNING) continue;
    const entry = counts.get(code) ?? { count: 0, severity, pointer };
    entry.count += 1;
    counts.set(code, entry);
  }
  return counts;
}

async function compare(before, after) {
  const old = before === null ? new Map() : await issues(before);
  const now = await issues(after);
  const worse = [];
  for (const [code, { count, severity, pointer }] of now) {
    const allowed = old.get(code)?.count ?? 0;
    if (count <= allowed) continue;
    const kind = severity === ERROR ? 'error' : 'warning';
    worse.push(`${after}: ${kind} ${code} ×${count} (before: ${allowed}), first at ${pointer ?? 'the file'}`);
  }
  return worse;
}

const clean = process.argv.includes('--clean');
const files = process.argv.slice(2).filter((argument) => argument !== '--clean');
if (files.length === 0 || (!clean && files.length % 2 !== 0)) {
  console.error('usage: node .ci/validate.mjs BEFORE AFTER [BEFORE AFTER ...]  |  --clean FILE...');
  process.exit(2);
}
const pairs = clean ? files.map((file) => [null, file]) : [];
for (let at = 0; !clean && at < files.length; at += 2) pairs.push([files[at], files[at + 1]]);
let failures = 0;
for (const [before, after] of pairs) {
  for (const line of await compare(before, after)) {
    console.error(line);
    failures += 1;
  }
}
console.log(`${pairs.length} files validated, ${failures} new kinds of issue`);
process.exit(failures === 0 ? 0 : 1);
