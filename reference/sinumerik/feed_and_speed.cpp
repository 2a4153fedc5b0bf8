// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a block sets beside its motion: F, S, the mode of the feed, T, D and H.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

constexpr std::int64_t kLastEdge = 9;

// SIE-COM-03, SIE-COM-01
void refuse_below_zero(BlockContext& block, Address address, ClauseId clause) {
  const Number& value = block.words.written(address);
  if (value.sign() >= 0) return;
  block.alarm(
      AlarmClass::value_sign, clause, name_of(address),
      with_values(fmt::format("{} is {{}}, below zero.", name_of(address).text()), {value}));
}

// SIE-MOD-07: the turns stay unknown until an S counts turns again.
void note_speed(BlockContext& block) {
  if (block.machine.constant_cutting_speed) {
    block.machine.turns_unknown = true;
  } else if (block.words.has(Address::s)) {
    block.machine.turns_unknown = false;
  }
}

}  // namespace

void take_feed_and_speed(BlockContext& block) {
  Machine& machine = block.machine;
  const BlockWords& words = block.words;
  if (words.has(Address::f)) {
    refuse_below_zero(block, Address::f, "SIE-COM-01"_clause);
    machine.feed = words.written(Address::f);
    machine.feed_is_of_before = false;
    machine.feed_of_cycle.reset();
    machine.feed_is_of_cycle = false;
    // SIE-COM-06: an F of 0 is no fault until a block cuts.
    machine.feed_is_zero = machine.feed.sign() == 0;
    if (machine.feed_is_zero) block.out.accept("SIE-COM-06"_clause);
  }
  if (words.has(Address::s)) {
    refuse_below_zero(block, Address::s, "SIE-COM-03"_clause);
    machine.speed = words.written(Address::s);
    machine.speed_given = false;
  }
}

// SIE-MOD-07. An F of the block itself is of the new feed (SIE-MOD-08).
void take_feed_mode(BlockContext& block) {
  Machine& machine = block.machine;
  if (const int code = block.codes.feed_mode; code >= 0) {
    const bool per_revolution = code == 95 || code == 96 || code == 97;
    const FeedMode mode = per_revolution ? FeedMode::per_revolution : FeedMode::per_minute;
    if (mode != machine.feed_mode && !block.words.has(Address::f)) machine.feed_is_of_before = true;
    machine.feed_mode = mode;
    machine.constant_cutting_speed = code == 96 || code == 961;
  }
  if (block.codes.once != 4) note_speed(block);
}

// SIE-COM-05
void accept_odd_numbers(BlockContext& block) {
  const auto is_odd = [&](Address address) {
    if (!block.words.has(address)) return false;
    const Number& value = block.words.written(address);
    if (!value.is_rational() || value != value.floor()) return true;
    const bool is_below = address != Address::h && value.sign() < 0;
    return is_below || (address == Address::d && value > Number(kLastEdge));
  };
  if (is_odd(Address::t) || is_odd(Address::d) || is_odd(Address::h)) {
    block.out.accept("SIE-COM-05"_clause);
  }
}

}  // namespace gonogo::reference::sinumerik
