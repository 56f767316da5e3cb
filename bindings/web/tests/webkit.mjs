// Tests of the laboratory in WebKit, the engine of Safari. Run from the root of the repository, after `bash bindings/web/build`:
//
//     xvfb-run -a node bindings/web/tests/webkit.mjs [NATIVE_ANSWERS]
//
// It needs Debian's packages webkit2gtk-driver and xvfb. Playwright drives only WebKit builds of its own, so this script sends the
// commands of W3C WebDriver itself. NATIVE_ANSWERS as for `lab.mjs`.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const native = process.argv[2];
const here = 'bindings/web';
const ROOMS = ['normals', 'artefacts', 'probe', 'inspect', 'exercises'];
const PORT = 4499;
const PAGE_UP = '\uE00E';
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';
const files = execFileSync('dpkg', ['-L', 'libwebkit2gtk-4.1-0'], { encoding: 'utf8' }).split('\n');
const browser = files.find((path) => path.endsWith('/MiniBrowser'));

const sleep = (/** @type {number} */ milliseconds) => new Promise((done) => { setTimeout(done, milliseconds); });

/** Sends a command to the driver. */
async function command(method, path, body) {
  const answer = await fetch(`http://127.0.0.1:${PORT}${path}`, { method, body: body && JSON.stringify(body) });
  const { value } = await answer.json();
  if (value?.error) throw new Error(`${path}: ${value.error}: ${value.message}`);
  return value;
}

/** Calls a function until it gives something, for a minute at most. */
async function until(what, run) {
  for (const end = Date.now() + 60_000; Date.now() < end; await sleep(50)) {
    const found = await run().catch(() => null);
    if (found) return found;
  }
  throw new Error(`no ${what} after a minute`);
}

const driver = spawn('WebKitWebDriver', [`--port=${PORT}`], { stdio: 'inherit' });
let session = '';
try {
  await until('driver', () => command('GET', '/status'));
  const options = { binary: browser, args: ['--automation'] };
  const opened = await command('POST', '/session', { capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': options } } });
  session = `/session/${opened.sessionId}`;
  console.log(`WebKit ${opened.capabilities.browserVersion}`);
  const run = (script, ...args) => command('POST', `${session}/execute/sync`, { script, args });
  const find = async (selector) => (await command('POST', `${session}/element`, { using: 'css selector', value: selector }))[ELEMENT];
  const text = (id) => command('GET', `${session}/element/${id}/text`);
  const ready = () => until('page', () => run('return document.querySelector("#laboratory[data-ready]") !== null'));
  const go = async (link) => {
    await run('delete document.getElementById("laboratory").dataset.ready; location.hash = arguments[0]', link);
    await ready();
  };
  const drawn = () => run('return document.querySelector(".room").dataset.drawn');
  const troubles = () => run(`
    const shown = [...document.querySelectorAll('.message.error')].filter((message) => message.checkVisibility());
    return [...window.troubles, ...shown.map((message) => message.textContent)]`);

  await command('POST', `${session}/timeouts`, { script: 120_000 });
  await command('POST', `${session}/window/rect`, { width: 1280, height: 900 });
  await command('POST', `${session}/url`, { url: pathToFileURL(resolve('target/lab/lab.html')).href });
  await ready();
  await run(`window.troubles = [];
    for (const kind of ['error', 'unhandledrejection']) {
      addEventListener(kind, (event) => window.troubles.push(String(event.message ?? event.reason)));
    }`);

  mkdirSync('target/lab/screenshots', { recursive: true });
  for (const room of ROOMS) {
    await go(`#room=${room}`);
    writeFileSync(`target/lab/screenshots/${room}-webkit.png`, Buffer.from(await command('GET', `${session}/screenshot`), 'base64'));
    assert.deepEqual(await troubles(), [], room);
    assert.equal(await run('return document.documentElement.scrollWidth - innerWidth'), 0, `${room} scrolls sideways`);
  }
  console.log('ok    each room opens from disk');

  for (const [room, name] of [['normals', 'crease'], ['artefacts', 'segments'], ['probe', 'exponent'], ['inspect', 'turn']]) {
    await go(`#room=${room}&subject=gear&segments=0&experiment=mach-bands`);
    const [link, before] = [await run('return location.hash'), await drawn()];
    const slider = await find(`input[data-name="${name}"]`);
    await command('POST', `${session}/element/${slider}/value`, { text: PAGE_UP });
    await until('other picture', async () => (await drawn()) !== before && (await run('return location.hash')) !== link);
    assert.deepEqual(await troubles(), [], room);
  }
  console.log('ok    sliders by keyboard change the picture and the link');

  for (const file of ['gear.obj', 'leaf.ply', 'part-binary.stl', 'mirrored.gltf', 'sphere-seam.glb']) {
    await go('#room=normals&subject=torus');
    const input = await find('input[type="file"]');
    await command('POST', `${session}/element/${input}/value`, { text: resolve('data', file) });
    await until(`counts of ${file}`, () => run(`
      return document.querySelector('select[data-name="subject"]').selectedOptions[0].textContent === arguments[0]
        && document.querySelector('.counts td') !== null`, file));
    assert.deepEqual(await troubles(), [], file);
  }
  await command('POST', `${session}/element/${await find('input[type="file"]')}/value`, { text: resolve(here, 'tests/hostile.obj') });
  const words = await until('error in words', async () => text(await find('.message.error')));
  assert.match(words, /hostile\.obj/);
  console.log('ok    an opened file of each format is shown, and a hostile one is an error in words');

  if (native) {
    const requests = JSON.parse(readFileSync(`${here}/tests/requests.json`, 'utf8'));
    let buffers = 0;
    for (const [name, request] of Object.entries(requests)) {
      const answer = await command('POST', `${session}/execute/async`, {
        script: `
          const [sent, done] = arguments;
          const base64 = (bytes) => {
            let text = '';
            for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
            return btoa(text);
          };
          window.laboratory.ask(sent).then(
            ({ value, buffers }) => done({ value: JSON.stringify(value), buffers: buffers.map(base64) }),
            (error) => done({ value: String(error), buffers: [] }))`,
        args: [request],
      });
      assert.equal(answer.value, JSON.stringify(JSON.parse(readFileSync(join(native, `${name}.json`), 'utf8'))), name);
      answer.buffers.forEach((own, k) => {
        assert.ok(Buffer.from(own, 'base64').equals(readFileSync(join(native, `${name}.${k}`))), `${name}: buffer ${k} differs`);
        buffers++;
      });
    }
    assert.ok(buffers > 100, `${buffers} buffers`);
    console.log(`ok    the same bits as the native program (${Object.keys(requests).length} answers, ${buffers} buffers)`);
  }
} finally {
  if (session) await command('DELETE', session).catch(() => {});
  driver.kill();
}
