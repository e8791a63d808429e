// usage: node validate_glb.mjs FILE.glb…
//
// Runs the Khronos validator on each file and prints what it finds. Exits 1 on any error or warning.
import { validateGlb } from './validator.mjs';

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error('usage: node validate_glb.mjs FILE.glb…');
  process.exit(2);
}

const LISTED = 20;

let failed = 0;
for (const file of files) {
  let result;
  try {
    result = await validateGlb(file);
  } catch (error) {
    result = { problems: [`unreadable: ${error.message ?? error}`], notes: [] };
  }
  console.log(`${result.problems.length ? 'FAIL' : 'ok'} ${file}`);
  const lines = [...result.problems, ...result.notes];
  for (const text of lines.slice(0, LISTED)) console.log(`  ${text}`);
  if (lines.length > LISTED) console.log(`  and ${lines.length - LISTED} more`);
  if (result.problems.length) ++failed;
}
process.exit(failed ? 1 : 0);
