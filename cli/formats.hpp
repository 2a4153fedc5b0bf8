// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `gonogo expand` writes a trace.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "reference/expander.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::cli {

// Appends text for each item as it comes.
class RecordFormat {
 public:
  virtual ~RecordFormat() = default;
  virtual void record(const reference::Record& record, std::string& out) = 0;
  virtual void alarm(const reference::AlarmReport& report, std::string& out) = 0;
  virtual void not_covered(const reference::NotCovered& outside, std::string& out) = 0;
  virtual void places(std::uint64_t /*block*/, const reference::CyclePlaces& /*places*/) {}
  virtual void finish(std::string& /*out*/) {}
};

// "jsonl": the records of docs/protocol.md. "table": for people. "ngc": plain G00 to G03 in the
// order of the motions, radius programming, absolute. "svg": a drawing sheet, on which the cycle of
// `named_block` has its points named; 0: the first cycle.
std::unique_ptr<RecordFormat> make_record_format(std::string_view name,
                                                 const reference::Profile& profile,
                                                 std::string_view program_name,
                                                 std::uint64_t named_block = 0);
// The last of them.
std::unique_ptr<RecordFormat> make_svg_format(const reference::Profile& profile,
                                              std::string_view program_name,
                                              std::uint64_t named_block);

}  // namespace gonogo::cli
