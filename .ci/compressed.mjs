// Compresses glTF files with gltf-transform and gltfpack, and checks what crease makes of them.
//
//     npm install @gltf-transform/core @gltf-transform/extensions @gltf-transform/functions draco3dgltf gltfpack meshoptimizer
//     node .ci/compressed.mjs PROGRAM FOLDER FILE...        (packages are searched for from the current folder)
//
// FILE is a plain .glb. For each way to compress it: positions that crease decompresses equal the original ones within half a step
// of the quantisation, and normals are bit for bit those of the same file decompressed by gltf-transform, face by face. With
// `--compress meshopt`, gltf-transform reads the same faces from the output. Prints the files that the validator should see.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(join(process.cwd(), 'x.js'));
const load = (name) => import(pathToFileURL(require.resolve(name)));
const { NodeIO } = await load('@gltf-transform/core');
const { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } = await load('@gltf-transform/extensions');
const { meshopt } = await load('@gltf-transform/functions');
const { MeshoptDecoder, MeshoptEncoder } = await load('meshoptimizer');
const draco3d = await load('draco3dgltf');

const DRACO_BITS = 14;
const METHODS = KHRDracoMeshCompression.EncoderMethod;

await MeshoptDecoder.ready;
await MeshoptEncoder.ready;
const newIO = async () =>
  new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.decoder': await draco3d.default.createDecoderModule(),
    'draco3d.encoder': await draco3d.default.createEncoderModule(),
    'meshopt.decoder': MeshoptDecoder,
    'meshopt.encoder': MeshoptEncoder,
  });
const io = await newIO();

const draco = (method) => async (from, to) => {
  const document = await io.read(from);
  document.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({
    method, quantizationBits: { POSITION: DRACO_BITS },
  });
  await io.write(to, document);
};
const transform = (level) => async (from, to) => {
  const document = await io.read(from);
  await document.transform(meshopt({ encoder: MeshoptEncoder, level, quantizePosition: 16 }));
  await io.write(to, document);
};
const lossless = async (from, to) => {
  const document = await io.read(from);
  document.createExtension(EXTMeshoptCompression).setRequired(true)
    .setEncoderOptions({ method: EXTMeshoptCompression.EncoderMethod.QUANTIZE });
  await io.write(to, document);
};
const pack = (...options) => async (from, to) => {
  execFileSync(process.execPath, [require.resolve('gltfpack/cli.js'), '-i', from, '-o', to, '-kn', '-km', '-ke', '-kv', ...options]);
};
const WAYS = {
  'edgebreaker': draco(METHODS.EDGEBREAKER),
  'sequential': draco(METHODS.SEQUENTIAL),
  'medium': transform('medium'),
  'high': transform('high'),
  'lossless': lossless,
  'pack-c': pack('-c'),
  'pack-cc': pack('-cc', '-ce', 'ext'),
  'pack-cz': pack('-cz', '-ce', 'khr'),
  'pack-float': pack('-cc', '-noq'),
};

// World positions of all vertices, and the largest step of stored integers in the world.
function positions(document) {
  const points = [];
  let step = 0;
  for (const node of document.getRoot().listNodes()) {
    const matrix = node.getWorldMatrix();
    const scale = Math.max(...[0, 1, 2].map((axis) => Math.hypot(...matrix.slice(4 * axis, 4 * axis + 3))));
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const accessor = primitive.getAttribute('POSITION');
      const stored = accessor.getArray();
      if (!(stored instanceof Float32Array)) {
        const most = accessor.getNormalized() ? 2 ** (8 * stored.BYTES_PER_ELEMENT - (stored instanceof Int16Array || stored instanceof Int8Array ? 1 : 0)) - 1 : 1;
        step = Math.max(step, scale / most);
      }
      const used = new Set(primitive.getIndices()?.getArray() ?? Array(accessor.getCount()).keys());
      for (const vertex of used) {
        const [x, y, z] = accessor.getElement(vertex, []);
        points.push([0, 1, 2].map((row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row]));
      }
    }
  }
  return { points, step };
}

// The largest distance along an axis from a point of one set to the nearest of the other.
function deviation(some, others) {
  return Math.max(...some.map((p) => Math.min(...others.map((q) => Math.max(...p.map((x, axis) => Math.abs(x - q[axis])))))));
}

