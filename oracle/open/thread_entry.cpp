// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_entry.hpp"

#include <algorithm>

#include "oracle/motion/chords.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

constexpr const char* kManyPieces = "The entry has more than 50,000 pieces.";
constexpr const char* kDeepInfeed = "The infeed goes deeper than its pass.";

}  // namespace

void ThreadEntry::begin(const Position& from, const Number& pass) {
  const reference::ThreadMilling& item = geometry_.item();
  radius_ = item.radius_of_pass(pass);
  reached_ = pass > 1 ? item.radius_of_pass(pass - 1) : item.start_radius;
  stands_ = from;
  from_ = near_rational(geometry_.from_axis(from));
  const Number away = exact::sqrt(norm_squared(from_));
  reach_ = item.external ? max(geometry_.reach(), away + item.tool_radius * 2) : reached_;
  sense_ = 0;
  swept_ = {};
  far_.clear();
  points_ = {from_};
  departure_.clear();
}

ThreadEntry::Taken ThreadEntry::add(const Motion& motion) {
  if (!departure_.empty()) return Taken::departs;
  const Number& tau = geometry_.tolerances().tolerance;
  const bool stays = agree(motion.from, motion.to(), tau) && agree(motion.to(), stands_, tau);
  if (stays && !nearly_full_turn(motion)) return Taken::nothing;
  std::optional<std::string> fault;
  switch (motion.record.kind) {
    case RecordKind::arc:
      fault = add_arc(motion);
      break;
    case RecordKind::feed:
      fault = add_line(motion);
      break;
    default:
      fault = wrong_traverse();
      break;
  }
  stands_ = motion.to();
  if (!fault) return Taken::progress;
  departure_ = *std::move(fault);
  return Taken::departs;
}

std::optional<std::string> ThreadEntry::wrong_traverse() const {
  if (points_.size() > 1) return "A traverse follows the infeed, where the helix is due.";
  if (sense_ != 0) return "A traverse follows the entry arc, where the infeed is due.";
  return "The entry arc is missing: a traverse stands where the arc to the start of the thread is "
         "due.";
}

// J-THR-02
std::optional<std::string> ThreadEntry::add_arc(const Motion& motion) {
  const Record& record = motion.record;
  if (record.plane != geometry_.item().plane) return "The entry arc lies in another plane.";
  if (points_.size() > 1) return "An arc follows the infeed, where the helix is due.";
  const int sense = record.rot < 0 ? -1 : 1;
  const PlaneVector begin = from_centre(record, motion.from);
  const PlaneVector end = from_centre(record, motion.to());
  if (is_seen(begin) || is_seen(end)) {
    const bool is_on = sense_ == 0 || (sense == sense_ && dot(end_arm_, begin).sign() >= 0);
    if (!is_on) return "The entry turns back.";
    sense_ = sense;
    end_arm_ = end;
  }
  swept_.add(approximate_turns(motion));
  const double beyond = estimate(geometry_.tolerances().tolerance * 2);
  if (swept_.exceed_a_turn(beyond, estimate_length(end))) {
    return "The entry turns round more than once.";
  }
  if (!is_inside(motion)) {
    if (!geometry_.item().external) return "The entry goes through the wall of the bore.";
    if (far_.size() >= kMostMotions) return kManyPieces;
    far_.push_back(motion);
  }
  points_ = {near_rational(geometry_.from_axis(motion.to()))};
  return std::nullopt;
}

// R3: what keeps to its centre within the tolerance turns no way.
bool ThreadEntry::is_seen(const PlaneVector& arm) const {
  const Number& tau = geometry_.tolerances().tolerance;
  return visible_sign(norm_squared(arm) - tau * tau) > 0;
}

bool ThreadEntry::is_inside(const Motion& motion) const {
  const Clearance inside = geometry_.within(motion, reach_);
  if (inside.kind == Clearance::Kind::undecided) {
    throw exact::Undecided("whether an arc of the entry stays in its region is not decided");
  }
  return inside.kind == Clearance::Kind::clear;
}

