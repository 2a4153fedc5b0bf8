// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two findings have in common when they are the same defect, as far as a black box shows.
#pragma once

#include <string>

#include "fuzz/generate/generator.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::hunt {

struct Signature {
  std::string dialect;
  oracle::VerdictKind kind = oracle::VerdictKind::pass_exact;
  std::string clause;  // departed from; empty: none
  // Kinds of the two records, classes of the two alarms, or what broke down; "feed/feed X": the
  // first axis along which two of one kind end apart; "feed/rapid of an earlier block" where the
  // subject moves in a block that the reference has left.
  std::string what;
  std::string code;  // in force in the block: "G94"; of a motion beside a dwell that of the motion

  // "fail.geometry GSK-G94-02 feed/rapid in G94"
  std::string text() const;
  // 8 hexadecimal digits.
  std::string hash() const;
  // The subject makes a motion more than its block has; what comes next is of the program.
  bool is_surplus() const;
  // The class of the alarm that the subject gives and no text asks for; empty: no such alarm.
  std::string undue_alarm() const;
  friend auto operator<=>(const Signature&, const Signature&) = default;
};

Signature signature_of(const oracle::Verdict& verdict, const generate::GeneratedProgram& program);

// The kind of a record or the class of an alarm, from its text: "feed"; "none" of nothing.
std::string kind_in_text(const std::string& text);

}  // namespace gonogo::hunt
