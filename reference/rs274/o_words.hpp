// SPDX-License-Identifier: GPL-3.0-or-later
//
// O words: which line of the program comes next. A program is still read line by line; the lines of
// a subroutine and of the outermost loop that runs are remembered, and those up to a subroutine
// that stands behind its call.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/line_source.hpp"
#include "reference/expander.hpp"
#include "reference/rs274/expression.hpp"
#include "reference/rs274/words.hpp"

namespace gonogo::reference::rs274 {

// NGC-OWD-10: the bounds of what the gauge follows.
inline constexpr std::size_t kMostRemembered = std::size_t{1} << 20;  // bytes of lines
inline constexpr std::uint64_t kMostRepeated = 100'000;               // lines that ran before
inline constexpr std::size_t kMostOpen = 1'000;                       // loops and conditions
inline constexpr std::size_t kMostCalls = 9;                          // in each other

// Whether the line is a % line.
bool is_tape_mark(std::string_view text);

// NGC-OWD-13: the alarm of what belongs to the other style of subroutines; `word`: M or O.
void refuse_style(char word, const grammar::Span& where, std::string message, BlockOutput& out);

class OWords {
 public:
  OWords(Parameters& parameters, const ReadingsInUse& readings, bool skips)
      : parameters_(parameters), readings_(readings), skips_(skips) {}
  OWords(const OWords&) = delete;
  OWords& operator=(const OWords&) = delete;

  // The next line that runs; false at the end of the text.
  bool next(grammar::LineSource& lines, grammar::Line& line);
  // The line that came last is an O word. Alarms and what is not read go to `out`.
  void take(const grammar::Block& block, Calculator& calculator, BlockOutput& out);
  // NGC-OWD-13: M98, whose words are right, and M99.
  void call_numbered(const BlockWords& words, const grammar::Span& where, BlockOutput& out);
  void end_numbered(std::uint64_t line, const grammar::Span& where, BlockOutput& out);
  // Calls in each other, and the program.
  std::size_t calls() const { return levels_.size(); }
  // Whether the line that came last is beyond what is followed.
  bool is_beyond() const {
    return remembered_ > kMostRemembered || repeated_ > kMostRepeated || ran_off_;
  }
  // Whether there was an O word.
  bool is_used() const { return is_used_; }
  // Whether lines are skipped now, up to an O word that has not come yet.
  bool skips_lines() const { return wanted_ || defined_ != nullptr; }
  // The label whose end is looked for while lines are skipped; empty: none are.
  std::string_view skipped_label() const {
    if (defined_ != nullptr) return defined_label_;
    return wanted_ ? std::string_view(wanted_->label) : std::string_view();
  }

 private:
  struct StoredLine {
    std::uint64_t number = 0;
    std::string text;
  };
  using Text = std::vector<StoredLine>;
  struct Sub {
    std::uint64_t line = 0;
    Text text;
  };
  // A condition or a loop that is open.
  struct Open {
    grammar::ControlKind kind;
    std::string label;
    std::size_t start = 0;  // the line of the O word in the text
    std::int64_t left = 0;  // of repeat
    bool is_done = false;   // no branch runs any more; the loop ends at its end
  };
  // The program, or a subroutine that was called.
  struct Level {
    std::string sub;  // empty: the program
    const Text* text;
    std::size_t at = 0;  // the next line
    std::vector<Open> open = {};
    bool is_numbered = false;  // called by M98
    std::int64_t left = 1;     // how often it runs
  };
  // What is looked for.
  struct Wanted {
    std::string label;
    std::vector<grammar::ControlKind> kinds;
  };
  // One O word in the hands of the function for its kind.
  struct Step {
    const grammar::Block& block;
    const grammar::Control& control;
    Calculator& calculator;
    BlockOutput& out;
  };

  bool read(grammar::LineSource& lines, grammar::Line& line);
  const grammar::Control* control_of(std::string_view text);
  bool is_wanted(std::string_view text);
  bool is_wanted(const grammar::Control& control) const;
  bool is_main() const { return levels_.size() == 1; }
  bool is_recording() const;
  void remember(const grammar::Line& line, Text& text);
  void forget();
  void keep_current();
  bool remember_next();
  bool find_behind(const std::string& label);
  enum class Found : std::uint8_t { nowhere, another_style, here };
  Found find_numbered(std::int64_t number, Sub& found);
  bool is_numbered_behind(const std::string& label);
  void open(const Step& step, bool is_done);
  bool is_new_label(const Step& step);
  Open* innermost(const Step& step, std::initializer_list<grammar::ControlKind> kinds);
  void want(const std::string& label, std::initializer_list<grammar::ControlKind> kinds);
  void go_back_to(std::size_t place);
  std::optional<Value> value(const Step& step);
  std::optional<bool> holds(const Step& step);
  // The only ways into a call and out of it: lines and parameters have the same levels.
  void enter(Level level, std::vector<Value> arguments = {});
  void leave();
  bool refuse(const Step& step, std::string message) const;
  bool leave_out(const Step& step, std::string message) const;

  void run(const Step& step);
  void run_sub(const Step& step);
  void run_return(const Step& step);
  void run_call(const Step& step);
  void run_if(const Step& step);
  void run_elseif(const Step& step);
  void run_else(const Step& step);
  void run_endif(const Step& step);
  void run_while(const Step& step);
  void run_endwhile(const Step& step);
  void run_do(const Step& step);
  void run_repeat(const Step& step);
  void run_endrepeat(const Step& step);
  void run_break(const Step& step);

  Parameters& parameters_;
  const ReadingsInUse& readings_;
  bool skips_;  // lines behind '/'
  Text tape_;   // lines of the program that may come again
  std::map<std::string, Sub> subs_;
  std::map<std::int64_t, Sub> numbered_;  // NGC-OWD-13
  Text* defined_ = nullptr;               // the subroutine that is read
  std::string defined_label_;
  bool fills_ = false;  // its lines are new
  std::vector<Level> levels_ = {Level{{}, &tape_, 0, {}}};
  std::optional<Wanted> wanted_;
  std::map<std::string, std::uint64_t> labels_;  // of conditions and loops, by subroutine; lines
  grammar::Block scratch_;
  grammar::Line* current_ = nullptr;
  grammar::LineSource* lines_ = nullptr;
  std::string called_at_;  // the line of a call that looked ahead
  bool is_used_ = false;
  bool ran_off_ = false;  // a numbered subprogram has run to its end without M99
  std::size_t remembered_ = 0;
  std::uint64_t repeated_ = 0;
};

}  // namespace gonogo::reference::rs274
