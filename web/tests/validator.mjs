// The Khronos validator on one file.
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import validator from 'gltf-validator';

const SEVERITIES = ['error', 'warning', 'information', 'hint'];

// Returns { problems, notes }: errors and warnings, and what is less, one line each.
export async function validateGlb(file) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), {
    uri: path.basename(file),
    externalResourceFunction: (uri) =>
      readFile(path.join(path.dirname(file), decodeURIComponent(uri))).then((bytes) => new Uint8Array(bytes)),
  });
  const line = ({ severity, code, message, pointer }) => `${SEVERITIES[severity]} ${code} ${pointer ?? ''}: ${message}`;
  const { messages, truncated, numErrors, numWarnings } = report.issues;
  const problems = messages.filter(({ severity }) => severity <= 1).map(line);
  if (truncated) problems.push(`${numErrors} errors and ${numWarnings} warnings at least; the list was cut`);
  return { problems, notes: messages.filter(({ severity }) => severity > 1).map(line) };
}
