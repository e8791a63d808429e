// usage: node bundle.mjs [--check]
//
// Bundles web/page and what it uses of three.js into report/html/page.bundle.js, which the C++ build puts into radlint.
// --check: exit 1 where the file is not what would be written.
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const OUT = path.join(HERE, '../report/html/page.bundle.js');

async function licences() {
  const text = await readFile(path.join(HERE, 'node_modules/three/LICENSE'), 'utf8');
  const { version } = JSON.parse(await readFile(path.join(HERE, 'node_modules/three/package.json'), 'utf8'));
  return `/*\nMade by web/bundle.mjs of web/page and three.js ${version}. Licence of three.js:\n\n${text.trim()}\n*/\n`;
}

async function bundle() {
  const result = await build({
    absWorkingDir: HERE,
    entryPoints: ['page/main.js'],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    legalComments: 'none',
    charset: 'utf8',
    write: false,
  });
  return (await licences()) + result.outputFiles[0].text;
}

const text = await bundle();
if (process.argv[2] === '--check') {
  const held = await readFile(OUT, 'utf8').catch(() => '');
  if (held !== text) {
    console.error('report/html/page.bundle.js is not what web/ makes: run node web/bundle.mjs');
    process.exit(1);
  }
  console.log('the bundle is fresh');
} else {
  await writeFile(OUT, text);
  console.log(`${OUT}: ${text.length} characters`);
}
