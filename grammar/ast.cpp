// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/ast.hpp"

namespace gonogo::grammar {

void Block::clear() {
  skip = false;
  tape_mark = false;
  sequence_number.reset();
  program_number.reset();
  number_place = {};
  line_comment = {};
  words.clear();
  named.clear();
  other_blank = {};
  terms.clear();
  names.clear();
  assignments.clear();
  control.reset();
  comments.clear();
  outside.reset();
}

}  // namespace gonogo::grammar
