// SPDX-License-Identifier: GPL-3.0-or-later
//
// The HTML report as people meet it: opened from a file in a real browser, without network.
// GONOGO_REPORT_PAGE names the program that writes a report, GONOGO_CHROMIUM the browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openBrowser, withPage as withBrowserPage } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const data = join(here, '..', 'publish', 'report', 'data');
const writer = process.env.GONOGO_REPORT_PAGE;
const work = mkdtempSync(join(tmpdir(), 'gonogo-browser-'));

let context;
const reports = new Map();  // results file -> page

before(async () => {
  assert.ok(writer, 'GONOGO_REPORT_PAGE must name the program that writes a report');
  context = await openBrowser(work);
});

after(async () => {
  await context?.close();
  rmSync(work, { recursive: true, force: true });
});

function report(results) {
  if (!reports.has(results)) {
    const directory = join(work, `report-${reports.size}`);
    mkdirSync(directory);
    execFileSync(writer, [results, directory]);
    reports.set(results, pathToFileURL(join(directory, 'index.html')).href);
  }
  return reports.get(results);
}

const withPage = (results, body, hash = '') => withBrowserPage(context, report(results) + hash, async (page, busy) => {
  await page.waitForSelector('#decision');
  await body(page, busy);
});

const results = join(data, 'results.jsonl');
const atCase = (id) => `#case=${encodeURIComponent(id)}`;
const text = (page, selector) => page.locator(selector).innerText();
// Until the list has followed.
const counted = (page, words) => page.waitForFunction(
  (begin) => document.querySelector('#count').textContent.startsWith(begin), words);
// Until the page has drawn it.
const shows = (page, selector, words) => page.waitForFunction(
  ([at, wanted]) => document.querySelector(at)?.innerText === wanted, [selector, words]);
const sizes = (page) => page.locator('#rows .row').count();

// Recorded verdicts: 4 fail.*, crash, protocol; one oracle-gap; 30 cases in all.
test('the headline says what came out', () => withPage(results, async (page) => {
  assert.equal(await text(page, '#decision'), 'NO-GO');
  assert.match(await text(page, '#headline'), /28 of 30 cases judged . 22 GO . 6 NO-GO . 1 undecided . 1 not claimed/);
  assert.equal(await page.locator('#incomplete').count(), 0);
  assert.match(await text(page, '#facts'), /builtin:gsk\+g94-r-sign/);
}));

test('a run of passes is GO', () => withPage(join(data, 'go.jsonl'), async (page) => {
  assert.equal(await text(page, '#decision'), 'GO');
}));

test('a file without footer says so where nobody can miss it', () => withPage(join(data, 'without-footer.jsonl'), async (page) => {
  assert.equal(await text(page, '#decision'), 'INCOMPLETE');
  assert.match(await text(page, '#incomplete'), /no footer/);
}));

test('search and filters narrow the list', () => withPage(results, async (page) => {
  assert.equal(await sizes(page), 6);  // all NO-GO, to begin with
  await page.fill('#search', 'sigsegv');
  assert.equal(await sizes(page), 1);
  await page.fill('#search', '');
  await page.selectOption('#by-verdict', 'fail.feed');
  assert.match(await text(page, '#rows'), /gsk\.g94\.000003/);
  assert.equal(await sizes(page), 1);
  await page.click('#clear');
  await counted(page, '30 of 30 cases');
  await page.selectOption('#by-cycle', 'g110');
  await counted(page, '8 of 30 cases');
  await page.fill('#search', 'no such text');
  assert.match(await text(page, '#rows'), /No case fits/);
}));

test('a cell of the matrix shows its cases', () => withPage(results, async (page) => {
  const cell = page.locator('#matrix button[aria-label^="GSK-G94-06 g94:"]');
  assert.match(await cell.getAttribute('aria-label'), /: 8 passed, 0 departed here/);
  await cell.click();
  await counted(page, '8 of');
  assert.match(await text(page, '#matrix'), /GSK-G94-08[^]*not checked/);
}));

