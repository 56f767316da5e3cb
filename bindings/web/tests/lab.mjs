// Tests of the laboratory in a real browser. Run from the root of the repository, after `bash bindings/web/build`:
//
//     node bindings/web/tests/lab.mjs NODE_MODULES [NATIVE_ANSWERS [PART_OF_A_NAME]]
//
// NODE_MODULES has playwright-core and axe-core. NATIVE_ANSWERS is the folder that `cargo test laboratory` wrote; without it, bits are
// not compared. LAB_BROWSER is the path of another browser than /usr/bin/chromium: a Chromium, or a Firefox if its name says so.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, native, only] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), 'x.js'));
const { chromium, firefox } = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const page_file = pathToFileURL(resolve('target/lab/lab.html')).href;
const here = 'bindings/web';
const SAME_BITS = 'the same bits as the native program';
const ROOMS = ['normals', 'artefacts', 'probe', 'inspect', 'exercises'];

const executablePath = process.env.LAB_BROWSER ?? '/usr/bin/chromium';
const isFirefox = basename(executablePath).includes('firefox');
const browser = isFirefox
  ? await firefox.launch({ executablePath, channel: 'moz-firefox' })
  : await chromium.launch({ executablePath, args: ['--no-sandbox'] });
let failed = 0;

/** Runs a test. */
async function test(name, run) {
  if (only && !name.includes(only)) return;
  if (!native && name === SAME_BITS) return console.log(`skip  ${name}: no answers of the native program`);
  const start = Date.now();
  try {
    await run();
    console.log(`ok    ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAIL  ${name}\n${error.stack ?? error}`);
  }
}

/** A page at a link; everything on its console and every request is an error. */
async function open(link = '', options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, locale: 'en-GB', ...options });
  const page = await context.newPage();
  const troubles = [];
  page.on('console', (message) => troubles.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => troubles.push(`error: ${error}`));
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(page_file)) troubles.push(`request: ${request.url()}`);
  });
  await page.goto(page_file + link);
  await page.waitForSelector('#laboratory[data-ready]', { timeout: 60_000 });
  return { page, troubles, close: () => context.close() };
}

/** Goes to another link on the same page. */
async function go(page, link) {
  await page.evaluate((fragment) => {
    delete document.getElementById('laboratory').dataset.ready;
    location.hash = fragment;
  }, link);
  await page.waitForSelector('#laboratory[data-ready]', { timeout: 60_000 });
}

const drawn = (page) => page.evaluate(() => Number(document.querySelector('.room')?.dataset.drawn ?? 0));
async function after(page, action) {
  const before = await drawn(page);
  await action();
  await page.waitForFunction((count) => Number(document.querySelector('.room')?.dataset.drawn ?? 0) > count, before, { timeout: 30_000 });
}
const checksum = (page, index = 0) => page.evaluate((k) => {
  const canvas = document.querySelectorAll('canvas')[k];
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.reduce((sum, byte, place) => (sum * 31 + byte * (place % 97)) % 2147483647, 7);
}, index);

