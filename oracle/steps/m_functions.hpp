// SPDX-License-Identifier: GPL-3.0-or-later
//
// R5. Where an M function may stand among the motions and dwells, and what is said of one
// that stands elsewhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "oracle/records/verdict.hpp"
#include "reference/record.hpp"

namespace gonogo::oracle {

// An M function that the reference passes on.
struct DueMFunction {
  reference::Record record;
  std::size_t step = 0;   // the step of the reference that it comes before
  bool is_fixed = false;  // it stands nowhere else
};

// What an M function does by the numbers that all makers share: it ends the program, so that
// nothing runs behind it; it starts or closes what a cut needs.
bool ends_program(const reference::Record& m_function);
bool starts_something(const reference::Record& m_function);

// How often the line names the M function. By its text: an alarm keeps the reference from saying
// what the block means.
std::size_t times_named(std::string_view line, std::int32_t number);

// The M function is due, and something else comes (`got`, record `number`).
Verdict m_function_missing(const reference::Record& due, std::string got, std::size_t number);
// The subject's M function, its record `number`: it is another than the due one; stands between the
// motions of a cycle or within a cut; comes before it is due; or is due nowhere near.
Verdict other_m_function(const reference::Record& due, const reference::Record& got,
                         std::size_t number);
Verdict m_function_within(const reference::Record& due, const reference::Record& got,
                          std::size_t number);
inline constexpr std::string_view kComesEarly = "An M function comes before it is due.";
// `due`: the text of what is due there.
Verdict m_function_too_early(const reference::Record& got, std::size_t number, std::string due);
Verdict m_function_too_many(const reference::Record& got, std::size_t number, std::string due);

}  // namespace gonogo::oracle