// J-THR-02. `start`: of the infeed, behind the chords.
bool ThreadEntry::leaves_region(const PlaneVector& start,
                                std::span<const PlaneVector> chords) const {
  if (!is_inside(line(start, start))) return true;
  const auto leaves = [&](const Motion& motion) {
    return !geometry_.item().external ||
           geometry_.within_chord(motion, from_, start).kind != Clearance::Kind::clear;
  };
  return std::ranges::any_of(far_, leaves) ||
         std::ranges::any_of(chords, [&](const PlaneVector& end) {
           const Motion there = line(end, end);
           return !is_inside(there) && leaves(there);
         });
}

Motion ThreadEntry::line(const PlaneVector& from, const PlaneVector& to) const {
  Motion motion;
  motion.record.kind = RecordKind::feed;
  motion.from = at(from);
  motion.record.to = at(to);
  return motion;
}

std::optional<std::string> ThreadEntry::add_line(const Motion& motion) {
  if (points_.size() >= kMostMotions) return kManyPieces;
  points_.push_back(near_rational(geometry_.from_axis(motion.to())));
  return std::nullopt;
}

std::optional<std::string> ThreadEntry::fault_before_helix(const Position& here) const {
  if (!departure_.empty()) return departure_;
  const PlaneVector end = near_rational(geometry_.from_axis(here));
  // The last cut is the infeed; or the last of several in one line; or it is too small to see.
  const std::size_t last = points_.size() - 1;
  std::optional<std::string> fault = fault_of(last == 0 ? 0 : last - 1, end);
  if (!fault || last == 0) return fault;
  const Number twice = geometry_.tolerances().tolerance * 2;
  std::size_t first = last - 1;
  while (first > 0 && lie_along_a_line(std::span(points_).subspan(first - 1), twice)) --first;
  if (first != last - 1 && !fault_of(first, end)) return std::nullopt;
  if (chords_granted() && !fault_of(last, end)) return std::nullopt;
  return fault;
}

bool ThreadEntry::on_start_circle(const PlaneVector& at_start) const {
  return geometry_.on_circle(at(at_start), geometry_.item().start_radius);
}

// With the infeed from this one of the points.
std::optional<std::string> ThreadEntry::fault_of(std::size_t infeed,
                                                 const PlaneVector& here) const {
  const Tolerances& tolerances = geometry_.tolerances();
  const Number twice = tolerances.tolerance * 2;
  const std::span<const PlaneVector> points(points_);
  if (infeed > 0) {
    // J-THR-01: chords where they are granted.
    const bool chords = chords_granted() && sense_ == 0 &&
                        are_chords_of_an_arc(points.first(infeed + 1), twice,
                                             tolerances.tolerance + tolerances.chord);
    const bool needs_arc = sense_ == 0 && !on_start_circle(points[0]);
    if (!chords && needs_arc) {
      return "The entry is no arc: straight cuts lead to the start of the thread.";
    }
    if (!chords) return bent_infeed(here);
  } else if (sense_ == 0 && !on_start_circle(points[0])) {
    return "The entry arc is missing.";
  }
  if (!geometry_.is_free(at(points[infeed]), reached_)) return "The infeed is missing.";
  if (leaves_region(points[infeed], points.first(infeed))) {
    return geometry_.item().external
               ? "The entry leads farther from the part than the safe position and a tool's "
                 "diameter beside it."
               : "The entry goes through the wall of the bore.";
  }
  if (is_deep(points[infeed], here)) return kDeepInfeed;
  return std::nullopt;
}

// What is said of several cuts from the end of the entry, which are not one line.
std::string ThreadEntry::bent_infeed(const PlaneVector& here) const {
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    if (is_deep(points_[i], points_[i + 1])) return kDeepInfeed;
  }
  if (is_deep(points_.back(), here)) return kDeepInfeed;
  return "The infeed is not one straight cut.";
}

bool ThreadEntry::is_deep(const PlaneVector& from, const PlaneVector& to) const {
  return geometry_.clearance(line(from, to), radius_).kind != Clearance::Kind::clear;
}

}  // namespace gonogo::oracle
