// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions in step with the spindle: G33, G33.1 and the threading cycle G76.
#include <fmt/format.h>

#include "fuzz/generate/ngc_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

void NgcWriter::synchronous_block() {
  Words words;
  mode_words(words);
  enter(words, choices_.one_in(2) ? 33 : kG33Point1);
  spindle_words(words, {3, 4});
  const std::uint32_t axes = puts_wrong(24) ? 0 : 1 + choices_.below(7);
  for (const Axis axis : {x, y, z}) {
    if ((axes >> axis & 1) != 0) words.push_back(axis_word(axis, 20));
  }
  const bool any_lead = profile_.readings.is("ngc.g33.k=free"_reading) && choices_.one_in(3);
  if (any_lead || puts_wrong(16)) {
    words.push_back(choices_.pick({"K0", "K-1.5", "K-2"}));
  } else if (!puts_wrong(24)) {
    const std::int64_t least = length_of(unit() / 10);
    words.push_back(
        word('K', choices_.one_in(3) ? unit() * choices_.between(1, 5) / 2 : least + length(3)));
  }
  if (motion_ == kG33Point1 && choices_.one_in(3)) words.push_back(choices_.pick({"I1.5", "I0.5"}));
  if (puts_wrong(24)) words.push_back(feed_word());
  unused_words(words, motion_ == 33 ? "RIJLPQDH" : "RJLPQDH");
  // G33.1 comes back.
  if (motion_ == 33) arrive();
  write(std::move(words), "GM");
}

// J, K, R: some passes, and often a depth that is just that of a pass. The depth of all of them.
std::int64_t NgcWriter::pass_words(Words& words) {
  std::int64_t infeed = unit() / 10 * choices_.pick({1, 3, 7});
  if (choices_.one_in(3)) infeed = unit() / choices_.pick({2, 4, 8});
  if (choices_.one_in(3)) {
    infeed = length_of(unit() / 20);
    infeed += length(1);
  }
  const char* const degression =
      choices_.one_in(3) ? "" : choices_.pick({"R1", "R2", "R2", "R1.5", "R3", "R2.5", "R1.25"});
  const bool equal = degression[0] == '\0' || std::string_view(degression) == "R1";
  // Passes by the root: as many as the square of this.
  const std::int64_t most = equal ? settings_.pecks : 3;
  std::int64_t depth = infeed * choices_.between(2, most);
  if (choices_.one_in(3)) depth += choices_.between(-1, 1);
  if (choices_.one_in(3)) depth += choices_.between(0, infeed) - infeed / 2;
  if (puts_wrong(12)) depth = infeed - choices_.between(0, 1);
  words.push_back(word('J', infeed));
  words.push_back(word('K', depth));
  if (degression[0] != '\0') words.push_back(degression);
  return depth;
}

// L and E. A taper may be as long as the thread is deep, and as half the thread.
void NgcWriter::taper_words(Words& words, std::int64_t travel, std::int64_t depth) {
  const std::uint32_t kind = choices_.below(8);
  if (kind < 3) return;
  if (kind != 3) words.push_back(fmt::format("L{}", choices_.below(4)));
  if (kind == 4) return;
  std::int64_t taper = choices_.between(1, travel / 2);
  if (choices_.one_in(4)) taper = depth + choices_.between(-1, 1);
  if (choices_.one_in(4)) taper = travel / 2 + choices_.between(-1, puts_wrong(2) ? 1 : 0);
  words.push_back(word('E', taper < 0 ? 0 : taper));
}

// Words that do not go with the others; one reading takes some of them.
void NgcWriter::threading_faults(Words& words) {
  const bool forgiven =
      profile_.readings.is("ngc.g76.checks=linuxcnc"_reading) && choices_.one_in(2);
  if (!forgiven && !puts_wrong(6)) return;
  count("fault: word of G76");
  switch (choices_.below(4)) {
    case 0:
      words.push_back(axis_word(choices_.pick({x, y}), 20));
      break;
    case 1:
      // One without which there is no thread.
      std::erase_if(words, [letter = choices_.pick({'P', 'I', 'J', 'K', 'Z'})](
                               const std::string& word) { return word[0] == letter; });
      break;
    default:
      replace(words, choices_.pick({"R0.5", "P0", "P-1", "H-1", "H-2", "H1.5", "L4", "L7", "L-1",
                                    "L1.5", "E-1", "E9", "Q-1", "I0", "J0", "J-0.1", "K-1"}));
  }
  on_fault();
}

void NgcWriter::threading_block() {
  Words words;
  mode_words(words);
  const bool forgiven =
      profile_.readings.is("ngc.g76.checks=linuxcnc"_reading) && choices_.one_in(3);
  if (plane_ != 18 && !forgiven && !puts_wrong(16)) {
    plane_ = 18;
    series_plane_ = 0;
    words.push_back(code(18));
  }
  enter(words, 76);
  spindle_words(words, {3, 4});
  // The way is known where it is written.
  if (!at_[z] && !incremental_) set_incremental(words, true);
  std::int64_t travel = length_of(unit() * 2);
  travel += length(20);
  words.push_back(travel_word(z, any_sign(travel)));
  const std::uint32_t lead = choices_.below(3);
  words.push_back(fmt::format("P{}.{}", lead, 1 + choices_.below(9)));
  words.push_back(word('I', any_sign(1 + length(4))));
  const std::int64_t depth = pass_words(words);
  taper_words(words, travel, depth);
  if (choices_.one_in(3))
    words.push_back(choices_.pick({"Q29", "Q29.5", "Q30", "Q0", "Q-10", "Q45"}));
  if (choices_.one_in(3)) words.push_back(fmt::format("H{}", choices_.below(4)));
  if (choices_.one_in(8)) words.push_back(feed_word());
  unused_words(words, "D");
  arrive();
  threading_faults(words);
  write(std::move(words), "GMHL");
}

}  // namespace gonogo::generate
