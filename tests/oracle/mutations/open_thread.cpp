// SPDX-License-Identifier: GPL-3.0-or-later
//
// A thread as GSK-G114-06 tells it: per pass an arc to the start, infeed, helix, run-out, back,
// away.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "open_parts.hpp"

namespace gonogo::mutations {
namespace {

using reference::PlaneAxes;
using reference::ThreadMilling;
using reference::ThreadRunOut;
using std::numbers::pi;

constexpr double kDegree = pi / 180;

class OpenThread : public OpenPart {
 public:
  explicit OpenThread(const ThreadMilling& thread)
      : thread_(thread),
        axes_(axes_of(thread.plane)),
        d_(index(axes_.d)),
        centre_{value_of(thread.centre[0]), value_of(thread.centre[1])},
        top_(value_of(thread.r_plane)),
        bottom_(value_of(thread.bottom)),
        up_(top_ < bottom_ ? -1 : 1),
        free_(thread.external ? 1 : -1),
        start_radius_(value_of(thread.start_radius)),
        run_out_(value_of(thread.runout_length)),
        angle_(value_of(thread.runout_angle) * kDegree),
        lead_(value_of(thread.lead)),
        beside_(2 * value_of(thread.tool_radius)),
        passes_(thread.passes().to_int64().value()) {}

  std::string broken_by(std::span<const Stroke> strokes, const Margin& margin) const override {
    // Too small to be told apart from none.
    const double small = 16 * margin.arc;
    if (std::abs(top_ - bottom_) <= small || value_of(thread_.lead) <= small ||
        start_radius_ <= small || value_of(thread_.infeed) <= small) {
      return "";
    }
    Reading reading{*this, strokes, margin};
    return reading.run();
  }

 private:
  // One reading of the motions, step by step.
  struct Reading {
    const OpenThread& of;
    std::span<const Stroke> strokes;
    const Margin& margin;
    std::size_t next = 0;
    std::int64_t pass = 1;
    double begun_at = 0;  // the helix of the pass, along p

    std::string run() {
      for (; pass <= of.passes_; ++pass) {
        for (auto step : {&Reading::entry, &Reading::helix, &Reading::run_out, &Reading::back,
                          &Reading::away}) {
          const std::string broken = (this->*step)();
          if (!broken.empty()) return broken;
        }
      }
      skip_nil();
      return next < strokes.size() ? "a motion after the last pass (GSK-G114-10)" : "";
    }

    double radius() const { return value_of(of.thread_.radius_of_pass(Number(pass))); }
    double at(const Place& place) const { return plane_radius(of.axes_, place, of.centre_); }
    bool at_top(const Place& place) const {
      return std::abs(place[of.d_] - of.top_) <= margin.place;
    }
    bool more() const { return next < strokes.size(); }
    const Stroke& stroke() const { return strokes[next]; }
    void skip_nil() {
      while (more() && stroke().is_nil(margin.nil)) ++next;
    }
    bool has_words() const {
      const Record& record = *stroke().record;
      return record.feed == of.thread_.feed && record.feed_mode == of.thread_.feed_mode;
    }

    // J-THR-02. How far from the axis the motions of an entry that begins at `from` may lead, and a
    // half more: a semicircle on a chord leaves the circle of its ends by less than that.
    double widest(const Place& from, bool is_round) const {
      constexpr double kMore = 1.5;
      if (of.free_ > 0) {
        return kMore * std::max(of.start_radius_ + of.run_out_, at(from)) + of.beside_;
      }
      // From the middle of a bore nothing leads through its wall.
      if (pass == 1 && at(from) <= margin.arc) {
        return (is_round ? of.start_radius_ : radius()) + 3 * margin.arc;
      }
      return kMore * std::max(radius(), at(from));
    }

    std::string excursion_of_entry(const Stroke& motion, const Place& begin) const {
      constexpr int kParts = 64;
      for (int i = 1; i <= kParts; ++i) {
        if (at(motion.at(static_cast<double>(i) / kParts)) > widest(begin, motion.is_round)) {
          return "the entry leads far from the part or through the wall (GSK-CYC-01)";
        }
      }
      return "";
    }

