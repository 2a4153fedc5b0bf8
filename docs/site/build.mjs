#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
//
// build.mjs OUT [--peers FOLDER] [--playground FOLDER]: the documents of this checkout as a site that opens
// offline, each document and each cycle a page, with a search. `npm ci` in this folder brings the renderer of
// Markdown and the library of the search.
//
// FOLDER of --peers is a site of `gonogo site`, put in OUT/peers; that of --playground is put in
// OUT/playground. A playground that lies in OUT already is linked as well. Exits with 1 where a
// document links to what is not there, with 2 where it is used wrongly.
import { cpSync, existsSync, mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { Builder } from './pages.mjs';

export { placeOf, slug } from './places.mjs';

const here = dirname(fileURLToPath(import.meta.url));

function putFolder(out, name, from) {
  if (from === undefined) return;
  if (!existsSync(join(from, 'index.html'))) throw new Error(`${from} has no index.html: name the folder of a site`);
  cpSync(from, join(out, name), { recursive: true });
}

// Builds the site of the checkout `root` into `out`; what is wrong with its documents, a sentence each.
export async function buildSite(root, out, { peers, playground } = {}) {
  const { marked } = await import('marked').catch(() => {
    throw new Error(`the renderer of Markdown is missing: run \`npm ci\` in ${here}`);
  });
  if (!existsSync(join(here, 'node_modules/minisearch'))) {
    throw new Error(`the library of the search is missing: run \`npm ci\` in ${here}`);
  }
  mkdirSync(out, { recursive: true });
  putFolder(out, 'peers', peers);
  putFolder(out, 'playground', playground);
  const extra = [['peers/index.html', 'Implementations under the gauge'], ['playground/index.html', 'Playground']]
    .filter(([place]) => existsSync(join(out, place)));
  const builder = new Builder(root, out, marked, extra);
  builder.build(here);
  return { pages: builder.documents.length, faults: builder.faults };
}

async function main(words) {
  const folders = {};
  const places = [];
  for (let i = 0; i < words.length; ++i) {
    const option = /^--(peers|playground)$/.exec(words[i]);
    if (option && words[i + 1] !== undefined) folders[option[1]] = words[++i];
    else places.push(words[i]);
  }
  if (places.length !== 1 || places[0].startsWith('-')) {
    console.error('usage: build.mjs OUT [--peers FOLDER] [--playground FOLDER]');
    return 2;
  }
  try {
    const { pages, faults } = await buildSite(join(here, '..', '..'), places[0], folders);
    for (const fault of faults) console.error(fault);
    console.log(`${join(places[0], 'index.html')}: ${pages} documents`);
    return faults.length === 0 ? 0 : 1;
  } catch (error) {
    console.error(`build.mjs: ${error.message}.`);
    return 2;
  }
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  process.exitCode = await main(process.argv.slice(2));
}
