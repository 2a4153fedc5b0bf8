// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>

#include "oracle/relation/free_step.hpp"
#include "oracle/relation/near.hpp"
#include "reference/gsk988ta/milling.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::relation {

using reference::RecordKind;
using reference::ThreadMilling;
using reference::ThreadRunOut;

namespace {

constexpr int kTurn = 360;

// GSK-G114-06 to -11: each pass an entry, an infeed, a helix, a run-out, the way back and the way
// to the safe position, in this order and nothing else. Where one step ends and the next begins is
// looked for at every end of a motion.
class ThreadPasses {
 public:
  ThreadPasses(const ThreadMilling& thread, const Followed& way)
      : thread_(thread),
        terms_(way.terms),
        slack_(way.slack),
        subject_(way.subject),
        begin_(way.begin),
        axes_(reference::axes_of(thread.plane)),
        middle_{rational_near(thread.centre[0]), rational_near(thread.centre[1])},
        top_(rational_near(thread.r_plane)),
        bottom_(rational_near(thread.bottom)),
        up_((top_ - bottom_).sign()),
        free_(thread.external ? 1 : -1),
        start_(rational_near(thread.start_radius)),
        run_out_(rational_near(thread.runout_length)),
        lead_(rational_near(thread.lead)),
        whole_(rational_near(abs(thread.travel)) / lead_ * kTurn),
        passes_(thread.passes().to_int64().value()) {}

  StepAnswer answer() {
    pass(1, begin_);
    return {{ends_.begin(), ends_.end()}, broken_by_, broken_};
  }

 private:
  using Step = std::string_view;

  Offset offset_of(const Position& place) const {
    return {place[axes_.p] - middle_.p, place[axes_.q] - middle_.q};
  }
  // Nothing moves on another axis, and the words are those of the block.
  Step words_of(const Event& piece, bool may_traverse) const {
    if (moves_another_axis(piece, subject_.at(begin_).from, axes_, slack_.axis(piece.width))) {
      return "Another axis moves.";
    }
    if (terms_.compare_blocks && piece.block != thread_.block)
      return "The motion is of another line.";
    if (piece.part == Part::traverse) return may_traverse ? "" : "A traverse stands for a cut.";
    const Label& label = *piece.label;
    const bool cuts = label.kind == RecordKind::feed || label.kind == RecordKind::arc;
    const bool has_feed = label.feed_mode == thread_.feed_mode &&
                          agree(thread_.feed, label.feed, terms_.feed_resolution, terms_);
    return cuts && has_feed ? "" : "The motion is of another kind or feed.";
  }
  static bool is_straight(const Event& piece) { return piece.source().kind == RecordKind::feed; }
  // Where an arc may come as its chord, and where chords are granted.
  bool may_be_round(const Event& piece) const {
    return !is_straight(piece) || terms_.chord.sign() > 0;
  }

  Number height_of(const Position& place) const { return (place[axes_.d] - bottom_) * up_; }
  bool is_at_top(const Position& place, const Number& width) const {
    return abs(place[axes_.d] - top_) <= slack_.axis(width);
  }
  Number radius_of_pass(std::int64_t number) const {
    return number == 0 ? start_ : rational_near(thread_.radius_of_pass(Number(number)));
  }

  // Farther from the axis than a radius, or nearer to it: of the line between the ends.
  static bool leads_beyond(const Offset& from, const Offset& to, const Number& radius) {
    return radius.sign() < 0 || max(from.square(), to.square()) > radius * radius;
  }
  static bool leads_within(const Offset& from, const Offset& to, const Number& radius) {
    if (radius.sign() <= 0) return false;
    const Offset way{to.p - from.p, to.q - from.q};
    const Number along = -(way.p * from.p + way.q * from.q);
    const Number length_2 = way.square();
    if (along.sign() <= 0) return from.square() < radius * radius;
    if (along >= length_2) return to.square() < radius * radius;
    const Number across = way.p * from.q - way.q * from.p;
    return across * across < radius * radius * length_2;
  }
  // Deeper in the material than a circle.
  bool is_deeper(const Offset& from, const Offset& to, const Number& radius,
                 const Number& off) const {
    return free_ > 0 ? leads_within(from, to, radius - off) : leads_beyond(from, to, radius + off);
  }
  bool is_deeper(const Event& piece, const Number& radius) const {
    return is_deeper(offset_of(piece.from), offset_of(piece.to), radius, slack_.round(piece.width));
  }
  bool is_beyond(const Event& piece, const Number& radius) const {
    return leads_beyond(offset_of(piece.from), offset_of(piece.to),
                        radius + slack_.round(piece.width));
  }
  bool is_on(const Offset& at, const Number& radius, const Number& off) const {
    const Number low = max(radius - off, 0);
    return at.square() >= low * low && at.square() <= (radius + off) * (radius + off);
  }

