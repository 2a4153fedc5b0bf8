// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/free_step.hpp"

namespace gonogo::relation {

using reference::RecordKind;
using reference::ThreadMilling;

namespace {

// GSK-G114, as far as stated here: between the R plane and the bottom; no deeper in the material
// than the last pass, and no farther from the axis than twice rho_0 and J, or than where the tool
// stands; no rise in the material by more than a lead, but along d; traverses away from the work;
// cuts with the feed, in the cycle's sense round the axis; no more turns than the passes need.
class ThreadConditions {
 public:
  ThreadConditions(const ThreadMilling& thread, const Position& begin, const Terms& terms)
      : thread_(thread),
        terms_(terms),
        axes_(reference::axes_of(thread.plane)),
        middle_{rational_near(thread.centre[0]), rational_near(thread.centre[1])},
        low_(rational_near(min(thread.bottom, thread.r_plane))),
        high_(rational_near(max(thread.bottom, thread.r_plane))),
        winding_(thread.sense, terms.tolerance * 4) {
    const Number deepest = rational_near(thread.radius_of_pass(thread.passes()));
    const Number start = rational_near(thread.start_radius);
    nearest_ = thread.external ? deepest : Number(0);
    farthest_ = thread.external ? start * 2 + rational_near(thread.runout_length) : deepest;
    const Winding::Offset place = offset_of(begin);
    farthest_ = max(farthest_, rational_near(sqrt(place.p * place.p + place.q * place.q)));
    const Number turns = rational_near(abs(thread.travel) / thread.lead);
    // An entry and a run-out are no more than one turn each; the helices may begin anywhere.
    most_quarters_ = thread.passes() * (turns.ceil() + 3) * 4;
    least_quarters_ = (thread.passes() * turns - thread.passes()) * 4;
  }

  std::string_view take(const Event& piece) {
    const Number slack = terms_.tolerance + piece.width;
    const Number& height = piece.to[axes_.d];
    if (height < low_ - slack || height > high_ + slack) {
      return "The tool leaves the heights of the thread.";
    }
    const Winding::Offset to = offset_of(piece.to);
    const Number outer = farthest_ + terms_.tolerance * 17 / 8 + piece.width;
    if (to.p * to.p + to.q * to.q > outer * outer) return "The tool goes away from the work.";
    if (terms_.compare_blocks && piece.block != thread_.block)
      return "The motion is of another line.";
    if (piece.part == Part::traverse) {
      winding_.leave();
      base_ = height;
      return goes_inward(piece, slack) ? "A traverse goes toward the work." : std::string_view();
    }
    return take_cut(piece, to);
  }

  bool may_be_over(const Position& place) const {
    return abs(place[axes_.d] - rational_near(thread_.r_plane)) <= terms_.tolerance &&
           Number(winding_.quarters()) >= least_quarters_;
  }

 private:
  Winding::Offset offset_of(const Position& place) const {
    return {place[axes_.p] - middle_.p, place[axes_.q] - middle_.q};
  }

  // Away is from an external thread outward, from an internal one inward.
  bool goes_inward(const Event& piece, const Number& slack) const {
    const Winding::Offset from = offset_of(piece.from);
    const Winding::Offset to = offset_of(piece.to);
    if (thread_.external) {
      return from.p * (to.p - from.p) + from.q * (to.q - from.q) <
             -slack * (abs(from.p) + abs(from.q));
    }
    const Number most = max(abs(from.p), abs(from.q)) + slack;
    return abs(to.p) > most || abs(to.q) > most;
  }

  bool is_in_material(const Position& place, const Number& slack) const {
    const Winding::Offset at = offset_of(place);
    const Number start = rational_near(thread_.start_radius);
    const Number limit = thread_.external ? start - slack * 2 : start + slack * 2;
    const Number distance_2 = at.p * at.p + at.q * at.q;
    return thread_.external ? limit.sign() > 0 && distance_2 < limit * limit
                            : distance_2 > limit * limit;
  }

  // Whether it rises in the material, beside its groove, by more than a lead: as it moves in the
  // plane, at any of 32 places of the piece.
  bool cuts_crest(const Event& piece, const Number& slack) {
    const int up = (rational_near(thread_.r_plane) - rational_near(thread_.bottom)).sign();
    const Number rise = (piece.to[axes_.d] - piece.from[axes_.d]) * up;
    if (rise.sign() <= 0) base_ = piece.to[axes_.d];
    const bool moves = way_of(piece, axes_.p) + way_of(piece, axes_.q) > slack * 4;
    if (rise.sign() <= 0 || !moves || !base_) return false;
    constexpr int kPlaces = 32;
    for (int k = 1; k <= kPlaces; ++k) {
      Position at = piece.from;
      for (const reference::Axis axis : reference::kAllAxes) {
        at[axis] += (piece.to[axis] - piece.from[axis]) * k / kPlaces;
      }
      const Number risen = (at[axes_.d] - *base_) * up;
      if (risen > rational_near(thread_.lead) + slack * 2 && is_in_material(at, slack)) return true;
    }
    return false;
  }

  std::string_view take_cut(const Event& piece, const Winding::Offset& to) {
    const Label& label = *piece.label;
    const bool is_its_own = (label.kind == RecordKind::feed || label.kind == RecordKind::arc) &&
                            label.feed_mode == thread_.feed_mode &&
                            agree(thread_.feed, label.feed, terms_.feed_resolution, terms_);
    if (!is_its_own) return "The motion is of another kind or feed.";
    // The first entry comes from the middle, at the R plane.
    const Number inner = nearest_ - terms_.tolerance * 17 / 8 - piece.width;
    const bool is_below =
        abs(piece.to[axes_.d] - rational_near(thread_.r_plane)) > terms_.tolerance + piece.width;
    if (is_below && inner.sign() > 0 && to.p * to.p + to.q * to.q < inner * inner) {
      return "The cut is deeper than the last pass.";
    }
    if (cuts_crest(piece, terms_.tolerance + piece.width)) return "The cut rises in the material.";
    winding_.take(to);
    if (winding_.goes_back()) return "The cut goes round the axis the other way.";
    return Number(winding_.quarters()) > most_quarters_
               ? "The cut makes more turns than the passes need."
               : std::string_view();
  }

  const ThreadMilling& thread_;
  const Terms& terms_;
  reference::PlaneAxes axes_;
  Winding::Offset middle_;
  Number low_;
  Number high_;
  Winding winding_;
  std::optional<Number> base_;  // from where the tool rises
  Number nearest_;
  Number farthest_;
  Number most_quarters_;
  Number least_quarters_;
};

}  // namespace

StepAnswer follow(const ThreadMilling& thread, SubjectSide& subject, std::size_t begin,
                  const Terms& terms) {
  ThreadConditions conditions(thread, subject.at(begin).from, terms);
  return follow_under(conditions, subject, begin, terms.tolerance);
}

}  // namespace gonogo::relation
