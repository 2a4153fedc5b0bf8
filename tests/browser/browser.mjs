// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests in a real browser share: a Chromium without network, and pages that must not complain.
// GONOGO_CHROMIUM names the browser.
import assert from 'node:assert/strict';
import { join } from 'node:path';

const kFlags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

// A browser with its profile below `work`; to be closed.
export async function openBrowser(work, height = 900) {
  const { chromium } = await import('playwright-core').catch(() => {
    throw new Error('playwright-core is missing: run `npm ci` in tests/browser');
  });
  return chromium.launchPersistentContext(join(work, 'profile'), {
    executablePath: process.env.GONOGO_CHROMIUM ?? '/usr/bin/chromium', args: kFlags,
    viewport: { width: 1280, height }, colorScheme: 'light', offline: true,
    reducedMotion: 'reduce',  // a place that is measured is where it stays: no page scrolls smoothly
  });
}

// Milliseconds of the processor that the page's thread has had so far, without what else the machine does.
async function threadTime(context, page) {
  const session = await context.newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return 1000 * metrics.find(({ name }) => name === 'TaskDuration').value;
  };
}

// Opens the page, runs `body`, which is also given the clock of its thread, and asserts that the page never complained, nor asked for anything but `own`
// addresses.
export async function withPage(context, url, body, own = /^(file|data):/) {
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('dialog', (dialog) => { complaints.push(`dialog ${dialog.message()}`); dialog.dismiss(); });
  page.on('request', (request) => {
    if (!own.test(request.url())) requests.push(request.url());
  });
  try {
    const busy = await threadTime(context, page);
    await page.goto(url);
    await body(page, busy);
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests, []);
  } finally {
    await page.close();
  }
}
