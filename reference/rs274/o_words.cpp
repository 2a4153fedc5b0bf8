// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-OWD-01 to NGC-OWD-11.
#include "reference/rs274/o_words.hpp"

#include <algorithm>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
using grammar::ControlKind;

// NGC-OWD-08
bool OWords::refuse(const Step& step, std::string message) const {
  step.out.alarms.push_back(
      {AlarmClass::syntax, "NGC-OWD-08"_clause, 'O', step.control.where, std::move(message)});
  return false;
}

// NGC-OWD-10
bool OWords::leave_out(const Step& step, std::string message) const {
  step.out.not_covered =
      NotCovered{current_->number, "o-word", std::move(message), step.control.where};
  return false;
}

std::optional<Value> OWords::value(const Step& step) {
  return step.calculator.calculated(step.block, step.control.values.front());
}

std::optional<bool> OWords::holds(const Step& step) {
  return step.calculator.is_true(step.block, step.control.values.front());
}

// NGC-OWD-08: the label of a condition or a loop stands for one of them.
bool OWords::is_new_label(const Step& step) {
  const std::string name = levels_.back().sub + '#' + step.control.label;
  const auto [place, is_new] = labels_.try_emplace(name, current_->number);
  if (is_new) remembered_ += name.size() + sizeof(std::uint64_t);
  if (is_new || place->second == current_->number) return true;
  return refuse(step, "The label belongs to another O word.");
}

void OWords::open(const Step& step, bool is_done) {
  Level& level = levels_.back();
  const bool was_recording = is_recording();
  level.open.push_back({step.control.kind, step.control.label, 0, 0, is_done});
  if (is_main() && !was_recording && is_recording() && level.at == tape_.size()) {
    remember(*current_, tape_);
    ++level.at;
  }
  level.open.back().start = level.at == 0 ? 0 : level.at - 1;
}

OWords::Open* OWords::innermost(const Step& step, std::initializer_list<ControlKind> kinds) {
  std::vector<Open>& all = levels_.back().open;
  if (!all.empty() && all.back().label == step.control.label &&
      std::ranges::find(kinds, all.back().kind) != kinds.end()) {
    return &all.back();
  }
  refuse(step, "No condition or loop of this label is open here.");
  return nullptr;
}

void OWords::want(const std::string& label, std::initializer_list<ControlKind> kinds) {
  wanted_ = Wanted{label, kinds};
}

void OWords::go_back_to(std::size_t place) {
  levels_.back().at = place;
}

// NGC-OWD-01
void OWords::run_sub(const Step& step) {
  if (defined_ != nullptr || !is_main()) {
    refuse(step, "A subroutine stands within another one.");
    return;
  }
  if (!levels_.back().open.empty()) {
    leave_out(step, "The gauge does not read a subroutine within a loop or a condition.");
    return;
  }
  const auto [place, is_new] = subs_.try_emplace(step.control.label, Sub{current_->number, {}});
  if (place->second.line != current_->number) {
    refuse(step, "There is another subroutine of this label.");
    return;
  }
  // NGC-OWD-11: of one that was looked for the lines are there.
  fills_ = is_new;
  if (!is_new) step.out.accept("NGC-OWD-11"_clause);
  defined_ = &place->second.text;
  defined_label_ = step.control.label;
}

// NGC-OWD-03: return and endsub; a return may have the label of another O word.
void OWords::run_return(const Step& step) {
  if (defined_ != nullptr) {  // the end of one that is read
    defined_ = nullptr;
    return;
  }
  if (levels_.back().is_numbered) {
    refuse_style('O', step.control.where, "M99 ends what M98 calls, and no return or endsub does.",
                 step.out);
    return;
  }
  const bool ends = step.control.kind == ControlKind::endsub;
  if (is_main() || (ends && levels_.back().sub != step.control.label)) {
    refuse(step, "No subroutine of this label runs here.");
    return;
  }
  if (!step.control.values.empty()) {
    std::optional<Value> returned = value(step);
    if (!returned) return;
    parameters_.returned = std::move(returned);
  }
  leave();
}

// NGC-OWD-02
void OWords::run_call(const Step& step) {
  std::string label = step.control.label;
  if (label.empty()) {
    const std::optional<Number> number = step.calculator.value(step.block, step.control.number);
    if (!number) return;
    const auto whole = number->is_rational() ? number->to_int64() : std::nullopt;
    if (!whole || *whole < 0) {
      leave_out(step, "The gauge reads whole numbers as labels.");
      return;
    }
    label = std::to_string(*whole);
  }
  std::vector<Value> arguments;
  for (const grammar::TermRange& range : step.control.values) {
    std::optional<Value> argument = step.calculator.calculated(step.block, range);
    if (!argument) return;
    arguments.push_back(*std::move(argument));
  }
  if (!subs_.contains(label)) {
    if (!find_behind(label)) {
      if (is_numbered_behind(label)) {
        refuse(step, "The subprogram of this number ends with M99, and M98 calls it.");
        return;
      }
      leave_out(step, "The program has no subroutine of this label; a file may have it.");
      return;
    }
    step.out.accept("NGC-OWD-11"_clause);
  }
  if (levels_.size() > kMostCalls) {
    leave_out(step, "The gauge follows nine calls within each other.");
    return;
  }
  enter({label, &subs_.at(label).text}, std::move(arguments));
}

// NGC-OWD-04
void OWords::run_if(const Step& step) {
  if (!is_new_label(step)) return;
  const std::optional<bool> runs = holds(step);
  if (!runs) return;
  open(step, *runs);
  if (*runs) return;
  want(step.control.label, {ControlKind::elseif, ControlKind::else_, ControlKind::endif});
}

