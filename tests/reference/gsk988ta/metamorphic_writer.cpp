// SPDX-License-Identifier: GPL-3.0-or-later
//
// One program as text, in any of its writings.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>

#include "metamorphic_program.hpp"

namespace gonogo::reference::testing {
namespace {

// The words besides the axis words that a cycle retains; F is modal everywhere. No word of the
// thread cycles is (GSK-MOD-04), nor R and P of the pockets (GSK-MOD-03), nor L of the helix.
std::string_view retained_addresses(StepKind kind) {
  switch (kind) {
    case StepKind::cut:
      return "XYZUVWRJKF";
    case StepKind::pocket:
      return "ILQDF";
    case StepKind::helix:
      return "IDF";
    default:
      return "F";
  }
}

bool has_address(const Words& words, char address) {
  return std::any_of(words.begin(), words.end(),
                     [&](const Word& word) { return word.address == address; });
}

// Writes steps as blocks of words; keeps where the machine stands.
class Writer {
 public:
  Writer(const Model& model, const Writing& writing)
      : writing_(writing), axes_(axes_of(writing.plane)), stand_{model.start, false} {
    block({{'G', fmt::format("{}", plane_code(writing.plane))},
           {'G', writing.lengths == Lengths::inch ? "20" : "21"}});
    for (const Step& step : model.steps) put(step);
  }
  std::vector<Words> take() { return std::move(blocks_); }

 private:
  void block(Words words) { blocks_.push_back(std::move(words)); }
  void dwell(std::int64_t milliseconds) {
    block({{'G', "4"}, {'P', fmt::format("{}", milliseconds)}});
  }

  std::string number(std::int64_t count, bool is_length = true) const {
    const bool converted = is_length && writing_.lengths == Lengths::inch_in_mm;
    const std::int64_t value = std::abs(converted ? count * 254 : count);
    const std::int64_t one = converted ? 10'000 : 1'000;
    return fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", value / one, value % one,
                       converted ? 4 : 3);
  }

  Axis axis(std::size_t place) const {
    return place == 0 ? axes_.p : place == 1 ? axes_.q : axes_.d;
  }

  // The word of an axis; an increment counts from `from`.
  Word word(std::size_t place, std::int64_t to, std::int64_t from, bool incremental) const {
    std::int64_t value = incremental ? to - from : to;
    if (axis(place) == Axis::x && writing_.diameter) value *= 2;
    return {(incremental ? "UVW" : "XYZ")[index(axis(place))], number(value)};
  }
  // To the counts of a point. `depth_from`: where an increment along d counts from.
  void add_axis_words(Words& words, const Point& end, const std::array<bool, 3>& named,
                      std::int64_t depth_from) const {
    for (std::size_t place = 0; place < 3; ++place) {
      if (!named[place]) continue;
      const bool incremental = writing_.incremental && !(stand_.astray && place < 2);
      const std::int64_t from = place == 2 ? depth_from : stand_.at[place];
      words.push_back(word(place, end[place], from, incremental));
    }
  }
  void add_feed(Words& words, const Step& step) const {
    words.push_back({'G', step.per_revolution ? "99" : "98"});
    if (step.feed) words.push_back({'F', number(*step.feed)});
  }

  void put(const Step& step) {
    if (step.kind == StepKind::dwell) return dwell(step.feed.value());
    // A milling mode that was not left keeps its words.
    if (!is_milling(step.kind) || step.kind != mode_) retained_.clear();
    mode_ = step.kind;
    if (step.blocks.empty()) return put_motion(step);
    for (const CycleBlock& repeat : step.blocks) put_block(step, repeat);
    if (!is_milling(step.kind) || !step.closes) return;
    block({{'G', "80"}});
    retained_.clear();
  }