test('a failure shows its evidence', () => withPage(results, async (page) => {
  await page.locator('.row', { hasText: 'gsk.g94.000002' }).click();
  const detail = await text(page, '#detail');
  assert.match(detail, /The motion ends at Z -5/);
  assert.match(detail, /Traverse from A to B along p alone/);  // the clause's text
  assert.match(detail, /10 mm, exactly/);
  assert.match(detail, /Witness\s+X 30 +Z -5/);
  assert.match(await text(page, '#program .at-fault'), /G94 X20 Z-10 R-5 F100/);
  assert.match(await text(page, '#want-got'), /-15[^]*-5/);
  assert.equal((await text(page, "#command")).replace(/^\S*\//, ""),
    "gonogo certify --subject builtin:gsk+g94-r-sign --corpus 'my corpus' --case gsk.g94.000002");
}));

// The traverse to Z -15 that the subject leads to -5; before it the root of 30^2 + 5^2 on both sides.
test('a failure says how long both sides take', () => withPage(results, async (page) => {
  const traverses = page.locator('#times tbody tr', { hasText: 'Traverses' }).locator('td');
  assert.deepEqual(await traverses.allInnerTexts(), ['114.414 mm (rounded)', '50.414 mm (rounded)', '40.414 mm (rounded)']);
  assert.equal(await page.locator('#times tbody tr').count(), 2);  // cuts and traverses: nothing waits or turns
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}, atCase('gsk.g94.000002')));

test('a failure says under which reading it would be GO', () => withPage(results, async (page) => {
  assert.match(await text(page, '#detail .other'), /gsk\.pocket\.end=r-plane/);
  assert.match(await text(page, '#detail'), /0\.333333 mm, exactly 1\/3/);
}, atCase('gsk.g110.000001')));

test('a drawing has its views, both paths and the departure', () => withPage(results, async (page) => {
  const views = await page.locator('#sheet [data-view], #strip [data-view]').evaluateAll((all) => all.map((one) => one.dataset.view));
  assert.deepEqual(views, ['front', 'top', 'side', 'isometric', 'unfolded']);  // below: its layers, motion beside motion
  for (const view of views.slice(0, 4)) {
    for (const mark of ['.gs-r.gs-feed', '.gs-s.gs-feed', '.gs-r.gs-rapid', '.gs-s.gs-rapid', '.gs-witness']) {
      assert.ok(await page.locator(`#sheet [data-view=${view}] ${mark}`).count() > 0, `${view} ${mark}`);
    }
  }
}, atCase('gsk.g110.000001')));

test('stepping moves the mark in the drawing and the records beside it', () => withPage(results, async (page) => {
  const mark = () => page.locator('#sheet [data-marks=front] .gs-now').getAttribute('d');
  await shows(page, '#position', 'subject 2 of 10');  // the departure
  const departure = await mark();
  assert.match(await text(page, '#stepped'), /Reference, record 2[^]*-15[^]*Subject, record 2[^]*-5/);
  await page.click('#forward');
  await shows(page, '#position', 'subject 3 of 10');
  assert.notEqual(await mark(), departure);
  await page.locator('#detail').focus();
  await page.keyboard.press('ArrowLeft');
  await shows(page, '#position', 'subject 2 of 10');
  assert.equal(await mark(), departure);
  await page.keyboard.press('ArrowLeft');
  await shows(page, '#position', 'subject 1 of 10');
  assert.ok(await page.locator('#back').isDisabled());
  assert.match(await text(page, '#program .now'), /G00 X60 Z5/);
  await page.check('input[name=owner][value=r]');
  // A rapid, two cycles of four motions, M30 and the end.
  await shows(page, '#position', 'reference 1 of 11');
  await page.click('#last');
  assert.match(await text(page, '#stepped .active'), /kind\s+end/);
  await page.click('#departure');
  await page.waitForFunction((wanted) =>
    document.querySelector('#sheet [data-marks=front] .gs-now').getAttribute('d') === wanted, departure);
}, atCase('gsk.g94.000002')));

test('findings are told once and lead to their cases', () => withPage(results, async (page) => {
  const rows = page.locator('#findings tbody tr');
  assert.equal(await rows.count(), 7);  // 4 fail.*, crash, protocol and the gap, no two of them alike
  await page.locator('#findings tbody a').first().click();
  await page.waitForSelector('#sheet');
  await page.locator('#findings tbody button').first().click();
  await counted(page, '1 of 30 cases');
}));

test('a view in space turns, magnifies and follows the steps', () => withPage(results, async (page) => {
  const drawn = () => page.locator('#space .gs-r.gs-feed').getAttribute('d');
  const isometric = await drawn();
  assert.ok(isometric.length > 20);
  await page.locator('#space svg').scrollIntoViewIfNeeded();
  const box = await page.locator('#space svg').boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 80, middle[1] + 20, { steps: 4 });
  await page.mouse.up();
  const turned = await drawn();
  assert.notEqual(turned, isometric);
  await page.mouse.wheel(0, -200);
  await page.waitForFunction((before) => document.querySelector('#space .gs-r.gs-feed').getAttribute('d') !== before, turned);
  await page.locator('.space-bar button', { hasText: 'Isometric' }).click();
  assert.equal(await drawn(), isometric);
  const now = await page.locator('#space .gs-now').getAttribute('d');
  await page.click('#forward');
  assert.notEqual(await page.locator('#space .gs-now').getAttribute('d'), now);
  await page.locator('.space-bar input').first().uncheck();
  assert.equal(await drawn(), '');
}, atCase('gsk.g94.000002')));