await test('Portuguese and English have the same keys and placeholders, and all that scripts name exist', async () => {
  const [en, pt] = ['en', 'pt'].map((tag) => JSON.parse(readFileSync(`${here}/page/texts.${tag}.json`, 'utf8')));
  assert.deepEqual(Object.keys(pt), Object.keys(en));
  const holes = (text) => (text.match(/\{\w+\}/g) ?? []).sort();
  for (const key of Object.keys(en)) {
    assert.deepEqual(holes(pt[key]), holes(en[key]), key);
    assert.ok(en[key].length > 0 && pt[key].length > 0, key);
  }
  const scripts = readdirSync(`${here}/page`).filter((name) => name.endsWith('.js'));
  const sources = scripts.map((name) => readFileSync(`${here}/page/${name}`, 'utf8')).join('\n');
  const named = new Set([...sources.matchAll(/'([a-z][\w-]*)'/gi)].map((match) => match[1]));
  const starts = [...sources.matchAll(/[`']([a-z-]+-)(?:\$\{|')/g)].map((match) => match[1]);
  for (const [, key] of sources.matchAll(/\btext\('([\w-]+)'/g)) assert.ok(key in en, `no text has the key ${key}`);
  for (const key of Object.keys(en)) {
    assert.ok(named.has(key) || starts.some((start) => key.startsWith(start)), `no script names ${key}`);
  }
});

await test('each room opens from disk: no message on the console, no request', async () => {
  const { page, troubles, close } = await open();
  for (const room of ROOMS) {
    await go(page, `#room=${room}&zoom=1.1`);
    assert.equal(await page.getAttribute('nav [aria-current]', 'data-name'), `room-${room}`);
    assert.deepEqual(troubles, []);
    assert.equal(await page.locator('.message.error').count(), 0);
  }
  await close();
});

await test('findings have no marks of Markdown', async () => {
  const { page, close } = await open('#room=inspect');
  let findings = 0;
  for (const subject of ['gear', 'bracket', 'leaf', 'teapot']) {
    await go(page, `#room=inspect&subject=${subject}`);
    findings += await page.locator('details.finding').count();
    assert.ok(!(await page.textContent('.room')).includes('`'), subject);
  }
  assert.ok(findings > 0);
  await close();
});

await test(SAME_BITS, async () => {
  const { page, close } = await open('#room=exercises');
  const requests = JSON.parse(readFileSync(`${here}/tests/requests.json`, 'utf8'));
  const experiments = await page.evaluate(async () => (await window.laboratory.ask({ verb: 'experiments', language: 'en' })).value.map(({ id }) => id));
  for (const id of experiments) assert.ok(`experiment-${id}` in requests, `no request for ${id}`);
  assert.ok(Object.keys(requests).filter((name) => name.startsWith('normals-')).length >= 12);
  let buffers = 0;
  for (const [name, request] of Object.entries(requests)) {
    const answer = await page.evaluate(async (sent) => {
      const { value, buffers } = await window.laboratory.ask(sent);
      const base64 = (bytes) => {
        let text = '';
        for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
        return btoa(text);
      };
      return { value: JSON.stringify(value), buffers: buffers.map(base64) };
    }, request);
    const expected = JSON.stringify(JSON.parse(readFileSync(join(native, `${name}.json`), 'utf8')));
    assert.equal(answer.value, expected, `${name}: other numbers`);
    assert.ok(!('error' in JSON.parse(answer.value)), `${name}: ${answer.value}`);
    answer.buffers.forEach((own, k) => {
      const other = readFileSync(join(native, `${name}.${k}`));
      assert.ok(Buffer.from(own, 'base64').equals(other), `${name}: buffer ${k} differs`);
      buffers++;
    });
    assert.ok(!existsSync(join(native, `${name}.${answer.buffers.length}`)), `${name}: a buffer is missing`);
  }
  assert.ok(buffers > 100, `${buffers} buffers`);
  console.log(`      ${Object.keys(requests).length} answers, ${buffers} buffers`);
  await close();
});

await test('sliders by keyboard change the picture and the link', async () => {
  const { page, troubles, close } = await open();
  for (const [room, name] of [['normals', 'crease'], ['artefacts', 'segments'], ['probe', 'exponent'], ['inspect', 'turn']]) {
    await go(page, `#room=${room}&subject=gear&segments=0&experiment=mach-bands`);
    await page.focus(`input[data-name="${name}"]`);
    const [link, picture] = [page.url(), await checksum(page)];
    for (let k = 0; k < 3; k++) await after(page, () => page.keyboard.press('PageUp'));
    assert.notEqual(page.url(), link, room);
    assert.notEqual(await checksum(page), picture, room);
    assert.deepEqual(troubles, []);
  }
  await close();
});

await test('the lamp is dragged', async () => {
  const { page, close } = await open('#room=normals');
  const box = await page.locator('.stage').first().boundingBox();
  const picture = await checksum(page, 2);
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height * 0.3);
  await page.mouse.down();
  await after(page, () => page.mouse.move(box.x + box.width * 0.8, box.y + box.height * 0.7, { steps: 4 }));
  await after(page, () => page.mouse.up());
  assert.match(page.url(), /lampx=0\.6&lampy=-0\.4/);
  assert.deepEqual(await Promise.all(['lampx', 'lampy'].map((name) => page.inputValue(`input[data-name="${name}"]`))), ['0.6', '-0.4']);
  assert.notEqual(await checksum(page, 2), picture);
  await close();
});

await test('a link restores the state', async () => {
  const link = '#room=normals&subject=torus&segments=31&weight=max&crease=77&turn=-60&lampx=0.3&hairs=1&lang=pt';
  const first = await open(link);
  const second = await open('#room=exercises');
  await second.page.evaluate((fragment) => { location.hash = fragment; }, link);
  await second.page.waitForSelector('#laboratory[data-ready="normals"] select[data-name="weight"]');
  await second.page.waitForFunction(() => document.querySelector('.room')?.dataset.drawn);
  assert.equal(await first.page.inputValue('select[data-name="weight"]'), 'max');
  assert.equal(await first.page.inputValue('input[data-name="crease"]'), '77');
  assert.equal(await first.page.getAttribute('html', 'lang'), 'pt-BR');
  assert.equal(await checksum(first.page, 1), await checksum(second.page, 1));
  await first.close();
  await second.close();
  const run = await open('#room=artefacts&experiment=shading-terminator&parameters=segments:12');
  assert.equal(await run.page.inputValue('select[data-name="experiment"]'), 'shading-terminator');
  assert.match(await run.page.textContent('.command code'), /shading-terminator --segments 12/);
  await run.close();
});

await test('the page shows the state of its address, also after Back', async () => {
  const { page, troubles, close } = await open('#room=normals&subject=torus&segments=24');
  await page.focus('input[data-name="crease"]');
  await after(page, () => page.keyboard.press('PageUp'));
  await go(page, '#room=normals&subject=gear&segments=0');
  await page.goBack();
  await page.waitForFunction(() => document.querySelector('select[data-name="subject"]')?.value === 'torus');
  await close();
  assert.deepEqual(troubles, []);
});

await test('unknown names and values in a link are ignored', async () => {
  const { page, troubles, close } = await open();
  for (const link of ['room=__proto__', 'room=constructor', 'lang=toString', 'segments=1.5', 'weight=x', 'subject=x&segments=1e9', 'against=x',
    'room=probe&px=1&py=-5', 'room=exercises&exercise=x&seed=1e12', 'room=artefacts&experiment=x&magnified=x:1,2', 'zoom=1e300&turn=NaN']) {
    await go(page, `#${link}`);
    assert.deepEqual(await page.locator('.message.error:visible').allTextContents(), [], link);
    assert.equal(await page.textContent('h1'), 'crease: laboratory', link);
    assert.deepEqual(troubles, [], link);
  }
  await close();
});

await test('the magnifier is in the link, and can be closed', async () => {
  const { page, close } = await open('#room=artefacts&experiment=lost-highlight&magnified=plate-gouraud:0.1,0.5,0.9,0.5');
  assert.equal(await page.inputValue('input[aria-label$="y₂"]'), '160');
  await page.click('.panel .close');
  assert.ok(!(await page.isVisible('.panel')) && !page.url().includes('magnified'));
  await close();
});

await test('a link keeps the place of a finding, and the pixels of a line', async () => {
  const { page, close } = await open('#room=inspect&subject=leaf');
  await page.locator('details.finding summary').first().click();
  await after(page, () => page.locator('details.finding .buttons button').first().click());
  const opened = await open(new URL(page.url()).hash);
  assert.equal(await opened.page.locator('details.finding[open]').count(), 1);
  assert.equal(await opened.page.locator('.stage circle').count(), 2);
  await opened.close();
  await go(page, '#room=artefacts&experiment=lost-highlight&parameters=size:320&magnified=plate-gouraud:0.1,0.5,0.2,0.5');
  await page.fill('input[aria-label$="x₂"]', '287');
  await page.press('input[aria-label$="x₂"]', 'Tab');
  const again = await open(new URL(page.url()).hash);
  assert.equal(await again.page.inputValue('input[aria-label$="x₂"]'), '287');
  await again.close();
  await close();
});

await test('a probed pixel is the same at every width', async () => {
  const term = async (width) => {
    const { page, close } = await open('#room=probe&px=0.6&py=0.5', { viewport: { width, height: 900 } });
    const words = await page.innerText('.terms');
    await close();
    return words;
  };
  assert.equal(await term(1280), await term(400));
});

await test('the names of arrows at one point are apart', async () => {
  const { page, close } = await open('#room=exercises&exercise=1-6-17');
  await page.click('[data-name="way"]');
  await page.waitForSelector('.arrows text');
  const places = await page.locator('.arrows text').evaluateAll((all) => all.map((name) => [Number(name.getAttribute('x')), Number(name.getAttribute('y'))]));
  const [width, height] = await page.locator('.arrows').first().evaluate((svg) => svg.getAttribute('viewBox').split(' ').slice(2).map(Number));
  assert.ok(places.length === 5 && places.every(([x, y]) => x > 0 && x < width && y > 0 && y < height), String(places));
  places.forEach(([x, y], k) => places.slice(0, k).forEach(([a, b]) => assert.ok(Math.hypot(x - a, y - b) > width / 40, String(places))));
  assert.equal(await page.locator('.arrows circle.spot').count(), 2);
  await close();
});

await test('counts of separate triangles are those of the saved file', async () => {
  const { page, close } = await open('#room=normals&crease=180');
  const stl = Buffer.alloc(84 + 50 * 2);
  stl.writeUInt32LE(2, 80);
  [[0, 0, 0, 1, 0, 0, 1, 1, 0], [0, 0, 0, 1, 1, 0, 0, 1, 0]].forEach((corners, facet) => corners.forEach((x, k) => stl.writeFloatLE(x, 84 + 50 * facet + 12 + 4 * k)));
  mkdirSync('target/tmp', { recursive: true });
  writeFileSync('target/tmp/square.stl', stl);
  await drop(page, 'target/tmp/square.stl');
  await page.waitForFunction(() => document.querySelector('select[data-name="subject"]')?.value === 'file');
  const { value } = await page.evaluate(() => window.laboratory.ask({ verb: 'save', view: { subject: 'file', segments: 0, crease: 180 }, format: 'glb' }));
  assert.equal(value.vertices, 4);
  assert.match((await page.innerText('.counts')).replace(/\s+/g, ' '), /\b4\b.*\b4\b/);
  await close();
});

await test('a slow room can be left', async () => {
  const { page, close } = await open('#room=artefacts&experiment=lost-highlight');
  let started = 0;
  page.on('worker', () => { started++; });
  await page.evaluate(() => { location.hash = '#room=artefacts&experiment=silhouette&parameters=size:640'; });
  // The page says that it computes; then the work that nothing needs is ended with its worker.
  await page.waitForSelector('.working:visible');
  await page.click('[data-name="room-exercises"]');
  await page.waitForSelector('#laboratory[data-ready="exercises"]', { timeout: 60_000 });
  assert.equal(started, 1);
  assert.deepEqual(await page.locator('.message.error:visible').allTextContents(), []);
  await close();
});

await test('a plot begins with a measure and a parameter that change', async () => {
  const { page, close } = await open('#room=artefacts&experiment=false-smoothing&parameters=size:96');
  await page.click('[data-name="trace"]');
  await page.waitForFunction(() => document.querySelector('select[data-name="along"]')?.value === 'crease', null, { timeout: 60_000 });
  await page.waitForFunction(() => new Set([...document.querySelectorAll('.live circle')].map((it) => it.getAttribute('cy'))).size > 1, null, { timeout: 60_000 });
  await close();
});

await test('a print of a dark page is dark on white', async () => {
  if (isFirefox) return console.log('      skipped: the protocol of this browser has no media for print');
  const { page, close } = await open('#room=normals', { colorScheme: 'dark' });
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  const colours = await page.evaluate(() => [getComputedStyle(document.body).backgroundColor, getComputedStyle(document.body).color]);
  assert.deepEqual(colours, ['rgb(255, 255, 255)', 'rgb(0, 0, 0)']);
  await close();
});

/** Drops a file on the page as a user does. */
async function drop(page, path, name = path.split('/').pop()) {
  const text = readFileSync(path).toString('base64');
  const transfer = await page.evaluateHandle(([bytes, file]) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], file));
    return data;
  }, [text, name]);
  await page.dispatchEvent('main', 'drop', { dataTransfer: transfer });
}

