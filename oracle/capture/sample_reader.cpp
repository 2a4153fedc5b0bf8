// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/capture/sample_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

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

SampleReader::SampleReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw SampleFault(fmt::format("{}: The file cannot be opened.", path));
  if (!next_line()) {
    throw SampleFault(
        fmt::format("{}: The file is empty. Its first line must name the columns, "
                    "as t,x,z.",
                    path));
  }
  read_header();
}

void SampleReader::fail(std::size_t column, const std::string& sentence) const {
  throw SampleFault(fmt::format("{}, line {}, column {}: {}", path_, line_, column + 1, sentence));
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
    const std::size_t comma = rest.find(',');
    cells_.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    rest.remove_prefix(comma + 1);
  }
}

void SampleReader::read_header() {
  constexpr auto kNames =
      std::to_array<std::pair<std::string_view, Field>>({{"t", Field::time},
                                                         {"time", Field::time},
                                                         {"x", Field::x},
                                                         {"y", Field::y},
                                                         {"z", Field::z},
                                                         {"a", Field::a},
                                                         {"c", Field::c},
                                                         {"f", Field::feed},
                                                         {"block", Field::block},
                                                         {"line", Field::block},
                                                         {"alarm", Field::alarm}});
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::string name = cells_[i];
    for (char& each : name) {
      if (each >= 'A' && each <= 'Z') each = static_cast<char>(each - 'A' + 'a');
    }
    const auto* found = std::ranges::find(kNames, name, &std::pair<std::string_view, Field>::first);
    if (found == kNames.end()) {
      fail(i, fmt::format("\"{}\" names no column. Write t or time, x, y, z, a, c, f, block or "
                          "line, alarm.",
                          cells_[i]));
    }
    if (std::ranges::find(columns_, found->second) != columns_.end()) {
      fail(i, fmt::format("The column \"{}\" stands twice.", cells_[i]));
    }
    columns_.push_back(found->second);
    for (reference::Axis axis : reference::kAllAxes) {
      if (name.size() == 1 && name.front() == letter(axis)) axes_.add(axis);
    }
  }
  if (std::ranges::find(columns_, Field::time) == columns_.end()) {
    fail(0, "There is no column of the time. Name one t or time, in seconds.");
  }
  if (axes_.empty()) fail(0, "There is no column of an axis. Name at least one of x, y, z, a, c.");
}

Number SampleReader::number_at(std::size_t column) const {
  const std::string& text = cells_[column];
  if (!is_plain_decimal(text)) {
    fail(column, fmt::format("\"{}\" is no decimal number.", text));
  }
  const std::size_t sign = text.front() == '+' ? 1 : 0;
  auto value = Number::parse(std::string_view(text).substr(sign));
  if (!value) fail(column, fmt::format("\"{}\" is no decimal number.", text));
  return *value;
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
  alarm_->native = name;
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
    switch (columns_[i]) {
      case Field::time: {
        sample.time = number_at(i);
        const std::size_t point = cells_[i].find('.');
        const std::size_t decimals = point == std::string::npos ? 0 : cells_[i].size() - point - 1;
        time_decimals_ = std::max(time_decimals_, static_cast<int>(decimals));
        if (last_time_ && sample.time <= *last_time_) {
          fail(i, fmt::format("The time {} does not grow: the sample before has {}.", cells_[i],
                              last_time_->text()));
        }
        last_time_ = sample.time;
        break;
      }
      case Field::feed:
        if (!cells_[i].empty()) number_at(i);
        break;
      case Field::block:
        sample.block = line_number_at(i);
        break;
      case Field::alarm:
        if (!cells_[i].empty()) set_alarm(cells_[i], i);
        break;
      default: {
        const auto axis = static_cast<reference::Axis>(static_cast<int>(columns_[i]) - 1);
        sample.at[axis] = number_at(i);
        break;
      }
    }
  }
  if (alarm_) alarm_->block = sample.block;
}

bool SampleReader::next(Sample& sample) {
  if (!next_line()) return false;
  if (alarm_) fail(0, "A line follows the alarm that closes the file.");
  if (cells_.front() == "alarm") {
    read_alarm_row();
    if (next_line()) fail(0, "A line follows the alarm that closes the file.");
    return false;
  }
  read_row(sample);
  sample.line = line_;
  sample.number = samples_++;
  return true;
}

}  // namespace gonogo::oracle
