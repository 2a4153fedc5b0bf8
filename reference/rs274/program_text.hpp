// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands round the blocks of a program: % lines, the numbers of lines and of the program, and
// its end.
#pragma once

#include <string_view>

#include "reference/expander.hpp"

namespace gonogo::reference::rs274 {

// NGC-COM-07: where % lines may stand.
class ProgramText {
 public:
  // Ends the program at the second % line of a pair; an alarm where one may not stand.
  void take(const grammar::Block& block, BlockOutput& out);
  void leave_out() { has_line_ = true; }

 private:
  bool has_line_ = false;   // a line that is not blank was there
  bool is_opened_ = false;  // by a %
};

// NGC-COM-05, NGC-COM-06: an alarm where N or O has a number that it may not have.
void check_numbers(const grammar::Block& block, const ReadingsInUse& readings, BlockOutput& out);

// NGC-COM-10: an alarm where the last comment in brackets is (abort,...).
void check_abort(const grammar::Block& block, BlockOutput& out);

// NGC-COM-08: an alarm at the end of a text that does not end the program. `skipped`: the label of
// an O word whose end was looked for up to there, or empty.
void check_text_end(const grammar::Span& end, std::string_view skipped,
                    const ReadingsInUse& readings, BlockOutput& out);

}  // namespace gonogo::reference::rs274
