// Measures the laboratory: frames while a lamp is dragged, normals at a new crease angle, and the first picture.
//
//     node bindings/web/tests/speed.mjs NODE_MODULES [--native]
//
// With --native it draws the same frames in one thread of the native library as well, which takes minutes to compile.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(join(resolve(process.argv[2]), 'x.js'));
const { chromium } = require('playwright-core');
const browser = await chromium.launch({ executablePath: process.env.LAB_BROWSER ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
const start = Date.now();
await page.goto(`${pathToFileURL(resolve('target/lab/lab.html')).href}#room=normals`);
const paint = await page.evaluate(() => new Promise((done) => {
  new PerformanceObserver((list) => done(list.getEntries()[0].startTime)).observe({ type: 'paint', buffered: true });
}));
await page.waitForSelector('#laboratory[data-ready]');
console.log(`first paint ${paint.toFixed(0)} ms, first pictures ${Date.now() - start} ms`);
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const view = { subject: 'superquadric', segments: 188, size: [640, 480], crease: 180 };
const lamps = Array.from({ length: 70 }, (_, k) => [Math.sin(k / 10) * 0.7, Math.cos(k / 10) * 0.7]);
const draws = lamps.map((lamp) => ({ verb: 'draw', view: { ...view, lamp }, pictures: ['phong'], marks: [] }));
const found = await page.evaluate(async ({ view, draws }) => {
  const ask = window.laboratory.ask;
  const faces = (await ask({ verb: 'normals', view })).value.facts.faces;
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [640, 480];
  document.body.append(canvas);
  const frames = [];
  for (const draw of draws) {
    const before = performance.now();
    const { buffers } = await ask(draw);
    canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(buffers[0].buffer), 640, 480), 0, 0);
    frames.push(performance.now() - before);
  }
  const creases = [];
  for (let k = 0; k < 15; k++) creases.push((await ask({ verb: 'normals', view: { ...view, crease: 20 + k } })).milliseconds);
  return { faces, frames, creases };
}, { view, draws });
await browser.close();
const frame = median(found.frames.slice(10));
console.log(`${found.faces} triangles, Phong, 640×480: ${frame.toFixed(1)} ms a frame, ${(1000 / frame).toFixed(1)} frames a second`);
console.log(`normals at a new crease angle: ${median(found.creases).toFixed(1)} ms`);
if (process.argv.includes('--native')) {
  const folder = mkdtempSync(join(tmpdir(), 'laboratory-'));
  const requests = Object.fromEntries(draws.map((draw, k) => [`frame-${String(k).padStart(2, '0')}`, draw]));
  writeFileSync(join(folder, 'requests.json'), JSON.stringify(requests));
  const command = ['run', '--release', '--quiet', '--package', 'crease-web', '--bin', 'answers', '--target-dir', resolve('target/lab/build')];
  const printed = execFileSync('cargo', [...command, '--', join(folder, 'requests.json'), join(folder, 'answers')], {
    cwd: 'bindings/web', encoding: 'utf8', env: { ...process.env, RAYON_NUM_THREADS: '1' },
  });
  rmSync(folder, { recursive: true });
  const times = printed.trim().split('\n').map((line) => Number(line.split(' ')[1]));
  console.log(`the same in one thread of the native library: ${median(times.slice(10)).toFixed(1)} ms a frame`);
}
