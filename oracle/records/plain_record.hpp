// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fast path before the JSON parser for records as nearly all of them are written: known keys,
// plain ASCII strings without escapes, numbers that are strings. It is five times as fast, and says
// nothing about anything else: what a record means, and what is wrong with one, is
// read_trace_line's.
#pragma once

#include <string_view>

#include "reference/record.hpp"

namespace gonogo::oracle {

// The record of a line of JSON where it is plain, the same as read_trace_line gives; false where
// the line has to be read by that, which may find a record, an alarm or a fault. `record` is as
// new, and unspecified on false.
bool read_plain_record(std::string_view line, reference::Record& record);

}  // namespace gonogo::oracle
