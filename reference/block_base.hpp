// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the code of every dialect does with a block: it reports broken rules, and it puts out
// motions from where the machine stands.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "reference/expander.hpp"
#include "reference/words.hpp"

namespace gonogo::reference {

using AxisValue = std::pair<Axis, Number>;

// The modal state that motions need.
struct MotionState {
  Position position;
  Plane plane = Plane::g18;
  FeedMode feed_mode = FeedMode::per_minute;
  Number feed;  // 0: none in force
};

struct BlockBase {
  MotionState& state;
  const WordPlaces& places;
  const Profile& profile;
  const ReadingsInUse& readings;
  std::uint64_t line;
  BlockOutput& out;

  // A broken rule. `address` names the word; a missing word has its place past the line's end.
  void alarm(AlarmClass alarm, ClauseId clause, WordName address, std::string message);
  void missing(ClauseId clause, WordName address);
  // An alarm when no feed is in force.
  void need_feed(ClauseId clause);
  // Whether only rotary axes move.
  bool turns_alone(const Position& to) const;
  // The program ends here for the gauge: `address` has a value that is not read.
  void not_covered(std::string code, char address, std::string message);
  void not_covered(int g_code, char address, std::string message);

  // Motions from where the machine stands; they move it.
  void rapid(ClauseId clause, std::initializer_list<AxisValue> to);
  void feed(ClauseId clause, std::initializer_list<AxisValue> to);
  Record motion(RecordKind kind, ClauseId clause, std::initializer_list<AxisValue> to);
  // One motion to `to` along the axes that are named.
  Record motion_to(RecordKind kind, ClauseId clause, AxisSet named, const Position& to);
  // The same of an arc. Names both axes of the plane, whichever are named.
  Record arc_to(ClauseId clause, AxisSet named, const Position& to,
                const std::array<Number, 2>& centre, int sense);
  void put(Record record) { out.items.emplace_back(std::move(record)); }
  // A to D of a cutting cycle, where it is put out: A is where the machine stands, C the end point,
  // B lies the taper beyond it on the positioning axis and level with A on the other, D behind C.
  void name_corners(Axis positioning, Axis cutting, const Number& taper, const Position& c) const;
  // The position gets new coordinates; nothing moves.
  void rename(const Position& to);

 private:
  // A record to be filled in place: copies of it cost more than all else of a block.
  Record& put_record() { return std::get<Record>(out.items.emplace_back()); }
  void write_motion(Record& record, RecordKind kind, ClauseId clause,
                    std::initializer_list<AxisValue> to);
};

// Whether the block stands between programs, once a block has run: a second %, which ends the
// program as `clause` says, or the number of another program, which is not read.
bool leaves_program(const grammar::Block& block, std::uint64_t line, bool has_begun,
                    ClauseId clause, BlockOutput& out);

// A program number before the first block of a program, which may stand again.
class ProgramHead {
 public:
  // Whether the block has a number although one stood before it.
  bool repeats(const grammar::Block& block) {
    return block.program_number.has_value() && std::exchange(has_number_, true);
  }

 private:
  bool has_number_ = false;
};

// What the program needs of the machine and the profile does not state: `what` is the subject of
// a sentence, `line` the line of TOML that states it.
NotCovered lacking_in_profile(std::string_view what, std::string line, const grammar::Span& where,
                              std::uint64_t block);

// A word that the block's code does not use and no rule ignores; a control may give it a
// meaning. `code` as it is quoted: G01.
NotCovered word_outside(const grammar::Word& word, std::string_view code, std::uint64_t line);

// A block whose construct is not read. REQUIRES: there is one.
NotCovered construct_outside(const grammar::Block& block, std::uint64_t line);

// The last M function of the 840D, and the last that a record holds; above it any control alarms.
inline constexpr std::int64_t kLargestM = 2'147'483'647;
// Every control of its kind has M functions up to this number; no text says where its own end.
inline constexpr std::int64_t kLastCommonM = 9'999;

// The M functions of a block are passed on: those that stop or end something after the motion, the
// others before.
// The record of an M word; nothing for one that is no M function (an alarm, by a clause of its
// own), or that is not read.
std::optional<Record> read_m_function(const grammar::Word& word, std::uint64_t line,
                                      ClauseId clause, ClauseId alarm_clause, BlockOutput& out);
void put_m_function(Record record, BlockOutput& out);
// A code of the control that the gauge does not read.
NotCovered m_function_outside(std::int64_t number, std::string_view title,
                              const grammar::Word& word, std::uint64_t line);
// An M function above those that every control of its kind has.
NotCovered m_function_too_large(std::int64_t number, const grammar::Span& where,
                                std::uint64_t line);

}  // namespace gonogo::reference
