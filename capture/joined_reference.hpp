// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference's steps as sampled positions can show them: without motions too small to see,
// and with those that go on in one way as one.
#pragma once

#include <deque>
#include <optional>

#include "oracle/steps/reference_steps.hpp"

namespace gonogo::oracle {

class JoinedReference {
 public:
  // All must outlive it.
  JoinedReference(const reference::Profile& profile, grammar::LineSource& lines,
                  const Tolerances& tolerances);

  // The current step; the last one (the end, an alarm, not covered) stays.
  const ReferenceStep& current();
  void advance();
  bool at_end() { return is_end(current()); }

 private:
  void take(const reference::Item& item);
  void take_motion(const Record& record);
  void flush();

  const Tolerances& tolerances_;
  reference::Expander expander_;
  Position position_;              // where the motions so far end
  Position stood_;                 // where the last one that was kept ends
  bool over_arcs_ = false;         // arcs were left out behind it
  std::size_t left_out_ = 0;       // in a row
  std::optional<Motion> pending_;  // which what follows may go on
  std::deque<ReferenceStep> ready_;
  std::size_t items_ = 0;
};

}  // namespace gonogo::oracle