await test('a dropped file of each format is shown, and a hostile one is an error in words', async () => {
  const { page, troubles, close } = await open('#room=normals');
  for (const file of ['gear.obj', 'leaf.ply', 'part-binary.stl', 'mirrored.gltf', 'sphere-seam.glb']) {
    if (statSync(`data/${file}`).size === 0) continue;
    await drop(page, `data/${file}`);
    await page.waitForFunction((name) => document.querySelector('select[data-name="subject"]')?.selectedOptions[0]?.textContent === name, file);
    await page.waitForFunction(() => document.querySelector('.counts td'));
    assert.equal(await page.locator('.message.error:visible').count(), 0, file);
  }
  const bad = join(process.env.CREASE_MESHES ?? '../shared/meshes', 'bad');
  const hostile = existsSync(bad) ? readdirSync(bad).filter((name) => /\.(obj|ply|stl|glb|gltf)$/.test(name)).map((name) => join(bad, name)) : [];
  if (!hostile.length) console.log(`      no ${bad}: one hostile file only`);
  let refused = 0;
  for (const path of [`${here}/tests/hostile.obj`, ...hostile]) {
    await page.evaluate(() => document.querySelector('.message button')?.click());
    await drop(page, path);
    await page.waitForFunction((name) => document.querySelector('.message.error:not([hidden])')
      || document.querySelector('select[data-name="subject"]')?.selectedOptions[0]?.textContent === name, path.split('/').pop(), { timeout: 30_000 });
    const shown = page.locator('.message.error:visible');
    if (await shown.count()) {
      refused++;
      const words = await shown.textContent();
      assert.ok(words.includes(path.split('/').pop()) && !words.includes('the program stopped'), `${path}: ${words}`);
    }
  }
  assert.ok(refused >= 1, 'no hostile file was refused');
  await page.selectOption('select[data-name="subject"]', 'torus');
  await page.waitForFunction(() => document.querySelector('input[data-name="segments"]'));
  assert.deepEqual(troubles, []);
  await close();
});

