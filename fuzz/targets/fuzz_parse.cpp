// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parse: in every dialect, what parses prints to text that parses to the same tree; errors lie
// within their line. Every line goes through every dialect, so an input is plain NC text and one
// that is found for a dialect serves the others. Cost cap: 4 KiB, since longer inputs only repeat
// what a block can hold.

#include "fuzz/targets/target.hpp"
#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"

namespace {

using namespace gonogo;

// The blocks are reused from line to line.
void check(grammar::Dialect dialect, const grammar::Line& line, grammar::Block& block,
           grammar::Block& again) {
  if (auto error = grammar::parse_block(dialect, line.text, block)) {
    if (error->where.end > line.text.size() || error->where.end < error->where.begin) {
      fuzz::fail("an error lies outside its line", line.text);
    }
    grammar::render(*error, "fuzz", line.number, line.text);
    return;
  }
  std::string printed = grammar::print(dialect, block);
  if (fuzz::planted_fault() == "print-cut" && !printed.empty()) printed.pop_back();
  if (grammar::parse_block(dialect, printed, again) || !(again == block)) {
    fuzz::fail("the printed block is another one", printed);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4096) return 0;
  grammar::MemorySource bytes(fuzz::text_of(data, size));
  grammar::LineSource lines(bytes);
  grammar::Line line;
  grammar::Block block;
  grammar::Block again;
  while (lines.next(line)) {
    for (const grammar::Dialect dialect : grammar::kDialects) check(dialect, line, block, again);
  }
  return 0;
}
