// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/alarm_ground.hpp"

#include <variant>

#include "reference/dialect.hpp"

namespace gonogo::oracle {

using reference::ClauseId;
using reference::kNoClause;
using reference::Record;
using reference::RecordKind;

namespace {

// A cycle may go back and forth for ever.
constexpr std::size_t kMostItems = 10'000'000;

// The clause of an item and its block; none of those that say neither.
struct Ground {
  ClauseId clause = kNoClause;
  std::uint64_t block = 0;
};

Ground ground_of(const reference::Item& item) {
  return std::visit(
      [](const auto& one) -> Ground {
        if constexpr (requires { one.clause; }) {
          return {one.clause, one.block};
        } else {
          return {kNoClause, one.block};
        }
      },
      item);
}

class Search {
 public:
  explicit Search(const AlarmPlace& place) : place_(place) {}

  void accept(std::uint64_t block, ClauseId clause) {
    const bool is_there = place_.block != 0 ? block == place_.block
                                            : items_ >= place_.behind && items_ < place_.before;
    if (is_there && accepted_ == kNoClause) accepted_ = clause;
  }

  // Whether to go on.
  bool take(const reference::Item& item) {
    ++items_;
    const auto* record = std::get_if<Record>(&item);
    if (record != nullptr && record->kind == RecordKind::end) {
      // What stands behind the end is not run.
      if (accepted_ == kNoClause && first_ == kNoClause) accepted_ = record->clause;
      return false;
    }
    const Ground ground = ground_of(item);
    if (place_.block == 0) {
      if (items_ > place_.behind && first_ == kNoClause) first_ = ground.clause;
      return items_ < place_.before && items_ < kMostItems;
    }
    if (ground.block == place_.block && first_ == kNoClause) first_ = ground.clause;
    return ground.block <= place_.block && items_ < kMostItems;
  }

  // Nothing: the block can be read, and moves nothing.
  ClauseId found() const { return accepted_ != kNoClause ? accepted_ : first_; }

 private:
  const AlarmPlace& place_;
  std::size_t items_ = 0;
  ClauseId accepted_ = kNoClause;
  ClauseId first_ = kNoClause;
};

}  // namespace

ClauseId clause_of_right(const reference::Profile& profile, const ProgramText& program,
                         const AlarmPlace& place) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  Search search(place);
  expander.on_acceptance(
      [&](std::uint64_t block, ClauseId clause) { search.accept(block, clause); });
  try {
    while (const reference::Item* item = expander.next()) {
      if (!search.take(*item)) break;
    }
  } catch (const exact::Undecided&) {
    // What was found so far stands.
  }
  const ClauseId found = search.found();
  return found != kNoClause ? found : reference::find_dialect(profile.dialect)->syntax_clause;
}

}  // namespace gonogo::oracle
