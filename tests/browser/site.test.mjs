// SPDX-License-Identifier: GPL-3.0-or-later
//
// The site of many results as people meet it: opened from files in a real browser, without network.
// GONOGO names the program, GONOGO_CHROMIUM the browser; with GONOGO_SCREENSHOTS=FOLDER each page is
// kept as a picture.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openBrowser, withPage as withBrowserPage } from './browser.mjs';

const corpus = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'corpus');
const gonogo = process.env.GONOGO;
const pictures = process.env.GONOGO_SCREENSHOTS;
const work = mkdtempSync(join(tmpdir(), 'gonogo-site-'));
const kPages = ['index', 'clauses', 'departures', 'vote', 'trend', 'speed'];
const kSubjects = ['ngc', 'ngc+depth-from-tool', 'ngc+empty-last-peck', 'ngc+equal-pecks'];

let context;
let data;

function run(statuses, ...words) {
  const done = spawnSync(gonogo, words, { cwd: work, encoding: 'utf8' });
  assert.ok(statuses.includes(done.status), `gonogo ${words.join(' ')}: ${done.status} ${done.stderr}`);
  return done;
}

before(async () => {
  assert.ok(gonogo, 'GONOGO must name the program');
  for (const subject of kSubjects) {
    run([0, 1], 'certify', '--subject', `builtin:${subject}`, '--dialect', 'rs274', '--corpus', corpus,
      '--only', 'ngc.peck*', '--only', 'ngc.cycles*', '--report', subject);
  }
  run([0], 'site', 'acme@9=ngc', 'acme@10=ngc+depth-from-tool', 'bolt@1=ngc+empty-last-peck',
    '<b>crank</b>@2=ngc+equal-pecks', '--out', 'site', '--title', 'Four <i>runs</i>');
  data = JSON.parse(readFileSync(join(work, 'site', 'site.json'), 'utf8'));
  context = await openBrowser(work);
});

after(async () => {
  await context?.close();
  rmSync(work, { recursive: true, force: true });
});

const withPage = (name, body) =>
  withBrowserPage(context, pathToFileURL(join(work, 'site', `${name}.html`)).href, body);

const texts = (page, selector) => page.locator(selector).allInnerTexts();

