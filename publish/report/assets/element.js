// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page and of the playground: elements, made of text, never of markup.
'use strict';

// An element with attributes; children are elements or text, never markup.
function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'on') {
      for (const [event, handler] of Object.entries(value)) node.addEventListener(event, handler);
    } else if (value !== false && value != null) {
      node.setAttribute(name, value === true ? '' : value);
    }
  }
  node.append(...children.filter((child) => child != null && child !== false));
  return node;
}

const kSvg = 'http://www.w3.org/2000/svg';

function svgNode(tag, css) {
  const node = document.createElementNS(kSvg, tag);
  node.setAttribute('class', css);
  return node;
}
