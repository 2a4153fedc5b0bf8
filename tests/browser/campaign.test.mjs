// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a long hunt as people meet it: opened from its folder in a real browser, without network.
// GONOGO names the program, GONOGO_CHROMIUM the browser; with GONOGO_SCREENSHOTS=FOLDER it is kept as
// a picture.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { openBrowser, withPage as withBrowserPage } from './browser.mjs';

const gonogo = process.env.GONOGO;
const pictures = process.env.GONOGO_SCREENSHOTS;
const work = mkdtempSync(join(tmpdir(), 'gonogo-campaign-'));

let context;
let told;

function batch(...words) {
  const done = spawnSync(gonogo, ['ci', 'batch', '--subject', 'builtin:ngc+offsets-absolute', '--dialect', 'rs274',
    '--campaign', 'night', '--round', '300', ...words], { cwd: work, encoding: 'utf8' });
  assert.equal(done.status, 1, done.stderr);
}

before(async () => {
  assert.ok(gonogo, 'GONOGO must name the program');
  batch('--programs', '601');
  told = JSON.parse(readFileSync(join(work, 'night', 'campaign.json'), 'utf8'));
  context = await openBrowser(work);
});

after(async () => {
  await context?.close();
  rmSync(work, { recursive: true, force: true });
});

const withPage = (body) => withBrowserPage(context, pathToFileURL(join(work, 'night', 'index.html')).href, body);
const number = async (page, what) => Number(await page.locator('.totals div', { has: page.locator(`dt:text-is("${what}")`) })
  .locator('dd').innerText());

test('a departure is read on a phone', () => withPage(async (page) => {
  await page.setViewportSize({ width: 400, height: 900 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400);
  const { width } = await page.locator('#symptoms-1 tbody td').first().boundingBox();
  assert.ok(width > 120, `${width} px`);
}));

test('one fault is one finding, with its cause and all of its symptoms', () => withPage(async (page) => {
  assert.equal(told.findings.length, 1);
  assert.ok(told.findings[0].faces.length > 10);
  assert.equal(await page.locator('#told .badge').innerText(), `1 finding, ${told.findings[0].faces.length} symptoms`);
  assert.equal(await page.locator('section[id^=finding-]').count(), 1);
  assert.equal(await page.locator('.cause').innerText(),
    `Behaves as if: ${told.findings[0].cause}. ${told.findings[0].evidence}`);
  assert.match(told.findings[0].evidence, /^It explains [0-9]+ of [0-9]+ departures/);
  assert.equal(await page.locator('#symptoms-1 tbody tr').count(), told.findings[0].faces.length);
  const times = (await page.locator('#symptoms-1 tbody td.number').allInnerTexts()).map(Number);
  // By gravity, paths before alarms, and of one verdict the most frequent first.
  const verdicts = told.findings[0].faces.map((face) => face.verdict);
  const isPath = verdicts.map((verdict) => !verdict.startsWith('fail.alarm'));
  assert.deepEqual(isPath, [...isPath].sort((a, b) => b - a));
  for (const verdict of new Set(verdicts)) {
    const own = times.filter((_, i) => verdicts[i] === verdict);
    assert.deepEqual(own, [...own].sort((a, b) => b - a), verdict);
  }
  if (pictures) await page.screenshot({ path: join(pictures, 'campaign.png'), fullPage: true });
}));

test('a symptom says when it was seen first and last, and leads to what the judge said', () => withPage(async (page) => {
  const face = told.findings[0].faces[0];
  const dates = await page.locator('#symptoms-1 tbody tr').first().locator('td.dates').allInnerTexts();
  assert.deepEqual(dates, [face.first, face.last].map((seen) => `round ${seen.round}\n${seen.at}`));
  for (const link of await page.locator('a[href]').evaluateAll((nodes) => nodes.map((node) => node.getAttribute('href')))) {
    assert.ok(existsSync(join(work, 'night', link)), link);
  }
}));

test('the numbers are those of the campaign', () => withPage(async (page) => {
  for (const [what, key] of [['programs', 'programs'], ['judged', 'judged'], ['judged with motion', 'moved'],
    ['skipped', 'skipped'], ['not GO', 'no_go']]) {
    assert.equal(await number(page, what), told.count[key], what);
  }
  assert.equal(told.count.programs, 600);
  assert.ok(await number(page, 'programs a second of a round, each shard') > 0);
  const features = await page.locator('#feature-table tbody th').allInnerTexts();
  assert.deepEqual(features, Object.keys(told.features));
  const arc = page.locator('#feature-table tbody tr', { has: page.locator('th:text-is("arc")') });
  const { judged, no_go: departed, skipped } = told.features.arc;
  assert.deepEqual((await arc.locator('td').allInnerTexts()).map(Number), [judged, departed, skipped]);
}));

test('the reduced program stands there with its sheet and its command, and what the judge says can be opened', () => withPage(async (page) => {
  const face = told.findings[0].faces[0];
  const program = readFileSync(join(work, 'night', face.folder, 'program.nc'), 'utf8');
  const shown = await page.locator('#finding-1 > pre .line').allInnerTexts();
  assert.deepEqual(shown.map((line) => line.trimEnd()), program.replace(/\n$/, '').split('\n').map((line) => line.trimEnd()));
  assert.equal(await page.locator('#finding-1 .figure svg').count(), 1);
  assert.ok((await page.locator('#finding-1 .figure').boundingBox()).height > 100);
  assert.ok(await page.locator('#finding-1 .figure .gs-witness').count() > 0);
  assert.match(await page.locator('#finding-1 .again').innerText(), /gonogo reduce \S*program\.nc --subject /);
  assert.equal(await page.locator('#finding-1 details pre').isVisible(), false);
  await page.locator('#finding-1 summary').click();
  assert.match(await page.locator('#finding-1 details pre').innerText(), new RegExp(face.verdict.replace('.', '\\.')));
}));

test('it stays within a narrow window', () => withPage(async (page) => {
  await page.setViewportSize({ width: 480, height: 900 });
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= window, `${wide} > ${window}`);
}));

test('a further round writes it anew, and leaves nothing half written', async () => {
  batch('--programs', '301');
  await withPage(async (page) => assert.equal(await number(page, 'programs'), 900));
  assert.deepEqual(readdirSync(join(work, 'night')).sort(), ['campaign.json', 'index.html', 'shard-1-of-1']);
});
