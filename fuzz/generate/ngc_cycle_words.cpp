// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles of holes: pecks, dwells, repeats, the spindle, and what may be wrong.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/generate/ngc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

std::string NgcWriter::spindle_word(int sense) {
  spindle_ = sense;
  spindle_named_ = true;
  return fmt::format("M{}", sense);
}

void NgcWriter::spindle_words(Words& words, std::initializer_list<int> senses) {
  if (puts_wrong(16)) {
    count("fault: spindle");
    words.push_back(spindle_word(choices_.pick({3, 4, 5})));
  } else if (std::ranges::find(senses, spindle_) == senses.end()) {
    words.push_back(spindle_word(choices_.pick(senses)));
  }
}

// A depth of a peck. Decimal ones have no exact binary value; some meet the clearance of 0.01 inch.
std::int64_t NgcWriter::peck_length() {
  const std::int64_t clearance = inch_ ? unit() / 100 : unit() / 1000 * 254;
  switch (choices_.below(6)) {
    case 0:
      return unit() / 10 * choices_.pick({1, 3, 7});
    case 1:
      return unit() / choices_.pick({2, 4, 8});
    case 2: {
      const std::int64_t part = clearance / choices_.pick({1, 2});
      return part + choices_.between(-1, 1);
    }
    default:
      return unit() / 4 + length(4);
  }
}

// Q, and D where it is read. So small a peck that no fault may meet it is followed by another Q.
void NgcWriter::peck_words(Words& words, bool first) {
  const bool fresh = first || minute_pecks_ || !sticky_.q || choices_.one_in(4);
  if (fresh) {
    sticky_.q = peck_length();
    if (!profile_.block_skip && choices_.one_in(12)) {
      count("minute pecks");
      sticky_.q = choices_.between(1, 20);
    }
    minute_pecks_ = *sticky_.q < unit() / 20;
    words.push_back(word('Q', *sticky_.q));
  }
  if (profile_.readings.is("ngc.peck.d=clearance"_reading) && choices_.one_in(2)) {
    words.push_back(word('D', choices_.one_in(8) ? -length(1) : length(1)));
  }
}

// The words that one cycle has and another does not, and a spindle that turns.
void NgcWriter::own_words(Words& words, bool first) {
  if (motion_ == 74) spindle_words(words, {4});
  if (motion_ == 84) spindle_words(words, {3});
  if (motion_ == 86) spindle_words(words, {3, 4});
  if (is_pecking(motion_)) peck_words(words, first);
  const bool dwells = is_dwelling(motion_) || is_tapping(motion_);
  const bool needed = is_dwelling(motion_) && first;
  bool has_dwell = dwells && (needed || choices_.one_in(is_tapping(motion_) ? 2 : 4));
  // One P for both, where the cycle has one.
  if (choices_.one_in(40)) {
    count("dwell in a cycle");
    dwells_ = has_dwell = true;
    words.push_back(code(4));
  }
  if (!has_dwell) return;
  const std::uint32_t seconds = choices_.below(4);
  const std::uint32_t tenths = choices_.below(10);
  words.push_back(choices_.one_in(8) ? "P0" : fmt::format("P{}.{}", seconds, tenths));
}

// L.
std::int64_t NgcWriter::hole_count(Words& words) {
  if (!choices_.one_in(incremental_ ? 2 : 5)) return 1;
  const std::int64_t holes = choices_.pick({1, 2, 2, 3, 4});
  if (holes > 1) count(incremental_ ? "cycle: a row of holes" : "cycle: L in one place");
  words.insert(words.begin(), fmt::format("L{}", holes));
  return holes;
}

std::string_view NgcWriter::letters_unused_by_cycle() const {
  if (is_pecking(motion_)) {
    return profile_.readings.is("ngc.peck.d=clearance"_reading) ? "IJKHEP" : "IJKHEPD";
  }
  return is_dwelling(motion_) || is_tapping(motion_) ? "IJKHEQD" : "IJKHEQDP";
}

// In place of the word of that letter, or beside the others.
void NgcWriter::replace(Words& words, std::string_view text) {
  std::erase_if(words, [&](const std::string& word) { return word[0] == text[0]; });
  words.emplace_back(text);
}

// Words that do not go with the others.
void NgcWriter::cycle_faults(Words& words) {
  // Where a control may find it late, what it has moved before is to be seen.
  const bool late = profile_.readings.is("ngc.cycle.alarm-at=late"_reading);
  if (minute_pecks_ || !puts_wrong(late ? 5 : 10)) return;
  const char depth = "XYZ"[plane_axes()[2]];
  const auto leave_out = [&](std::string_view letters) {
    std::erase_if(words, [&](const std::string& word) {
      return letters.find(word[0]) != std::string_view::npos;
    });
  };
  switch (choices_.below(late ? 4 : 10)) {
    case 0:
      count("fault: cycle without its own word");
      leave_out(is_pecking(motion_) ? "Q" : "P");
      break;
    case 1:
    case 2:
      count("fault: sign of P or Q");
      replace(words, is_pecking(motion_) ? choices_.pick({"Q0", "Q-1", "Q-0.5"})
                                         : choices_.pick({"P-1", "P-0.5", "P-0.0001"}));
      break;
    case 3:
      count("fault: cycle without R or depth");
      leave_out(choices_.one_in(2) ? std::string_view("R") : std::string_view(&depth, 1));
      break;
    case 4:
      count("fault: R below the bottom");
      if (sticky_.r && !is_pecking(motion_)) {
        const std::int64_t above = 1 + length(5);
        replace(words, word(depth, (incremental_ ? 0 : *sticky_.r) + above));
      }
      break;
    case 5:
      count("fault: L");
      replace(words, choices_.pick({"L0", "L-1", "L1.5", "L-0.5", "L0.5"}));
      break;
    case 6:
      count("fault: rotary axis in a cycle");
      words.push_back(axis_word(choices_.one_in(2) ? a : c, 90));
      break;
    case 7:
      count("fault: cycle without an axis");
      leave_out("XYZ");
      break;
    case 8:
      count("fault: G98 with G99");
      words.push_back("G98");
      words.push_back("G99");
      break;
    default:
      count("fault: two motions");
      words.push_back(choices_.pick({"G0", "G1", "G80", "G81", "G83"}));
  }
  on_fault();
}

}  // namespace gonogo::generate
