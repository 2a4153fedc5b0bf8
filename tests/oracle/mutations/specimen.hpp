// SPDX-License-Identifier: GPL-3.0-or-later
//
// A case of the corpus under one combination of its readings, with the trace that the reference
// shows of it and the path that follows from it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oracle/judge/judge_session.hpp"
#include "path_map.hpp"

namespace gonogo::mutations {

// What a subject puts out.
struct Trace {
  std::vector<Record> records;
  oracle::RunEnd end;
};

// Which open part a record of the right trace belongs to.
enum class PartKind : std::uint8_t { none, level, helix_pocket, thread, pocket_milling };

struct Specimen {
  std::string id;
  std::string group;  // dialect and cycle
  std::string program;
  reference::Profile profile;
  oracle::Tolerances tolerances;
  Trace right;
  std::vector<reference::Position> before;        // where each record starts, every axis
  std::vector<reference::Position> after;         // and ends
  std::vector<PartKind> part;                     // of each record
  std::vector<std::size_t> part_number;           // which of the parts, from 0
  std::vector<reference::Item> items;             // the open parts, in their order
  std::vector<reference::AlarmClass> admissible;  // classes of the alarm
  std::vector<NewName> names;
  std::vector<reference::Renaming> renamings;  // the same, exact
  Place start{};
  std::vector<PathElement> path;

  double tolerance() const { return value_of(tolerances.tolerance); }
  std::vector<Stroke> strokes(const Trace& trace) const;
};

// A case as it stands in the corpus, as far as it is needed.
struct RawCase {
  std::string id;
  std::string group;
  std::string program;
  reference::Profile profile;
  using Assignment = std::vector<std::pair<std::string, std::string>>;
  std::vector<Assignment> assignments;
};

// Those that are covered, by group.
using RawCases = std::map<std::string, std::vector<RawCase>>;
RawCases cases_of_corpus(const std::string& folder);

// The records that the reference shows under a profile; nothing where it ends otherwise than right.
std::optional<std::vector<Record>> shown_under(const reference::Profile& profile,
                                               const std::string& program);

// Longer traces take their map too long.
inline constexpr std::size_t kMostRecords = 400;

// Nothing for what the bench leaves alone: programs that are not covered, traces of more than
// `most` records. Throws std::logic_error where the shown path breaks a condition of its own.
std::unique_ptr<Specimen> make_specimen(const RawCase& raw, const RawCase::Assignment& readings,
                                        std::size_t most);

}  // namespace gonogo::mutations
