// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <set>

#include "oracle/relation/thread_site.hpp"

namespace gonogo::relation {

using reference::RecordKind;
using reference::ThreadMilling;

namespace {

constexpr int kTurn = 360;

// GSK-G114-06 to -11: each pass an entry, an infeed, a helix, a run-out, the way back and the way
// to the safe position, in this order and nothing else. Where one step ends and the next begins is
// looked for at every end of a motion.
class ThreadPasses : private ThreadSite {
 public:
  ThreadPasses(const ThreadMilling& thread, const Followed& way)
      : ThreadSite(thread, way),
        subject_(way.subject),
        begin_(way.begin),
        whole_(rational_near(abs(thread.travel)) / lead_ * kTurn),
        passes_(thread.passes().to_int64().value_or(std::numeric_limits<std::int64_t>::max())) {}

  StepAnswer answer() {
    pass(1, begin_);
    return {{ends_.begin(), ends_.end()}, broken_by_, broken_};
  }

 private:
  using Step = std::string_view;

  static bool is_straight(const Event& piece) { return piece.source().kind == RecordKind::feed; }
  // Where an arc may come as its chord, and where chords are granted.
  bool may_be_round(const Event& piece) const {
    return !is_straight(piece) || tolerances_.chord.sign() > 0;
  }

  void breaks(std::size_t piece, Step what) {
    if (what.empty() || (!broken_.empty() && piece <= broken_by_)) return;
    broken_by_ = piece;
    broken_ = what;
  }
  // The next piece that is no stretch without a label (R3).
  std::size_t behind_small(std::size_t i) {
    const Position place = subject_.at(i).from;
    while (subject_.at(i).is_motion()) {
      const auto end = end_of_small_stretch(subject_, i, place, tolerances_.tolerance);
      if (!end) break;
      i = *end;
    }
    return i;
  }
  // Between the records that each is one motion.
  bool is_end(std::size_t i) { return subject_.at(i).begins; }

  void pass(std::int64_t number, std::size_t begin) {
    if (!visited_.insert({number, begin}).second) return;
    if (number > passes_) {
      ends_.insert(begin);
      return;
    }
    enter(number, begin);
  }

  // What has come of an entry.
  struct Entry {
    explicit Entry(ThreadPasses& passes) : arcs(passes) {}
    Arcs arcs;
    std::vector<Offset> chords;  // places of the straight cuts before the infeed
    bool has_arc = false;
    bool goes_in = false;
    Offset from;  // of the infeed
  };
  bool is_round(const Entry& entry) const {
    return entry.chords.empty() ? entry.has_arc : are_chords(entry.chords);
  }

