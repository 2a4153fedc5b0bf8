// SPDX-License-Identifier: GPL-3.0-or-later
//
// The site of the documents as people meet it: opened from a file in a real browser, without network, and
// searched by keys alone. GONOGO_CHROMIUM names the browser.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { openBrowser, withPage } from './browser.mjs';

const root = new URL('../../', import.meta.url).pathname;
if (!['marked', 'minisearch'].every((name) => existsSync(join(root, 'docs/site/node_modules', name)))) {
  console.log('SKIPPED: the libraries of the site are missing: run `npm ci` in docs/site');
  process.exit(0);
}
const { buildSite } = await import('../../docs/site/build.mjs');
const work = mkdtempSync(join(tmpdir(), 'gonogo-documents-browser-'));
const site = join(work, 'site');
const open = (name, body) => withPage(context, pathToFileURL(join(site, name)).href, body);

let context;
before(async () => {
  await buildSite(root, site);
  context = await openBrowser(work);
});
after(async () => {
  await context?.close();
  rmSync(work, { recursive: true, force: true });
});

const found = (page) => page.locator('#search-found a strong').allInnerTexts();

test('a clause is found and opened by keys alone', () => open('dialects/hnc21t/g74.html', async (page) => {
  await page.keyboard.press('/');
  await page.keyboard.type('ngc-g82-01');
  await page.locator('#search-found a').first().waitFor();
  assert.equal((await found(page))[0], 'NGC-G82-01');
  assert.match(await page.locator('#search-count').innerText(), /^\d+ found$/);
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement.querySelector('strong').textContent), 'NGC-G82-01');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'search-words');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.waitForURL(/rs274\/g81-g82\.html#ngc-g82-01$/);
}));

test('Enter opens the best, Escape empties, and nothing found is said', () => open('index.html', async (page) => {
  assert.equal(await page.getByRole('searchbox', { name: 'Search' }).count(), 1);
  await page.fill('#search-words', 'qqqq');
  await page.waitForFunction(() => document.querySelector('#search-count').textContent === 'Nothing found');
  await page.keyboard.press('Escape');
  assert.equal(await page.inputValue('#search-words'), '');
  assert.equal(await page.locator('#search-count').innerText(), '');
  await page.fill('#search-words', 'LCYC82');
  await page.keyboard.press('Enter');
  await page.waitForURL(/sinumerik802s\/lcyc82\.html$/);
}));
