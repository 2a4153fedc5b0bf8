// SPDX-License-Identifier: GPL-3.0-or-later
//
// THE REFERENCE IS NAIVE ON PURPOSE. It is exact, and is meant to be read beside the manual, clause
// by clause. It is no model for a controller.
//
// A program goes in line by line; items come out one at a time. Memory is one block, for any
// number of blocks or of motions of a block.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"
#include "reference/generator.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::reference {

// A place of a cycle's path under the name that its text gives it, as the cycle itself has computed
// it: a point, or a plane across the one axis that is named. For drawings.
struct NamedPlace {
  std::string_view name;       // "B", "R plane"
  std::optional<Axis> across;  // of a plane
  Position at;
};
// The letters that the text of a cycle has for axes: 'p' for Z.
using NamedAxis = std::pair<char, Axis>;
struct CyclePlaces {
  std::vector<NamedPlace> places;
  std::vector<NamedAxis> axes;
  bool empty() const { return places.empty() && axes.empty(); }
};

// What one block does: motions, then the motions of a cycle, then M functions; or alarms.
struct BlockOutput {
  std::vector<Item> items;
  Generator<Item> cycle;
  std::vector<Item> after;
  std::vector<Alarm> alarms;
  // Motions of a block that alarms, by a control that finds the fault on the way.
  std::vector<Item> before_alarm;
  std::vector<Warning> warnings;
  std::optional<NotCovered> not_covered;
  std::optional<grammar::Span> beyond_range;  // a value that an expression has, reference/range.hpp
  bool program_end = false;
  // The rule that ends a program though no text states it.
  ClauseId end_clause = kNoClause;

  // The rules that no text states by which the block runs on, or would but for its alarms; only
  // while somebody asks for them.
  bool notes_acceptances = false;
  std::vector<ClauseId> accepted;
  void accept(ClauseId clause) {
    if (notes_acceptances) accepted.push_back(clause);
  }

  // The places of the cycle that the block runs, only while somebody asks for them.
  bool notes_places = false;
  CyclePlaces cycle_places;
  void name_plane(std::string_view name, Axis axis, const Number& at) {
    if (!notes_places) return;
    NamedPlace& plane = cycle_places.places.emplace_back(NamedPlace{name, axis, {}});
    plane.at[axis] = at;
  }
  void name_point(std::string_view name, const Position& at) {
    if (notes_places) cycle_places.places.push_back({name, std::nullopt, at});
  }
  void name_axis(char letter, Axis axis) {
    if (notes_places) cycle_places.axes.emplace_back(letter, axis);
  }

  void clear();
};

// One dialect's meaning of blocks. Holds the modal state.
class BlockInterpreter {
 public:
  virtual ~BlockInterpreter() = default;
  virtual void run(std::uint64_t line, const grammar::Block& block, BlockOutput& out) = 0;
  // The line that is read next; false at the end of the text. What the language says of the order
  // of lines stands behind it; lines that came before may come again.
  virtual bool next_line(grammar::LineSource& lines, grammar::Line& line) {
    return lines.next(line);
  }
  // Whether lines that came before may come again from now on.
  virtual bool may_repeat_lines() const { return false; }
  // Whether a line behind '/' that is left out alarms; asked of one that cannot be read.
  virtual bool alarms_left_out() const { return false; }
  // A block was left out, since blocks behind '/' are skipped.
  virtual void leave_out() {}
  // The text is at its end, and no block ended the program; `end` is the place behind the last
  // line. Alarms are of that line.
  virtual void end_text(const grammar::Span& end, BlockOutput& out) {
    static_cast<void>(end);
    static_cast<void>(out);
  }
  // Where the machine stands after everything that was put out so far.
  virtual const Position& position() const = 0;
  // The machine stands elsewhere than the open path that was put out last would have left it.
  virtual void stand_at(const Position& position) = 0;
};

// How a level whose path is open comes out: as the path that `expand` shows, or as the level that
// the judge decides by what is cleared.
enum class OpenPaths : std::uint8_t { shown, judged };

struct Dialect;

class Expander {
 public:
  // `profile` and `lines` must outlive the expander. REQUIRES: the profile's dialect is one of
  // dialects().
  Expander(const Profile& profile, grammar::LineSource& lines, OpenPaths open_paths);
  ~Expander();

  // The next item, valid until the next call. The last one is an `end` record, an AlarmReport or a
  // NotCovered; then null. Where exact::Undecided was thrown there is no next one: it is thrown
  // again.
  const Item* next();

  // After an item whose path is open (ThreadMilling): where the subject's own path ended. Blocks
  // that follow start from there.
  void stand_at(const Position& position) { interpreter_->stand_at(position); }

  const ReadingsInUse& readings() const { return readings_; }
  // The readings that mattered since the last call.
  std::vector<ReadingKey> take_touched_readings() {
    std::vector<ReadingKey> touched = readings_.touched();
    readings_.forget_touched();
    return touched;
  }
  // Behind an end that no text states (its clause says so): `next` goes on with the line behind it,
  // as a control does that ignores the mark. REQUIRES: the last item was such an end.
  void go_past_end() {
    ended_ = out_.program_end = false;
    out_.end_clause = kNoClause;
  }
  // Whether lines have come in their order, and will.
  bool is_in_order() const { return !interpreter_->may_repeat_lines(); }
  // Gets every warning, with its line. A judge does without.
  using WarningSink = std::function<void(const Warning&, const grammar::Line&)>;
  void on_warning(WarningSink sink) { warn_ = std::move(sink); }
  // Gets every block that runs on by a rule that no text states, with that clause: a control that
  // alarms there breaks no text (docs/relation.md, R7).
  using AcceptanceSink = std::function<void(std::uint64_t block, ClauseId clause)>;
  void on_acceptance(AcceptanceSink sink) {
    accept_ = std::move(sink);
    out_.notes_acceptances = true;
  }
  // Gets the places of every cycle that runs, before its motions.
  using PlaceSink = std::function<void(std::uint64_t block, const CyclePlaces& places)>;
  void on_places(PlaceSink sink) {
    place_ = std::move(sink);
    out_.notes_places = true;
  }
  // After a syntax alarm: the text of its line, for a diagnostic.
  std::string_view failed_line() const { return line_.text; }
  // The same without its comments.
  std::string failed_words() const;

 private:
  const Item* produce();
  const Item* finish(Item item);
  void leave_out_of_range();
  bool next_line();

  const Profile& profile_;
  grammar::LineSource& lines_;
  ReadingsInUse readings_;
  const Dialect& dialect_;
  std::unique_ptr<BlockInterpreter> interpreter_;
  grammar::Line line_;
  grammar::Block block_;
  BlockOutput out_;
  WarningSink warn_;
  AcceptanceSink accept_;
  PlaceSink place_;
  std::size_t next_item_ = 0;
  std::size_t next_after_ = 0;
  std::uint64_t of_cycle_ = 0;  // items of the block so far
  Item last_;
  bool text_ended_ = false;
  bool ended_ = false;
  std::optional<exact::Undecided> undecided_;
};

}  // namespace gonogo::reference