await test('exercises accept the answers of the lectures and refuse others', async () => {
  const printed = {
    'example-1': ['5.0588', '5.0588', '5.0588'], 'example-1-blinn': ['5.0971', '5.0971', '5.0971'],
    'example-2': ['0.2462', '0.2462', '0.2462'], 'example-2-blinn': ['0.2470', '0.2470', '0.2470'],
    'example-3': ['0.1524', '0.1584', '0.1554'], 'example-3-blinn': ['0.1524', '0.1585', '0.1555'],
    '1-6-16-matte': ['0.6', '0.7', '0'], '1-6-16': ['0.7', '0.8', '0.1'], '1-6-17': ['0.9', '1.1', '0.3'],
    '1-6-18': ['0.4', '0.8', '0.2'], '1-6-19': ['0.3535', '0.5535', '0'], '1-6-19-blinn': ['0.7036', '0.9036', '0'],
    '1-6-23': ['0.75', '0', '0'], '1-6-24': ['0.6', '0.4', '0.6'], '1-6-25-a': ['0.15', '0.4', '0.3'],
    '1-6-25-b1': ['0.1', '0.5', '0.5'], '1-6-25-b2': ['0.2', '0.3', '0.1'], '1-6-29': ['0', '0', '0'],
    '1-6-31': ['0,1647', '0,2094', '0,0560'],
  };
  const { page, troubles, close } = await open('#room=exercises');
  const all = await page.locator('select[data-name="exercise"] option').evaluateAll((options) => options.map(({ value }) => value));
  assert.deepEqual(Object.keys(printed).sort(), all.sort());
  const answer = async (numbers) => {
    for (const [k, name] of ['R', 'G', 'B'].entries()) await page.fill(`[data-name="answer-${name}"]`, numbers[k]);
    await page.evaluate(() => { document.querySelector('.result').className = 'result'; });
    await page.click('button[type="submit"]');
    await page.waitForFunction(() => /right|wrong/.test(document.querySelector('.result').className));
    return page.getAttribute('.result', 'class');
  };
  for (const [id, numbers] of Object.entries(printed)) {
    if ((await page.inputValue('select[data-name="exercise"]')) !== id) await after(page, () => page.selectOption('select[data-name="exercise"]', id));
    assert.match(await answer(numbers), /right/, id);
    const wrong = String(Number(numbers[1].replace(',', '.')) + 0.02);
    assert.match(await answer([numbers[0], wrong, numbers[2]]), /wrong/, id);
  }
  await after(page, () => page.click('[data-name="random"]'));
  assert.match(page.url(), /seed=\d+/);
  const colour = await page.evaluate(async () => {
    const { exercise, seed } = window.laboratory.state;
    return (await window.laboratory.ask({ verb: 'check', id: exercise, seed, answer: [0, 0, 0] })).value.colour;
  });
  assert.match(await answer(colour.map(String)), /right/);
  assert.ok(page.url().includes(`seed=${await page.inputValue('input[data-name="seed"]')}`));
  await page.selectOption('select[data-name="lang"]', 'pt');
  await page.waitForSelector('html[lang="pt-BR"] #laboratory[data-ready="exercises"]');
  assert.equal(await page.inputValue('[data-name="answer-R"]'), String(colour[0]), 'an answer outlives the change of language');
  await after(page, () => page.selectOption('select[data-name="exercise"]', '1-6-25-b1'));
  await page.click('[data-name="way"]');
  assert.match(await page.locator('.terms').innerText(), /vértice 1, w = 0,5/);
  assert.deepEqual(troubles, []);
  await close();
});

