// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/thread_site.hpp"

#include "oracle/relation/near.hpp"
#include "reference/geometry/kernel.hpp"

namespace gonogo::relation {

using reference::RecordKind;
using reference::ThreadMilling;
using reference::ThreadRunOut;

namespace {

constexpr int kWholeTurn = 360;

Number within_turn(const Number& degrees) {
  return degrees - (degrees / kWholeTurn).floor() * kWholeTurn;
}

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
      angle_(within_turn(rational_near(thread.runout_angle))),
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

bool ThreadSite::is_unfit(std::int64_t number) const {
  if (run_out_.sign() == 0) return false;
  const Number radius = radius_of_pass(number);
  const Offset end = ends_of_run_out({radius, 0}).front();
  const bool is_polar =
      thread_.runout == ThreadRunOut::open || thread_.runout == ThreadRunOut::polar;
  const Number off = slack_.round(0);
  return is_deeper(is_polar ? end : Offset{radius, 0}, end, radius, off) ||
         is_deeper(end, end, kept_of(number), off);
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

bool ThreadSite::are_chords(const std::vector<Offset>& places) const {
  if (places.size() < 3) return false;
  const std::size_t last = places.size() - 1;
  const auto point = [&](std::size_t i) { return geometry::Point_2(places[i].p, places[i].q); };
  for (const auto& [i, k] : {std::pair(last / 2, last), std::pair(last / 3, last - last / 3)}) {
    if (CGAL::collinear(point(0), point(i), point(k))) continue;
    const geometry::Point_2 centre = CGAL::circumcenter(point(0), point(i), point(k));
    if (are_chords_about({centre.x(), centre.y()}, places)) return true;
  }
  return false;
}

bool ThreadSite::are_chords_about(const Offset& centre, const std::vector<Offset>& places) const {
  const Number radius = rational_near(sqrt((places[0] - centre).square()));
  const Number off = slack_.round(0);
  const int sense = across(places[0] - centre, places[1] - centre).sign();
  Winding winding(sense, 0);
  winding.take(places[0] - centre);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Offset from = places[i - 1] - centre;
    const Offset to = places[i] - centre;
    if (across(from, to).sign() != sense || leads_beyond(to, to, radius + off) ||
        leads_within(from, to, radius - off - tolerances_.chord)) {
      return false;
    }
    winding.take(to);
  }
  return sense != 0 && winding.quarters() <= 4;
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
    const Offset way = turned(within_turn(degrees), run_out_);
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

Number ThreadSite::farthest_of_run_out(const Number& radius) const {
  const Number end = radius + run_out_;
  const Number cosine = rational_near(exact::cos_degrees(angle_));
  const Number a = end * cosine - radius;
  if (angle_ <= Number(kWholeTurn / 2) || a.sign() == 0) return end;
  // Its centre is on the radius of the start, as far from there as from the end.
  const Number twice = (radius * radius + end * end - radius * end * cosine * 2) / a;
  return max(end, abs(radius + twice));
}

std::string_view ThreadSite::broken_height(const Event& piece) const {
  const Number off = slack_.axis(piece.width);
  const Number low = height_of(piece.from);
  const Number high = height_of(piece.to);
  if (high < low - off || high < -off) return "The run-out goes down.";
  if (high > abs(top_ - bottom_) + off) return "The run-out leaves the heights of the thread.";
  const Number allowed = lead_ * min(angle_, Number(kWholeTurn) - angle_) / kWholeTurn + off;
  if (high <= allowed) return {};
  // What lies above.
  const Number part = low >= allowed ? Number(0) : (allowed - low) / (high - low);
  const Offset from = offset_of(point_at(piece, part));
  return is_deeper(from, offset_of(piece.to), start_, slack_.round(piece.width))
             ? "The run-out rises in the material."
             : "";
}

std::string_view Arcs::take(const Event& piece) {
  const int sense = sense_of(piece, site_.axes_);
  if (sense * sense_ < 0) return "An arc turns the other way.";
  const Offset from = site_.offset_of(piece.from);
  const Offset to = site_.offset_of(piece.to);
  if (sense != 0 && piece.source().kind == RecordKind::arc) {
    const Offset centre = site_.centre_of(piece);
    const Offset arm = from - centre;
    // The angle between the arms of two arcs of one sense is that of their corner.
    const Number size = abs(arm_.p) + abs(arm_.q) + abs(arm.p) + abs(arm.q);
    if (along(arm_, arm) < -size * site_.slack_.round(0)) return "An arc turns back.";
    arm_ = to - centre;
  }
  if (sense_ == 0 && sense != 0) directions_ = Winding(sense, 0);
  if (sense != 0) sense_ = sense;
  if (sense_ != 0) directions_.take(to - from);
  return directions_.quarters() > 4 ? "The step turns more than once." : "";
}

}  // namespace gonogo::relation
