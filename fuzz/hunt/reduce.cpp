// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/reduce.hpp"

#include <algorithm>
#include <cstdlib>

#include "fuzz/hunt/profile_parts.hpp"
#include "oracle/differential/differential.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::hunt {
namespace {

using program::lines_of;
using program::SmallDecimal;
using program::TextLine;

using Clock = std::chrono::steady_clock;
using Lines = std::vector<TextLine>;

// Shorter texts are simpler; of equal ones, that with the smaller value.
bool is_simpler(const SmallDecimal& a, const SmallDecimal& b) {
  const std::string x = a.text();
  const std::string y = b.text();
  if (x.size() != y.size()) return x.size() < y.size();
  const auto [p, q] = same_scale(a, b);
  return std::abs(p) < std::abs(q);
}

// Simpler values, the simplest first.
std::vector<SmallDecimal> simpler_values(const SmallDecimal& number) {
  std::vector<SmallDecimal> values = {{0, 0}, {1, 0},  {2, 0},
                                      {5, 0}, {10, 0}, {-number.value, number.scale}};
  SmallDecimal cut = number;
  std::vector<SmallDecimal> shorter;
  while (cut.scale > 0) {
    cut = {cut.value / 10, cut.scale - 1};
    shorter.push_back(cut);
  }
  values.insert(values.end(), shorter.rbegin(), shorter.rend());
  for (std::int64_t step = 1'000'000; step >= 10; step /= 10) {
    values.push_back({cut.value / step * step, 0});
  }
  values.push_back({cut.value / 2, 0});
  std::erase_if(values, [&](const SmallDecimal& value) { return !is_simpler(value, number); });
  return values;
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
    drop_words(i);
    shorten_numbers(i);
    plain_layout(i);
    reset_settings(i);
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