    // At the R plane, with an arc at least in the first pass, to the radius of the pass.
    std::string entry() {
      bool turned = false;
      double swept = 0;
      const Place begin = next > 0 ? strokes[next - 1].to : strokes[0].from;
      for (skip_nil(); more() && at_top(stroke().to); ++next, skip_nil()) {
        const Stroke& motion = stroke();
        if (motion.is_dwell()) return "a dwell";
        if (!at_top(motion.from)) return "a motion from elsewhere to the R plane before the pass";
        turned = turned || motion.is_round;
        if (motion.is_round) swept += std::abs(motion.sweep);
        if (swept > 2 * pi + 0.1) return "the entry turns more than once";
        if (std::string broken = excursion_of_entry(motion, begin); !broken.empty()) return broken;
        if (motion.kind() == RecordKind::rapid) {
          if (pass == 1) return "a traverse in place of the entry arc (GSK-G114-10)";
          if (of.free_ * (at(motion.to) - of.start_radius_) < -margin.arc) {
            return "a traverse nearer to the thread than its start (GSK-G114-10)";
          }
        } else if (!has_words()) {
          return "another feed";
        }
      }
      if (pass == 1 && !turned && of.start_radius_ > margin.arc) {
        return "no entry arc (GSK-G114-06)";
      }
      return "";
    }

    std::string helix() {
      if (!more()) return "a pass is missing (GSK-G114-04)";
      const double r = radius();
      const double slope = 2 * pi / value_of(of.thread_.lead);  // radians a mm of depth
      double turned = 0;
      const double whole = std::abs(of.top_ - of.bottom_) * slope;
      const double slack = 4 * margin.arc * slope + 4 * margin.arc / std::max(r, margin.arc) + 1e-6;
      if (std::abs(at(stroke().from) - r) > margin.arc) return "the helix begins at another radius";
      if (!at_top(stroke().from)) return "the helix begins at another height";
      begun_at = stroke().from[index(of.axes_.p)] - of.centre_[0];
      for (; more() && whole - turned > slack; ++next) {
        const Stroke& motion = stroke();
        if (motion.is_nil(margin.nil)) continue;
        if (motion.kind() != RecordKind::arc || motion.record->plane != of.thread_.plane) {
          return "no helix";
        }
        if (!has_words()) return "another feed";
        if ((motion.record->rot < 0) != (of.thread_.sense < 0))
          return "the other hand (GSK-G114-09)";
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
          if (std::abs(value_of(motion.record->centre[i]) - of.centre_[i]) > margin.arc) {
            return "the helix has another centre";
          }
        }
        if (std::abs(at(motion.to) - r) > margin.arc) return "the helix has another radius";
        const double fall = of.up_ * (motion.from[of.d_] - motion.to[of.d_]);
        double sweep = std::abs(motion.sweep);
        // A turn whose ends nearly meet may be none, and none one.
        const double off = std::remainder(sweep - fall * slope, 2 * pi);
        if (std::abs(off) > slack) return "another lead";
        if (std::abs(sweep - off - fall * slope) > slack) {
          const double nearly = std::abs(std::remainder(sweep, 2 * pi));
          if (nearly > slack || std::abs(sweep - fall * slope) > 2 * pi + slack) {
            return "another lead";
          }
          sweep = fall * slope;
        }
        turned += sweep;
        if (turned > whole + slack) return "turns beyond the bottom";
      }
      if (whole - turned > slack) return "the helix ends early";
      const Place& end = strokes[next > 0 ? next - 1 : 0].to;
      if (std::abs(end[of.d_] - of.bottom_) > margin.place)
        return "the helix ends at another depth";
      return "";
    }

