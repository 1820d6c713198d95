// Asks ajv with the schema, and carom, about every file of accepted/ and refused/, and ajv about the catalogue.
// Usage: node agree.mjs CAROM SCENE_DIR WEB_DIR (where ajv is installed). Exit 77: there is no ajv.
import {execFileSync, spawnSync} from 'node:child_process';
import {readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [carom, scenes, web] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));

let Ajv;
try {
  Ajv = createRequire(resolve(web, 'package.json'))('ajv/dist/2020').default;
} catch {
  console.log('skipped: ajv is not installed in tools/web (npm ci there)');
  process.exit(77);
}

const printed = execFileSync(carom, ['scenes', 'schema'], {encoding: 'utf8'});
const ajv = new Ajv({allErrors: true, strict: true, strictTypes: false, strictRequired: false});
const fits = ajv.compile(JSON.parse(printed));

const json_files = folder =>
  readdirSync(folder, {recursive: true}).map(name => join(folder, name)).filter(name => name.endsWith('.json') && !name.endsWith('.schema.json')).sort();

function loader_accepts(files) {
  const run = spawnSync(carom, ['scenes', 'validate', '--json', ...files], {encoding: 'utf8'});
  return new Map(JSON.parse(run.stdout).scenes.map(scene => [scene.path, scene]));
}

let wrong = 0;
function expect(file, who, expected, found, why) {
  if (expected === found) return;
  ++wrong;
  console.log(`${file}: ${who} ${found ? 'accepts' : 'refuses'} it${found ? '' : ': ' + why}`);
}

let files = 0;
let empty = false;
for (const [folder, expected, catalogue] of [[join(here, 'accepted'), true], [join(here, 'refused'), false], [scenes, true, true]]) {
  const list = json_files(folder);
  empty ||= list.length === 0;
  const loaded = loader_accepts(list);
  for (const file of list) {
    const fitting = fits(JSON.parse(readFileSync(file, 'utf8')));
    expect(file, 'the schema', expected, fitting, ajv.errorsText(fits.errors));
    expect(file, 'the loader', expected, loaded.get(file).valid, loaded.get(file).problems.join('; '));
    files += catalogue ? 0 : 1;
  }
}
console.log(`${files} files and the catalogue, ${wrong} disagreements`);
process.exit(wrong === 0 && !empty ? 0 : 1);
