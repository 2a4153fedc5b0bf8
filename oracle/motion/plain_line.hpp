// SPDX-License-Identifier: GPL-3.0-or-later
//
// A filter before the reader of a trace: whether a line is the record of a motion that is known
// already.
#pragma once

#include <string_view>

#include "oracle/motion/plain_motion.hpp"

namespace gonogo::oracle {

// Whether the line is this motion's record in JSON, with its keys in the order of `append_json`, no
// blanks, and the motion's clause or none. False says nothing: the line has to be read.
// REQUIRES: the motion is of a record, whose feed is not negative.
bool is_line_of(const PlainMotion& motion, std::string_view line);

}  // namespace gonogo::oracle
