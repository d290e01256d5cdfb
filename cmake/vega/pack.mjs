// node pack.mjs <folder with node_modules> <folder to write to>
//
// Takes from the installed packages what a report carries: the three scripts without the notes of where their sources
// are, and the licences of everything in them, each text once.
import {mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const [from, to] = process.argv.slice(2);
const modules = join(from, 'node_modules');
mkdirSync(to, {recursive: true});

for (const name of ['vega', 'vega-lite', 'vega-embed']) {
  const text = readFileSync(join(modules, name, 'build', `${name}.min.js`), 'utf8');
  if (/<\/script|<!--/i.test(text)) throw new Error(`${name} would end the element that it stands in`);
  writeFileSync(join(to, `${name}.js`), text.replace(/^\/\/# sourceMappingURL=.*$/gm, ''));
}

// What the three scripts are built from; the rest of the packages belongs to their command lines.
const inside = /^(vega|d3-|topojson|fast-json-patch|json-stringify|delaunator|robust-predicates|internmap|semver)/;
const users = new Map();
for (const name of readdirSync(modules).filter((each) => inside.test(each)).sort()) {
  const folder = join(modules, name);
  const file = readdirSync(folder).find((each) => /^licen[sc]e/i.test(each));
  const {version, license} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const text = file ? readFileSync(join(folder, file), 'utf8').trim() : `Licence: ${license}`;
  users.set(text, [...(users.get(text) ?? []), `${name} ${version}`]);
}
const parts = [...users].map(([text, names]) => `${names.join(', ')}\n\n${text}\n`);
writeFileSync(join(to, 'licences.txt'), parts.join('\n----\n\n'));