  // Arcs of one sense at the R plane, and one straight cut to r_n.
  void enter(std::int64_t number, std::size_t begin) {
    const Number radius = radius_of_pass(number);
    const Position start = subject_.at(begin).from;
    const Number standing = rational_near(sqrt(offset_of(start).square()));
    const Number widest = max(start_ + run_out_, standing) + rational_near(thread_.tool_radius) * 2;
    Entry entry(*this);
    entry.has_arc = is_on(offset_of(start), start_, slack_.round(0));
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      const bool is_entered = entry.goes_in || (is_small_infeed(number) && is_round(entry));
      const bool may_go_down = is_entered && is_end(i) &&
                               is_on(offset_of(piece.from), radius, slack_.round(piece.width));
      if (may_go_down) helix(number, i);
      if (!piece.is_motion()) return breaks(i, "A pass is missing.");
      Step broken = words_of(piece, false);
      if (broken.empty() && !is_at_top(piece.to, piece.width)) {
        broken = "The entry leaves the R plane, or its arc or infeed is missing.";
      }
      if (broken.empty() && free_ > 0 && is_beyond(piece, widest)) {
        broken = "The entry goes away from the work.";
      }
      if (broken.empty()) {
        broken = is_round_piece(entry, i, radius) ? go_round(entry, piece, number)
                                                  : go_in(entry, piece, number);
      }
      if (!broken.empty()) return breaks(i, broken);
    }
  }
  bool is_round_piece(const Entry& entry, std::size_t i, const Number& radius) {
    const Event& piece = subject_.at(i);
    const bool has_turned = entry.has_arc || !entry.chords.empty();
    return !entry.goes_in && may_be_round(piece) &&
           !(is_straight(piece) && has_turned && is_infeed(i, radius));
  }
  Step go_round(Entry& entry, const Event& piece, std::int64_t number) {
    // A bolt is entered from above its middle.
    if (free_ < 0 && is_deeper(piece, radius_of_pass(number - 1))) {
      return "The entry goes through the wall of the bore.";
    }
    if (is_straight(piece)) {
      if (entry.chords.empty()) entry.chords.push_back(offset_of(piece.from));
      entry.chords.push_back(offset_of(piece.to));
      return {};
    }
    if (!entry.chords.empty() && !is_round(entry)) return "The entry has no arc.";
    entry.chords.clear();
    entry.has_arc = true;
    return entry.arcs.take(piece);
  }
  Step go_in(Entry& entry, const Event& piece, std::int64_t number) {
    if (!entry.goes_in) entry.from = offset_of(piece.from);
    // Straight cuts in line with the infeed may be a part of it.
    while (!entry.goes_in && !is_round(entry)) {
      const std::size_t last = entry.chords.size();
      if (last < 2 || turns_aside(entry.chords[last - 2], entry.from, offset_of(piece.to))) {
        return "The entry has no arc.";
      }
      entry.from = entry.chords[last - 2];
      entry.chords.resize(last == 2 ? 0 : last - 1);
    }
    entry.goes_in = true;
    if (is_deeper(entry.from, entry.from, radius_of_pass(number - 1), slack_.round(piece.width))) {
      return "The entry ends in the material.";
    }
    if (is_deeper(piece, radius_of_pass(number))) return "The infeed is deeper than its pass.";
    const bool is_one_cut =
        is_straight(piece) && !turns_aside(entry.from, offset_of(piece.from), offset_of(piece.to));
    return is_one_cut ? Step() : Step("The infeed is not one straight cut.");
  }
  // An infeed of two tolerances may come in pieces of which each stays at one place (R3).
  bool is_small_infeed(std::int64_t number) const {
    const Number infeed = abs(radius_of_pass(number) - radius_of_pass(number - 1));
    return infeed <= tolerances_.tolerance * 2 + slack_.round(0);
  }
  // For chords: whether one leads to the circle of the pass.
  bool is_infeed(std::size_t i, const Number& radius) {
    const Event& piece = subject_.at(i);
    return is_on(offset_of(piece.to), radius, slack_.round(piece.width));
  }
  // In pieces an arc keeps its centre. Nobody knows the centre of an arc that is as straight as a
  // line.
  bool is_of_one_arc(const Event& first, const Event& piece) const {
    if (first.record == piece.record || first.label->is_flat || piece.label->is_flat) return true;
    if (first.source().kind != RecordKind::arc || piece.source().kind != RecordKind::arc) {
      return false;
    }
    const Number off = tolerances_.tolerance * 17 / 4;
    const Offset apart = centre_of(first) - centre_of(piece);
    return max(abs(apart.p), abs(apart.q)) <= off;
  }
  static Number degrees_of(const Number& along, const Number& across) {
    if (along.sign() == 0 && across.sign() == 0) return 0;
    const Number degrees = rational_near(angle_degrees(along, across));
    // Rounded: sums of many stay small numbers.
    return (degrees * 1'000'000'000).floor() / 1'000'000'000;
  }

  // On the circle of the pass, in the cycle's sense, down by a lead for each turn, to the bottom.
  void helix(std::int64_t number, std::size_t begin) {
    const Number radius = radius_of_pass(number);
    if (!is_at_top(subject_.at(begin).from, 0)) return;
    Position place = subject_.at(begin).from;
    Offset last = offset_of(place);
    Number swept;
    // What a place may be off along the circle, in degrees: below 60 tau / r.
    const Number aside =
        radius.sign() > 0 ? tolerances_.tolerance * 17 / 8 * 60 / radius : Number(kTurn);
    for (std::size_t i = begin;; ++i) {
      const Event& piece = subject_.at(i);
      if (is_end(i) && swept >= whole_ - aside * 2 && is_at_bottom(piece.from)) run_out(number, i);
      if (!piece.is_motion()) return breaks(i, "The helix ends early.");
      if (swept > whole_ + aside * 2)
        return breaks(i, "The helix makes more turns than it has leads.");
      if (end_of_small_stretch(subject_, i, place, tolerances_.tolerance)) {
        last = offset_of(piece.to);
        continue;
      }
      const Step broken = words_of(piece, false);
      if (!broken.empty()) return breaks(i, broken);
      if (!may_be_round(piece)) return breaks(i, "The helix is not round.");
      const Offset to = offset_of(piece.to);
      if (!is_on(to, radius, slack_.round(piece.width) + tolerances_.chord)) {
        return breaks(i, "The helix has another radius.");
      }
      // R3: a granted chord.
      const Number inner = radius - slack_.round(piece.width) - tolerances_.chord;
      if (is_straight(piece) && inner.sign() > 0 && nearest_square(last, to) < inner * inner) {
        return breaks(i, "A chord of the helix is longer than is granted.");
      }
      const Number ahead = along(last, to);
      const Number onward = across(last, to) * thread_.sense;
      // Rounding may lead back by less than it is.
      const bool leads_back = onward.sign() < 0;
      if (leads_back && -onward > tolerances_.tolerance * radius) {
        return breaks(i, "The helix turns the other way.");
      }
      swept += leads_back ? -degrees_of(ahead, -onward) : degrees_of(ahead, onward);
      last = to;
      place = piece.to;
      const Number fallen = (top_ - piece.to[axes_.d]) * up_;
      const Number off = slack_.axis(piece.width) + lead_ * aside / kTurn;
      if (abs(fallen - lead_ * swept / kTurn) > off)
        return breaks(i, "The helix has another lead.");
    }
  }
  // GSK-G114-11.
  void run_out(std::int64_t number, std::size_t begin) {
    if (run_out_.sign() == 0) return back(number, begin);
    const Offset from = offset_of(subject_.at(begin).from);
    const std::vector<Offset> ends = ends_of_run_out(from);
    const Number radius = radius_of_pass(number);
    const Number widest = farthest_of_run_out(radius);
    const bool leads_in = is_unfit(number);
    Arcs arcs(*this);
    std::vector<Offset> places = {from};  // of straight cuts
    bool needs_chords = false;            // for they are not one line that keeps off the pass
    Event first_round;
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      const Offset here = offset_of(piece.from);
      const Number off = tolerances_.tolerance * 17 / 4;
      const bool is_over =
          i > begin && is_end(i) && std::ranges::any_of(ends, [&](const Offset& end) {
            return abs(end.p - here.p) <= off && abs(end.q - here.q) <= off;
          });
      constexpr Step kBent = "The run-out is neither straight nor one arc.";
      if (is_over && needs_chords && !are_chords(places)) return breaks(i, kBent);
      if (is_over) back(number, i);
      if (!piece.is_motion()) return breaks(i, "The run-out is missing.");
      Step broken = words_of(piece, false);
      const Offset to = offset_of(piece.to);
      const bool is_deep = !leads_in && is_deeper(piece, radius);
      const Number granted = is_straight(piece) ? tolerances_.chord : Number(0);
      if (broken.empty() && is_deep &&
          is_deeper(here, to, radius, slack_.round(piece.width) + granted)) {
        broken = "The run-out is deeper than its pass.";
      }
      if (broken.empty() && free_ > 0 && is_beyond(piece, widest)) {
        broken = "The run-out goes away from the work.";
      }
      if (broken.empty()) broken = broken_height(piece);
      if (!broken.empty()) return breaks(i, broken);
      if (is_straight(piece)) {
        places.push_back(to);
        needs_chords = needs_chords || is_deep || turns_aside(from, here, to);
        const bool is_bent = needs_chords && tolerances_.chord.sign() == 0;
        if (is_bent || first_round.is_motion()) return breaks(i, kBent);
        continue;
      }
      if (!first_round.is_motion()) first_round = piece;
      if (places.size() > 1 || !is_of_one_arc(first_round, piece)) return breaks(i, kBent);
      if (broken = arcs.take(piece); !broken.empty()) return breaks(i, broken);
    }
  }

