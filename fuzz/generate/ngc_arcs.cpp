// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs by their centre and by their radius, and helices.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "fuzz/generate/ngc_writer.hpp"

namespace gonogo::generate {

std::array<NgcWriter::Axis, 3> NgcWriter::plane_axes() const {
  if (plane_ == 18) return {z, x, y};
  if (plane_ == 19) return {y, z, x};
  return {x, y, z};
}

void NgcWriter::choose_plane(Words& words) {
  if (choices_.one_in(4)) set_plane(words);
}

// Cycles that follow are a series of their own where it changes.
void NgcWriter::set_plane(Words& words) {
  const int before = plane_;
  plane_ = choices_.pick({17, 18, 19});
  if (plane_ != before) series_plane_ = 0;
  words.push_back(code(plane_));
}

// One of the eight places with the same two distances from the centre: the radius is the same.
NgcWriter::Pair NgcWriter::turned(Pair from) {
  if (choices_.one_in(2)) std::swap(from.p, from.q);
  return {any_sign(from.p), any_sign(from.q)};
}

// By how much an end misses its circle: nothing, or near one of the limits.
std::int64_t NgcWriter::beside(std::int64_t radius) {
  if (choices_.below(6) != 0) return 0;
  switch (choices_.below(4)) {
    case 0:
      return any_sign(choices_.between(18, 22));  // 0.002 mm
    case 1:
      return any_sign(choices_.between(1, 3));  // 0.0002 inch
    case 2:
      return any_sign(
          inch_ ? choices_.between(27, 29)
                : choices_.between(281, 284));  // 0.02 mm or 0.002 inch, times the root of 2
    default:
      return any_sign(radius / 1000 + choices_.between(-1, 1));
  }
}

void NgcWriter::end_words(Words& words, Pair travel) {
  const auto [p, q, third] = plane_axes();
  // An axis that does not move may be left out.
  const bool names_p = travel.p != 0 || choices_.one_in(2);
  const bool names_q = travel.q != 0 || choices_.one_in(2);
  if (names_p) words.push_back(travel_word(p, travel.p));
  if (names_q) words.push_back(travel_word(q, travel.q));
}

void NgcWriter::radius_words(Words& words) {
  count("arc by R");
  Pair travel = {any_sign(length(20)), any_sign(length(20))};
  if (choices_.one_in(3)) travel.q = 0;
  const double chord = std::hypot(static_cast<double>(travel.p), static_cast<double>(travel.q));
  const auto half = static_cast<std::int64_t>(chord / 2);
  std::int64_t radius = half + 1 + length(20);
  // About half the chord; 0.00127 mm is forgiven by one reading.
  if (choices_.one_in(8)) radius = half + choices_.between(-14, 6);
  if (radius <= 0) radius = length_of(unit());
  end_words(words, travel);
  words.push_back(word('R', choices_.one_in(3) ? -radius : radius));
}

void NgcWriter::offset_words(Words& words, Pair offset) {
  const auto [p, q, third] = plane_axes();
  const auto put_offset = [&](Axis axis, std::int64_t value) {
    words.push_back(word("IJK"[axis], absolute_centre_ ? *at_[axis] + value : value));
  };
  // An offset of nil may be left out, but not both.
  const bool needs_both = absolute_centre_ && !errs(20);
  const bool names_p = offset.p != 0 || needs_both || choices_.one_in(3);
  if (names_p) put_offset(p, offset.p);
  if (offset.q != 0 || needs_both || !names_p || choices_.one_in(3)) put_offset(q, offset.q);
}

void NgcWriter::centre_words(Words& words) {
  count("arc by centre");
  const auto [p, q, third] = plane_axes();
  if (absolute_centre_ && !(at_[p] && at_[q])) {
    absolute_centre_ = false;
    words.push_back("G91.1");
  }
  Pair start = {any_sign(length(20)), choices_.one_in(2) ? any_sign(length(20)) : 0};
  // A radius that is none to one reading.
  if (errs(40)) start = {choices_.between(0, 14), 0};
  const Pair offset = {-start.p, -start.q};
  if (choices_.one_in(4)) {
    count("full circle");
    // A centre alone is an arc by a reading.
    if (!has_code_ && choices_.one_in(2)) words.push_back(travel_word(p, 0));
    if (has_code_ && choices_.one_in(2)) end_words(words, {});
  } else {
    Pair end = turned(start);
    const double radius = std::hypot(static_cast<double>(start.p), static_cast<double>(start.q));
    (end.p == 0 ? end.q : end.p) += beside(static_cast<std::int64_t>(radius));
    end_words(words, {end.p + offset.p, end.q + offset.q});
  }
  offset_words(words, offset);
}

void NgcWriter::helix_words(Words& words) {
  const auto [p, q, third] = plane_axes();
  if (choices_.one_in(3)) {
    count("helix");
    words.push_back(axis_word(third, 20));
  }
  if (choices_.one_in(5)) {
    count("turns");
    words.push_back(
        fmt::format("P{}", 1 + choices_.below(static_cast<std::uint32_t>(settings_.turns))));
  }
  if (choices_.one_in(12)) words.push_back(axis_word(choices_.one_in(2) ? a : c, 90));
}

// Words that do not go with the others.
void NgcWriter::arc_faults(Words& words, bool by_radius) {
  if (!puts_wrong(25)) return;
  const auto [p, q, third] = plane_axes();
  switch (choices_.below(3)) {
    case 0:
      count("fault: offset of another plane");
      if (!by_radius) words.push_back(word("IJK"[third], length(5)));
      break;
    case 1:
      count("fault: centre and radius");
      words.push_back(by_radius ? word("IJK"[p], length(5)) : "R5");
      break;
    default:
      count("fault: number of turns");
      words.push_back(choices_.pick({"P0", "P1.5", "P-2"}));
  }
  lose_place();
}

void NgcWriter::arc_block() {
  Words words;
  choose_plane(words);
  const auto [p, q, third] = plane_axes();
  if (at_[p] && at_[q]) {
    mode_words(words);
  } else if (!incremental_) {
    set_incremental(words, true);
  }
  enter(words, choices_.pick({2, 3}));
  const bool by_radius = choices_.one_in(2);
  if (by_radius) {
    radius_words(words);
  } else {
    centre_words(words);
  }
  helix_words(words);
  feed_words(words);
  unused_words(words, "QLDHE");
  arrive();
  arc_faults(words, by_radius);
  write(std::move(words));
}

}  // namespace gonogo::generate