  void breaks(std::size_t piece, Step what) {
    if (what.empty() || (!broken_.empty() && piece <= broken_by_)) return;
    broken_by_ = piece;
    broken_ = what;
  }
  // The next piece that is no stretch without a label (R3).
  std::size_t behind_small(std::size_t i) {
    while (subject_.at(i).is_motion()) {
      const auto end = end_of_small_stretch(subject_, i, terms_.tolerance);
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

  // J-THR-02 says it at length: arcs of one sense at the R plane, and one straight cut to r_n.
  void enter(std::int64_t number, std::size_t begin) {
    const Number radius = radius_of_pass(number);
    const Position start = subject_.at(begin).from;
    const Number standing = rational_near(sqrt(offset_of(start).square()));
    const Number widest = max(start_ + run_out_, standing) + rational_near(thread_.tool_radius) * 2;
    bool has_turned = is_on(offset_of(start), start_, slack_.round(0));
    bool goes_in = false;
    Arcs arcs;
    Offset from;
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      const bool may_go_down = has_turned && is_end(i) &&
                               is_on(offset_of(piece.from), radius, slack_.round(piece.width));
      if (may_go_down && (goes_in || !goes_through_wall(number, begin, i))) helix(number, i);
      if (!piece.is_motion()) return breaks(i, "A pass is missing.");
      Step broken = words_of(piece, false);
      if (broken.empty() && !is_at_top(piece.to, piece.width)) {
        broken = "The entry leaves the R plane, or its arc or infeed is missing.";
      }
      if (broken.empty() && free_ > 0 && is_beyond(piece, widest)) {
        broken = "The entry goes away from the work.";
      }
      if (!broken.empty()) return breaks(i, broken);
      if (!goes_in && may_be_round(piece) &&
          !(is_straight(piece) && has_turned && is_infeed(i, radius))) {
        if (broken = arcs.take(piece, way_of_piece(piece)); !broken.empty())
          return breaks(i, broken);
        has_turned = true;
        continue;
      }
      if (!has_turned) return breaks(i, "The entry has no arc.");
      if (!goes_in) from = offset_of(piece.from);
      if (!goes_in && goes_through_wall(number, begin, i)) {
        return breaks(i, "The entry goes through the wall of the bore.");
      }
      goes_in = true;
      if (is_deeper(from, from, radius_of_pass(number - 1), slack_.round(piece.width))) {
        return breaks(i, "The entry ends in the material.");
      }
      if (is_deeper(piece, radius)) return breaks(i, "The infeed is deeper than its pass.");
      if (!is_straight(piece) || turns_aside(from, offset_of(piece.from), offset_of(piece.to))) {
        return breaks(i, "The infeed is not one straight cut.");
      }
    }
  }
  // A bore is entered within the pass before, or in the circle whose diameter leads from where the
  // tool stands to where the entry ends.
  bool goes_through_wall(std::int64_t number, std::size_t begin, std::size_t end) {
    if (free_ > 0) return false;
    const Offset from = offset_of(subject_.at(begin).from);
    const Offset to = offset_of(subject_.at(end).from);
    for (std::size_t i = begin; i < end; ++i) {
      const Event& piece = subject_.at(i);
      const Offset at = offset_of(piece.to);
      const Offset a{at.p - from.p, at.q - from.q};
      const Offset b{at.p - to.p, at.q - to.q};
      const Number off = slack_.round(piece.width) * (abs(a.p) + abs(a.q) + abs(b.p) + abs(b.q));
      const bool is_in_circle = a.p * b.p + a.q * b.q <= off;
      if (!is_in_circle && is_deeper(piece, radius_of_pass(number - 1))) return true;
    }
    return false;
  }
  // Of chords: whether one leads to the circle of the pass.
  bool is_infeed(std::size_t i, const Number& radius) {
    const Event& piece = subject_.at(i);
    return is_on(offset_of(piece.to), radius, slack_.round(piece.width));
  }
  // Whether a line that began elsewhere goes on in another direction.
  bool turns_aside(const Offset& begin, const Offset& from, const Offset& to) const {
    const Offset first{from.p - begin.p, from.q - begin.q};
    const Offset all{to.p - begin.p, to.q - begin.q};
    const Number off = terms_.tolerance * 3;
    const Number across = first.p * all.q - first.q * all.p;
    const bool goes_back = first.p * (to.p - from.p) + first.q * (to.q - from.q) < -off * off;
    return goes_back || across * across > off * off * all.square();
  }

  // Arcs that all turn one way, no more than once: the way their directions go round, of which
  // quarters are seen.
  class Arcs {
   public:
    Step take(const Event& piece, const Offset& way) {
      const int rot = piece.source().rot;
      if (rot != 0 && !piece.label->is_flat) {
        if (sense_ != 0 && (rot < 0) != (sense_ < 0)) return "An arc turns the other way.";
        if (sense_ == 0) directions_ = Winding(rot < 0 ? -1 : 1, 0);
        sense_ = rot;
      }
      if (sense_ != 0) directions_.take(way);
      return directions_.quarters() > 4 ? "The step turns more than once." : "";
    }

   private:
    int sense_ = 0;
    Winding directions_{1, 0};
  };
  Offset way_of_piece(const Event& piece) const {
    return {piece.to[axes_.p] - piece.from[axes_.p], piece.to[axes_.q] - piece.from[axes_.q]};
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
    Offset last = offset_of(subject_.at(begin).from);
    Number swept;
    // What a place may be off along the circle, in degrees: below 60 tau / r.
    const Number aside =
        radius.sign() > 0 ? terms_.tolerance * 17 / 8 * 60 / radius : Number(kTurn);
    for (std::size_t i = begin;; ++i) {
      const Event& piece = subject_.at(i);
      if (is_end(i) && swept >= whole_ - aside * 2 && is_at_bottom(piece.from)) run_out(number, i);
      if (!piece.is_motion()) return breaks(i, "The helix ends early.");
      if (swept > whole_ + aside * 2) return breaks(i, "The helix makes more turns than J-THR-04.");
      if (end_of_small_stretch(subject_, i, terms_.tolerance)) {
        last = offset_of(piece.to);
        continue;
      }
      const Step broken = words_of(piece, false);
      if (!broken.empty()) return breaks(i, broken);
      if (!may_be_round(piece)) return breaks(i, "The helix is not round.");
      const Offset to = offset_of(piece.to);
      if (!is_on(to, radius, slack_.round(piece.width) + terms_.chord)) {
        return breaks(i, "The helix has another radius.");
      }
      const Number along = last.p * to.p + last.q * to.q;
      const Number across = (last.p * to.q - last.q * to.p) * thread_.sense;
      // Rounding may lead back by less than it is.
      const bool leads_back = across.sign() < 0;
      if (leads_back && -across > terms_.tolerance * radius) {
        return breaks(i, "The helix turns the other way.");
      }
      swept += leads_back ? -degrees_of(along, -across) : degrees_of(along, across);
      last = to;
      const Number fallen = (top_ - piece.to[axes_.d]) * up_;
      const Number off = slack_.axis(piece.width) + lead_ * aside / kTurn;
      if (abs(fallen - lead_ * swept / kTurn) > off)
        return breaks(i, "The helix has another lead.");
    }
  }
  bool is_at_bottom(const Position& place) const {
    return abs(height_of(place)) <= terms_.tolerance * 17 / 8;
  }

  // Where J and K lead from the end of the helix; of a bore also through its axis.
  std::vector<Offset> ends_of_run_out(const Offset& from) const {
    const Number radius = rational_near(sqrt(from.square()));
    const Number sense = thread_.sense;
    const auto turned = [&](const Number& degrees, const Number& length) {
      const auto [cosine, sine] = exact::cos_sin_degrees(degrees);
      const Number c = rational_near(cosine);
      const Number s = rational_near(sine) * sense;
      return Offset{(from.p * c - from.q * s) * length / radius,
                    (from.q * c + from.p * s) * length / radius};
    };
    const auto straight = [&](const Number& from_normal) {
      const Number degrees = free_ > 0 ? from_normal : Number(kTurn / 2) - from_normal;
      const Offset way =
          turned((degrees + kTurn * 2) - ((degrees + kTurn * 2) / kTurn).floor() * kTurn, run_out_);
      return Offset{from.p + way.p, from.q + way.q};
    };
    const Number& k = thread_.runout_angle;
    std::vector<Offset> ends;
    const auto is = [&](ThreadRunOut one) {
      return thread_.runout == ThreadRunOut::open || thread_.runout == one;
    };
    if (is(ThreadRunOut::polar)) {
      ends.push_back(turned(k, radius + run_out_ * free_));
      if (free_ < 0 && run_out_ > radius) ends.push_back(turned(k, 0));
    }
    if (is(ThreadRunOut::radial)) ends.push_back(straight(k));
    if (is(ThreadRunOut::tangent)) ends.push_back(straight(Number(kTurn / 4) - k));
    return ends;
  }

  // GSK-G114-11.
  void run_out(std::int64_t number, std::size_t begin) {
    if (run_out_.sign() == 0) return back(number, begin);
    const Offset from = offset_of(subject_.at(begin).from);
    const std::vector<Offset> ends = ends_of_run_out(from);
    const Number radius = radius_of_pass(number);
    Number widest = radius;
    for (const Offset& end : ends) widest = max(widest, rational_near(sqrt(end.square())));
    Arcs arcs;
    bool has_straight = false;
    bool has_round = false;
    for (std::size_t i = begin;; ++i) {
      i = behind_small(i);
      const Event& piece = subject_.at(i);
      const Offset here = offset_of(piece.from);
      const Number off = terms_.tolerance * 17 / 4;
      const bool is_over =
          i > begin && is_end(i) && std::ranges::any_of(ends, [&](const Offset& end) {
            return abs(end.p - here.p) <= off && abs(end.q - here.q) <= off;
          });
      if (is_over) back(number, i);
      if (!piece.is_motion()) return breaks(i, "The run-out is missing.");
      Step broken = words_of(piece, false);
      if (broken.empty() && is_deeper(piece, radius))
        broken = "The run-out is deeper than its pass.";
      if (broken.empty() && free_ > 0 && is_beyond(piece, widest)) {
        broken = "The run-out goes away from the work.";
      }
      if (broken.empty()) broken = broken_height(piece);
      if (!broken.empty()) return breaks(i, broken);
      (is_straight(piece) ? has_straight : has_round) = true;
      const bool is_bent =
          has_straight && (has_round || turns_aside(from, here, offset_of(piece.to)));
      if (is_bent && terms_.chord.sign() == 0)
        return breaks(i, "The run-out is neither straight nor one arc.");
      if (!is_straight(piece)) broken = arcs.take(piece, way_of_piece(piece));
      if (!broken.empty()) return breaks(i, broken);
    }
  }

  // From the bottom up, never down; in the material no higher than the groove rises over K.
  Step broken_height(const Event& piece) const {
    const Number off = slack_.axis(piece.width);
    const Number low = height_of(piece.from);
    const Number high = height_of(piece.to);
    if (high < low - off || high < -off) return "The run-out goes down.";
    if (height_of(piece.to) > abs(top_ - bottom_) + off)
      return "The run-out leaves the heights of the thread.";
    const Number angle = rational_near(thread_.runout_angle);
    const Number allowed = lead_ * min(angle, Number(kTurn) - angle) / kTurn + off;
    if (high <= allowed) return {};
    // What lies above.
    const Number part = low >= allowed ? Number(0) : (allowed - low) / (high - low);
    const Offset from = offset_of(point_at(piece, part));
    return is_deeper(from, offset_of(piece.to), start_, slack_.round(piece.width))
               ? "The run-out rises in the material."
               : Step();
  }

  Number kept_of(std::int64_t number) const {
    const Number depth = rational_near(thread_.depth_of_pass(Number(number)));
    return run_out_ < depth ? radius_of_pass(number) : start_;
  }

  // Along d alone, to the R plane, beside where the run-out ended.
  void back(std::int64_t number, std::size_t begin) {
    const Position foot = subject_.at(begin).from;
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
      if (broken.empty() && (piece.to[axes_.d] - top_) * up_ > off)
        broken = "The way back goes beyond the R plane.";
      if (!broken.empty()) return breaks(i, broken);
    }
  }

