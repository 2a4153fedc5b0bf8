// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the judge says about one program and one subject.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/records/gap_reason.hpp"
#include "oracle/records/rounding_census.hpp"
#include "oracle/records/sampled_figures.hpp"
#include "reference/record.hpp"
#include "reference/word_name.hpp"

namespace gonogo::oracle {

enum class VerdictKind : std::uint8_t {
  // GO
  pass_exact,
  pass_rounded,
  pass_tolerance,
  pass_properties,  // a path that the manual leaves open, held to its properties
  // Neither
  xfail,   // fails as it is known to
  skip,    // not claimed
  advice,  // departs from an expectation that no text states
  // NO-GO
  fail_geometry,
  fail_order,
  fail_feed,
  fail_region,
  fail_reading,
  fail_overrun,
  fail_alarm_missing,
  fail_alarm_spurious,
  fail_alarm_class,
  fail_alarm_late,
  fail_declaration,  // what the subject declares, it skips
  state_leak,
  crash,
  timeout,
  out_of_memory,
  protocol,
  unmapped_alarm,
  xpass,
  // Undecided
  oracle_gap,
  oracle_error,
};
// `neither`: it says nothing for or against the subject.
enum class Decision : std::uint8_t { go, no_go, undecided, neither };
inline constexpr std::size_t kDecisions = 4;

std::string_view name(VerdictKind kind);  // "fail.geometry"
std::optional<VerdictKind> verdict_kind(std::string_view name);
Decision decision(VerdictKind kind);
// Whether a case that ended so was judged (J-RUN-14): neither an advice nor a known failure, skip
// or gap.
inline bool is_judged(VerdictKind kind) {
  return decision(kind) == Decision::go || decision(kind) == Decision::no_go;
}
std::span<const std::string_view> verdict_names();

// The rules of the acceptance relation (docs/relation.md), R1 to R8.
enum class RelationRule : std::uint8_t {
  none,  // a GO; or what is no matter of the relation, as a crash
  correspondence,
  place,
  label,
  traverse,
  event,
  alarm,
  silence,
  free_step,
};
std::string_view name(RelationRule rule);      // "R2"; "" of none
std::string rule_text(std::string_view name);  // "R2 (place)"; of another name the name itself

// A verdict with its evidence. Texts of records are JSON, numbers exact.
struct Verdict {
  VerdictKind kind = VerdictKind::pass_exact;
  RelationRule rule = RelationRule::none;  // none: that which the kind is the name of (rule_of)
  GapReason gap = GapReason::none;         // of an oracle_gap
  reference::ClauseId clause = reference::kNoClause;
  // For an advice: what it would be if a text stated the expectation; of an xfail: what it is.
  std::optional<VerdictKind> departure;
  std::size_t property_motions = 0;  // of a GO: motions of the subject held to properties alone
  // For a GO: those that are compared.
  std::optional<RoundingCensus> coordinates = {};
  std::string reading;                // another reading under which the answer would be GO: "k=v"
  std::string told_under;             // J-READ-01: "k=v, k=v", where `expand` shows others
  std::uint64_t block = 0;            // source line; 0: none
  std::optional<std::size_t> record;  // place of the subject's record, from 0
  reference::WordName word;
  std::string want;             // the reference's record, level or alarm
  std::string got;              // the subject's
  std::string deviation_exact;  // mm, as in a record; empty: none
  std::string deviation_mm;     // the same as a decimal
  std::string witness;          // a point that proves it: {"x":"1",...}; empty: none
  std::string feature;          // what the subject skips; empty: it refused a profile
  std::string message;          // a sentence for people
  std::string known;            // of an xfail: the reason that its entry gives
  std::shared_ptr<const SampledFigures> sampled = nullptr;  // of sampled positions
};

// The rule that the verdict says is broken; of R8 `clause` is that of the step. An xfail keeps that
// of what is known.
RelationRule rule_of(const Verdict& verdict);

// What the gauge cannot say, and why: for people and for programs.
Verdict gap_verdict(GapReason reason, std::string message);

}  // namespace gonogo::oracle