  // Along d alone, to the R plane, beside where the run-out ended.
  void back(std::int64_t number, std::size_t begin) {
    const Position foot = subject_.at(begin).from;
    const bool leads_in = is_unfit(number);
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      if (is_end(i) && is_at_top(piece.from, 0)) away(number, i);
      if (!piece.is_motion()) return breaks(i, "The way back is missing.");
      const Number off = slack_.axis(piece.width);
      Step broken = words_of(piece, true);
      const bool is_aside = abs(piece.to[axes_.p] - foot[axes_.p]) > off ||
                            abs(piece.to[axes_.q] - foot[axes_.q]) > off;
      if (broken.empty() && is_aside) broken = "The way back leads aside.";
      const Number risen = (piece.to[axes_.d] - piece.from[axes_.d]) * up_;
      if (broken.empty() && risen < -off) broken = "The way back leads down.";
      if (broken.empty() && !leads_in && is_deeper(piece, kept_of(number))) {
        broken = "The way back goes through the part.";
      }
      if (broken.empty() && (piece.to[axes_.d] - top_) * up_ > off)
        broken = "The way back goes beyond the R plane.";
      if (!broken.empty()) return breaks(i, broken);
    }
  }

  // Along p alone, one way, at the R plane, until the tool is safe.
  void away(std::int64_t number, std::size_t begin) {
    const Position foot = subject_.at(begin).from;
    const Number wall = max(start_, rational_near(sqrt(offset_of(foot).square())));
    const bool leads_in = is_unfit(number);
    int direction = 0;
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      if (is_end(i) && is_safe(piece.from)) pass(number + 1, i);
      if (!piece.is_motion()) return breaks(i, "The safe position is missing.");
      const Number off = slack_.axis(piece.width);
      Step broken = words_of(piece, true);
      const Number way = piece.to[axes_.p] - piece.from[axes_.p];
      if (abs(way) > off && direction == 0) direction = way.sign();
      const Number reach = start_ + run_out_ + rational_near(thread_.tool_radius) * 2;
      if (broken.empty() && !is_at_top(piece.to, piece.width))
        broken = "The way to safety leaves the R plane.";
      if (broken.empty() && abs(piece.to[axes_.q] - foot[axes_.q]) > off)
        broken = "The way to safety leads aside.";
      if (broken.empty() && way * direction < -off) broken = "The way to safety turns back.";
      if (broken.empty() && free_ > 0 && abs(piece.to[axes_.p] - middle_.p) > reach + off) {
        broken = "The way to safety goes away from the work.";
      }
      // In a bore the way leads along p, wherever along q the run-out ended, and not into the wall.
      const Number farthest = max(abs(foot[axes_.p] - middle_.p), abs(start_ - run_out_));
      const bool crosses =
          free_ > 0 ? !leads_in && is_deeper(piece, kept_of(number))
                    : abs(piece.to[axes_.p] - middle_.p) > farthest + slack_.round(piece.width) ||
                          is_deeper(piece, wall);
      if (broken.empty() && crosses) broken = "The way to safety crosses the work.";
      if (!broken.empty()) return breaks(i, broken);
    }
  }

  SubjectSide& subject_;
  std::size_t begin_;
  Number whole_;  // degrees of a helix
  std::int64_t passes_;
  std::set<std::pair<std::int64_t, std::size_t>> visited_;
  std::set<std::size_t> ends_;
  std::size_t broken_by_ = 0;
  Step broken_;
};

}  // namespace

StepAnswer follow(const ThreadMilling& thread, const Followed& way) {
  return ThreadPasses(thread, way).answer();
}

}  // namespace gonogo::relation
