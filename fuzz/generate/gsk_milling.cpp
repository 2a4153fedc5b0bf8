// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks of the milling cycles G110 to G117.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/generate/gsk_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

// The centre, and the depth as an increment from the R plane, so that its direction is known.
void GskWriter::mill_place(Words& words, std::int64_t depth) {
  const auto [p, q, d] = plane_axes();
  words.push_back(axis_word(p, 60));
  words.push_back(axis_word(q, 60));
  words.push_back(word("UVW"[d], scaled(d, depth)));
  if (choices_.one_in(20)) words.push_back(fmt::format("C{}", choices_.below(360)));
}

// R, seldom the wrong way.
void GskWriter::mill_r(Words& words, bool down) {
  if (choices_.below(3) == 0) return;
  const std::int64_t above = length(5);
  words.push_back(word('R', down != errs(25) ? -above : above));
}

void GskWriter::pocket_block() {
  Words words;
  const bool entry = mode_ != Mode::pocket;
  if (entry || choices_.one_in(4)) words.push_back(choices_.pick({"G110", "G111"}));
  count(entry ? "pocket entry" : "pocket repeated");
  const bool down = choices_.below(6) != 0;
  const bool sized = entry || choices_.one_in(3);
  // A deep pocket under the infeed of a shallow one would be cut in a million layers.
  if (sized) pocket_infeed_ = length(4) + 1;
  std::int64_t depth = pocket_infeed_ * choices_.between(1, settings_.layers) - choices_.below(3);
  if (choices_.one_in(20)) depth = 0;
  mill_place(words, down ? -depth : depth);
  mill_r(words, down);
  if (sized) {
    const std::int64_t tool = length(5) + choices_.below(3) + 1;
    const std::int64_t step = choices_.between(1, 2 * tool) - (choices_.one_in(2) ? 1 : 0);
    const std::int64_t rings = choices_.between(0, std::int64_t{settings_.rings} * 4);
    const std::int64_t reach = (step > 0 ? step : 1) * rings / 4 + choices_.below(2);
    words.push_back(word('I', tool + reach));
    words.push_back(word('L', step));
    words.push_back(word('Q', pocket_infeed_));
    words.push_back(word('D', tool));
  }
  if (choices_.one_in(2)) words.push_back(word('P', choices_.one_in(5) ? -length(2) : length(2)));
  if (choices_.one_in(4)) words.push_back(feed_word());
  mode_ = Mode::pocket;
  put(std::move(words));
}

void GskWriter::helix_block() {
  Words words;
  const bool entry = mode_ != Mode::helix;
  if (entry || choices_.one_in(4)) words.push_back(choices_.pick({"G112", "G113"}));
  count(entry ? "helix entry" : "helix repeated");
  const bool down = choices_.below(6) != 0;
  const std::int64_t depth = choices_.one_in(20) ? 0 : length(20);
  mill_place(words, down ? -depth : depth);
  mill_r(words, down);
  if (entry || choices_.one_in(3)) {
    const std::int64_t tool = length(5) + choices_.below(3);
    words.push_back(word('I', tool + length(10) + choices_.below(2)));
    words.push_back(word('D', tool));
  }
  if (choices_.one_in(2)) words.push_back(fmt::format("L{}", choices_.below(7)));
  if (choices_.one_in(6)) words.push_back("M35");
  if (choices_.one_in(4)) words.push_back(feed_word());
  mode_ = Mode::helix;
  put(std::move(words));
}

// J and K. Mostly far enough to clear the thread, and in a bore never so far that the tool would
// meet the opposite wall. A straight run-out clears it only along the radius.
void GskWriter::run_out_words(Words& words, std::int64_t height, std::int64_t room, bool internal) {
  const bool straight = profile_.readings.is("gsk.thread.runout=radial"_reading) ||
                        profile_.readings.is("gsk.thread.runout=tangent"_reading);
  // Without the word the profile's length holds, which the bore may be too small for; without
  // either the thread is not covered.
  const bool may_lack_length = !straight && !internal && profile_.parameters.contains("5921");
  const bool has_length = !may_lack_length || choices_.below(4) != 0;
  const std::int64_t clears = height + length(1);
  const std::int64_t reach = !straight && choices_.one_in(3) ? length(3) : clears;
  const bool no_run_out = !straight && choices_.one_in(6);
  if (has_length) words.push_back(word('J', no_run_out ? 0 : std::min(reach, room)));
  if (straight) {
    words.push_back(profile_.readings.is("gsk.thread.runout=radial"_reading) ? "K0" : "K90");
  } else if (choices_.below(3) != 0 || !may_lack_angle(has_length && no_run_out)) {
    const std::uint32_t angle = choices_.one_in(2) ? choices_.below(13) * 30 : choices_.below(362);
    words.push_back(fmt::format("K{}", angle));
  }
}

// The profile gives it, or nothing needs it.
bool GskWriter::may_lack_angle(bool no_run_out) const {
  return no_run_out || profile_.parameters.contains("5920");
}

void GskWriter::thread_block() {
  Words words;
  const bool entry = mode_ != Mode::thread;
  const bool internal = choices_.one_in(2);
  if (entry || choices_.below(3) != 0) {
    words.push_back(fmt::format("G{}", (internal ? 116 : 114) + choices_.between(0, 1)));
  }
  count(internal ? "internal thread" : "external thread");
  const bool down = choices_.below(6) != 0;
  // Quarters of a turn, and now and then any part of one.
  const std::int64_t lead = length(4) + std::int64_t{choices_.below(20)} * 4;
  std::int64_t depth = lead * choices_.between(0, 16) / 4 + choices_.below(4) / 3;
  if (depth < 3) depth = 0;  // the passes within the tolerance's depth look the same
  mill_place(words, down ? -depth : depth);
  mill_r(words, down);
  const std::int64_t tool = length(5) + choices_.below(3);
  const std::int64_t height = std::max<std::int64_t>(0, tool - length(4)) + choices_.below(2);
  // Between the tool and the axis; where it is a few increments, opposite sides of the axis agree.
  const std::int64_t room = length(20) + length_of(10);
  const bool fills_bore = internal && choices_.one_in(40);
  const std::int64_t bore =
      fills_bore ? 2 * tool : 2 * (internal ? tool : 0) + 2 * room + choices_.below(3);
  words.push_back(word('I', lead));
  words.push_back(word('E', bore));
  words.push_back(word('P', height));
  words.push_back(word('D', tool));
  if (choices_.below(3) != 0) {
    words.push_back(word('Q', height / choices_.between(1, settings_.layers) + choices_.below(2)));
  }
  run_out_words(words, height, room, internal);
  if (choices_.one_in(4)) words.push_back(feed_word());
  mode_ = Mode::thread;
  put(std::move(words));
}

}  // namespace gonogo::generate
