// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/reduce.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/hunt/simpler.hpp"
#include "fuzz/program/text.hpp"
#include "oracle/differential/differential.hpp"

namespace gonogo::hunt {
namespace {

using program::lines_of;
using program::SmallDecimal;
using program::TextLine;

using Clock = std::chrono::steady_clock;
using Lines = std::vector<TextLine>;

std::string code_or_name(const program::TextWord& word) {
  const std::string code = code_of(word);
  return code.empty() ? name_of(word) : code;
}

class Reducer {
 public:
  Reducer(Reproducer reproducer, const StillShows& shows, const ReduceLimits& limits)
      : best_(std::move(reproducer)),
        has_right_path_(limits.needs_right_path && has_right_path(best_.program)),
        shows_(shows),
        limits_(limits),
        deadline_(Clock::now() + limits.time) {}

  Reduced run() {
    for (std::size_t before = 0; before != smaller_ + 1 && !spent();) {
      before = smaller_ + 1;
      drop_programs();
      for (std::size_t i = 0; i <= best_.before.size(); ++i) reduce_program(i);
    }
    return {best_, runs_, !spent()};
  }

 private:
  bool spent() const { return runs_ >= limits_.runs || Clock::now() >= deadline_; }

  bool accepts(Reproducer candidate) {
    if (spent()) return false;
    ++runs_;
    if (!shows_(candidate)) return false;
    // What no path is right for shows nothing of the subject.
    if (has_right_path_ && !has_right_path(candidate.program)) return false;
    best_ = std::move(candidate);
    ++smaller_;
    return true;
  }

  // Program i: of those before, and the last of all.
  static generate::GeneratedProgram& program(Reproducer& reproducer, std::size_t i) {
    return i < reproducer.before.size() ? reproducer.before[i] : reproducer.program;
  }

  bool accepts_text(std::size_t i, const Lines& lines) {
    Reproducer candidate = best_;
    program(candidate, i).text = text_of(lines);
    return accepts(std::move(candidate));
  }

  // Delta debugging of a list: without halves, quarters, ... single items. `without` says whether
  // items [begin, end) can go, and lets them go; `count` is the length now.
  template <typename Count, typename Without>
  void drop_parts(const Count& count, const Without& without) {
    for (std::size_t size = std::max<std::size_t>(1, count() / 2);; size /= 2) {
      for (std::size_t begin = 0; begin < count() && !spent();) {
        const std::size_t end = std::min(begin + size, count());
        if (!without(begin, end)) begin = end;
      }
      if (size <= 1) return;
    }
  }

  void drop_programs() {
    drop_parts([&] { return best_.before.size(); },
               [&](std::size_t begin, std::size_t end) {
                 Reproducer candidate = best_;
                 const auto first = candidate.before.begin();
                 candidate.before.erase(first + static_cast<std::ptrdiff_t>(begin),
                                        first + static_cast<std::ptrdiff_t>(end));
                 return accepts(std::move(candidate));
               });
  }

  void reduce_program(std::size_t i) {
    drop_lines(i);
    drop_names(i);
    drop_words(i);
    shorten_equal_numbers(i);
    shorten_numbers(i);
    plain_layout(i);
    plain_spelling(i);
    reset_settings(i);
    simplify_machine(i);
  }

  void drop_lines(std::size_t i) {
    Lines lines = lines_of(program(best_, i).text);
    drop_parts([&] { return lines.size(); },
               [&](std::size_t begin, std::size_t end) {
                 Lines fewer = lines;
                 fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(begin),
                             fewer.begin() + static_cast<std::ptrdiff_t>(end));
                 if (!accepts_text(i, fewer)) return false;
                 lines = std::move(fewer);
                 return true;
               });
  }

  // Words of one address, or one code, in all lines: each of them may need the others. Along an
  // axis that nothing names any more the machine need not start from elsewhere.
  void drop_names(std::size_t i) {
    std::set<std::string> names;
    for (const TextLine& line : lines_of(program(best_, i).text)) {
      for (const program::TextWord& word : line.words) names.insert(code_or_name(word));
    }
    names.erase("");
    for (const std::string& name : names) {
      Reproducer candidate = best_;
      generate::GeneratedProgram& fewer = program(candidate, i);
      Lines lines = lines_of(fewer.text);
      for (TextLine& line : lines) {
        std::erase_if(line.words, [&](const auto& word) { return code_or_name(word) == name; });
      }
      fewer.text = text_of(lines);
      for (const reference::Axis axis : reference::kAllAxes) {
        if (name == std::string(1, "XYZAC"[index(axis)])) fewer.profile.initial.at[axis] = 0;
      }
      accepts(std::move(candidate));
    }
  }

  void drop_words(std::size_t i) {
    Lines lines = lines_of(program(best_, i).text);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      drop_parts([&] { return lines[line].words.size(); },
                 [&](std::size_t begin, std::size_t end) {
                   Lines fewer = lines;
                   auto& words = fewer[line].words;
                   words.erase(words.begin() + static_cast<std::ptrdiff_t>(begin),
                               words.begin() + static_cast<std::ptrdiff_t>(end));
                   if (!accepts_text(i, fewer)) return false;
                   lines = std::move(fewer);
                   return true;
                 });
    }
  }

