// SPDX-License-Identifier: GPL-3.0-or-later
//
// What terminal, summaries and hunts say of one departure in the same words: the machine where it
// is not the default, the program with the block that departs, what is wanted and what came.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/line_source.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// What is known of one case that departs. An empty field is left out.
struct FindingFacts {
  std::string comment;   // what the case is about
  std::string profile;   // JSON
  std::string blocks;    // of its program, marked_blocks
  std::string in_force;  // in the block that departs, left by earlier ones
  std::string want;
  std::string got;
  std::string message;
  std::string known;      // of an xfail: the reason of its entry
  std::string departure;  // of an advice or xfail: the verdict that it would be
  std::string rule;       // of the relation, that is broken
  std::string gap;        // of an oracle-gap: its reason
  std::string clause;
  std::string basis;  // of the expectation departed from
  std::optional<std::uint64_t> block;
  std::optional<std::uint64_t> record;  // place of the subject's, from 0
  std::string deviation_exact;
  std::string deviation_mm;
  std::string witness;  // for people
  std::string reading;
  std::string cause;  // sentences
  std::string next;   // the command that shows more
};
FindingFacts finding_facts(const Verdict& verdict);
// The line of what is wanted, for a subject that has no lines.
std::optional<std::uint64_t> line_wanted(std::string_view want);

// The parts of the text, in their order.
struct FindingPart {
  enum class Form { sentence, fact, lines, command };
  Form form;
  std::string what;  // the name of a fact or a command
  std::string text;
};
// The place of a record, which data count from 0 and people, as lines, from 1; empty: none.
std::string record_number(const std::optional<std::uint64_t>& record);
// "0.5 mm (exactly 1/2)"; empty: none.
std::string deviation_text(const FindingFacts& facts);
std::vector<FindingPart> finding_parts(const FindingFacts& facts);
// The same for a terminal or a log, each line behind the indent.
std::string finding_text(const FindingFacts& facts, std::string_view indent);

// A record or an alarm as people write it: {"k":"rapid","b":2,"to":{"z":"-7"}} is "rapid Z-7". What
// is none comes back as it is.
std::string short_step(std::string_view json);

// "want rapid Z-7 / got rapid Z-3"; empty: there is neither.
std::string want_and_got(std::string_view want, std::string_view got);

// The lines about this one of a program with their numbers, the line itself marked by a caret
// below; nothing without such a line; 0: the first lines. Bytes that are no text of ASCII are shown
// as ?.
std::string marked_blocks(grammar::ByteSource& program, std::uint64_t line);
std::string marked_blocks(std::string_view program, std::uint64_t line);
// All lines in the same way; 0: none is marked.
std::string marked_program(std::string_view program, std::uint64_t line);

// What a profile in JSON has other than the default machine, which is all that it says: "units
// inch; gsk.decimals keep". Empty: nothing.
std::string other_machine(std::string_view profile);

}  // namespace gonogo::oracle
