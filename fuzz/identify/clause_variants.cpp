// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion that a clause asks for is of another kind, or is left out, at any place
// among the motions of its block.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

using reference::clause_name;
using reference::ClauseId;

// The clauses of the motions of the block that departs, that of the departure first.
std::vector<ClauseId> clauses_concerned(const Observation& departure) {
  std::vector<ClauseId> clauses;
  const auto add = [&](ClauseId clause) {
    if (clause != reference::kNoClause && std::ranges::find(clauses, clause) == clauses.end()) {
      clauses.push_back(clause);
    }
  };
  add(departure.verdict.clause);
  const auto shown = run_reference(departure.profile, departure.program);
  if (!shown) return clauses;
  for (const Record& record : shown->records) {
    if (record.block == departure.verdict.block && is_motion(record.kind)) add(record.clause);
  }
  return clauses;
}

// The feed of a cut of its block, else the last one before it.
void give_feed(std::vector<Record>& records, Record& record) {
  const Record* source = nullptr;
  for (const Record& other : records) {
    if (other.kind != RecordKind::feed || &other == &record || other.block > record.block) continue;
    source = &other;
  }
  if (source == nullptr) return;
  record.feed = source->feed;
  record.feed_mode = source->feed_mode;
}

bool give_kind(std::vector<Record>& records, ClauseId clause, RecordKind from, RecordKind to) {
  bool changed = false;
  for (Record& record : records) {
    if (record.clause != clause || record.kind != from) continue;
    changed = true;
    record.kind = to;
    record.feed = {};
    record.feed_mode = {};
    if (to == RecordKind::feed) give_feed(records, record);
  }
  return changed;
}

void add_kinds_of(ClauseId clause, Variants& out) {
  for (const auto& [from, to] : {std::pair(RecordKind::feed, RecordKind::rapid),
                                 std::pair(RecordKind::rapid, RecordKind::feed)}) {
    add_model(
        fmt::format("the motion of {} is a {}, not a {}", clause_name(clause), name(to),
                    name(from)),
        [=](const Observation&, KeptOutcome& model) {
          return give_kind(model.records, clause, from, to);
        },
        out);
  }
}

}  // namespace

void add_clause_variants(const Observation& departure, Variants& out) {
  for (const ClauseId clause : clauses_concerned(departure)) {
    add_kinds_of(clause, out);
    add_model(
        fmt::format("the motion of {} is left out", clause_name(clause)),
        [clause](const Observation&, KeptOutcome& model) {
          return std::erase_if(model.records, [&](const Record& record) {
                   return record.clause == clause && is_motion(record.kind);
                 }) > 0;
        },
        out);
  }
}

}  // namespace gonogo::identify
