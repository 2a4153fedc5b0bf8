// SPDX-License-Identifier: GPL-3.0-or-later
//
// The site of the documents: every document has a page, every link of every page leads somewhere
// within the site, nothing is loaded from elsewhere, a broken link of a document is reported, each cycle has
// a page, and the search finds what people look for.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, normalize, relative } from 'node:path';
import { after, test } from 'node:test';
import { createContext, runInContext } from 'node:vm';

const root = new URL('../../', import.meta.url).pathname;
if (!['marked', 'minisearch'].every((name) => existsSync(join(root, 'docs/site/node_modules', name)))) {
  console.log('SKIPPED: the libraries of the site are missing: run `npm ci` in docs/site');
  process.exit(0);
}
const { buildSite, placeOf, slug } = await import('../../docs/site/build.mjs');
const work = mkdtempSync(join(tmpdir(), 'gonogo-documents-'));
after(() => rmSync(work, { recursive: true, force: true }));
const site = join(work, 'site');
const built = await buildSite(root, site);

function pagesOf(folder) {
  return readdirSync(folder, { recursive: true }).map(String).filter((name) => name.endsWith('.html')).sort();
}
const attributes = (html, name) => [...html.matchAll(new RegExp(`<[a-z][^>]*\\s${name}="([^"]*)"`, 'g'))]
  .map((match) => match[1].replace(/&amp;/g, '&').replace(/&quot;/g, '"'));

// What is wrong with the links of a site, a sentence each.
function badLinks(folder) {
  const pages = new Map(pagesOf(folder).map((name) => [name, readFileSync(join(folder, name), 'utf8')]));
  const ids = new Map([...pages].map(([name, html]) => [name, new Set(attributes(html, 'id'))]));
  const bad = [];
  for (const [name, html] of pages) {
    for (const source of attributes(html, 'src')) {
      if (/^[a-z]+:/.test(source) || !existsSync(join(folder, dirname(name), source))) bad.push(`${name}: src ${source}`);
    }
    for (const link of attributes(html, 'href')) {
      if (/^(https?|mailto|data):/.test(link)) continue;
      const [path, fragment] = link.split('#');
      const target = path === '' ? name : normalize(join(dirname(name), path));
      if (!existsSync(join(folder, target))) bad.push(`${name}: ${link}`);
      else if (target.startsWith('playground/')) continue;  // what it runs stands in the fragment
      else if (fragment && ids.has(target) && !ids.get(target).has(decodeURIComponent(fragment))) bad.push(`${name}: no place ${link}`);
    }
  }
  return bad;
}

test('every document has a page, in the navigation of every page', () => {
  assert.deepEqual(built.faults, []);
  const documents = ['README.md', 'ARCHITECTURE.md', 'CONTRIBUTING.md', 'CHANGELOG.md',
    ...readdirSync(join(root, 'docs')).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`),
    ...readdirSync(join(root, 'docs/dialects')).filter((name) => name.endsWith('.md')).map((name) => `docs/dialects/${name}`)];
  assert.equal(built.pages, documents.length);
  for (const name of pagesOf(site)) {
    const navigation = /<nav[^]*?<\/nav>/.exec(readFileSync(join(site, name), 'utf8'))[0];
    const targets = new Set(attributes(navigation, 'href').map((link) => normalize(join(dirname(name), link))));
    for (const document of documents) assert.ok(targets.has(placeOf(document)), `${name} lacks ${document}`);
  }
});

test('every link leads somewhere, and nothing is loaded from elsewhere', () => {
  assert.deepEqual(badLinks(site), []);
  const links = pagesOf(site).reduce((sum, name) => sum + attributes(readFileSync(join(site, name), 'utf8'), 'href').length, 0);
  assert.ok(links > 2000, `${links} links`);
  for (const name of pagesOf(site)) {
    const html = readFileSync(join(site, name), 'utf8');
    assert.doesNotMatch(html, /<script(?! src="(\.\.\/)*search\.js" defer><\/script>)|<link[^>]*href="https?:|url\(/, name);
  }
});

test('tables, code and pictures of a document are on its page', () => {
  const page = readFileSync(join(site, 'dialects/rs274.html'), 'utf8');
  const text = readFileSync(join(root, 'docs/dialects/rs274.md'), 'utf8');
  assert.equal(page.match(/<img /g).length, text.match(/^!\[/gm).length);
  assert.equal(page.match(/<pre>/g).length, text.match(/^```/gm).length / 2);
  assert.ok(page.match(/<table>/g).length > 10);
  assert.doesNotMatch(page, /<!--/);
});

