// usage: node written_by_tests.mjs TESTS…
//
// Runs test programs so that their folders stay, and the Khronos validator over every GLB and glTF in them that our
// writer made. Exits 1 on any error or warning, and where nothing was written.
import { execFile } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { promisify } from 'node:util';
import { validateGlb } from './validator.mjs';
import { glbParts } from './written_glb.mjs';

const run = promisify(execFile);
const folder = await mkdtemp(path.join(tmpdir(), 'rad-written-'));

// Tests also write files that are damaged on purpose: for them to be read.
async function isOurs(file) {
  const bytes = await readFile(file);
  try {
    const json = file.endsWith('.gltf') ? JSON.parse(bytes.toString('utf8')) : glbParts(bytes).json;
    return /^rad(fix|lint) /.test(json.asset.generator);
  } catch {
    return false;
  }
}

async function written() {
  const files = (await readdir(folder, { recursive: true })).filter((name) => /\.(glb|gltf)$/.test(name)).sort();
  const whole = files.map((name) => path.join(folder, name));
  const ours = await Promise.all(whole.map(isOurs));
  return whole.filter((_, i) => ours[i]);
}

// Models of tests name images that are nowhere; a buffer that is missing is an error.
const PIXEL = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSuQmCC';
const WEBP = Buffer.from('UklGRhoAAABXRUJQVlA4TA0AAAAvAAAAEAcQERGIiP4HAA==', 'base64');
const image = (uri) => (/\.(png|jpe?g)$/.test(uri) ? Buffer.from(PIXEL, 'base64') : /\.webp$/.test(uri) ? WEBP : null);

let failed = 0;
try {
  const env = { ...process.env, TEST_TMPDIR: folder, RAD_KEEP_FOLDERS: '1' };
  for (const program of process.argv.slice(2)) await run(program, ['--gtest_brief=1'], { env, maxBuffer: 1 << 28 });
  const files = await written();
  if (!files.length) throw new Error('the tests wrote no GLB and no glTF');
  for (const file of files) {
    const { problems } = await validateGlb(file, image);
    if (!problems.length) continue;
    ++failed;
    console.log(`FAIL ${path.relative(folder, file)}`);
    for (const problem of problems.slice(0, 20)) console.log(`  ${problem}`);
  }
  console.log(`${files.length} files that tests wrote, ${failed} with errors or warnings`);
} finally {
  await rm(folder, { recursive: true });
}
process.exit(failed ? 1 : 0);
