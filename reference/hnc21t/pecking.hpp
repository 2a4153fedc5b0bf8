// SPDX-License-Identifier: GPL-3.0-or-later
//
// One plunge of G74 and G75: in pecks with withdrawals, or in one.
#pragma once

#include "reference/hnc21t/cycle.hpp"

namespace gonogo::reference::hnc21t {

// The clauses of the cycle whose plunge it is.
struct PlungeClauses {
  ClauseId pecks;     // about pecks with withdrawals
  ClauseId straight;  // about a plunge without them
};

// From A along an axis to the bottom, and out again; mm as true lengths.
struct Plunge {
  CycleMotions motions;
  ClauseId clause;
  Axis axis;
  Number top;                      // A
  Number bottom;                   // where the last motion at the feed ends
  int direction;                   // of the bottom from A; 0: no depth
  Number pecks;                    // 1: straight to the bottom
  Number step;                     // dK
  Number withdrawal;               // e
  bool from_withdrawn = false;     // hnc.peck.from = withdrawn
  bool clamped = false;            // hnc.peck.clamp = start
  bool withdraws_at_feed = false;  // hnc.peck.withdraw = feed
  std::optional<Number> approach;  // hnc.g74.mode3, hnc.g75.mode3 = on: a traverse to here first

  // Where peck k (from 1) ends except for the last one, and the withdrawal after it. Closed forms,
  // so that the millionth is as exact as the first.
  Number end_of_peck(const Number& k) const;
  Number withdrawn_after(const Number& k) const;

 private:
  Number depth_of_peck(const Number& k) const;
};

// Signs of e and dK, in every block that writes them.
void check_peck_words(BlockContext& block, ClauseId clause);
// The plunge from A to `bottom` with the words in force; rules that they break become alarms.
Plunge plan_plunge(BlockContext& block, Axis axis, const Number& bottom,
                   const PlungeClauses& clauses);
Generator<Item> run_plunge(Plunge plunge);

}  // namespace gonogo::reference::hnc21t