test('a thread in space has its own dashes and its words', () => withPage(results, async (page) => {
  // 1 mm of feed from the origin, then 1 mm of thread.
  const [feed, thread, words] = await page.evaluate(() => {
    const view = new View3d({ moves: { r: [[2, 0, 0, 0, 10000, 0, 0], [4, 0, 0, 10000]] } });
    const svg = view.build();
    const drawn = (kind) => svg.querySelector(`.gs-r.gs-${kind}`).getAttribute('d').split('M').length - 1;
    return [drawn('feed'), drawn('thread'), view.legend().map((one) => one.textContent)];
  });
  assert.deepEqual([feed, thread, words], [1, 1, ['reference, feed', 'reference, thread']]);
}));

// Boxes of what is drawn, in pixels of the screen.
const boxes = (page, selector) => page.locator(selector).evaluateAll((all) => all.filter((one) => one.getClientRects().length > 0).map((one) => {
  const { left, top, right, bottom } = one.getBoundingClientRect();
  return { left, top, right, bottom, width: right - left, height: bottom - top };
}));
const within = (inner, outer) => inner.left >= outer.left - 1 && inner.right <= outer.right + 1 && inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;

test('what is magnified keeps its sizes, and its numbers are made anew', () => withPage(results, async (page) => {
  const measured = async () => ({
    ring: (await boxes(page, '#sheet [data-view=front] .gs-witness circle'))[0].width,
    head: (await page.locator('#sheet [data-view=front] path.gs-head').first().getAttribute('d')).match(/-?[\d.]+/g).slice(0, 4).map(Number),
    title: (await boxes(page, '#sheet [data-view=front] .gs-name'))[0],
    numbers: await page.locator('#sheet [data-view=front] .gs-numbers .gs-label').allInnerTexts(),
    high: (await boxes(page, '#sheet [data-view=front] .gs-numbers .gs-label')).map((box) => box.height),
    scale: await page.locator('#sheet [data-view=front] .gs-content').evaluate((node) => node.getCTM().a),
  });
  const before = await measured();
  await page.click('#zoom-departure');
  const after = await measured();
  const length = ({ head: [a, b, c, d] }) => Math.hypot(a - c, b - d);
  assert.ok(after.scale > 1.9 * before.scale, JSON.stringify([before.scale, after.scale]));
  assert.ok(Math.abs(after.ring - before.ring) < 1, JSON.stringify([before.ring, after.ring]));
  assert.ok(Math.abs(length(after) - length(before)) < 0.1);
  assert.ok(Math.abs(after.title.height - before.title.height) < 0.5);
  assert.ok(after.high.every((one) => Math.abs(one - before.high[0]) < 0.5));
  assert.notDeepEqual(after.numbers, before.numbers);
  assert.ok(after.numbers.length >= 4, 'numbers at the frame');
  // Read at one moment: the page may still be scrolling.
  const [view, ...inside] = await boxes(page, '#sheet, #sheet [data-view=front] .gs-numbers .gs-label, #sheet [data-view=front] .gs-witness circle');
  for (const box of inside) assert.ok(within(box, view), JSON.stringify([box, view]));
}, atCase('gsk.g94.000002')));

