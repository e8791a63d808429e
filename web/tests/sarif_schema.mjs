// usage: node sarif_schema.mjs RADLINT ROOT
//
// SARIF reports of radlint against the schema that is published for SARIF 2.1.0, as the package jest-sarif brings it.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import Ajv from 'ajv';
import { run } from './opened_page.mjs';

const SCHEMA = '@microsoft/jest-sarif/lib/schemas/sarif-2.1.0-rtm.5.json';

const [radlint, root] = process.argv.slice(2);
const { resolve } = createRequire(import.meta.url);
const json = async (file) => JSON.parse(await readFile(resolve(file), 'utf8'));
const ajv = new Ajv({ allErrors: true, schemaId: 'auto' });
ajv.addMetaSchema(await json('ajv/lib/refs/json-schema-draft-04.json'));
const validate = ajv.compile(await json(SCHEMA));
const folder = await mkdtemp(path.join(tmpdir(), 'sarif-'));
const models = path.join(root, 'corpus/models');
const rules = path.join(root, 'corpus/rules');

function faultsOf(sarif) {
  return validate(sarif) ? [] : validate.errors.map((error) => `${error.dataPath}: ${error.message}`);
}

async function check(what, ...words) {
  const sarif = JSON.parse(await run(radlint, ...words, '--format', 'sarif', '--no-cache'));
  assert.deepEqual(faultsOf(sarif), [], what);
  const [{ results, invocations }] = sarif.runs;
  assert.ok(results.length > 0, what);
  console.log(`${what}: ${results.length} results, ${invocations[0].toolExecutionNotifications?.length ?? 0} notifications`);
  return sarif;
}

try {
  // A check that finds nothing wrong anywhere proves nothing.
  assert.notDeepEqual(faultsOf({ version: '2.1.0', runs: [{ tool: {} }] }), []);

  const stages = ['model', 'preprocess', 'solve', 'display'];
  for (const stage of stages) await check(`all fixtures at ${stage}`, rules, path.join(root, 'corpus/formats'), '--stage', stage);

  const crowd = path.join(folder, 'crowd.obj');
  const collapsed = Array.from({ length: 6000 }, () => 'f 1 2 3\n');
  await writeFile(crowd, `v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\n${collapsed.join('')}`);
  const kept = await check('more than are kept', crowd, '--no-group', '--select', 'RL007');
  assert.equal(kept.runs[0].results.length, 5000);
  assert.equal(kept.runs[0].invocations[0].toolExecutionNotifications[0].associatedRule.id, 'RL902');

  const known = path.join(folder, 'known.json');
  const lamp = path.join(models, 'lamp_post.obj');
  await run(radlint, lamp, '--write-baseline', known, '--select', 'RL201');
  const compared = await check('under a baseline', lamp, '--baseline', known);
  assert.ok(compared.runs[0].results.every((result) => result.baselineState));

  const model = path.join(folder, 'silenced lämp.obj');
  await writeFile(model, `# radlint: ignore-file[RL2] known\n${await readFile(lamp, 'utf8')}`);
  const silenced = await check('with suppressions', model);
  assert.ok(silenced.runs[0].results.some((result) => result.suppressions.length > 0));
  await writeFile(path.join(folder, 'broken.obj'), 'v 0 0 zero\nf 1 2\n');
  await check('a file that cannot be read', path.join(folder, 'broken.obj'));
} finally {
  await rm(folder, { recursive: true });
}