// Every face as the bytes of its corners, from the smallest corner on.
function faces(document, semantics) {
  const all = [];
  for (const mesh of document.getRoot().listMeshes()) {
    for (const primitive of mesh.listPrimitives()) {
      const arrays = semantics.map((semantic) => primitive.getAttribute(semantic)).filter(Boolean);
      const corner = (vertex) => arrays.map((accessor) => {
        const [array, size] = [accessor.getArray(), accessor.getElementSize()];
        const bytes = array.slice(vertex * size, (vertex + 1) * size);
        return Buffer.from(bytes.buffer).toString('hex');
      }).join('-');
      const indices = primitive.getIndices()?.getArray() ?? [...Array(primitive.getAttribute('POSITION').getCount()).keys()];
      for (let at = 0; at + 2 < indices.length; at += 3) {
        const corners = [0, 1, 2].map((k) => corner(indices[at + k]));
        const first = corners.indexOf([...corners].sort()[0]);
        all.push([0, 1, 2].map((k) => corners[(first + k) % 3]).join(' '));
      }
    }
  }
  return all.sort();
}

function same(what, some, others) {
  const different = some.filter((face, number) => face !== others[number]).length;
  if (some.length === 0 || some.length !== others.length || different > 0) {
    throw new Error(`${what}: ${different} of ${some.length} faces differ (the other has ${others.length})`);
  }
}

const [program, folder, ...files] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const run = (...options) => execFileSync(program, options, { stdio: ['ignore', 'pipe', 'pipe'] });
const outputs = [];
for (const file of files) {
  const original = positions(await io.read(file));
  const size = Math.max(...[0, 1, 2].map((axis) => {
    const along = original.points.map((point) => point[axis]);
    return Math.max(...along) - Math.min(...along);
  }));
  for (const [way, compress] of Object.entries(WAYS)) {
    const name = (kind) => join(folder, `${basename(file, '.glb')}.${way}.${kind}glb`);
    const what = `${basename(file)}, ${way}`;
    await compress(file, name(''));
    const compressed = readFileSync(name(''));
    const header = compressed.subarray(20, 20 + compressed.readUInt32LE(12)).toString();
    if (!/draco|meshopt/.test(header)) throw new Error(`${what}: not compressed`);

    run('normals', name(''), '-q', '-o', name('ours.'));
    const ours = await io.read(name('ours.'));
    const decompressed = positions(ours);
    const step = /draco/.test(header) ? size / (2 ** DRACO_BITS - 1) : decompressed.step;
    const bound = 0.5 * step + 4e-7 * size;
    const off = Math.max(deviation(decompressed.points, original.points), deviation(original.points, decompressed.points));
    if (!(off <= bound)) throw new Error(`${what}: positions are off by ${off}, more than ${bound}`);

    // gltf-transform knows the older name only; its decoder reads both bitstreams.
    writeFileSync(name('known.'), Buffer.from(compressed.toString('latin1').replaceAll('KHR_meshopt', 'EXT_meshopt'), 'latin1'));
    const plain = await (await newIO()).read(name('known.'));
    for (const extension of plain.getRoot().listExtensionsUsed()) {
      if (/draco|meshopt/.test(extension.extensionName)) extension.dispose();
    }
    await io.write(name('plain.'), plain);
    run('normals', name('plain.'), '-q', '-o', name('reference.'));
    const reference = await io.read(name('reference.'));
    same(what, faces(ours, ['POSITION', 'NORMAL']), faces(reference, ['POSITION', 'NORMAL']));

    run('normals', name(''), '-q', '--compress', 'meshopt', '-o', name('again.'));
    const again = await io.read(name('again.'));
    same(`${what}, compressed again`, faces(again, ['POSITION', 'NORMAL']), faces(ours, ['POSITION', 'NORMAL']));
    outputs.push(name('plain.'), name('ours.'));
    console.error(`${what}: positions off by ${off.toExponential(1)} (bound ${bound.toExponential(1)}), normals alike`);
  }
}
writeFileSync(join(folder, 'pairs.txt'), outputs.join('\n') + '\n');
