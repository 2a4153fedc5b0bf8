// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block of a cycle of holes: its words, the rules that they may break, its levels. What all of
// G73, G74 and G81 to G89 share.
#pragma once

#include <string>

#include "reference/rs274/approach.hpp"
#include "reference/rs274/holes.hpp"

namespace gonogo::reference::rs274 {

// The word that a cycle has beside R, the third axis and L.
enum class OwnWord : std::uint8_t { none, needs_p, takes_p, needs_q };

class HoleBlock {
 public:
  // Takes the words of the block; those that break a rule become alarms. `block` must outlive it.
  explicit HoleBlock(BlockContext& block, OwnWord own = OwnWord::none);

  // Whether no rule is broken so far.
  bool is_sound() const { return block_.out.alarms.empty(); }
  const BlockContext& block() const { return block_; }
  const StickyWords& words() const { return block_.machine.cycle.words; }
  // A rule of the cycle that is broken; a control may find it only over the first hole.
  void alarm_at_hole(AlarmClass alarm, ClauseId clause, WordName word, std::string message);
  // P is missing in a cycle that may need it.
  void missing_dwell(ClauseId clause);

  // REQUIRES: is_sound().
  const CycleLevels& levels() const { return *levels_; }
  Number clear() const;  // C
  // In mm of the units in force.
  Number length_of(const Number& number) const { return block_.machine.modes.length_of(number); }
  // A hole leaves the tool on R, and not on C.
  void end_at_r_plane() { ends_at_r_plane_ = true; }
  void dwell_for(const Number& seconds) { dwell_ = seconds; }

  // Makes the holes; where a rule is broken, what a control has moved when it finds that.
  void run(Hole hole);
  void stop();

 private:
  // How far a control may have moved when it finds a broken rule.
  enum class Found : std::uint8_t { at_once, above_the_place, over_the_hole };

  void warn_of_no_depth() const;
  void take_words();
  void take_own_word();
  void check_axes();
  void note_late(Found found);
  Number repeats();
  Number r_base() const;
  CycleLevels levels_from(const Number& base) const;
  CycleLevels levels_of_numbers() const;
  CycleLevels read_levels() const;
  HoleAhead ahead() const;

  BlockContext& block_;
  PlaneAxes axes_;
  OwnWord own_;
  InitialLevel initial_;
  Number count_;
  std::optional<CycleLevels> levels_;
  Number dwell_;
  bool ends_at_r_plane_ = false;
  std::size_t late_ = 0;                // alarms that a control may find late
  bool is_q_at_fault_ = false;          // one of them is of a Q that is not above zero
  Found found_ = Found::over_the_hole;  // of those the one that it finds first
};

}  // namespace gonogo::reference::rs274
