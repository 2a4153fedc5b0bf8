// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces written by hand, a record a word.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "judging.hpp"

namespace gonogo::oracle {

using WordTrace = std::vector<std::string>;

// A record in one word: R3,0,10 a traverse of block 3 to X0 Z10; F3,0,10 a feed; D3,1 a dwell; M3,5
// an M function; T3,0,10,2 a thread of lead 2; A3 an alarm, `spindle-stopped`.
inline std::string json_of_word(const std::string& word, bool blocks) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : word.substr(1) + ",") {
    if (c != ',') {
      part += c;
    } else {
      parts.push_back(std::exchange(part, ""));
    }
  }
  const std::string b = blocks ? fmt::format(R"("b":{},)", parts[0]) : "";
  const auto to = [&] { return fmt::format(R"("to":{{"x":"{}","z":"{}"}})", parts[1], parts[2]); };
  switch (word[0]) {
    case 'R':
      return fmt::format(R"({{"k":"rapid",{}{}}})", b, to());
    case 'F':
      return fmt::format(R"({{"k":"feed",{}{},"f":"100"}})", b, to());
    case 'T':
      return fmt::format(R"({{"k":"thread",{}{},"lead":"{}","start":"0"}})", b, to(), parts[3]);
    case 'D':
      return fmt::format(R"({{"k":"dwell",{}"s":"{}"}})", b, parts[1]);
    case 'M':
      return fmt::format(R"({{"k":"m",{}"m":{}}})", b, parts[1]);
    default:
      return fmt::format(R"({{"k":"alarm","class":"spindle-stopped",{}"native":"9"}})", b);
  }
}

inline Verdict judged_trace(const std::string& program, const WordTrace& trace,
                            const Judging& judging) {
  std::string text;
  for (const std::string& word : trace) text += json_of_word(word, judging.blocks) + "\n";
  return judge_trace(program, text, judging);
}

inline Verdict judged_words(const std::string& program, const WordTrace& trace,
                            Judging judging = {.m = true}) {
  judging.dialect = "rs274";
  return judged_trace(program, trace, judging);
}

inline bool is_go_of_cycle(const Verdict& verdict) {
  return decision(verdict.kind) == Decision::go;
}

inline WordTrace with_word_moved(WordTrace trace, std::size_t from, std::size_t to) {
  const std::string word = trace[from];
  trace.erase(trace.begin() + static_cast<std::ptrdiff_t>(from));
  trace.insert(trace.begin() + static_cast<std::ptrdiff_t>(to), word);
  return trace;
}

}  // namespace gonogo::oracle
