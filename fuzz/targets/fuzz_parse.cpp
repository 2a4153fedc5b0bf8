// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parse: what parses prints to text that parses to the same tree; errors lie within their line.
// Cost cap: 4 KiB, since longer inputs only repeat what a block can hold.
#include <cstdlib>

#include "fuzz/targets/target.hpp"
#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gonogo;
  if (size > 4096) return 0;
  grammar::MemorySource bytes(fuzz::text_of(data, size));
  grammar::LineSource lines(bytes);
  grammar::Line line;
  grammar::Block block;
  grammar::Block again;
  while (lines.next(line)) {
    if (auto error = grammar::parse_block(grammar::Dialect::gsk988ta, line.text, block)) {
      if (error->where.begin > line.text.size() || error->where.end < error->where.begin) {
        fuzz::fail("an error lies outside its line", line.text);
      }
      grammar::render(*error, "fuzz", line.number, line.text);
      continue;
    }
    const std::string printed = grammar::print(block);
    if (grammar::parse_block(grammar::Dialect::gsk988ta, printed, again) || !(again == block)) {
      fuzz::fail("the printed block is another one", printed);
    }
  }
  return 0;
}
