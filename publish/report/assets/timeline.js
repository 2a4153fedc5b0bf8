// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the motions of a path in their order, above the slider that steps through
// them: a colour and a height for each kind, a line where a block begins, a mark at the departure.
'use strict';

const kKinds = [['rapid', 'tl-rapid', 5], ['thread', 'tl-thread', 12], ['dwell', 'tl-other', 3], ['m', 'tl-other', 3], ['end', 'tl-other', 3],
  ['alarm', 'tl-alarm', 12], ['not-covered', 'tl-alarm', 12]];
const kMostBlocks = 400;  // more would be one grey field
const kTimelineHeight = 20;

function kindOf(record) {
  const [, css, height] = kKinds.find(([kind]) => kind === record[0]) ?? [null, 'tl-feed', 9];
  return { css, height };
}

// Runs of what is alike, each as a box from half a step before its first record to half a step after its last.
function timelineRuns(records) {
  const d = new Map();
  for (let i = 0; i < records.length;) {
    const { css, height } = kindOf(records[i]);
    let last = i;
    while (last + 1 < records.length && kindOf(records[last + 1]).css === css && records[last + 1][1] === records[i][1]) ++last;
    d.set(css, `${d.get(css) ?? ''}M${i - 0.5} 18v${-height}h${last - i + 1}v${height}Z`);
    i = last + 1;
  }
  return d;
}

// What the failing block does, the blocks' beginnings, the kinds and the departure; drawn for one path.
function drawTimeline(node, records, block, departing) {
  const path = (css, d) => { const made = svgNode('path', css); made.setAttribute('d', d); return made; };
  const starts = records.flatMap(([, of], i) => (i === 0 || of !== records[i - 1][1] ? [i] : []));
  const blamed = records.flatMap(([, of], i) => (of === block ? [`M${i - 0.5} 0h1v${kTimelineHeight}h-1Z`] : []));
  node.setAttribute('viewBox', `0 0 ${Math.max(1, records.length - 1)} ${kTimelineHeight}`);
  node.replaceChildren(path('tl-block', blamed.join('')),
    ...[...timelineRuns(records)].map(([css, d]) => path(`tl-kind ${css}`, d)),
    path('tl-start', starts.length <= kMostBlocks ? starts.map((i) => `M${i - 0.5} 2v16`).join('') : ''),
    path('tl-departure', departing === undefined ? '' : `M${departing} 0v${kTimelineHeight}`));
}

function timeline(s, slider) {
  const node = svgNode('svg', 'tl');
  node.id = 'timeline';
  node.setAttribute('preserveAspectRatio', 'none');
  node.setAttribute('aria-hidden', 'true');  // the slider says it all
  node.addEventListener('click', (event) => {
    const box = node.getBoundingClientRect();
    goTo(s.owner, Math.round((event.clientX - box.left) / box.width * s.last[s.owner]));
    slider.focus({ preventScroll: true });
  });
  return el('div', { class: 'timeline' }, node, slider);
}

// Where one stands in a path. A run may have been stopped where it departs: then the path has no end.
function placeText(s, owner, index) {
  const ended = owner === 'r' || ['end', 'alarm'].includes(s.lists.s.at(-1)?.[0]);
  return `${owner === 'r' ? 'reference' : 'subject'} ${index + 1} of ${s.last[owner] + 1}${ended ? '' : ' recorded'}`;
}

// What a slider's value means.
function recordText(s, owner, index) {
  const record = s.lists[owner][index];
  if (!record) return `${owner === 'r' ? 'reference' : 'subject'}: no records`;
  const departing = index === (owner === 's' ? s.data.record : s.data.wanted);
  return [placeText(s, owner, index), record[0], record[1] > 0 && `line ${record[1]}`, departing && 'the departure'].filter(Boolean).join(', ');
}
