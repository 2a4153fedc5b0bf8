// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_waivers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

using report::text_of;

// What the line says that the case departs by, as an entry knows it.
Verdict departure_of(const CaseRow& row) {
  Verdict departure;
  departure.kind = row.kind == VerdictKind::xfail
                       ? verdict_kind(row.departure).value_or(VerdictKind::oracle_error)
                       : row.kind;
  departure.deviation_exact = row.deviation_exact;
  departure.got = row.got;
  return departure;
}

std::string not_known(const CaseRow& row) {
  return fmt::format("{}: it is {}, and no known failure of the run says so.", row.id,
                     row.verdict());
}

}  // namespace

VerdictKind kind_before(const Json& line) {
  const auto readings = line.find("readings");
  const Json& source = readings == line.end() ? line : *readings;
  return verdict_kind(text_of(source, "verdict")).value_or(VerdictKind::oracle_error);
}

const KnownFailure* RunWaivers::steady_entry(const std::string& id) const {
  const auto found = std::ranges::find_if(
      entries_, [&](const KnownFailure& entry) { return !entry.flaky && entry.covers(id); });
  return found == entries_.end() ? nullptr : &*found;
}

bool RunWaivers::is_steady(const CaseRow& row) const {
  const Verdict departure = departure_of(row);
  const bool is_known = row.kind == VerdictKind::xfail;
  return std::ranges::any_of(entries_, [&](const KnownFailure& entry) {
    return !entry.flaky && entry.covers(row.id) && entry.is(departure) &&
           (!is_known || visible(entry.reason) == row.known);
  });
}

// An entry of a fail.reading leaves it to the readings of the run what the pass comes to.
std::string RunWaivers::fault_of_pass(const Json& line, const CaseRow& row) const {
  const KnownFailure* const entry = steady_entry(row.id);
  const auto readings = line.find("readings");
  const std::string known = readings == line.end() ? std::string() : text_of(*readings, "known");
  if (entry == nullptr) return known.empty() ? "" : not_known(row);
  const bool is_left_open = entry->verdict == VerdictKind::fail_reading && readings != line.end();
  if (is_left_open && known == visible(entry->reason)) return {};
  return fmt::format(
      "{}: it passes, and a known failure of the run says that it fails ({}), but the line is {}.",
      row.id, visible(entry->reason), row.verdict());
}

std::string RunWaivers::fault(const Json& line, const CaseRow& row, bool holds_words) const {
  if (decision(kind_before(line)) == Decision::go) return fault_of_pass(line, row);
  if (row.kind == VerdictKind::xpass) {
    const KnownFailure* const entry = steady_entry(row.id);
    if (entry == nullptr) return not_known(row);
    const std::string own = entry->pass_message();
    const std::string& told = row.message;
    if (!holds_words || told == own) return {};
    return fmt::format("{}: the message was \"{}\", but its known failure makes it \"{}\".", row.id,
                       told, own);
  }
  if (row.kind == VerdictKind::xfail) {
    const Verdict departure = departure_of(row);
    const bool is_known = std::ranges::any_of(entries_, [&](const KnownFailure& entry) {
      return entry.covers(row.id) && entry.is(departure) && visible(entry.reason) == row.known;
    });
    return is_known ? "" : not_known(row);
  }
  if (!text_of(line, "known").empty()) {
    return fmt::format("{}: {} has no reason of a known failure.", row.id, row.verdict());
  }
  // A program that is in no corpus is held against no entry.
  if (row.decision() != Decision::no_go || is_fresh(row.id) || !is_steady(row)) return {};
  return fmt::format("{}: it is {}, but a known failure of the run says so: it is xfail.", row.id,
                     row.verdict());
}

bool RunWaivers::rests_on_runs(const CaseRow& row) const {
  return row.kind == VerdictKind::xfail && !row.known.empty() &&
         row.departure != name(VerdictKind::fail_reading) && !is_steady(row);
}

std::vector<std::string> RunWaivers::additions(const CaseRow& row) const {
  const Verdict departure = departure_of(row);
  std::vector<std::string> texts;
  for (const KnownFailure& entry : entries_) {
    if (!entry.flaky || !entry.covers(row.id) || !entry.is(departure)) continue;
    for (int runs = entry.flaky->failures + 1; runs <= entry.flaky->runs; ++runs) {
      texts.push_back(entry.beyond_flaky(runs));
    }
  }
  return texts;
}

}  // namespace gonogo::oracle::evidence
