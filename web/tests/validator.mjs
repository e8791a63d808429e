// The Khronos validator on one file.
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import validator from 'gltf-validator';

const SEVERITIES = ['error', 'warning', 'information', 'hint'];

// Returns { problems, notes }: errors and warnings, and what is less, one line each. `missing(uri)` gives bytes in place of
// a file beside it that is not there.
export async function validateGlb(file, missing = () => null) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), {
    uri: path.basename(file),
    externalResourceFunction: async (uri) => {
      const bytes = await readFile(path.join(path.dirname(file), decodeURIComponent(uri))).catch((error) => {
        const instead = missing(uri);
        if (!instead) throw error;
        return instead;
      });
      return new Uint8Array(bytes);
    },
  });
  const line = ({ severity, code, message, pointer }) => `${SEVERITIES[severity]} ${code} ${pointer ?? ''}: ${message}`;
  const { messages, truncated, numErrors, numWarnings } = report.issues;
  const problems = messages.filter(({ severity }) => severity <= 1).map(line);
  if (truncated) problems.push(`${numErrors} errors and ${numWarnings} warnings at least; the list was cut`);
  return { problems, notes: messages.filter(({ severity }) => severity > 1).map(line) };
}