const mainOf = (name) => /<main[^]*<\/main>/.exec(readFileSync(join(site, name), 'utf8'))[0];

test('the start page opens with what a reader wants to do, then the cycles, then the documents', () => {
  const main = mainOf('index.html');
  const links = attributes(main, 'href');
  assert.equal(links[0], 'readme.html#judging-your-own-controller');
  for (const wanted of ['guide-certifier.html', 'protocol.html#a-first-subject', '#the-cycles', 'guide-ci.html#4-hunt', 'guide-corpus.html#2-write-a-case']) {
    assert.ok(links.indexOf(wanted) >= 0 && links.indexOf(wanted) < links.indexOf('dialects/rs274/g81-g82.html'), wanted);
  }
  assert.ok(main.indexOf('id="all-documents"') > main.indexOf('dialects/sinumerik802s/lcyc82.html'));
});

const kCyclePages = {
  gsk988ta: ['g90', 'g92', 'g94', 'g110-g111', 'g112-g113', 'g114-g115-g116-g117'], hnc21t: ['g74', 'g75', 'g80', 'g81', 'g82'],
  rs274: ['g33-g33.1', 'g76', 'g81-g82', 'g83-g73', 'g84-g74', 'g85-g86-g89'], sinumerik802s: ['lcyc75', 'lcyc82'], sinumerik840d: [],
};
test('each cycle has a page with its clauses and its drawing, linked from its dialect and the start page', () => {
  for (const [dialect, names] of Object.entries(kCyclePages)) {
    const folder = join(site, 'dialects', dialect);
    const pages = existsSync(folder) ? readdirSync(folder).filter((name) => name.endsWith('.html')).sort() : [];
    assert.deepEqual(pages, names.map((name) => `${name}.html`).sort());
    for (const page of pages) {
      const main = mainOf(`dialects/${dialect}/${page}`);
      assert.equal(main.match(/<h1 /g).length, 1, page);
      assert.ok(attributes(main, 'src').some((source) => source.endsWith('.svg')), `${page} has no drawing`);
      assert.match(main, /<a id="[a-z0-9]+(-[a-z0-9]+)+-\d+"><\/a>[A-Z0-9]+-/, `${page} has no clause`);
      assert.ok(attributes(main, 'href').includes(`../${dialect}.html`), page);
      assert.ok(attributes(mainOf(`dialects/${dialect}.html`), 'href').includes(`${dialect}/${page}`), page);
      assert.ok(attributes(mainOf('index.html'), 'href').includes(`dialects/${dialect}/${page}`), page);
    }
  }
  // What linked to a dialect's page still finds its place there.
  for (const id of ['ngc-g82-01', 'section-10', 'ngc.g83.return']) assert.match(mainOf('dialects/rs274.html'), new RegExp(`id="${id}"`));
});

test('the search finds clauses, readings, cycles and words, at places that are there', () => {
  const context = createContext({});
  runInContext(readFileSync(join(site, 'search-index.js'), 'utf8'), context);
  const find = (words) => context.gonogoFind(words).map(({ address }) => address);
  assert.equal(find('NGC-G82-01')[0], 'dialects/rs274/g81-g82.html#ngc-g82-01');
  assert.equal(find('ngc.g83.return')[0], 'dialects/rs274/g83-g73.html#ngcg83return');
  assert.equal(find('G76')[0], 'dialects/rs274/g76.html');
  assert.equal(find('lcyc75')[0], 'dialects/sinumerik802s/lcyc75.html');
  assert.equal(find('exit codes')[0], 'exit-codes.html');
  assert.equal(find('the sandbox')[0], 'protocol.html#the-sandbox');
  assert.equal(find('certificat')[0].split('#').length, 2);
  assert.ok(find('tapping chuck').includes('dialects/rs274/g84-g74.html'));
  assert.ok(find('tapping chuk').length > 0, 'one letter is missing');
  assert.equal(find('xyzzyq').length, 0);
  const pages = new Map(pagesOf(site).map((name) => [name, new Set(attributes(readFileSync(join(site, name), 'utf8'), 'id'))]));
  for (const [place, , sections] of context.gonogoPages) {
    for (const [id] of sections) assert.ok(id === '' || pages.get(place).has(id), `${place}#${id}`);
  }
});