test('a failing block fills the view at first, and what leads to it is cut at the frame', () => withPage(results, async (page) => {
  const drawn = () => page.evaluate(() => {
    const path = document.querySelector('#sheet [data-view=front] .gs-s.gs-feed');
    const { width, height } = path.getBoundingClientRect();
    const clip = document.querySelector('#clip-front rect').getBBox();
    return { share: Math.max(width / clip.width, height / clip.height), approach: document.querySelector('#sheet [data-view=front] .gs-r.gs-rapid').getBoundingClientRect().width / clip.width };
  });
  const first = await drawn();
  await page.click('#zoom-all');
  const whole = await drawn();
  assert.ok(first.share > 1.2 * whole.share, JSON.stringify([first, whole]));
  assert.ok(first.approach > 1 || first.share > 0.5, JSON.stringify(first));
  assert.ok(whole.approach <= 1.01, JSON.stringify(whole));
  await page.click('#zoom-block');
  assert.deepEqual(await drawn(), first);
}, atCase('gsk.g94.000002')));

test('rapids have a colour of their own that is seen in light, in dark and on paper', () => withPage(results, async (page) => {
  for (const media of [{ colorScheme: 'light' }, { colorScheme: 'dark' }, { media: 'print' }]) {
    await page.emulateMedia(media);
    const found = await page.evaluate(() => {
      const luminance = (color) => color.match(/[\d.]+/g).slice(0, 3).map((v) => v / 255)
        .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
      const style = (css) => getComputedStyle(document.querySelector(`#sheet [data-view] ${css}`));
      const paper = luminance(style('.gs-r.gs-rapid').stroke && getComputedStyle(document.querySelector('#sheet .gs-paper')).fill);
      return ['r', 's'].map((owner) => {
        const [feed, rapid] = ['feed', 'rapid'].map((kind) => style(`.gs-${owner}.gs-${kind}`));
        const [a, b] = [luminance(rapid.stroke), paper].sort((x, y) => y - x);
        return { ratio: (a + 0.05) / (b + 0.05), differs: feed.stroke !== rapid.stroke, dashed: rapid.strokeDasharray !== 'none', opacity: rapid.opacity };
      });
    });
    for (const one of found) assert.ok(one.ratio >= 3 && one.differs && one.dashed && one.opacity === '1', JSON.stringify([media, found]));
  }
}, atCase('gsk.g94.000002')));

test('the timeline marks kinds, blocks and the departure, and the slider says them', () => withPage(results, async (page) => {
  for (const css of ['.tl-rapid', '.tl-feed', '.tl-start', '.tl-block']) {
    assert.ok((await page.locator(`#timeline ${css}`).getAttribute('d')).length > 0, css);
  }
  assert.match(await page.locator('#timeline .tl-departure').getAttribute('d'), /^M1 /);  // the second record
  const slider = page.locator('#slider');
  assert.match(await slider.getAttribute('aria-valuetext'), /^subject 2 of 10, rapid, line \d+, the departure$/);
  assert.equal(await slider.getAttribute('aria-label'), 'Record');
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await shows(page, '#position', 'subject 3 of 10');
  assert.match(await slider.getAttribute('aria-valuetext'), /^subject 3 of 10, feed/);
  await page.locator('#timeline').click({ position: { x: 1, y: 10 } });
  await shows(page, '#position', 'subject 1 of 10');
}, atCase('gsk.g94.000002')));

