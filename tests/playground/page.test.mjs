// SPDX-License-Identifier: GPL-3.0-or-later
//
// The playground as people meet it: opened from a file in a real browser, without network.
// GONOGO_PLAYGROUND_PAGE names the page, GONOGO_CHROMIUM the browser; GONOGO_SCREENSHOT, where set, is a
// file for a picture.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openBrowser, withPage as withBrowserPage } from '../browser/browser.mjs';

if (!existsSync(process.env.GONOGO_PLAYGROUND_PAGE ?? 'playground.html')) {
  console.log('SKIPPED: playground.build has made no page');
  process.exit(0);
}
const here = dirname(fileURLToPath(import.meta.url));
const work = mkdtempSync(join(tmpdir(), 'gonogo-playground-page-'));
const kPage = pathToFileURL(process.env.GONOGO_PLAYGROUND_PAGE ?? 'playground.html').href;
const kPocket = 'G17 G00 X30 Y14 Z9\nG110 X20 Y10 W-4 R-3 I10 L4 Q2 P0.5 D3 F200\n';

let context;
before(async () => {
  context = await openBrowser(work, 1500);
});
after(async () => {
  await context?.close();
  rmSync(work, { recursive: true, force: true });
});

function withPage(asked, body) {
  const hash = asked ? `#${new URLSearchParams(asked).toString().replaceAll('+', '%20')}` : '';
  return withBrowserPage(context, kPage + hash, async (page) => {
    await settled(page);
    await body(page);
  }, /^(file|data|blob):/);
}

const settled = (page) => page.waitForFunction(() => /record|Wrong use|stopped/.test(document.querySelector('#state').textContent), null, { timeout: 60_000 });
const text = (page, selector) => page.locator(selector).innerText();
const records = async (page) => (await page.locator('#records').textContent()).trim().split('\n').map((line) => JSON.parse(line));

const kAlarm = 'G00 X130 Z5\n  G90 X60 Z-20 R40 F200;\n';
test('a program is expanded in the page alone, with an alarm shown by line, caret and clause', () => withPage({ dialect: 'gsk988ta', program: kAlarm }, async (page) => {
  assert.match(await text(page, '#state'), /An alarm ends it/);
  const messages = await page.locator('#messages').textContent();
  assert.match(messages, /^program\.nc:2:16: alarm: .*\n {6}G90 X60 Z-20 R40 F200;\n {19}\^$/m);
  const clause = /, (GSK-[A-Z0-9]+-\d+)\]/.exec(messages)[1];
  assert.ok((await text(page, '#message-clauses')).includes(clause));
  assert.equal((await records(page)).at(-1).clause, clause);
  // A click leads to the place.
  await page.click('#messages');
  assert.equal(await page.evaluate(() => {
    const area = document.querySelector('#program');
    return area.value.slice(area.selectionStart, area.selectionStart + 4);
  }), 'R40 ');
}));

test('each motion is stepped to with its clause, in space', () => withPage(null, async (page) => {
  assert.match(await text(page, '#position'), /^record 1 of \d+, line 1/);
  await page.locator('h2#path-title').click();
  for (let i = 0; i < 2; ++i) await page.keyboard.press('ArrowRight');
  const lit = await page.locator('#space path.gs-now').getAttribute('d');
  assert.match(lit, /^M.*L/);
  assert.match(await text(page, '#clause'), /GSK-[A-Z0-9]+-\d+ .+/);
  await page.locator('#steps tr').nth(4).click();
  assert.match(await text(page, '#position'), /^record 5 of/);
  assert.notEqual(await page.locator('#space path.gs-now').getAttribute('d'), lit);
  const before = await page.locator('#space path.gs-r').first().getAttribute('d');
  await page.click('#view-top');
  assert.notEqual(await page.locator('#space path.gs-r').first().getAttribute('d'), before);
}));

