// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/thread_site.hpp"

#include "oracle/relation/near.hpp"

namespace gonogo::relation {

using reference::RecordKind;
using reference::ThreadMilling;
using reference::ThreadRunOut;

namespace {

constexpr int kWholeTurn = 360;

// Whether the line between two places leads farther from the axis, or nearer to it.
bool leads_beyond(const Offset& from, const Offset& to, const Number& radius) {
  return radius.sign() < 0 || max(from.square(), to.square()) > radius * radius;
}
bool leads_within(const Offset& from, const Offset& to, const Number& radius) {
  return radius.sign() > 0 && nearest_square(from, to) < radius * radius;
}

}  // namespace

ThreadSite::ThreadSite(const ThreadMilling& thread, const Followed& way)
    : thread_(thread),
      tolerances_(way.tolerances),
      slack_(way.slack),
      begin_place_(way.subject.at(way.begin).from),
      axes_(reference::axes_of(thread.plane)),
      middle_{rational_near(thread.centre[0]), rational_near(thread.centre[1])},
      top_(rational_near(thread.r_plane)),
      bottom_(rational_near(thread.bottom)),
      up_((top_ - bottom_).sign()),
      free_(thread.external ? 1 : -1),
      start_(rational_near(thread.start_radius)),
      run_out_(rational_near(thread.runout_length)),
      lead_(rational_near(thread.lead)) {}

std::string_view ThreadSite::words_of(const Event& piece, bool may_traverse) const {
  if (moves_another_axis(piece, begin_place_, axes_, slack_.axis(piece.width))) {
    return "Another axis moves.";
  }
  if (tolerances_.compare_blocks && piece.block != thread_.block) {
    return "The motion is of another line.";
  }
  if (piece.part == Part::traverse) return may_traverse ? "" : "A traverse stands for a cut.";
  const Label& label = *piece.label;
  const bool cuts = label.kind == RecordKind::feed || label.kind == RecordKind::arc;
  const bool has_feed = label.feed_mode == thread_.feed_mode &&
                        agree(thread_.feed, label.feed, tolerances_.feed_resolution, tolerances_);
  return cuts && has_feed ? "" : "The motion is of another kind or feed.";
}

bool ThreadSite::is_on(const Offset& at, const Number& radius, const Number& off) {
  const Number low = max(radius - off, 0);
  return at.square() >= low * low && at.square() <= (radius + off) * (radius + off);
}

bool ThreadSite::is_deeper(const Offset& from, const Offset& to, const Number& radius,
                           const Number& off) const {
  return free_ > 0 ? leads_within(from, to, radius - off) : leads_beyond(from, to, radius + off);
}

bool ThreadSite::is_deeper(const Event& piece, const Number& radius) const {
  return is_deeper(offset_of(piece.from), offset_of(piece.to), radius, slack_.round(piece.width));
}

bool ThreadSite::is_beyond(const Event& piece, const Number& radius) const {
  return leads_beyond(offset_of(piece.from), offset_of(piece.to),
                      radius + slack_.round(piece.width));
}

Number ThreadSite::radius_of_pass(std::int64_t number) const {
  return number == 0 ? start_ : rational_near(thread_.radius_of_pass(Number(number)));
}

Number ThreadSite::kept_of(std::int64_t number) const {
  const Number depth = rational_near(thread_.depth_of_pass(Number(number)));
  return run_out_ < depth ? radius_of_pass(number) : start_;
}

bool ThreadSite::is_safe(const Position& place) const {
  const Offset at = offset_of(place);
  const Number off = slack_.round(0);
  const Number safe = start_ + run_out_ * free_;
  if (free_ < 0) return abs(at.p) <= abs(safe) + off;
  const Number least = max(safe - off, 0);
  return at.square() >= least * least;
}

bool ThreadSite::turns_aside(const Offset& begin, const Offset& from, const Offset& to) const {
  const Offset first = from - begin;
  const Offset all = to - begin;
  const Number off = tolerances_.tolerance * 3;
  const Number aside = across(first, all);
  return along(first, to - from) < -off * off || aside * aside > off * off * all.square();
}

std::vector<Offset> ThreadSite::ends_of_run_out(const Offset& from) const {
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
    const Number degrees = free_ > 0 ? from_normal : Number(kWholeTurn / 2) - from_normal;
    const Number turns = (degrees / kWholeTurn).floor();
    const Offset way = turned(degrees - turns * kWholeTurn, run_out_);
    return Offset{from.p + way.p, from.q + way.q};
  };
  const auto is = [&](ThreadRunOut one) {
    return thread_.runout == ThreadRunOut::open || thread_.runout == one;
  };
  const Number& k = thread_.runout_angle;
  std::vector<Offset> ends;
  if (is(ThreadRunOut::polar)) {
    ends.push_back(turned(k, radius + run_out_ * free_));
    if (free_ < 0 && run_out_ > radius) ends.push_back(turned(k, 0));
  }
  if (is(ThreadRunOut::radial)) ends.push_back(straight(k));
  if (is(ThreadRunOut::tangent)) ends.push_back(straight(Number(kWholeTurn / 4) - k));
  return ends;
}

std::string_view ThreadSite::broken_height(const Event& piece) const {
  const Number off = slack_.axis(piece.width);
  const Number low = height_of(piece.from);
  const Number high = height_of(piece.to);
  if (high < low - off || high < -off) return "The run-out goes down.";
  if (high > abs(top_ - bottom_) + off) return "The run-out leaves the heights of the thread.";
  const Number angle = rational_near(thread_.runout_angle);
  const Number allowed = lead_ * min(angle, Number(kWholeTurn) - angle) / kWholeTurn + off;
  if (high <= allowed) return {};
  // What lies above.
  const Number part = low >= allowed ? Number(0) : (allowed - low) / (high - low);
  const Offset from = offset_of(point_at(piece, part));
  return is_deeper(from, offset_of(piece.to), start_, slack_.round(piece.width))
             ? "The run-out rises in the material."
             : "";
}

}  // namespace gonogo::relation