test('the drawing stays in sight while what was wanted is read', () => withPage(results, async (page) => {
  for (const [width, height] of [[1400, 900], [1144, 800]]) {
    await page.setViewportSize({ width, height });
    await page.locator('#sheet').waitFor();
    const [sheet, stepper, card] = await page.evaluate(() => {
      document.querySelector('#want-got').scrollIntoView({ block: 'center' });
      return ['#sheet', '#stepper', '#want-got'].map((part) => document.querySelector(part).getBoundingClientRect()).map(({ top, bottom }) => [top, bottom]);
    });
    for (const [top, bottom] of [sheet, stepper]) assert.ok(top >= 0 && bottom <= height, JSON.stringify([width, sheet, stepper]));
    assert.ok(card[0] < height && card[1] > 0);
  }
}, atCase('gsk.g94.000002')));

test('on a phone one view is shown, and the departure in it', () => withPage(results, async (page) => {
  await page.setViewportSize({ width: 400, height: 800 });
  await page.reload();
  await page.locator('#sheet').waitFor();
  const [sheet, ...rings] = await boxes(page, '#sheet, #sheet [data-view] .gs-witness circle');
  assert.equal(rings.length, 1);
  assert.ok(within(rings[0], sheet) && sheet.right <= 400, JSON.stringify([rings, sheet]));
  const [frame, ...labels] = await boxes(page, '#sheet, #sheet .gs-numbers .gs-label');
  for (const box of labels) assert.ok(within(box, frame) && box.height > 9, JSON.stringify(box));
  assert.equal(await page.evaluate(() => document.querySelector('#sheet').scrollWidth <= document.querySelector('#sheet').clientWidth), true);
}, atCase('gsk.g110.000001')));

test('on paper each finding has a sheet of its own', () => withPage(results, async (page) => {
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.ok(await page.locator('#printed .printed').count() >= 6);
  assert.ok(await page.locator('#printed .sheet svg').count() >= 4);
  assert.equal(await page.locator('#filters').isVisible(), false);
  assert.equal(await page.locator('#findings').isVisible(), true);
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
  const pages = Number(/\/Count (\d+)/.exec(pdf)[1]);
  assert.ok(pages >= 7 && pages < 20, `${pages} pages`);
}));

// The inside of an A4 page less its margins, in CSS pixels.
const kInsidePage = { width: 703, height: 1016 };

test('on paper a sheet is one page, nothing of it is cut off, and what was folded is told', () => withPage(results, async (page) => {
  await page.setViewportSize(kInsidePage);
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const sheets = await page.locator('#printed .printed').evaluateAll((all) => all.map((one) => {
    const box = one.getBoundingClientRect();
    const within = (node) => { const own = node.getBoundingClientRect(); return own.right <= box.right + 1 && own.bottom <= box.bottom + 1; };
    const cut = (node) => !node.matches(':has(> .mono)') && node.scrollHeight > node.clientHeight + 1;
    return { height: box.height, outside: [...one.querySelectorAll('dd, pre .line, svg')].filter((node) => !within(node)).length,
      cut: [...one.querySelectorAll('dd')].filter(cut).length };
  }));
  assert.ok(sheets.length >= 6);
  for (const sheet of sheets) {
    assert.ok(sheet.height <= kInsidePage.height, JSON.stringify(sheet));
    assert.equal(sheet.outside, 0);
    assert.equal(sheet.cut, 0);
  }
  assert.equal(await page.locator('#gaps details:not([open])').count(), 0);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.locator('#gaps details[open]').count(), 0);
  assert.equal(await page.locator('#printed').count(), 0);
}));

test('an exact deviation is written as people write it', async () => {
  for (const [exact, mm, words] of [['{"root":["6","-0.001","30254578"]}', '0.499583834', '0.499583834 mm, exactly 6 \u2212 0.001\u00b7\u221a30254578'],
    ['{"root":["0","1","1/2"]}', '0.707106781', '0.707106781 mm, exactly \u221a(1/2)'],
    ['{"enclosure":["0.25","0.26"]}', '0.255', '0.255 mm, exactly between 0.25 and 0.26'], ['4', '4', '4 mm, exactly']]) {
    const path = join(work, `deviation-${mm}.jsonl`);
    writeFileSync(path, readFileSync(results, 'utf8').split('\n').map((line) => {
      if (!line.includes('"gsk.g110.000001"')) return line;
      return JSON.stringify({ ...JSON.parse(line), deviation: { exact, mm } });
    }).join('\n'));
    await withPage(path, async (page) => {
      const shown = await page.locator('#detail dt', { hasText: 'Deviation' }).locator('xpath=following-sibling::dd[1]').innerText();
      assert.equal(shown, words);
    }, atCase('gsk.g110.000001'));
  }
});

