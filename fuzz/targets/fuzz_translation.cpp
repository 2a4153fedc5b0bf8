// SPDX-License-Identifier: GPL-3.0-or-later
//
// Translation: a generated program, of any dialect, that is moved as a whole does the same there.
// The first byte chooses the dialect, the others are the generator's decisions. Cost cap: 3,000
// records, since a tiny Q over a great depth is a long program.
#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/target.hpp"
#include "oracle/differential/reference_run.hpp"
#include "fuzz/relations/trace.hpp"

namespace {

using namespace gonogo;

constexpr std::size_t kMostRecords = 3'000;

// Enclosures of one place that come about in two ways cannot be distinguished; nor need they be.
const reference::Number kTolerance = reference::Number::decimal(false, 1, 9);

void check(const generate::GeneratedProgram& program) {
  const std::optional<relations::Related> related = relations::translated(program);
  if (!related) return;
  const oracle::ReferenceRun first =
      oracle::run_reference(program.profile, program.text, kMostRecords);
  if (!first.is_told()) return;
  oracle::ReferenceRun other =
      oracle::run_reference(related->program.profile, related->program.text, kMostRecords);
  if (!other.is_told()) return;
  if (fuzz::planted_fault() == "centre-left-behind") {
    for (reference::Record& record : other.records) {
      if (record.kind == reference::RecordKind::arc) record.centre[0] += 1;
    }
  }
  const auto difference = relations::first_difference(
      {first.records, first.end}, {other.records, other.end}, *related, kTolerance);
  if (!difference) return;
  fuzz::fail("a program that is moved does something else: want " + difference->want + ", got " +
                 difference->got + "\n" + related->program.text,
             program.text);
}

generate::GeneratedProgram moved_program(generate::Choices& choices) {
  const auto all = generate::generators();
  const auto dialects = static_cast<std::uint32_t>(all.size());
  return all[choices.below(256) % dialects].generate(choices, nullptr);
}

}  // namespace

void fuzz::decide(generate::Choices& choices) {
  moved_program(choices);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  generate::Choices choices = fuzz::choices_of(data, size);
  try {
    check(moved_program(choices));
  } catch (const exact::Undecided&) {
    // What 4,096 bits do not decide is a gap, and no finding.
  }
  return 0;
}