// Which line of the program the mark lies on; 0: none.
const markedLine = (page) => page.evaluate(() => {
  const [box, mark] = ['#program', '#line-mark'].map((id) => document.querySelector(id));
  const style = getComputedStyle(box);
  const top = mark.getBoundingClientRect().top - box.getBoundingClientRect().top - parseFloat(style.paddingTop) - box.clientTop;
  return mark.hidden ? 0 : 1 + Math.round((top + box.scrollTop) / parseFloat(style.lineHeight) * 10) / 10;
});
// At one moment: other readings, which come later, move the page.
const isWithin = (page, inner, outer) => page.evaluate((names) => {
  const [small, large] = names.map((name) => document.querySelector(name).getBoundingClientRect());
  return small.top >= large.top && small.bottom <= large.bottom + 1;
}, [inner, outer]);
const toLine = (page, line) => page.evaluate((to) => {
  const box = document.querySelector('#program');
  box.focus();
  const at = box.value.split('\n').slice(0, to - 1).join('\n').length + (to > 1 ? 1 : 0);
  box.setSelectionRange(at, at);
}, line);

test('the line of a motion is marked, and the cursor in a line steps to its first motion', () => withPage({ dialect: 'gsk988ta', program: 'G00 X130 Z5\nG94 X60 Z-20 F200\n\nZ-40 R-15\n' }, async (page) => {
  assert.equal(await markedLine(page), 1);
  await page.locator('#steps tr').nth(3).click();
  assert.equal(await markedLine(page), 2);
  await page.click('#forward');
  await page.click('#forward');
  assert.match(await text(page, '#position'), /^record 6 of 10, line 4/);
  assert.equal(await markedLine(page), 4);
  // By mouse into the second line, then by keys: the third has no motion, the fourth has.
  await toLine(page, 2);
  const lit = await page.locator('#space path.gs-now').getAttribute('d');
  await page.keyboard.press('End');
  assert.match(await text(page, '#position'), /^record 2 of 10, line 2/);
  assert.notEqual(await page.locator('#space path.gs-now').getAttribute('d'), lit);
  assert.equal(await page.locator('#steps tr.now').getAttribute('data-at'), '1');
  await page.keyboard.press('ArrowDown');
  assert.equal(await markedLine(page), 2);
  await page.keyboard.press('ArrowDown');
  assert.match(await text(page, '#position'), /^record 6 of 10, line 4/);
  assert.equal(await markedLine(page), 4);
  await page.locator('#program').click({ position: { x: 60, y: 20 } });
  assert.match(await text(page, '#position'), /^record 1 of 10, line 1/);
  // Whoever writes stays in the line.
  await toLine(page, 2);
  await page.keyboard.press('End');
  await page.keyboard.type('0');
  await page.waitForFunction(() => document.querySelector('#records').textContent.includes('"2000"'));
  await page.waitForFunction(() => /line 2/.test(document.querySelector('#position').textContent));
  assert.equal(await markedLine(page), 2);
}));

test('a line that is not seen is scrolled to', () => withPage({ dialect: 'rs274', program: `${'(nothing)\n'.repeat(60)}G0 X1\nM2\n` }, async (page) => {
  await page.click('#forward');
  await page.click('#back');
  assert.equal(await markedLine(page), 61);
  assert.ok(await isWithin(page, '#line-mark', '#program'));
  await page.locator('#program').evaluate((node) => { node.scrollTop = 0; });
  await page.waitForFunction(() => document.querySelector('#line-mark').getBoundingClientRect().top > document.querySelector('#program').getBoundingClientRect().bottom);
}));

test('each dialect has examples, and none of them alarms', () => withPage(null, async (page) => {
  const dialects = await page.locator('#dialect option').allInnerTexts();
  assert.equal(dialects.length, 5);
  for (const dialect of dialects) {
    await page.selectOption('#dialect', dialect);
    const names = await page.locator('#example option').allInnerTexts();
    assert.ok(names.length >= 2, `${dialect}: ${names}`);
    for (const label of names) {
      await page.selectOption('#example', { label });
      await settled(page);
      assert.match(await text(page, '#state'), /^The program ends: \d+ records$/, `${dialect}, ${label}`);
      assert.ok(await page.locator('#said').isHidden(), label);
      assert.equal(await page.locator('#example option:checked').innerText(), label);
    }
  }
  // What the reader wrote stays under another dialect.
  await page.fill('#program', 'G0 X1\n');
  assert.equal(await page.locator('#example option:checked').innerText(), 'none of these:');
  await page.selectOption('#dialect', 'rs274');
  assert.equal(await page.inputValue('#program'), 'G0 X1\n');
  await page.selectOption('#example', { index: 1 });
  assert.match(await page.inputValue('#program'), /G83/);
}));