test('only up to here hides later motions', () => withPage(results, async (page) => {
  const drawn = () => page.locator('#sheet [data-view=front] .gs-s.gs-feed').getAttribute('d');
  const all = await drawn();
  assert.equal(all.split('M').length - 1, 4);  // two cycles with two feeds each
  await page.click('#forward');
  await page.check('#up-to');
  assert.equal((await drawn()).split('M').length - 1, 1);
  await page.uncheck('#up-to');
  assert.equal(await drawn(), all);
}, atCase('gsk.g94.000002')));

test('a click in the drawing chooses the nearest motion', () => withPage(results, async (page) => {
  await page.locator('#sheet [data-view=front] .gs-s.gs-feed').scrollIntoViewIfNeeded();
  const at = await page.evaluate(() => {
    const path = document.querySelector('#sheet [data-view=front] .gs-s.gs-feed');
    const middle = path.getPointAtLength(20).matrixTransform(path.getScreenCTM());
    return { x: middle.x, y: middle.y + 5 };
  });
  await page.mouse.click(at.x, at.y);
  assert.match(await text(page, '#position'), /^subject (3|7) of 10$/);  // the feeds that begin there
}, atCase('gsk.g94.000002')));

test('the list works from the keyboard', () => withPage(results, async (page) => {
  await page.locator('#list').focus();
  await page.keyboard.press('ArrowDown');
  assert.equal(await text(page, '#detail h2'), 'gsk.g110.000001');
  await page.keyboard.press('ArrowDown');
  assert.equal(await text(page, '#detail h2'), 'gsk.g110.000002');
  assert.equal(await page.locator('#list').getAttribute('aria-activedescendant'), 'row-1');
  assert.match(page.url(), /#case=gsk\.g110\.000002$/);
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'detail');
}));

test('a program in GBK is readable', () => withPage(results, async (page) => {
  assert.match(await text(page, '#program'), /O0002 \(端面车削\)/);
  assert.match(await text(page, '#detail'), /shown as GB18030/);
}, atCase('gsk.g94.000003')));

test('an alarm that is missing shows the alarm of the reference', () => withPage(results, async (page) => {
  await page.check('input[name=owner][value=r]');
  await page.click('#last');
  assert.match(await text(page, '#stepped .active'), /kind\s+alarm[^]*tool-too-large/);
}, atCase('gsk.g110.000002')));

test('hostile text stays text', async () => {
  const id = readFileSync(results, 'utf8').split('\n').filter((line) => line.includes('"crash"'))
    .map((line) => JSON.parse(line)).find((line) => line.verdict === 'crash').id;
  await withPage(results, async (page) => {
    assert.equal(await text(page, '#detail h2'), id);
    assert.match(await text(page, '#program'), /<script>window\.pwned=1<\/script>/);
    await page.click('#clear');
    await page.fill('#search', '<img');
    assert.equal(await sizes(page), 1);
    await page.waitForTimeout(100);
    assert.equal(await page.evaluate(() => window.pwned), undefined);
    assert.equal(await page.locator('img').count(), 0);
  }, atCase(id));
});

