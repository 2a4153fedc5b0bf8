// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/reference_side.hpp"

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::relation {

using reference::Item;
using reference::Record;
using reference::RecordKind;

ReferenceSide::ReferenceSide(const reference::Profile& profile, std::string_view program,
                             const Tolerances& tolerances, Settled settled, bool passes_end)
    : tolerances_(tolerances),
      bytes_(program),
      lines_(bytes_),
      expander_(profile, lines_, reference::OpenPaths::judged),
      settled_(std::move(settled)),
      passes_end_(passes_end),
      here_(profile.initial.at) {
  expander_.on_acceptance([this](std::uint64_t block, reference::ClauseId clause) {
    acceptances_.push_back({events_.size(), block, clause});
  });
}

const Event& ReferenceSide::at(std::size_t index) {
  while (index >= events_.size()) extend();
  return events_[index];
}

void ReferenceSide::push(Event event) {
  events_.push_back(std::move(event));
  items_.push_back(item_);
}

void ReferenceSide::extend() {
  if (motion_) {
    if (std::optional<Event> piece = motion_->next()) return push(*std::move(piece));
    motion_.reset();
  }
  if (!due_.empty()) {
    const Record record = due_.front();
    due_.pop_front();
    return take(record);
  }
  ++item_;
  const Item* item = expander_.next();
  while (passes_end_ && is_silent_end(*item)) {
    expander_.go_past_end();
    item = expander_.next();
  }
  take(*item);
}

void ReferenceSide::take(const Record& record) {
  Event event;
  event.item = std::make_shared<Item>(record);
  event.from = event.to = rastered(here_, tolerances_.tolerance).at;
  event.block = record.block;
  if (is_motion(record.kind)) {
    motion_.emplace(std::move(event), record, here_, tolerances_, Turn::as_written);
    here_ = end_of(record, here_);
    return;
  }
  if (record.kind == RecordKind::dwell && record.seconds.sign() == 0) return;
  if (record.kind == RecordKind::m) {
    if (!tolerances_.compare_m) return;
    if (!record.among_motions) return m_.push_back({record, events_.size(), {}});
  }
  event.part = record.kind == RecordKind::end ? Part::close : Part::stop;
  push(std::move(event));
}

void ReferenceSide::take(const Item& item) {
  if (const auto* record = std::get_if<Record>(&item)) return take(*record);
  Event event;
  event.item = std::make_shared<Item>(item);
  event.from = event.to = rastered(here_, tolerances_.tolerance).at;
  if (const auto* renaming = std::get_if<reference::Renaming>(&item)) {
    for (const reference::Axis axis : reference::kAllAxes) here_[axis] += renaming->shift[axis];
    event.part = Part::renaming;
    event.block = renaming->block;
  } else if (const auto settled = settled_.find(item_); settled != settled_.end()) {
    due_.assign(settled->second.begin(), settled->second.end());
    // Blocks that follow a thread start from where its path ended.
    if (std::holds_alternative<reference::ThreadMilling>(item)) {
      expander_.stand_at(due_.back().to);
    }
    return;
  } else if (!std::holds_alternative<reference::AlarmReport>(item) &&
             !std::holds_alternative<reference::NotCovered>(item)) {
    event.part = Part::free_step;
    event.block = std::visit(
        [](const auto& one) -> std::uint64_t {
          if constexpr (requires { one.block; }) return one.block;
          return 0;
        },
        item);
  }
  push(std::move(event));
}

// To the end of the block: those that stop something are put out behind its motions.
std::size_t ReferenceSide::m_functions(std::size_t index) {
  const auto is_of_block = [&](std::size_t event) {
    return at(event).block == at(index).block && at(event).part != Part::close &&
           at(event).part != Part::free_step;
  };
  if (index < scanned_) return m_.size();
  for (scanned_ = index; is_of_block(scanned_);) ++scanned_;
  return m_.size();
}

ReferenceSide::Block ReferenceSide::block_of(const MFunction& m) {
  if (m.events) return *m.events;
  Block block{m.event, m.event};
  const std::uint64_t number = m.record.block;
  while (block.begin > 0 && events_[block.begin - 1].block == number) --block.begin;
  while (at(block.end).block == number && at(block.end).part != Part::close) ++block.end;
  m.events = block;
  return block;
}

namespace {

// By what they do, as the dialects have it in common: M3 M4 M6 M7 M8 start something, M0 M1 M2 M5
// M9 M17 M30 M60 stop or end something.
constexpr std::array kStarting = {3, 4, 6, 7, 8};
constexpr std::array kEnding = {0, 1, 2, 5, 9, 17, 30, 60};
constexpr std::array kProgramEnd = {2, 17, 30};

// Whose place the text fixes: the functions of a line run in its order (NGC-MOD-01).
bool is_fixed(const Record& m) {
  using reference::operator""_clause;
  return m.clause == "NGC-COM-01"_clause;
}

}  // namespace

bool ReferenceSide::may_stand(std::size_t number, std::size_t index) {
  const MFunction& m = m_[number];
  if (index == m.event) return true;  // J-PROP-01: what the reference shows is right
  if (is_fixed(m.record)) return false;
  const Block block = block_of(m);
  if (index < block.begin || index > block.end) return false;
  const auto has = [&](std::size_t begin, std::size_t end, auto&& wanted) {
    for (std::size_t i = begin; i < end; ++i) {
      if (wanted(at(i))) return true;
    }
    return false;
  };
  const auto cuts = [](const Event& event) {
    return event.part == Part::cut || event.part == Part::free_step;
  };
  const auto moves = [&](const Event& event) { return event.is_motion() || cuts(event); };
  const auto waits = [&](const Event& event) {
    return cuts(event) || (event.part == Part::stop && event.source().kind == RecordKind::dwell);
  };
  const auto is_one_of = [&](const auto& list) { return std::ranges::count(list, m.record.m) > 0; };
  if ((m.record.before_cut || is_one_of(kStarting)) && has(block.begin, index, waits)) return false;
  if (is_one_of(kEnding) && has(index, block.end, cuts)) return false;
  const bool moves_behind = has(index, block.end, moves);
  if (is_one_of(kProgramEnd) && moves_behind) return false;
  // In a cycle before all motions or behind them; a clamp closes once the tool is in place.
  if (m.record.before_cut || !has(block.begin, block.end, cuts)) return true;
  return !moves_behind || !has(block.begin, index, moves);
}

bool ReferenceSide::may_change_places(std::size_t number, std::size_t later) const {
  const auto has_order = [](const Record& m) {
    return is_fixed(m) || std::ranges::count(kProgramEnd, m.m) > 0;
  };
  return m_block(number) == m_block(later) && !has_order(m_function(number)) &&
         !has_order(m_function(later));
}

void ReferenceSide::bring_forward(const Move& move) {
  m_functions(move.index);
  const auto at = [&](std::size_t number) {
    return m_.begin() + static_cast<std::ptrdiff_t>(number);
  };
  std::rotate(at(move.number), at(move.later), at(move.later + 1));
  moves_.push_back(move);
}

bool ReferenceSide::is_overdue(std::size_t number, std::size_t index) {
  const MFunction& m = m_[number];
  return index > (is_fixed(m.record) ? m.event : block_of(m).end);
}

}  // namespace gonogo::relation
