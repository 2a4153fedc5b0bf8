// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: starts it.
'use strict';

function openFromHash() {
  const id = /^#case=(.*)$/.exec(location.hash)?.[1];
  if (!id) {
    if (openCase) closeCase();
    return;
  }
  let wanted;
  try { wanted = decodeURIComponent(id); } catch { return; }
  const c = cases.find((one) => one.id === wanted);
  if (!c || c === openCase) return;
  if (!shown.includes(c)) {
    byId('by-verdict').value = '';
    applyFilters();
  }
  if (shown.includes(c)) choose(shown.indexOf(c), true);
}

showHeadline();
showTotals();
showFindings();
setUpFilters();
showAdvices();
showNotClaimed();
showRun();
showMatrix();
showGaps();
applyFilters();
openFromHash();
addEventListener('hashchange', openFromHash);
addEventListener('resize', showRows);