test('dark and light differ and keep their contrast', async () => {
  const page = await context.newPage();
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await page.goto(report(results) + atCase('gsk.g94.000002'));
    const worst = await page.evaluate(() => {
      const channels = (color) => color.match(/[\d.]+/g).map(Number);
      const luminance = (color) => channels(color).slice(0, 3).map((v) => v / 255)
        .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
        .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
      const back = (node) => {
        for (let at = node; at; at = at.parentElement) {
          const color = getComputedStyle(at).backgroundColor;
          if (channels(color)[3] !== 0) return color;
        }
        return 'rgb(255, 255, 255)';
      };
      let least = { ratio: 99 };
      for (const node of document.querySelectorAll('h1, h2, h3, h4, p, dt, dd, td, th, .badge, .line, .level, label, button:enabled, summary')) {
        if (!node.textContent.trim() || node.closest('[hidden]')) continue;
        const [a, b] = [luminance(getComputedStyle(node).color), luminance(back(node))].sort((x, y) => y - x);
        const ratio = (a + 0.05) / (b + 0.05);
        if (ratio < least.ratio) least = { ratio, text: node.textContent.slice(0, 40), tag: node.tagName };
      }
      return least;
    });
    assert.ok(worst.ratio >= 4.5, `${colorScheme}: ${JSON.stringify(worst)}`);
  }
  await page.close();
});

// ---- many cases ----

function manyCases() {
  const [header, ...lines] = readFileSync(results, 'utf8').trim().split('\n');
  const failure = JSON.parse(lines.find((line) => line.includes('"gsk.g110.000001"')));
  const pass = JSON.parse(lines.find((line) => line.includes('"gsk.g94.000001"')));
  const out = [header];
  for (let i = 1; i <= 10_000; ++i) {
    const id = `gsk.many.${String(i).padStart(6, '0')}`;
    out.push(JSON.stringify({ ...(i % 20 === 0 ? failure : pass), id }));
  }
  out.push(JSON.stringify({ totals: { 'pass-exact': 9500, 'fail.region': 500 }, judged: 10_000, assignments: [], sha256: '' }));
  const path = join(work, 'many.jsonl');
  writeFileSync(path, `${out.join('\n')}\n`);
  return path;
}

// The time is the page's own: from the start of the navigation until its last row and its last
// total stand there, read from the browser's performance timeline.
const kMostLoadMs = 2000;

test('ten thousand cases with 500 failures load within 2 s of the processor and stay usable', async (context_) => {
  const many = manyCases();
  report(many);  // not part of the time
  await withPage(many, async (page, busy) => {
    const loaded = await busy();
    context_.diagnostic(`loaded in ${Math.round(loaded)} ms`);
    assert.ok(loaded > 0 && loaded < kMostLoadMs, `loading took ${loaded} ms`);
    assert.match(await text(page, '#count'), /^500 of 10,000 cases/);
    const timed = async (what, act) => {
      const start = await busy();
      await page.evaluate(act);
      const ms = await busy() - start;
      context_.diagnostic(`${what}: ${Math.round(ms)} ms`);
      assert.ok(ms < 500, `${what} took ${ms} ms`);
    };
    await page.click('#clear');
    await page.waitForFunction(() => document.querySelector('#count').textContent.startsWith('10,000 of'));
    assert.ok(await sizes(page) < 60, 'only the rows in sight are in the page');
    await page.locator('#list').focus();
    await page.keyboard.press('End');
    assert.equal(await text(page, '#detail h2'), 'gsk.many.010000');
    await timed('search', () => {
      const search = document.querySelector('#search');
      search.value = '004321';
      search.dispatchEvent(new Event('input'));
    });
    assert.equal(await sizes(page), 1);
    await page.fill('#search', '');
    await timed('filter', () => {
      const verdict = document.querySelector('#by-verdict');
      verdict.value = '@no-go';
      verdict.dispatchEvent(new Event('change'));
    });
    assert.match(await text(page, '#count'), /^500 of 10,000 cases/);
    await page.locator('.row', { hasText: 'gsk.many.000020' }).click();
    const before = await text(page, '#position');
    await timed('step', () => {
      document.querySelector(document.querySelector('#forward').disabled ? '#back' : '#forward').click();
    });
    assert.notEqual(await text(page, '#position'), before);
  });
});

test('what the gauge does not read is folded', () => withPage(results, async (page) => {
  const codes = page.locator('#gaps .codes').first();
  assert.equal(await codes.isVisible(), false);
  await page.locator('#gaps details', { has: page.locator('.codes') }).first().locator('summary').click();
  assert.equal(await codes.isVisible(), true);
}));