  bool is_safe(const Position& place) const {
    const Offset at = offset_of(place);
    const Number off = slack_.round(0);
    const Number safe = start_ + run_out_ * free_;
    if (free_ < 0) return abs(at.p) <= abs(safe) + off;
    const Number least = max(safe - off, 0);
    return at.square() >= least * least;
  }

  // Along p alone, one way, at the R plane, until the tool is safe.
  void away(std::int64_t number, std::size_t begin) {
    const Position foot = subject_.at(begin).from;
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
      // Of a bore the way leads along p, wherever along q the run-out ended.
      const Number farthest = max(abs(foot[axes_.p] - middle_.p), abs(start_ - run_out_));
      const bool crosses =
          free_ > 0 ? is_deeper(piece, kept_of(number))
                    : abs(piece.to[axes_.p] - middle_.p) > farthest + slack_.round(piece.width);
      if (broken.empty() && crosses) broken = "The way to safety crosses the work.";
      if (!broken.empty()) return breaks(i, broken);
    }
  }

  const ThreadMilling& thread_;
  const Terms& terms_;
  Slack slack_;
  SubjectSide& subject_;
  std::size_t begin_;
  reference::PlaneAxes axes_;
  Offset middle_;
  Number top_;
  Number bottom_;
  int up_;
  int free_;  // outward or inward
  Number start_;
  Number run_out_;
  Number lead_;
  Number whole_;  // degrees of a helix
  std::int64_t passes_;
  std::set<std::pair<std::int64_t, std::size_t>> visited_;
  std::set<std::size_t> ends_;
  std::size_t broken_by_ = 0;
  Step broken_;
};