await test('every experiment shows artefact, cure and difference, and a number along a slider of its own', async () => {
  const { page, troubles, close } = await open('#room=artefacts');
  const experiments = await page.evaluate(async () => (await window.laboratory.ask({ verb: 'experiments', language: 'en' })).value);
  assert.ok(experiments.length >= 16);
  for (const { id, parameters } of experiments) {
    await go(page, `#room=artefacts&experiment=${id}&parameters=size:96`);
    for (const role of ['bad', 'cured', 'difference']) assert.ok(await page.locator(`figure.${role}`).count() > 0, `${id}: no picture ${role}`);
    const own = parameters.filter(({ name, range }) => range && name !== 'size');
    assert.ok(own.length > 0, `${id}: no slider`);
    assert.ok(await page.locator('.live').isVisible(), `${id}: no plot`);
  }
  await go(page, '#room=artefacts&experiment=attenuation-and-overflow&parameters=size:96');
  assert.equal(await page.locator('.verdict.fails').count(), 0);
  await go(page, '#room=artefacts&experiment=attenuation-and-overflow&parameters=size:96,intensity:4');
  await page.waitForSelector('.verdict.fails');
  assert.deepEqual(troubles, []);
  await close();
});

await test('pictures are saved under their names', async () => {
  const { page, close } = await open('#room=exercises');
  for (const [link, file] of [['#room=normals&subject=torus', 'torus-flat.png'], ['#room=probe&subject=torus', 'torus-phong.png'],
    ['#room=artefacts&experiment=orientation&parameters=size:65', 'orientation-halves.png']]) {
    await go(page, link);
    await page.locator('figure').first().hover();
    const [saved] = await Promise.all([page.waitForEvent('download'), page.locator('figure .save').first().click()]);
    assert.equal(saved.suggestedFilename(), file);
  }
  await close();
});