test('a second build gives the same bytes', async () => {
  const again = join(work, 'again');
  await buildSite(root, again);
  assert.deepEqual(pagesOf(again), pagesOf(site));
  for (const name of pagesOf(site)) assert.equal(readFileSync(join(again, name), 'utf8'), readFileSync(join(site, name), 'utf8'), name);
  assert.equal(readFileSync(join(again, 'search-index.js'), 'utf8'), readFileSync(join(site, 'search-index.js'), 'utf8'));
});

// A checkout of three documents.
function checkout(name, text) {
  const folder = join(work, name);
  mkdirSync(join(folder, 'docs/dialects'), { recursive: true });
  writeFileSync(join(folder, 'README.md'), '# Top\n\n[documents](docs/README.md#twice-1)\n');
  writeFileSync(join(folder, 'docs/README.md'), `# Documents\n\n## Twice\n\n## Twice\n\n${text}\n`);
  return folder;
}

test('a link that leads nowhere is a fault of its document', async () => {
  const faults = async (text) => (await buildSite(checkout('wrong', text), join(work, 'wrong-site'))).faults;
  assert.deepEqual(await faults('[up](../README.md)'), []);
  assert.deepEqual(await faults('[x](gone.md)'), ['docs/README.md: the link gone.md leads nowhere']);
  assert.match((await faults('![x](gone.svg)'))[0], /gone\.svg leads nowhere/);
  assert.match((await faults('[x](../../../etc/passwd)'))[0], /leads nowhere/);
  assert.match((await faults('[x](dialects)'))[0], /is a folder/);
});

test('a fragment that is not there is noticed', async () => {
  const folder = join(work, 'fragment-site');
  await buildSite(checkout('fragment', '[x](../README.md#bottom)'), folder);
  assert.deepEqual(badLinks(folder), ['index.html: no place readme.html#bottom']);
});

test('headings have the ids that readers of Markdown give them', () => {
  const used = new Map();
  assert.equal(slug('A hunt\'s folder', used), 'a-hunts-folder');
  assert.equal(slug('G94: radial, `R` & more', used), 'g94-radial-r--more');
  assert.equal(slug('Again', used), 'again');
  assert.equal(slug('Again', used), 'again-1');
});

test('peers and playground are linked where they are, and only there', async () => {
  const top = checkout('extra', 'See [try it](../build/playground/page/index.html#dialect=rs274).');
  const out = join(work, 'extra-site');
  await buildSite(top, out);
  for (const name of ['index.html', 'readme.html']) {
    assert.doesNotMatch(readFileSync(join(out, name), 'utf8'), /peers\/|playground\/|try it/);
  }
  const peers = join(work, 'peers');
  mkdirSync(peers);
  writeFileSync(join(peers, 'index.html'), '<h1 id="x">Peers</h1>');
  mkdirSync(join(out, 'playground'));
  writeFileSync(join(out, 'playground/index.html'), '<h1>Play</h1>');
  await buildSite(top, out, { peers });
  const page = readFileSync(join(out, 'readme.html'), 'utf8');
  assert.match(page, /href="peers\/index\.html"/);
  assert.match(page, /href="playground\/index\.html"/);
  assert.match(readFileSync(join(out, 'index.html'), 'utf8'), /href="playground\/index\.html#dialect=rs274">try it</);
  assert.deepEqual(badLinks(out), []);
  await assert.rejects(buildSite(top, out, { peers: join(work, 'nowhere') }), /has no index\.html/);
});

test('wrong use is told', () => {
  const run = (...words) => spawnSync(process.execPath, [join(root, 'docs/site/build.mjs'), ...words], { encoding: 'utf8' });
  assert.equal(run().status, 2);
  assert.match(run('--peers').stderr, /usage/);
  const done = run(join(work, 'by-command'));
  assert.equal(done.status, 0, done.stderr);
  assert.ok(existsSync(join(work, 'by-command', relative('docs', 'docs/guide-ci.html'))));
});
