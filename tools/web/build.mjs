// Bundles src/ into one HTML file that still has the data marker:  node build.mjs --out FILE [--data FILE|example --data-out FILE]
// With --data a page with these data is written as well, for looking at it.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";

const MARKER = "@CAROM_DATA@";
const here = path.dirname(fileURLToPath(import.meta.url));
const options = { out: { type: "string" }, data: { type: "string" }, "data-out": { type: "string" } };
const { values: given } = parseArgs({ options });
if (!given.out) throw new Error("--out FILE is missing");

async function bundle(entry) {
  const result = await build({
    entryPoints: [path.join(here, "src", entry)], bundle: true, minify: true, write: false, format: "iife", charset: "ascii",
    target: ["chrome100", "firefox104", "safari15.4"], legalComments: "none", define: { "process.env.NODE_ENV": '"production"' },
  });
  return result.outputFiles[0].text.trim();
}

async function save(file, text) {
  await mkdir(path.dirname(path.resolve(file)), { recursive: true });
  await writeFile(file, text);
}

const [shell, SCRIPT, STYLE] = await Promise.all([readFile(path.join(here, "src", "page.html"), "utf8"), bundle("main.js"), bundle("style.css")]);
if (/<\/script|<!--/i.test(SCRIPT) || /<\/style/i.test(STYLE)) throw new Error("the bundle would end its own element");
const page = shell.replace(/@(SCRIPT|STYLE)@/g, (_, name) => ({ SCRIPT, STYLE })[name]);
if (page.split(MARKER).length !== 2) throw new Error(`${MARKER} must occur exactly once`);
await save(given.out, page);

if (given["data-out"]) {
  const json = given.data === "example" ? JSON.stringify((await import("./example.mjs")).examplePage()) : await readFile(given.data, "utf8");
  await save(given["data-out"], page.replace(MARKER, () => json.replaceAll("<", "\\u003c")));
}
