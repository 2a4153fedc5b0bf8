// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <string_view>
#include <vector>

#include "oracle/relation/event.hpp"
#include "reference/expander.hpp"

namespace gonogo::relation {

// The records that lead through each free step that is decided, by the number of its item.
using Settled = std::map<std::size_t, std::vector<reference::Record>>;

// A rule that no text states, by which a block runs on, and the event with which the block begins.
struct Acceptance {
  std::size_t event = 0;
  std::uint64_t block = 0;
  reference::ClauseId clause = reference::kNoClause;
};

// The reference's events, each computed when it is looked at.
class ReferenceSide {
 public:
  // What it is given must outlive it. `passes_end`: what stands behind an end that no text states
  // follows what stands before it (R7).
  ReferenceSide(const reference::Profile& profile, std::string_view program,
                const Tolerances& tolerances, Settled settled, bool passes_end);
  // The last event is the close; REQUIRES: no event before `index` is.
  const Event& at(std::size_t index);

  // M functions that have no place of their own among the motions (R5), in order: how many are
  // known when event `index` is; each of them; whether it may stand before event `index`; whether
  // it must have come by then.
  std::size_t m_functions(std::size_t index);
  const reference::Record& m_function(std::size_t number) const { return m_[number].record; }
  bool may_stand(std::size_t number, std::size_t index);
  bool is_overdue(std::size_t number, std::size_t index);
  // Whether both belong to one block that gives them no order; then the later one may come first.
  bool may_change_places(std::size_t number, std::size_t later) const;
  struct Move {
    std::size_t index = 0;  // an event by which both are known
    std::size_t number = 0;
    std::size_t later = 0;
  };
  void bring_forward(const Move& move);
  const std::vector<Move>& moves() const { return moves_; }
  std::uint64_t m_block(std::size_t number) const { return m_[number].record.block; }

  const std::vector<Acceptance>& acceptances() const { return acceptances_; }
  std::size_t item_of(std::size_t index) const { return items_.at(index); }
  const Settled& settled() const { return settled_; }
  bool is_in_order() const { return expander_.is_in_order(); }
  std::string failed_words() const { return expander_.failed_words(); }
  const reference::ReadingsInUse& readings() const { return expander_.readings(); }

 private:
  // The events from `begin` to before `end`.
  struct Block {
    std::size_t begin;
    std::size_t end;
  };
  struct MFunction {
    reference::Record record;
    std::size_t event;                    // that it stands before
    mutable std::optional<Block> events;  // of its block, once they are known
  };
  void extend();
  void take(const reference::Item& item);
  void take(const reference::Record& record);
  void push(Event event);
  Block block_of(const MFunction& m);

  const Tolerances& tolerances_;
  grammar::MemorySource bytes_;
  grammar::LineSource lines_;
  reference::Expander expander_;
  Settled settled_;
  bool passes_end_;
  Position here_;
  std::deque<Event> events_;
  std::deque<std::size_t> items_;  // the number of the item of each event
  std::optional<MotionEvents> motion_;
  std::deque<reference::Record> due_;  // of a free step that is decided
  std::size_t item_ = 0;
  std::size_t scanned_ = 0;  // before which all M functions are known
  std::deque<MFunction> m_;
  std::vector<Move> moves_;
  std::vector<Acceptance> acceptances_;
};

}  // namespace gonogo::relation