await test('a saved picture of the probe has its vectors', async () => {
  const { page, troubles, close } = await open('#room=probe&subject=torus');
  await page.locator('figure').hover();
  const [saved] = await Promise.all([page.waitForEvent('download'), page.click('figure .save')]);
  const different = await page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const shown = document.querySelector('.stage canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    copy.getContext('2d').drawImage(image, 0, 0);
    const [a, b] = [shown, copy].map((canvas) => new Uint32Array(canvas.getContext('2d').getImageData(0, 0, 512, 512).data.buffer));
    return a.reduce((count, pixel, k) => count + (pixel === b[k] ? 0 : 1), 0);
  }, readFileSync(await saved.path()).toString('base64'));
  assert.ok(different > 1000 && different < 30_000, `${different} pixels are of vectors`);
  assert.deepEqual(troubles, []);
  await close();
});

await test('the trace of an experiment follows its closed form', async () => {
  const { page, close } = await open('#room=artefacts&experiment=flat-validity');
  await page.click('[data-name="trace"]');
  await page.waitForFunction(() => document.querySelector('.room')?.dataset.traced, null, { timeout: 60_000 });
  assert.ok(await page.locator('.live circle').count() > 10);
  await close();
});

await test('all points of a plot are measured on pictures of one size', async () => {
  // A shift of R sin(π/2N) pixels, which falls with the number of segments.
  const { page, close } = await open('#room=artefacts&experiment=lost-highlight&measure=2&along=segments');
  assert.match(await page.locator('.live .hint').innerText(), /pictures of 128 pixels/);
  if (!await page.evaluate(() => document.querySelector('.room')?.dataset.traced)) await page.click('[data-name="trace"]');
  await page.waitForFunction(() => document.querySelector('.room')?.dataset.traced, null, { timeout: 60_000 });
  const heights = await page.locator('.live circle').evaluateAll((all) => all.map((point) => Number(point.getAttribute('cy'))));
  assert.ok(heights.length > 10 && heights.every((height, k) => k === 0 || height >= heights[k - 1] - 8), heights.join());
  await close();
});

await test('axe finds no serious violation, in both colours and languages', async () => {
  const { page, close } = await open();
  await page.evaluate(axe);
  for (const [room, more] of ROOMS.flatMap((name) => [[name, '&theme=light'], [name, '&theme=dark&lang=pt']])) {
    await go(page, `#room=${room}${more}`);
    const { violations } = await page.evaluate(() => window.axe.run(document));
    const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
    assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`).slice(0, 3)}`), [], room + more);
  }
  await close();
});

await test('no text is wider than the page, at three widths', async () => {
  mkdirSync('target/lab/screenshots', { recursive: true });
  const { page, close } = await open();
  for (const width of [1280, 768, 390]) {
    await page.setViewportSize({ width, height: 900 });
    for (const room of ROOMS) {
      await go(page, `#room=${room}&subject=gear&segments=0&experiment=mach-bands&zoom=${1 + width / 10_000}`);
      await page.screenshot({ path: `target/lab/screenshots/${room}-${width}.png`, fullPage: width !== 1280 });
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(overflow <= 0, `${room} at ${width}: ${overflow} pixels too wide`);
    }
  }
  await close();
});

await browser.close();
if (failed) {
  console.log(`${failed} failed`);
  process.exit(1);
}
