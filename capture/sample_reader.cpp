// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/sample_reader.hpp"
#include "oracle/records/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kLineBytes = 64U << 10U;
constexpr std::string_view kBlanks = " \t\r";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

// A decimal as machines write it: sign, digits, point; no exponent, no fraction, no hex.
bool is_plain_decimal(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  const bool known = text.find_first_not_of("0123456789.") == std::string_view::npos;
  const bool digit = text.find_first_of("0123456789") != std::string_view::npos;
  return known && digit && std::ranges::count(text, '.') <= 1;
}

}  // namespace

SampleReader::SampleReader(const std::string& path, const SampleColumns& columns)
    : path_(path), file_(path, std::ios::binary) {
  constexpr int kPreamble = 1'000;  // lines that a log may put before the names
  if (!file_) throw SampleFault(fmt::format("{}: The file cannot be opened.", path));
  file_.exceptions(std::ios::badbit);  // what cannot be read is not the end of the samples
  for (int line = 0; line < kPreamble && next_line(); ++line) {
    find_separator();
    split();
    if (!is_header(columns)) continue;
    read_header(columns);
    return;
  }
  if (columns.empty()) {
    throw SampleFault(
        fmt::format("{}: The file is empty. Its first line must name the columns, "
                    "as t,x,z.",
                    path));
  }
  throw SampleFault(
      fmt::format("{}: No line has the column of the time that --columns names.", path));
}

void SampleReader::find_separator() {
  const bool semicolon = text_.find(';') != std::string::npos;
  separator_ = semicolon ? ';' : text_.find('\t') != std::string::npos ? '\t' : ',';
}

bool SampleReader::is_header(const SampleColumns& columns) const {
  const auto time = std::ranges::find(columns, SampleField::time, &SampleColumn::field);
  return time == columns.end() || std::ranges::find(cells_, time->name) != cells_.end();
}

void SampleReader::fail(std::size_t column, const std::string& sentence) const {
  throw SampleFault(
      fmt::format("{}, line {}, column {}: {}", path_, line_, column + 1, visible(sentence)));
}

bool SampleReader::next_line() {
  while (std::getline(file_, text_)) {
    ++line_;
    if (text_.size() > kLineBytes) fail(0, "The line is longer than 64 KiB.");
    if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
    if (text_.find_first_not_of(kBlanks) == std::string::npos) continue;
    split();
    return true;
  }
  return false;
}

void SampleReader::split() {
  cells_.clear();
  std::string_view rest = text_;
  while (true) {
    const std::size_t comma = rest.find(separator_);
    cells_.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
}

SampleColumn SampleReader::column_of(const std::string& cell, std::size_t place) const {
  std::string name = cell.substr(0, cell.find('['));
  while (!name.empty() && name.back() == ' ') name.pop_back();
  for (char& each : name) {
    if (each >= 'A' && each <= 'Z') each = static_cast<char>(each - 'A' + 'a');
  }
  const auto field = sample_field(name);
  SampleColumn column;
  column.name = cell;
  if (field) column.field = *field;
  const std::string_view unit = unit_in_brackets(cell);
  if (!field || (!unit.empty() && !set_unit(column, unit))) {
    fail(place, fmt::format("\"{}\" names no column. Write t or time, x, y, z, a, c, f, block or "
                            "line, motion, alarm, or say with --columns what it is.",
                            cell));
  }
  return column;
}

void SampleReader::read_header(const SampleColumns& columns) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    SampleColumn column;
    if (columns.empty()) {
      column = column_of(cells_[i], i);
    } else {
      const auto named = std::ranges::find(columns, cells_[i], &SampleColumn::name);
      if (named != columns.end()) column = *named;
    }
    const SampleField field = column.field;
    if (field != SampleField::other &&
        std::ranges::find(columns_, field, &SampleColumn::field) != columns_.end()) {
      fail(i, fmt::format("The column \"{}\" stands twice.", cells_[i]));
    }
    columns_.push_back(std::move(column));
    if (field >= SampleField::x && field <= SampleField::c) {
      axes_.add(static_cast<reference::Axis>(static_cast<int>(field) - 1));
    }
  }
  for (const SampleColumn& column : columns) {
    if (std::ranges::find(cells_, column.name) == cells_.end()) {
      fail(0, fmt::format("There is no column \"{}\", which --columns names.", column.name));
    }
  }
  if (std::ranges::find(columns_, SampleField::time, &SampleColumn::field) == columns_.end()) {
    fail(0, "There is no column of the time. Name one t or time, in seconds.");
  }
  if (axes_.empty()) fail(0, "There is no column of an axis. Name at least one of x, y, z, a, c.");
}