test('a deep hole of thousands of pecks is drawn as one line, and listed in parts', () => withPage({ dialect: 'rs274', program: 'F100 G0 Z1\nG83 X0 Y0 Z-100 R1 Q0.1\nM2\n' }, async (page) => {
  assert.match(await text(page, '#state'), /^The program ends: 3\d\d\d records/);
  for (const kind of ['feed', 'rapid']) {
    assert.ok((await page.locator(`#space path.gs-r.gs-${kind}`).getAttribute('d')).match(/M/g).length <= 2, kind);
  }
  assert.equal(await page.locator('#steps .part').count(), 20);
  // Each motion is still stepped to, and its row is seen.
  for (const at of [1500, 3, 1998]) {
    await page.locator('#slider').fill(String(at));
    assert.match(await page.locator('#space path.gs-now').getAttribute('d'), /^M.*L/);
    assert.ok(await isWithin(page, '#steps tr.now', '#steps .motions'), `row ${at}`);
  }
}));

test('other readings stand beside what is chosen', () => withPage({ dialect: 'gsk988ta', program: kPocket }, async (page) => {
  const row = page.locator('#other-list tr', { hasText: 'gsk.pocket.end' }).first();
  await row.waitFor();
  const changed = await row.locator('td').nth(2).innerText();
  await row.locator('button').click();
  assert.equal(await page.locator('#steps .motions').count(), 2);
  assert.ok(await page.locator('#steps tr.differs').count() > 0);
  assert.ok(changed.includes(await page.locator('#steps .motions.s tr.differs td').nth(1).innerText()));
  assert.notEqual(await page.locator('#space path.gs-s.gs-feed').getAttribute('d'), '');
  if (process.env.GONOGO_SCREENSHOT) await page.screenshot({ path: process.env.GONOGO_SCREENSHOT, fullPage: true });
  // Choosing it makes it the path.
  const before = await page.locator('#records').textContent();
  const value = await row.locator('td').nth(1).innerText();
  await page.selectOption('select[data-reading="gsk.pocket.end"]', value);
  await page.waitForFunction((old) => document.querySelector('#records').textContent !== old, before);
  assert.match(await page.locator('#link').getAttribute('href'), /reading=gsk\.pocket\.end/);
}));

test('dialect and profile are followed, and wrong ones are said', () => withPage({ dialect: 'rs274', program: 'G1 X1 F100\nM2\n' }, async (page) => {
  assert.deepEqual((await records(page))[0].to, { x: '1' });
  await page.fill('#profile', 'units = "inch"');
  await page.waitForFunction(() => document.querySelector('#records').textContent.includes('"25.4"'));
  await page.fill('#profile', 'units = "furlong"');
  await page.waitForFunction(() => /Wrong use/.test(document.querySelector('#state').textContent));
  assert.match(await text(page, '#messages'), /furlong/);
}));

test('what is too long is stopped, and the next program runs', { timeout: 240_000 }, () => withPage({ dialect: 'rs274', program: 'G0 X1\nM2\n' }, async (page) => {
  const until = (state) => page.waitForFunction((words) => document.querySelector('#state').textContent.startsWith(words), state, { timeout: 100_000 });
  await page.fill('#program', 'F100\nG0 Z1\nG83 X0 Y0 Z-1000 R1 Q0.0001\nM2\n');
  await until('It was stopped after 200000 records');
  // As after kPatience.
  await page.evaluate(() => {
    const asked = answer();
    stopWorker('The program was stopped.');
    return asked.catch((error) => error.message);
  });
  await page.fill('#program', 'G0 X2\nM2\n');
  await until('The program ends: 3 records');
}));

test('links of the dialect pages open their examples', async () => {
  const links = [...readFileSync(join(here, '..', '..', 'docs', 'dialects', 'gsk988ta.md'), 'utf8').matchAll(/page\/index\.html#([^)\s]+)\)/g)];
  assert.ok(links.length > 10);
  const asked = new URLSearchParams(links[0][1]);
  await withPage(asked, async (page) => {
    assert.equal(await page.inputValue('#program'), asked.get('program'));
    assert.equal(await page.inputValue('#dialect'), 'gsk988ta');
    assert.match(await text(page, '#state'), /The program ends/);
  });
});
