// SPDX-License-Identifier: GPL-3.0-or-later
//
// The line of the program whose motion is stepped to, marked behind the text of the box; and the line of
// the cursor. No line is wrapped, so that each is a row.
'use strict';

const lineBox = () => document.getElementById('program');
let markedLine = 0;

function placeMark() {
  const box = lineBox();
  const style = getComputedStyle(box);
  const height = parseFloat(style.lineHeight);
  const mark = document.getElementById('line-mark');
  mark.hidden = markedLine < 1 || markedLine > box.value.split('\n').length;
  mark.style.height = `${height}px`;
  mark.style.top = `${parseFloat(style.borderTopWidth) + parseFloat(style.paddingTop) + (markedLine - 1) * height - box.scrollTop}px`;
}

// 0: none. The text is scrolled to the line, unless somebody is writing in it.
function markLine(line) {
  const box = lineBox();
  markedLine = line;
  const height = parseFloat(getComputedStyle(box).lineHeight);
  const top = (line - 1) * height;
  const seen = top >= box.scrollTop && top + height <= box.scrollTop + box.clientHeight;
  if (line > 0 && !seen && document.activeElement !== box) box.scrollTop = top - 2 * height;
  placeMark();
}

function cursorLine() {
  const box = lineBox();
  return box.value.slice(0, box.selectionStart).split('\n').length;
}

// Calls `act` with the line in which the cursor is put, by mouse or keys.
function onCursor(act) {
  for (const event of ['click', 'keyup']) lineBox().addEventListener(event, () => act(cursorLine()));
  lineBox().addEventListener('scroll', placeMark);
}