std::string SampleReader::decimal_at(std::size_t column) const {
  std::string text = cells_[column];
  if (separator_ != ',') std::ranges::replace(text, ',', '.');
  if (!is_plain_decimal(text)) {
    fail(column, fmt::format("\"{}\" is no decimal number.", cells_[column]));
  }
  return text;
}

Number SampleReader::number_at(std::size_t column) const {
  const std::string text = decimal_at(column);
  const std::size_t sign = text.front() == '+' ? 1 : 0;
  auto value = Number::parse(std::string_view(text).substr(sign));
  if (!value) fail(column, fmt::format("\"{}\" is no decimal number.", text));
  const SampleColumn& named = columns_[column];
  return named.scale == Number(1) ? *value : *value * named.scale;
}

std::uint64_t SampleReader::line_number_at(std::size_t column) const {
  const std::string& text = cells_[column];
  if (text.empty()) return 0;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail(column, fmt::format("\"{}\" is no line number.", text));
  }
  return value;
}

// A name of letters in lower case and hyphens that is a class of the gauge is one; anything else is
// the machine's own name.
void SampleReader::set_alarm(const std::string& name, std::size_t column) {
  if (name.empty()) fail(column, "The alarm has no name.");
  alarm_.emplace();
  alarm_->native = visible(name);
  if (reference::alarm_class(name)) alarm_->alarm_class = name;
}

void SampleReader::read_alarm_row() {
  if (cells_.size() > 3) fail(3, "A line of an alarm is alarm,<class or name>,<line>.");
  if (cells_.size() < 2) fail(0, "The alarm has no name. Write alarm,<class or name>,<line>.");
  set_alarm(cells_[1], 1);
  if (cells_.size() == 3) alarm_->block = line_number_at(2);
}

void SampleReader::read_row(Sample& sample) {
  if (cells_.size() != columns_.size()) {
    fail(std::min(cells_.size(), columns_.size()),
         fmt::format("The line has {} values for {} columns.", cells_.size(), columns_.size()));
  }
  sample.block = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    switch (columns_[i].field) {
      case SampleField::time: {
        sample.time = number_at(i);
        const std::string text = decimal_at(i);
        const std::size_t point = text.find('.');
        const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
        time_decimals_ =
            std::max(time_decimals_, static_cast<int>(decimals) + columns_[i].decimals);
        if (last_time_ && sample.time <= *last_time_) {
          fail(i, fmt::format("The time {} does not grow: the sample before has {}.", cells_[i],
                              last_time_->text()));
        }
        last_time_ = sample.time;
        break;
      }
      case SampleField::feed:
        if (!cells_[i].empty()) number_at(i);
        break;
      case SampleField::motion:
      case SampleField::other:
        break;
      case SampleField::block:
        sample.block = line_number_at(i);
        break;
      case SampleField::alarm:
        if (!cells_[i].empty()) set_alarm(cells_[i], i);
        break;
      default: {
        const auto axis = static_cast<reference::Axis>(static_cast<int>(columns_[i].field) - 1);
        sample.at[axis] = number_at(i);
        break;
      }
    }
  }
  if (alarm_) alarm_->block = sample.block;
}

bool SampleReader::lacks_time() const {
  const auto time = std::ranges::find(columns_, SampleField::time, &SampleColumn::field);
  const auto place = static_cast<std::size_t>(time - columns_.begin());
  return cells_.size() == columns_.size() && cells_[place].empty();
}

bool SampleReader::next(Sample& sample) {
  after_hole_ = false;
  for (; next_line(); after_hole_ = true) {
    if (alarm_) fail(0, "A line follows the alarm that closes the file.");
    if (cells_.front() == "alarm") {
      read_alarm_row();
      if (next_line()) fail(0, "A line follows the alarm that closes the file.");
      return false;
    }
    if (lacks_time()) continue;
    read_row(sample);
    sample.line = line_;
    sample.number = samples_++;
    sample.after_hole = std::exchange(after_hole_, false);
    return true;
  }
  return false;
}

}  // namespace gonogo::oracle
