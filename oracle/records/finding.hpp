// SPDX-License-Identifier: GPL-3.0-or-later
//
// The findings of a run: what is NO-GO, or undecided without the corpus expecting it, grouped by
// what the cases have in common. Takes case lines one at a time; its memory depends on clauses and
// verdicts, not on cases.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/records/case_head.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// What a departure is about: the kinds of the two records or the classes of the two alarms
// ("rapid/feed"), or what broke down.
std::string departed_about(VerdictKind kind, std::string_view want, std::string_view got,
                           std::string_view message);

// Whether the subject's motion is of a block that the reference has left. Both are texts of steps.
bool is_of_earlier_block(std::string_view want, std::string_view got);

// Whether the subject answered otherwise than the reference, rather than not at all or not as the
// protocol says.
bool is_other_answer(VerdictKind kind);
// Whether the subject or the gauge broke down, so that no record is at fault.
bool is_breakdown(VerdictKind kind);

// The order of findings in a report: a wrong path before a wrong alarm, a breakdown after them.
unsigned gravity(VerdictKind kind);

// What a finding is likely to come from: a mistake with which the reference does as the subject.
struct Cause {
  std::string name;      // a sentence without its full stop; empty: none is known
  std::string evidence;  // sentences: how much it explains, and what explains as much

  bool empty() const { return name.empty(); }
  // "Behaves as if: I J K are taken as absolute. It explains 5 of 5 departures ..."
  std::string text() const;
};

// The cases that depart in one way, as far as their lines show. What was due in the place of one
// class of alarm that is not due, or of a motion of an earlier block, is chance.
struct Finding {
  struct Key {
    unsigned gravity = 0;
    VerdictKind kind = VerdictKind::fail_geometry;
    std::string dialect;
    std::string clause;  // departed from; empty: none
    std::string what;
    auto operator<=>(const Key&) const = default;
  };
  // A case as it stands in the list.
  struct Example {
    std::string id;
    std::string message;
    std::size_t blocks = 0;  // of its program; 0: not kept
    std::size_t bytes = 0;
  };
  Key key;
  Key shown;  // for people: of the cases themselves, as far as they have the same
  // The cases' own verdicts with their numbers: two where a class of alarm is not due.
  std::map<VerdictKind, std::size_t> kinds;
  std::size_t number = 0;  // from 1, in the order in which they were met
  std::size_t cases = 0;
  Example smallest;
  std::set<std::string> messages;               // one where all say the same, else two
  std::vector<std::string> first;               // ids
  std::map<std::string, std::size_t> by_cycle;  // cases
  Cause cause;

  // That most cases are of.
  std::string cycle() const;
  // "fail.geometry at GSK-G94-02 (rapid)"; two kinds with "and" between them
  std::string text() const;
  // "87 x fail.geometry at GSK-G94-02 (rapid), smallest: gsk.g94.000013, 2 blocks"; each kind
  // with the number of its cases
  std::string line() const;

 private:
  // " at GSK-G94-02 (rapid)"
  std::string place() const;
};

class Findings {
 public:
  // The finding that the case belongs to; null: it is none. `kind`: in the run, which may be
  // another than the line's own.
  const Finding* add(const CaseHead& line, VerdictKind kind);
  // Whether the case that was added last is the smallest of its finding so far.
  bool is_smallest() const { return is_smallest_; }
  // For one dialect, verdict, clause and `what`.
  void set_cause(const Finding::Key& key, Cause cause);
  // By gravity, or by the cycle that most of their cases are of and then by gravity; a feed for a
  // traverse behind a wrong place; then the smallest program first. Those of one cause stand
  // together, where the first of them stands.
  enum class Order : std::uint8_t { gravity, cycle };
  std::vector<const Finding*> list(Order order = Order::gravity) const;
  bool empty() const { return findings_.empty(); }

 private:
  std::map<Finding::Key, Finding> findings_;
  std::map<Finding::Key, Cause> causes_;
  bool is_smallest_ = false;
};

}  // namespace gonogo::oracle
