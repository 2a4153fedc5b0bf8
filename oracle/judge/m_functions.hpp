// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CMP-05. The M functions of both sides, which do not hold up the motions among which they stand.
#pragma once

#include <optional>
#include <string_view>

#include "oracle/judge/queue.hpp"
#include "oracle/judge/reference_steps.hpp"
#include "oracle/judge/terms.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

class MFunctions {
 public:
  // `terms` and `steps` must outlive it.
  MFunctions(const JudgeTerms& terms, const ReferenceSteps& steps) : terms_(terms), steps_(steps) {}

  // One that the reference has come to; one of the subject's, which is its record `number`. Each
  // says what differs.
  std::optional<Verdict> want(const reference::Record& record);
  std::optional<Verdict> take(const reference::Record& record, std::size_t number);
  // The subject's, wherever it belongs: whether it stands among the motions of its block.
  std::optional<Verdict> take_place(const reference::Record& record, std::size_t number);
  // A motion or a dwell of the subject's that is to be seen.
  std::optional<Verdict> take_event(const reference::Record& record, std::size_t number);
  // A cut, which some M functions have to come before.
  void note_cut(std::uint64_t block) { cut_block_ = block; }
  // The same of a motion of block `block` that neither departs nor waits for anything.
  void note_motion(std::uint64_t block) { motion_block_ = block; }
  // Whether a motion of the block finds no M function out of its place, and none waits for the
  // other side's.
  bool are_settled(std::uint64_t block) const {
    return is_none_due() && (block >= m_block_ || !tells_order());
  }
  // Whether none waits for the other side's.
  bool is_none_due() const { return want_.empty() && got_.empty(); }

  // At the end of the program: nothing may be missing or be too many.
  std::optional<Verdict> end();
  // Before an alarm in `block`, whose line that is. Those of earlier blocks must have come as
  // motion must; of its own block no text says whether any do that alarms. A control that checks at
  // load need not pass any, and passes no others either.
  std::optional<Verdict> end_before_alarm(std::uint64_t block, std::string_view line, bool at_load);
  // Before what no text states: those of that block and behind it are not judged (J-ALM-04).
  // Without line numbers nobody can tell them from the others.
  std::optional<Verdict> end_of_earlier(std::uint64_t block);

 private:
  std::optional<Verdict> settle();
  // Where lines come again, the number of one says nothing of its place among others.
  bool tells_order() const { return terms_.compare_blocks && steps_.is_in_order(); }

  const JudgeTerms& terms_;
  const ReferenceSteps& steps_;
  Queue<reference::Record> want_;
  struct Got {
    reference::Record record;
    bool after_cut;  // of its block
  };
  Queue<Got> got_;
  std::uint64_t cut_block_ = 0;     // of the last cutting motion
  std::uint64_t motion_block_ = 0;  // of the last motion or dwell
  std::uint64_t m_block_ = 0;       // of the last M function that the subject passed on
};

// An M function of a cycle that the subject has not passed on where it is due: it goes on by
// something else (`got`, its record `number`), or ends.
Verdict m_function_missing(const reference::Record& want, std::string got, std::size_t number);

}  // namespace gonogo::oracle