void OWords::run_elseif(const Step& step) {
  Open* const condition = innermost(step, {ControlKind::if_});
  if (condition == nullptr) return;
  if (!condition->is_done) {
    const std::optional<bool> runs = holds(step);
    if (!runs) return;
    condition->is_done = *runs;
    if (*runs) return;
    return want(step.control.label, {ControlKind::elseif, ControlKind::else_, ControlKind::endif});
  }
  want(step.control.label, {ControlKind::endif});
}

void OWords::run_else(const Step& step) {
  Open* const condition = innermost(step, {ControlKind::if_});
  if (condition == nullptr) return;
  if (std::exchange(condition->is_done, true)) want(step.control.label, {ControlKind::endif});
}

void OWords::run_endif(const Step& step) {
  if (innermost(step, {ControlKind::if_}) != nullptr) levels_.back().open.pop_back();
}

// NGC-OWD-05: the head of while, and the end of do.
void OWords::run_while(const Step& step) {
  std::vector<Open>& all = levels_.back().open;
  const bool ends_do =
      !all.empty() && all.back().kind == ControlKind::do_ && all.back().label == step.control.label;
  if (ends_do && all.back().is_done) return all.pop_back();
  if (!ends_do && !is_new_label(step)) return;
  const std::optional<bool> runs = holds(step);
  if (!runs) return;
  if (ends_do) {
    if (*runs) return go_back_to(all.back().start + 1);
    return all.pop_back();
  }
  open(step, !*runs);
  if (!*runs) want(step.control.label, {ControlKind::endwhile});
}

void OWords::run_endwhile(const Step& step) {
  const Open* const loop = innermost(step, {ControlKind::while_});
  if (loop == nullptr) return;
  const Open ended = *loop;
  // The head opens it again.
  levels_.back().open.pop_back();
  if (!ended.is_done) go_back_to(ended.start);
}

void OWords::run_do(const Step& step) {
  if (is_new_label(step)) open(step, false);
}

// NGC-OWD-07
void OWords::run_repeat(const Step& step) {
  if (!is_new_label(step)) return;
  const std::optional<Value> times = value(step);
  if (!times) return;
  const NearWhole number(times->number);
  const bool is_whole = number.is_whole() && !times->is_rounded;  // NGC-EXP-08
  const std::int64_t count = is_whole ? number.nearest().to_int64().value_or(-1) : -1;
  if (count < 0) {
    leave_out(step,
              "No text says how often a loop runs for a number that is not whole, or below "
              "zero.");
    return;
  }
  open(step, count == 0);
  levels_.back().open.back().left = count;
  if (count == 0) want(step.control.label, {ControlKind::endrepeat});
}

void OWords::run_endrepeat(const Step& step) {
  Open* const loop = innermost(step, {ControlKind::repeat});
  if (loop == nullptr) return;
  if (loop->is_done || --loop->left == 0) return levels_.back().open.pop_back();
  go_back_to(loop->start + 1);
}

// NGC-OWD-06: break and continue.
void OWords::run_break(const Step& step) {
  std::vector<Open>& all = levels_.back().open;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const Open& open) {
    return open.label == step.control.label &&
           (open.kind == ControlKind::while_ || open.kind == ControlKind::do_);
  });
  if (found == all.rend()) {
    refuse(step, "No while or do of this label is open here.");
    return;
  }
  all.erase(found.base(), all.end());
  Open& loop = all.back();
  const bool is_do = loop.kind == ControlKind::do_;
  if (step.control.kind == ControlKind::break_) {
    loop.is_done = true;
    return want(loop.label, {is_do ? ControlKind::while_ : ControlKind::endwhile});
  }
  if (is_do) return want(loop.label, {ControlKind::while_});
  const std::size_t start = loop.start;
  all.pop_back();
  go_back_to(start);
}

void OWords::take(const grammar::Block& block, Calculator& calculator, BlockOutput& out) {
  const Step step{block, *block.control, calculator, out};
  is_used_ = true;
  if (wanted_ && !is_wanted(step.control)) {
    leave_out(step, "The subroutine ends within a condition or a loop.");
    return;
  }
  wanted_.reset();
  if (!block.comments.empty()) out.accept("NGC-OWD-09"_clause);
  const ControlKind kind = step.control.kind;
  if (step.control.label.empty() && kind != ControlKind::call) {
    leave_out(step, "The gauge reads calculated labels of calls alone.");
    return;
  }
  if (levels_.back().open.size() > kMostOpen) {
    leave_out(step, "The gauge follows a thousand loops and conditions within each other.");
    return;
  }
  run(step);
  if (out.alarms.empty() && !out.not_covered) forget();
}

void OWords::run(const Step& step) {
  struct Run {
    ControlKind kind;
    void (OWords::*function)(const Step& step);
  };
  static constexpr Run kRuns[] = {
      {ControlKind::sub, &OWords::run_sub},
      {ControlKind::endsub, &OWords::run_return},
      {ControlKind::return_, &OWords::run_return},
      {ControlKind::call, &OWords::run_call},
      {ControlKind::if_, &OWords::run_if},
      {ControlKind::elseif, &OWords::run_elseif},
      {ControlKind::else_, &OWords::run_else},
      {ControlKind::endif, &OWords::run_endif},
      {ControlKind::while_, &OWords::run_while},
      {ControlKind::endwhile, &OWords::run_endwhile},
      {ControlKind::do_, &OWords::run_do},
      {ControlKind::repeat, &OWords::run_repeat},
      {ControlKind::endrepeat, &OWords::run_endrepeat},
      {ControlKind::break_, &OWords::run_break},
      {ControlKind::continue_, &OWords::run_break},
  };
  (this->*std::ranges::find(kRuns, step.control.kind, &Run::kind)->function)(step);
}

}  // namespace gonogo::reference::rs274
