// Fails where the project names a source that docs/bibliography.bib does not have: what follows "Source:" or "Sources:"
// up to "section", ";", "(" or the end, and every word that looks like a key of author and year. And on a bibliography
// that is no BibTeX or has a key twice.
// usage: node check_sources.mjs REPOSITORY
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';

const repository = process.argv[2] ?? '.';
const faults = [];

/** The keys of a BibTeX file; every entry has to close before the next begins. */
function readKeys(text) {
  const keys = new Set();
  let depth = 0;
  text.split('\n').forEach((line, index) => {
    const entry = line.match(/^@[a-z]+\{([^,\s]+),$/);
    if (entry) {
      if (depth !== 0) faults.push(`docs/bibliography.bib:${index + 1}: the entry before ${entry[1]} is not closed`);
      if (keys.has(entry[1])) faults.push(`docs/bibliography.bib:${index + 1}: ${entry[1]} stands here a second time`);
      keys.add(entry[1]);
      depth = 0;
    }
    for (const c of line.startsWith('%') ? '' : line) depth += c === '{' ? 1 : c === '}' ? -1 : 0;
  });
  if (depth !== 0) faults.push('docs/bibliography.bib: the last entry is not closed');
  return keys;
}

function* files(folder) {
  for (const name of readdirSync(folder)) {
    if (name === 'node_modules' || name === 'build' || name.startsWith('.')) continue;
    const path = join(folder, name);
    if (statSync(path).isDirectory()) yield* files(path);
    else if (/\.(h|cpp|mjs|js|ts|tsx|md)$/.test(name)) yield path;
  }
}

function namedSources(text) {
  const named = [...text.matchAll(/\b[a-z]{3,}(?:19|20)\d\d[a-z]*\b/g)].map(([key]) => key);
  for (const [, list] of text.matchAll(/^.*?(?:\/\/|\*).*\bSources?: (.*)$/gm)) {
    const keys = list.split(/section|;|\(|\. |\.$/)[0];
    named.push(...keys.split(/,| and /).map((key) => key.trim()).filter((key, i) => key !== '' && (i === 0 || /^[a-z][a-z0-9_]*$/.test(key))));
  }
  return named;
}

const keys = readKeys(readFileSync(join(repository, 'docs/bibliography.bib'), 'utf8'));
let citations = 0;
for (const room of ['engine', 'faces', 'benchmarks', 'docs', 'tests'].map((name) => join(repository, name)).filter(existsSync)) {
  for (const path of files(room)) {
    for (const key of namedSources(readFileSync(path, 'utf8'))) {
      citations += 1;
      if (!keys.has(key)) faults.push(`${path}: '${key}' is not in docs/bibliography.bib`);
    }
  }
}
if (citations === 0) faults.push('no source is named anywhere: is this the repository?');
for (const fault of faults) console.error(fault);
console.log(`${citations} sources named, ${faults.length} faults`);
process.exit(faults.length > 0 ? 1 : 0);