  void shorten_numbers(std::size_t i) {
    Lines lines = lines_of(program(best_, i).text);
    for (TextLine& line : lines) {
      for (program::TextWord& word : line.words) {
        if (!code_of(word).empty()) continue;
        // Back to front, so that the places before stay.
        const std::vector<program::NumberPlace> places = numbers_of(word);
        for (auto place = places.rbegin(); place != places.rend(); ++place) {
          shorten(i, lines, word, *place);
        }
      }
    }
  }

  void shorten(std::size_t i, const Lines& lines, program::TextWord& word,
               const program::NumberPlace& place) {
    const std::string whole = word.text;
    for (const SmallDecimal& value : simpler_values(place.number)) {
      word.text = whole;
      word.text.replace(place.begin, place.end - place.begin, value.text());
      if (accepts_text(i, lines)) return;
    }
    word.text = whole;
  }

  // A number that stands in several words, in all of them: R and Z on one level.
  void shorten_equal_numbers(std::size_t i) {
    std::map<std::string, std::size_t> counts;
    for (const TextLine& line : lines_of(program(best_, i).text)) {
      for (const program::TextWord& word : line.words) {
        if (!code_of(word).empty()) continue;
        for (const program::NumberPlace& place : numbers_of(word)) ++counts[place.number.text()];
      }
    }
    for (const auto& [text, count] : counts) {
      if (count < 2) continue;
      const SmallDecimal number = *program::value_of({"", "X" + text});
      for (const SmallDecimal& value : simpler_values(number)) {
        Lines lines = lines_of(program(best_, i).text);
        for (TextLine& line : lines) replace_number(line, number, value);
        if (accepts_text(i, lines)) break;
      }
    }
  }

  // One blank between words, LF at the end of lines; line by line only where all at once fails.
  void plain_layout(std::size_t i) {
    const Lines lines = lines_of(program(best_, i).text);
    auto plain = [](TextLine& line) {
      for (std::size_t w = 0; w < line.words.size(); ++w) line.words[w].gap = w == 0 ? "" : " ";
      line.rest.clear();
      line.end = "\n";
    };
    Lines all = lines;
    for (TextLine& line : all) plain(line);
    if (all == lines || accepts_text(i, all)) return;
    Lines some = lines;
    for (TextLine& line : some) {
      const TextLine whole = line;
      plain(line);
      if (line != whole && !accepts_text(i, some)) line = whole;
    }
  }

  // Capitals, codes without blanks and zeros; word by word only where a whole line fails.
  void plain_spelling(std::size_t i) {
    Lines lines = lines_of(program(best_, i).text);
    for (TextLine& line : lines) {
      const TextLine whole = line;
      for (program::TextWord& word : line.words) word.text = plain_text(word);
      if (line == whole || accepts_text(i, lines)) continue;
      line = whole;
      for (program::TextWord& word : line.words) {
        const std::string text = std::exchange(word.text, plain_text(word));
        if (word.text != text && !accepts_text(i, lines)) word.text = text;
      }
    }
  }

  // Entries of its tables go, and its numbers become simple.
  void simplify_machine(std::size_t i) {
    for (std::size_t entry = 0;;) {
      Reproducer candidate = best_;
      if (!drop_entry(program(candidate, i).profile, entry)) break;
      if (!accepts(std::move(candidate))) ++entry;
    }
    const std::size_t count = numbers_of(program(best_, i).profile).size();
    for (std::size_t place = 0; place < count; ++place) {
      const std::string text = numbers_of(program(best_, i).profile)[place]->text();
      const auto number = program::value_of({"", "X" + text});
      if (!number || number->text() != text || number->value == 0) continue;
      for (const SmallDecimal& value : simpler_values(*number)) {
        Reproducer candidate = best_;
        *numbers_of(program(candidate, i).profile)[place] =
            reference::Number::parse(value.text()).value();
        if (accepts(std::move(candidate))) break;
      }
    }
  }

  void reset_settings(std::size_t i) {
    for (std::size_t part = 0; part < profile_parts(); ++part) {
      Reproducer candidate = best_;
      if (reset_part(program(candidate, i).profile, part)) accepts(std::move(candidate));
    }
  }

  static bool has_right_path(const generate::GeneratedProgram& program) {
    constexpr std::size_t kMostRecords = 3'000;
    return !oracle::contradicts_itself(program.profile, program.text, kMostRecords);
  }

  Reproducer best_;
  bool has_right_path_;  // and has to keep it
  const StillShows& shows_;
  const ReduceLimits& limits_;
  Clock::time_point deadline_;
  std::size_t runs_ = 0;
  std::size_t smaller_ = 0;  // times that something smaller was found
};

}  // namespace

Reduced reduce(Reproducer reproducer, const StillShows& shows, const ReduceLimits& limits) {
  return Reducer(std::move(reproducer), shows, limits).run();
}

}  // namespace gonogo::hunt