  void put_motion(const Step& step) {
    const bool is_arc = step.kind == StepKind::centre_arc || step.kind == StepKind::radius_arc;
    Words words = {{'G', is_arc                         ? (step.sense < 0 ? "2" : "3")
                         : step.kind == StepKind::rapid ? "0"
                                                        : "1"}};
    add_feed(words, step);
    if (step.kind == StepKind::increment) {
      for (std::size_t place = 0; place < 3; ++place) {
        if (step.named[place]) words.push_back(word(place, step.end[place], 0, true));
      }
    } else {
      add_axis_words(words, step.end, step.named, stand_.at[2]);
    }
    if (step.kind == StepKind::centre_arc) {
      words.push_back({"IJK"[index(axes_.p)], number(step.offset[0])});
      words.push_back({"IJK"[index(axes_.q)], number(step.offset[1])});
    } else if (step.kind == StepKind::radius_arc) {
      words.push_back({'R', number(step.r)});
    }
    block(std::move(words));
    stand_ = after(step, stand_);
  }

  // A block that mills counts its depth from the R plane.
  void put_block(const Step& step, const CycleBlock& repeat) {
    const bool first = &repeat == &step.blocks.front();
    if (repeat.dwell > 0 && !first) dwell(repeat.dwell);
    Words words;
    if (first) add_feed(words, step);
    const std::int64_t to_r_plane = is_milling(step.kind) ? repeat.r.value_or(0) : 0;
    add_axis_words(words, repeat.end, repeat.named, stand_.at[2] + to_r_plane);
    if (repeat.r) words.push_back({'R', number(*repeat.r)});
    for (const Given& given : repeat.words) {
      words.push_back({given.address, number(given.count, given.is_length)});
    }
    // A cut without axis word and R is no repeat (GSK-G94-12).
    const bool repeats =
        is_milling(step.kind) || repeat.r || repeat.named[0] || repeat.named[1] || repeat.named[2];
    const bool spelled_out = writing_.repeats != Repeats::as_given && repeats;
    if (writing_.repeats == Repeats::entered_anew && repeats && !first) block({{'G', "80"}});
    latch(step.kind, words);
    if (spelled_out) {
      for (const Word& word : retained_) {
        if (!has_address(words, word.address)) words.push_back(word);
      }
    }
    const bool other = !first && repeat.code != (&repeat - 1)->code;
    if (first || other || repeat.code_stands || spelled_out) {
      words.insert(words.begin(), {'G', fmt::format("{}", repeat.code)});
    }
    block(std::move(words));
    stand_ = after(repeat, step.kind, stand_);
  }

  void latch(StepKind kind, const Words& words) {
    for (const Word& word : words) {
      if (retained_addresses(kind).find(word.address) == std::string_view::npos) continue;
      std::erase_if(retained_, [&](const Word& old) { return old.address == word.address; });
      retained_.push_back(word);
    }
  }

  Writing writing_;
  PlaneAxes axes_;
  Stand stand_;
  StepKind mode_ = StepKind::rapid;  // of the last step that moved or cut
  Words retained_;
  std::vector<Words> blocks_;
};

}  // namespace

std::vector<Words> write(const Model& model, const Writing& writing) {
  return Writer(model, writing).take();
}

Profile machine(const Model& model, const Writing& writing) {
  Profile profile;
  profile.x_diameter = writing.diameter;
  const Number one = Number(writing.lengths == Lengths::mm ? 1'000 : 25'400) / 1'000'000;
  const PlaneAxes axes = axes_of(writing.plane);
  profile.initial.at[axes.p] = Number(model.start[0]) * one;
  profile.initial.at[axes.q] = Number(model.start[1]) * one;
  profile.initial.at[axes.d] = Number(model.start[2]) * one;
  if (set_reading(profile, "gsk.thread.runout", writing.run_out) ||
      set_reading(profile, "gsk.helix.flat", writing.flat ? "on" : "off")) {
    throw std::invalid_argument("no such reading");
  }
  profile.parameters["5920"] = writing.run_out_parameters ? 50 : 0;
  profile.parameters["5921"] = writing.run_out_parameters ? 2 : 0;
  return profile;
}

std::string text(const std::vector<Words>& blocks) {
  std::string program;
  for (const Words& words : blocks) {
    for (const Word& word : words) {
      if (&word != &words.front()) program += ' ';
      program += word.address + word.number;
    }
    program += '\n';
  }
  return program;
}

void operator<<(std::ostream& out, const Model& model) {
  out << fmt::format("from ({}, {}, {}) thousandths along p, q, d:\n", model.start[0],
                     model.start[1], model.start[2])
      << text(write(model, {}));
}

}  // namespace gonogo::reference::testing