    // Where the run-outs end, from the end of the helix.
    std::array<std::array<double, 2>, 4> run_out_ends(const Place& from) const {
      const double p = from[index(of.axes_.p)] - of.centre_[0];
      const double q = from[index(of.axes_.q)] - of.centre_[1];
      const double theta = std::atan2(q, p);
      const double r = std::hypot(p, q);
      const double sense = of.thread_.sense;
      const auto polar = [&](double reach) {
        const double angle = theta + sense * of.angle_;
        const double length = r + of.free_ * reach;
        return std::array{of.centre_[0] + length * std::cos(angle),
                          of.centre_[1] + length * std::sin(angle)};
      };
      const auto straight = [&](double from_normal) {
        const double angle =
            of.free_ > 0 ? theta + sense * from_normal : theta + sense * (pi - from_normal);
        return std::array{from[index(of.axes_.p)] + of.run_out_ * std::cos(angle),
                          from[index(of.axes_.q)] + of.run_out_ * std::sin(angle)};
      };
      return {polar(of.run_out_), polar(of.free_ > 0 ? of.run_out_ : std::min(of.run_out_, r)),
              straight(of.angle_), straight(pi / 2 - of.angle_)};
    }

    // J-THR-05: higher than the groove leads while it is in the material.
    bool rises_in_material(const Stroke& motion) const {
      constexpr int kParts = 64;
      const double allowed = of.lead_ * std::abs(std::remainder(of.angle_, 2 * pi)) / (2 * pi);
      for (int i = 1; i <= kParts; ++i) {
        const Place place = motion.at(static_cast<double>(i) / kParts);
        const double rise = of.up_ * (place[of.d_] - of.bottom_);
        const double inside = of.free_ * (of.start_radius_ - at(place));
        if (rise > allowed + 2 * margin.place && inside > 3 * margin.arc) return true;
      }
      return false;
    }

    std::string run_out() {
      skip_nil();
      const Place from = next > 0 ? strokes[next - 1].to : strokes[0].from;
      Place end = from;
      double turned = 0;
      std::size_t count = 0;
      for (; more() && stroke().kind() != RecordKind::rapid; ++next) {
        const Stroke& motion = stroke();
        if (motion.is_nil(margin.nil)) continue;
        if (motion.is_dwell()) return "a dwell";
        const bool in_plane =
            std::abs(motion.to[index(of.axes_.p)] - motion.from[index(of.axes_.p)]) > margin.arc ||
            std::abs(motion.to[index(of.axes_.q)] - motion.from[index(of.axes_.q)]) > margin.arc ||
            motion.is_round;
        if (!in_plane) break;  // the way back, as a cut
        if (!has_words()) return "another feed";
        if (of.up_ * (motion.to[of.d_] - of.bottom_) < -margin.place) return "below the bottom";
        if (of.up_ * (motion.to[of.d_] - of.top_) > margin.place) return "above the R plane";
        for (const double part : {0.25, 0.5, 0.75, 1.0}) {
          if (of.free_ * (at(motion.at(part)) - radius()) < -2 * margin.arc) {
            return "deeper than the pass (GSK-G114-10)";
          }
        }
        if (rises_in_material(motion)) return "the run-out rises out of its groove (GSK-G114-11)";
        if (motion.is_round) turned += std::abs(motion.sweep);
        end = motion.to;
        ++count;
      }
      if (of.run_out_ == 0) return count > 0 ? "a run-out though J is 0 (GSK-G114-11)" : "";
      if (turned > 2 * pi + 0.1) return "a run-out of more than a turn (GSK-G114-11)";
      const double near = 3 * margin.arc + std::abs(of.run_out_) * 1e-9;
      const auto is_end = [&](const std::array<double, 2>& right) {
        return std::abs(end[index(of.axes_.p)] - right[0]) <= near &&
               std::abs(end[index(of.axes_.q)] - right[1]) <= near;
      };
      if (!std::ranges::any_of(run_out_ends(from), is_end)) {
        return "the run-out ends nowhere that J and K lead to (GSK-G114-11)";
      }
      return "";
    }

