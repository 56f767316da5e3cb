// Measures the laboratory: frames while a lamp is dragged, normals at a new crease angle, and the first picture.
//
//     node bindings/web/tests/speed.mjs NODE_MODULES
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(join(resolve(process.argv[2]), 'x.js'));
const { chromium } = require('playwright-core');
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
const start = Date.now();
await page.goto(`${pathToFileURL(resolve('target/lab/lab.html')).href}#room=normals`);
const paint = await page.evaluate(() => new Promise((done) => {
  new PerformanceObserver((list) => done(list.getEntries()[0].startTime)).observe({ type: 'paint', buffered: true });
}));
await page.waitForSelector('#laboratory[data-ready]');
console.log(`first paint ${paint.toFixed(0)} ms, first pictures ${Date.now() - start} ms`);
const found = await page.evaluate(async () => {
  const ask = window.laboratory.ask;
  const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
  const view = { subject: 'superquadric', segments: 188, size: [640, 480], crease: 180 };
  const faces = (await ask({ verb: 'normals', view })).value.facts.faces;
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [640, 480];
  document.body.append(canvas);
  const frames = [];
  for (let k = 0; k < 70; k++) {
    const before = performance.now();
    const lamp = [Math.sin(k / 10) * 0.7, Math.cos(k / 10) * 0.7];
    const { buffers } = await ask({ verb: 'draw', view: { ...view, lamp }, pictures: ['phong'], marks: [] });
    canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(buffers[0].buffer), 640, 480), 0, 0);
    frames.push(performance.now() - before);
  }
  const creases = [];
  for (let k = 0; k < 15; k++) creases.push((await ask({ verb: 'normals', view: { ...view, crease: 20 + k } })).milliseconds);
  return { faces, frame: median(frames.slice(10)), crease: median(creases) };
});
console.log(`${found.faces} triangles, Phong, 640×480: ${found.frame.toFixed(1)} ms a frame, ${(1000 / found.frame).toFixed(1)} frames a second`);
console.log(`normals at a new crease angle: ${found.crease.toFixed(1)} ms`);
await browser.close();