// About the axis, by half a turn.
void turn_over(reference::Record& record, const ThreadMilling& thread) {
  const reference::PlaneAxes axes = reference::axes_of(thread.plane);
  record.to[axes.p] = thread.centre[0] * 2 - record.to[axes.p];
  record.to[axes.q] = thread.centre[1] * 2 - record.to[axes.q];
  record.centre = {thread.centre[0] * 2 - record.centre[0],
                   thread.centre[1] * 2 - record.centre[1]};
}

std::vector<reference::Record> named_path(const ThreadMilling& thread, const Position& from,
                                          bool is_turned) {
  reference::gsk988ta::MillingSite site;
  site.block = thread.block;
  site.plane = thread.plane;
  site.axes = reference::axes_of(thread.plane);
  site.centre = from;
  site.centre[site.axes.p] = thread.centre[0];
  site.centre[site.axes.q] = thread.centre[1];
  site.r_plane = thread.r_plane;
  site.bottom = thread.bottom;
  site.travel = thread.travel;
  site.feed = thread.feed;
  site.feed_mode = thread.feed_mode;
  std::vector<reference::Record> path;
  auto passes = thread_passes(site, thread);
  while (const reference::Record* record = passes.next()) {
    path.push_back(*record);
    if (is_turned) turn_over(path.back(), thread);
  }
  // The last one says where all axes are.
  Position end = from;
  for (const reference::Record& record : path) end = end_of(record, end);
  path.back().axes = reference::kEveryAxis;
  path.back().to = end;
  return path;
}

}  // namespace

std::vector<std::vector<reference::Record>> paths_of(const ThreadMilling& thread,
                                                     const Position& from) {
  std::vector<std::vector<reference::Record>> paths;
  for (const ThreadRunOut one :
       {ThreadRunOut::polar, ThreadRunOut::radial, ThreadRunOut::tangent}) {
    if (thread.runout != ThreadRunOut::open && thread.runout != one) continue;
    ThreadMilling named = thread;
    named.runout = one;
    for (const bool is_turned : {false, true}) paths.push_back(named_path(named, from, is_turned));
    if (thread.runout_length.sign() == 0) break;
  }
  return paths;
}

StepAnswer follow(const ThreadMilling& thread, const Followed& way) {
  return ThreadPasses(thread, way).answer();
}

}  // namespace gonogo::relation