    std::string back() {
      skip_nil();
      if (!more()) return "no way back to the R plane (GSK-G114-10)";
      const Place foot = stroke().from;
      if (at_top(foot)) return "";
      for (; more(); ++next) {
        const Stroke& motion = stroke();
        if (motion.is_nil(margin.nil)) continue;
        for (const double part : {0.25, 0.5, 0.75, 1.0}) {
          const Place place = motion.at(part);
          if (std::abs(place[index(of.axes_.p)] - foot[index(of.axes_.p)]) > margin.arc ||
              std::abs(place[index(of.axes_.q)] - foot[index(of.axes_.q)]) > margin.arc) {
            return "the way back leads aside (GSK-G114-10)";
          }
        }
        if (motion.is_round || motion.is_dwell())
          return "the way back turns or rests (GSK-G114-10)";
        if (of.up_ * (motion.to[of.d_] - motion.from[of.d_]) < -margin.place) {
          return "the way back leads down again (GSK-G114-10)";
        }
        if (of.up_ * (motion.to[of.d_] - of.top_) > margin.place) return "above the R plane";
        if (at_top(motion.to)) {
          ++next;
          return "";
        }
      }
      return "the way back ends below the R plane (GSK-G114-10)";
    }

    // J-THR-06, for a bolt: farther than a tool's diameter beside the safe position; or through the
    // part, but to the side where the helix began.
    std::string excursion_of_away(const Stroke& motion) const {
      if (of.free_ < 0) return "";
      const double from = motion.from[index(of.axes_.p)] - of.centre_[0];
      const double to = motion.to[index(of.axes_.p)] - of.centre_[0];
      const double aside = motion.to[index(of.axes_.q)] - of.centre_[1];
      const double safe = of.start_radius_ + of.run_out_;
      if (std::abs(to) > safe + of.beside_ + margin.arc) {
        return "the safe position is far out (GSK-CYC-01)";
      }
      if (std::abs(to - std::copysign(safe, begun_at)) <= 2 * margin.arc) return "";
      const double nearest = from * to < 0
                                 ? std::abs(aside)
                                 : std::hypot(std::min(std::abs(from), std::abs(to)), aside);
      const double depth = value_of(of.thread_.depth_of_pass(Number(pass)));
      const double kept = of.run_out_ >= depth ? of.start_radius_ : radius();
      return nearest < kept - 4 * margin.arc ? "away through the part (GSK-G114-10)" : "";
    }

    std::string away() {
      skip_nil();
      const double safe = of.start_radius_ + of.free_ * of.run_out_;
      const Place from = next > 0 ? strokes[next - 1].to : strokes[0].from;
      // In a bore the place on the other side of the axis is as free; and the way leads along p
      // alone, wherever along q the run-out ended.
      const auto is_safe = [&](const Place& place) {
        if (of.free_ > 0) return at(place) >= safe - margin.arc;
        return std::abs(place[index(of.axes_.p)] - of.centre_[0]) <= std::abs(safe) + margin.arc;
      };
      if (is_safe(from) && !(more() && stroke().kind() == RecordKind::rapid)) return "";
      for (; more() && stroke().kind() != RecordKind::arc; ++next) {
        const Stroke& motion = stroke();
        if (motion.is_nil(margin.nil)) continue;
        if (motion.is_dwell()) return "a dwell";
        if (!at_top(motion.to)) return "the way to the safe position leaves the R plane";
        if (std::abs(motion.to[index(of.axes_.q)] - motion.from[index(of.axes_.q)]) > margin.arc) {
          return "the way to the safe position leads aside (GSK-G114-10)";
        }
        if (std::string broken = excursion_of_away(motion); !broken.empty()) return broken;
        if (is_safe(motion.to)) {
          ++next;
          return "";
        }
      }
      return is_safe(from) ? "" : "no move to the safe position (GSK-G114-06)";
    }
  };

  const ThreadMilling thread_;
  PlaneAxes axes_;
  std::size_t d_;
  std::array<double, 2> centre_;
  double top_;
  double bottom_;
  double up_;
  double free_;
  double start_radius_;
  double run_out_;
  double angle_;
  double lead_;
  double beside_;  // a tool's diameter
  std::int64_t passes_;
};

}  // namespace

std::shared_ptr<const OpenPart> open_thread(const ThreadMilling& thread) {
  return std::make_shared<OpenThread>(thread);
}

}  // namespace gonogo::mutations