// Chosen from the list, a case opens; Back closes it, Forward opens it again.
test('Back leads from a case to the report', () => withPage(results, async (page) => {
  assert.match(await text(page, '#headline .words'), /page of \d{4}-\d\d-\d\d \d\d:\d\d UTC/);
  await page.locator('#rows .row').first().click();
  const id = await text(page, '#detail h2');
  await page.goBack();
  await page.waitForFunction(() => document.querySelector('#detail').hidden);
  await page.goForward();
  await shows(page, '#detail h2', id);
}));

// 24 cycles of one case each; of the third and the last the case is NO-GO. Of the first, one more is
// skipped and one not covered.
function resultsOfCycles() {
  const [header, ...lines] = readFileSync(results, 'utf8').trimEnd().split('\n');
  const go = lines.map((line) => JSON.parse(line)).find(({ verdict }) => verdict === 'pass-exact');
  const cases = Array.from({ length: 26 }, (none, i) => ({ ...go, id: `gsk.c${String(i).padStart(2, '0')}`, cycle: `g${70 + i % 24}`,
    verdict: i === 2 || i === 23 ? 'fail.geometry' : i < 24 ? 'pass-exact' : 'skip', ...(i === 25 && { expected: true }) }));
  const file = join(work, 'cycles.jsonl');
  writeFileSync(file, `${[header, ...cases.map((one) => JSON.stringify(one))].join('\n')}\n`);
  return file;
}

for (const width of [1400, 1144, 400]) {
  test(`of many cycles those that fail stand open under the head line, at ${width} pixels`, () => withPage(resultsOfCycles(), async (page) => {
    await page.setViewportSize({ width, height: 900 });
    const place = (selector) => page.locator(selector).first().boundingBox();
    const [words, table, totals] = [await place('#headline .words'), await place('#by-cycles'), await place('#totals')];
    assert.ok(table.y >= words.y + words.height && table.y + table.height <= totals.y);
    assert.ok(table.x <= (await place('#decision')).x);
    const seen = () => page.locator('#by-cycles th[scope=row]:visible').allInnerTexts();
    assert.deepEqual(await seen(), ['g72', 'g93']);
    assert.equal(await text(page, '#by-cycles summary'), '22 cycles without a NO-GO');
    await page.locator('#by-cycles summary').click();
    assert.equal((await seen()).length, 24);
    await page.locator('#by-cycles summary').click();
    // Nobody can unfold paper.
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    assert.equal((await seen()).length, 24);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal((await seen()).length, 2);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    assert.match(await text(page, '#by-cycles .fails thead'), /not\s+covered/);
    assert.ok(await page.locator('#by-cycles .scroll').first().evaluate((box) => box.scrollWidth <= box.clientWidth));
  }));
}

for (const [what, hash] of [['the overview', ''], ['a case', atCase('gsk.g94.000002')]]) {
  test(`${what} is no wider than a phone`, () => withPage(results, async (page) => {
    await page.setViewportSize({ width: 400, height: 900 });
    await page.locator(hash === '' ? '#by-cycles' : '#sheet').waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400);
    // No column stands beyond the edge of its box.
    assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll('.scroll')]
      .filter((box) => box.scrollWidth > box.clientWidth).map((box) => box.textContent.slice(0, 60))), []);
  }, hash));
}

// The block at fault, the drawing and its stepper are seen at once, and stay while the facts are read.
test('a case fits one screen, with its drawing beside the program', () => withPage(results, async (page) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await page.locator('#sheet').waitFor();
  // From the top of the case, read at one moment: the page may still be scrolling.
  const places = await page.evaluate((parts) => {
    document.querySelector('.case').scrollIntoView();
    const { top } = document.querySelector('.case').getBoundingClientRect();
    return parts.map((part) => document.querySelector(part).getBoundingClientRect()).map((box) => [box.top - top, box.bottom - top]);
  }, ['#program .at-fault', '#sheet', '.stepper']);
  for (const [top, bottom] of places) assert.ok(top >= 0 && bottom <= 900, JSON.stringify(places));
}, atCase('gsk.g94.000002')));