test('every page has its title, the navigation and no link that leads nowhere', async () => {
  for (const name of kPages) {
    await withPage(name, async (page) => {
      assert.equal(await page.locator('h1').innerText(), 'Four <i>runs</i>');
      assert.equal(await page.locator('nav.pages a').count(), kPages.length);
      assert.equal(await page.locator('nav.pages a[aria-current=page]').count(), 1);
      const links = await page.locator('a[href]').evaluateAll((nodes) => nodes.map((node) => node.getAttribute('href')));
      for (const link of new Set(links)) {
        assert.ok(existsSync(join(work, 'site', link.replace(/#.*/, ''))), `${name}: ${link}`);
      }
      if (pictures) await page.screenshot({ path: join(pictures, `site-${name}.png`), fullPage: true });
    });
  }
});

test('the overview has a row a run, in the order in which people count', () => withPage('index', async (page) => {
  const titles = await texts(page, '#results-table tbody th a');
  assert.deepEqual(titles, ['<b>crank</b> 2', 'acme 9', 'acme 10', 'bolt 1']);
  assert.deepEqual(await texts(page, '#results-table .badge'), ['NO-GO', 'GO', 'NO-GO', 'NO-GO']);
  const cells = await texts(page, '#results-table tbody tr:nth-child(2) td.number');
  assert.equal(Number(cells[1].replace(',', '')), Object.values(data.runs[1].counts).reduce((a, b) => a + b));
}));

test('the matrix shows what is GO of what was answered', () => withPage('index', async (page) => {
  const row = page.locator('#matrix-table tbody tr', { has: page.locator('th:text-is("cycles")') });
  const shares = await row.locator('td').allInnerTexts();
  const counts = data.runs.map((one) => one.cycles.find((cycle) => cycle.cycle === 'cycles').counts);
  const wanted = counts.map((one) => (one['no-go'] === 0 ? `${one.go}` : `${one.go} / ${one.go + one['no-go']}`));
  assert.deepEqual(shares, wanted);
  assert.ok(counts.some((one) => one['no-go'] > 0));
}));

test('each departure stands there once, and the search finds those of one run', () => withPage('departures', async (page) => {
  const shown = () => page.locator('#departure-table tbody tr:visible').count();
  assert.equal(await shown(), data.departures.length);
  const keys = data.departures.map((one) => [one.dialect, one.verdict, one.clause, one.what].join());
  assert.equal(new Set(keys).size, keys.length);
  await page.locator('form.filter select').selectOption({ label: 'bolt 1' });
  const ofBolt = data.departures.filter((one) => one.runs.some((share) => data.runs[share.run].name === 'bolt'));
  assert.equal(await shown(), ofBolt.length);
  assert.ok(ofBolt.length > 0 && ofBolt.length < data.departures.length);
  await page.locator('form.filter input').fill('no such word');
  assert.equal(await shown(), 0);
  assert.match(await page.locator('#count').innerText(), /^0 of /);
}));

test('a case leads to its drawing in the report of its run', () => withPage('departures', async (page) => {
  const link = page.locator('#departure-table td.has a').first();
  const wanted = decodeURIComponent(/#case=(.*)$/.exec(await link.getAttribute('href'))[1]);
  await link.click();
  await page.waitForSelector('#sheet svg');
  assert.equal(await page.locator('#detail h2').innerText(), wanted);
}));

test('the vote counts every case once', () => withPage('vote', async (page) => {
  const told = (await texts(page, '#ballot-table td')).map((text) => Number(text.replace(',', '')));
  assert.equal(told.reduce((a, b) => a + b), data.cases);
  assert.equal(await page.locator('#pair-table tbody tr').count(), 3);  // acme votes once
  assert.equal(await page.locator('#vote .who').count(), 3);
}));

test('versions of one implementation are a course with what was lost', () => withPage('trend', async (page) => {
  assert.deepEqual(await texts(page, 'main h2'), ['acme']);
  assert.equal(await page.locator('.chart circle').count(), 2);
  const step = data.steps[0];
  assert.ok(step.lost > 0);
  await page.locator('details summary').first().click();
  assert.equal(await page.locator('details .ids a:visible').count(), Math.min(step.lost, 50));
}));

test('the slowest cases are there, the slowest first', () => withPage('speed', async (page) => {
  const times = (await texts(page, '#slowest-table tbody td.number')).map((text) => parseFloat(text.replace(',', '')));
  const first = times.slice(0, 10);
  assert.deepEqual(first, [...first].sort((a, b) => b - a));
  assert.equal(await page.locator('#speed-table tbody tr').count(), 4);
}));

test('without JavaScript everything is there but the search', async () => {
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send('Emulation.setScriptExecutionDisabled', { value: true });
  await page.goto(pathToFileURL(join(work, 'site', 'departures.html')).href);
  assert.equal(await page.locator('#departure-table tbody tr:visible').count(), data.departures.length);
  assert.equal(await page.locator('form.filter').isVisible(), false);
  await page.close();
});

test('dark and light keep their contrast', async () => {
  for (const colorScheme of ['light', 'dark']) {
    for (const name of kPages) {
      await withPage(name, async (page) => {
        await page.emulateMedia({ colorScheme });
        const worst = await page.evaluate(() => {
          const channels = (color) => color.match(/[\d.]+/g).map(Number);
          const luminance = (color) => channels(color).slice(0, 3).map((v) => v / 255)
            .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
            .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
          // A cell of the matrix may be of two colours: the worse of them counts.
          const backs = (node) => {
            for (let at = node; at; at = at.parentElement) {
              const style = getComputedStyle(at);
              const image = style.backgroundImage.match(/rgb\([^)]*\)/g);
              if (image) return image;
              if (channels(style.backgroundColor)[3] !== 0) return [style.backgroundColor];
            }
            return ['rgb(255, 255, 255)'];
          };
          let least = { ratio: 99 };
          for (const node of document.querySelectorAll('h1, h2, p, td, th, a, span, li, summary, footer, .chart text')) {
            if (!node.textContent.trim() || node.closest('[hidden]')) continue;
            const style = getComputedStyle(node);
            const ink = luminance(node instanceof SVGElement ? style.fill : style.color);
            for (const back of backs(node).map(luminance)) {
              const ratio = (Math.max(ink, back) + 0.05) / (Math.min(ink, back) + 0.05);
              if (ratio < least.ratio) least = { ratio, text: node.textContent.slice(0, 40), tag: node.tagName };
            }
          }
          return least;
        });
        assert.ok(worst.ratio >= 4.5, `${name}, ${colorScheme}: ${JSON.stringify(worst)}`);
      });
    }
  }
});

// What a customer is handed: all dialects' cases, several hundred of them pockets that cut into the wall.
test('the report of a whole campaign with hundreds of failures is below 10 MB and shows them all', async () => {
  const dialects = ['gsk988ta', 'hnc21t', 'rs274', 'sinumerik802s', 'sinumerik840d'].flatMap((name) => ['--dialect', name]);
  run([1], 'certify', '--subject', 'builtin:gsk+gouge', ...dialects, '--corpus', corpus, '--causes', '0', '--report', 'whole');
  const lines = readFileSync(join(work, 'whole', 'results.jsonl'), 'utf8').trim().split('\n').slice(1, -1);
  const failures = lines.filter((line) => line.includes('"verdict":"fail.')).length;
  assert.ok(lines.length > 10_000 && failures > 400, `${lines.length} cases, ${failures} failures`);
  assert.ok(statSync(join(work, 'whole', 'index.html')).size < 10_000_000);
  await withBrowserPage(context, pathToFileURL(join(work, 'whole', 'index.html')).href, async (page) => {
    await page.waitForSelector('#findings tbody tr');
    const grouped = (number) => number.toLocaleString('en-US');
    assert.match(await page.locator('#count').innerText(), new RegExp(`^${grouped(failures)} of ${grouped(lines.length)} cases`));
    // Every failure has its program and, where it has a path, its drawing.
    const first = await page.locator('#rows .row').first().innerText();
    await page.locator('#rows .row').first().click();
    assert.ok(first.startsWith(await page.locator('#detail h2').innerText()));
    assert.ok(await page.locator('#sheet [data-view]').count() > 0);
  });
});
