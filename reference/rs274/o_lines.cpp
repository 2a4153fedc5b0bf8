// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines that O words lead to: those that come again, and those that are looked for.
#include <algorithm>
#include <utility>

#include "grammar/parser.hpp"
#include "reference/rs274/o_words.hpp"

namespace gonogo::reference::rs274 {
namespace {

bool is_loop(grammar::ControlKind kind) {
  using enum grammar::ControlKind;
  return kind == while_ || kind == do_ || kind == repeat;
}

// Where the O word of a line would stand: behind '/', N and its number; nothing where there is
// none. An O word may be parsed without need, never missed.
bool may_be_o_word(std::string_view text, bool skips) {
  std::size_t at = text.find_first_not_of(" \t");
  if (at == std::string_view::npos) return false;
  if (text[at] == '/') {
    if (skips) return false;
    ++at;
  }
  return text.find_first_of("oO", at) != std::string_view::npos;
}

}  // namespace

bool is_tape_mark(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos && text[first] == '%';
}

// The O word of a line; null: it has none.
const grammar::Control* OWords::control_of(std::string_view text) {
  if (!may_be_o_word(text, skips_)) return nullptr;
  const bool is_read = !grammar::parse_block(grammar::Dialect::rs274, text, scratch_);
  return is_read && scratch_.control ? &*scratch_.control : nullptr;
}

// The lines of the program that a loop may need again, also while it has called a subroutine.
bool OWords::is_recording() const {
  return std::ranges::any_of(levels_.front().open,
                             [](const Open& open) { return is_loop(open.kind); });
}

void OWords::remember(const grammar::Line& line, Text& text) {
  remembered_ += line.text.size() + sizeof(StoredLine);
  text.push_back({line.number, std::string(line.text)});
}

// The next line, whether it runs or not.
bool OWords::read(grammar::LineSource& lines, grammar::Line& line) {
  Level& level = levels_.back();
  if (level.at < level.text->size()) {
    const StoredLine& stored = (*level.text)[level.at++];
    if (defined_ != nullptr && fills_) defined_->push_back(stored);
    ++repeated_;
    line.number = stored.number;
    line.text = stored.text;
    line.too_long = false;
    return true;
  }
  if (level.is_numbered) return ran_off_ = true;
  if (!lines.next(line)) return false;
  if (defined_ != nullptr) {
    remember(line, *defined_);
  } else if (is_recording() && !line.too_long) {
    remember(line, tape_);
    ++level.at;
  }
  return true;
}

// Lines that do not run are not looked at except for their O words.
bool OWords::is_wanted(std::string_view text) {
  const grammar::Control* const control = control_of(text);
  if (control == nullptr) return false;
  if (defined_ != nullptr) {
    return control->kind == grammar::ControlKind::sub ||
           (control->kind == grammar::ControlKind::endsub && control->label == defined_label_);
  }
  const bool ends_sub = !is_main() && levels_.back().at == levels_.back().text->size();
  return ends_sub || is_wanted(*control);
}

bool OWords::is_wanted(const grammar::Control& control) const {
  return control.label == wanted_->label &&
         std::ranges::find(wanted_->kinds, control.kind) != wanted_->kinds.end();
}

bool OWords::next(grammar::LineSource& lines, grammar::Line& line) {
  current_ = &line;
  lines_ = &lines;
  while (read(lines, line)) {
    if (!skips_lines() || is_beyond() || line.too_long) return true;
    if (is_tape_mark(line.text) || is_wanted(line.text)) return true;
  }
  return false;
}

// What may not come again.
void OWords::forget() {
  if (is_recording() || levels_.front().at != tape_.size()) return;
  for (const StoredLine& line : tape_) remembered_ -= line.text.size() + sizeof(StoredLine);
  tape_.clear();
  levels_.front().at = 0;
}

// The source forgets the line that came last when it is asked for more.
void OWords::keep_current() {
  called_at_ = current_->text;
  current_->text = called_at_;
}

// Keeps the line behind those that are kept for a call.
bool OWords::remember_next() {
  grammar::Line line;
  if (is_beyond() || !lines_->next(line) || line.too_long) return false;
  remember(line, tape_);
  return true;
}

// NGC-OWD-11: whether a subroutine stands in the lines that have not run yet; its lines are then
// known. They run later, and until then they are kept.
bool OWords::find_behind(const std::string& label) {
  keep_current();
  Sub* found = nullptr;
  for (std::size_t at = levels_.front().at; at < tape_.size() || remember_next(); ++at) {
    const StoredLine& line = tape_[at];
    if (found != nullptr) found->text.push_back(line);
    if (is_tape_mark(line.text)) break;
    const grammar::Control* const control = control_of(line.text);
    if (control == nullptr || control->label != label) continue;
    if (found == nullptr && control->kind == grammar::ControlKind::sub) {
      found = &subs_.try_emplace(label, Sub{line.number, {}}).first->second;
    } else if (found != nullptr && control->kind == grammar::ControlKind::endsub) {
      return true;
    }
  }
  subs_.erase(label);
  return false;
}

void OWords::enter(Level level, std::vector<Value> arguments) {
  if (level.is_numbered) {
    parameters_.enter_sharing();
  } else {
    parameters_.enter(std::move(arguments));
  }
  parameters_.returned.reset();  // NGC-OWD-03
  levels_.push_back(std::move(level));
}

void OWords::leave() {
  parameters_.leave();
  levels_.pop_back();
}

}  // namespace gonogo::reference::rs274
