// SPDX-License-Identifier: GPL-3.0-or-later
//
// The independent look: angles and square roots as they come, nothing shared with the judge.
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "tests/oracle/region/naive.hpp"
#include "tests/oracle/region/paths.hpp"

namespace gonogo::oracle::region {

double approximate(const Number& value) {
  return std::stod(value.decimal_text(15));
}

namespace {

// In doubles, relative to the pocket's centre.
struct PlainArc {
  double cx, cy;
  double start, turn;  // radians, turn signed
  double r0, r1;

  double distance(double x, double y) const {
    const double d = std::hypot(x - cx, y - cy);
    const double angle = std::atan2(y - cy, x - cx);
    const double sign = turn < 0 ? -1 : 1;
    double ahead = std::fmod((angle - start) * sign, 2 * std::numbers::pi);
    if (ahead < 0) ahead += 2 * std::numbers::pi;
    double best = std::min(to_end(x, y, 0), to_end(x, y, 1));
    // For nearly circular arcs the nearest point lies along the ray.
    for (; ahead <= std::fabs(turn); ahead += 2 * std::numbers::pi) {
      best = std::min(best, std::fabs(d - (r0 + (r1 - r0) * ahead / std::fabs(turn))));
    }
    return best;
  }
  double to_end(double x, double y, double part) const {
    const double r = r0 + (r1 - r0) * part;
    const double angle = start + turn * part;
    return std::hypot(x - cx - r * std::cos(angle), y - cy - r * std::sin(angle));
  }
};

PlainArc plain(const LevelMotion& motion, const PlanePoint& middle) {
  const double cx = approximate(motion.centre.p - middle.p);
  const double cy = approximate(motion.centre.q - middle.q);
  const double ax = approximate(motion.from.p - motion.centre.p);
  const double ay = approximate(motion.from.q - motion.centre.q);
  const double bx = approximate(motion.to.p - motion.centre.p);
  const double by = approximate(motion.to.q - motion.centre.q);
  const double start = std::atan2(ay, ax);
  double turn = std::atan2(by, bx) - start;
  const double whole = motion.rot < 0 ? -2 * std::numbers::pi : 2 * std::numbers::pi;
  // Into (0, 360] degrees of the sense; ends closer than 0.002 are a whole turn.
  while (turn * whole <= 0) turn += whole;
  while (std::fabs(turn) > 2 * std::numbers::pi + 1e-12) turn -= whole;
  if (std::hypot(ax - bx, ay - by) < 0.002 && std::fabs(turn) < 1) turn += whole;
  turn += whole * (std::abs(motion.rot) - 1);
  return {cx, cy, start, turn, std::hypot(ax, ay), std::hypot(bx, by)};
}

struct PlainPath {
  double px, py;
  std::vector<PlainArc> arcs;

  explicit PlainPath(const Job& job)
      : px(approximate(job.level.plunge.p - job.level.centre.p)),
        py(approximate(job.level.plunge.q - job.level.centre.q)) {
    for (const LevelMotion& motion : job.motions) {
      if (motion.is_arc) arcs.push_back(plain(motion, job.level.centre));
    }
  }
  double distance(double x, double y) const {
    double best = std::hypot(x - px, y - py);
    for (const PlainArc& arc : arcs) best = std::min(best, arc.distance(x, y));
    return best;
  }
};

Number exact_norm(const Number& p, const Number& q) {
  return exact::sqrt(p * p + q * q);
}

// Whether the direction lies in the sweep, by quadrants and slopes counted from the start.
bool swept(const LevelMotion& motion, const Number& p, const Number& q) {
  if (motion.from == motion.to || std::abs(motion.rot) > 1) return true;
  const Number ap = motion.from.p - motion.centre.p;
  const Number aq = motion.from.q - motion.centre.q;
  const Number side = motion.rot > 0 ? 1 : -1;
  // Coordinates along the start direction and to the side that the arc turns to.
  const auto turned = [&](const Number& vp, const Number& vq) {
    return PlanePoint{ap * vp + aq * vq, side * (ap * vq - aq * vp)};
  };
  const PlanePoint v = turned(p, q);
  const PlanePoint b = turned(motion.to.p - motion.centre.p, motion.to.q - motion.centre.q);
  const auto lower = [](const PlanePoint& u) {
    return u.q.sign() < 0 || (u.q.sign() == 0 && u.p.sign() < 0);
  };
  if (lower(v) != lower(b)) return lower(b);
  return (v.p * b.q - v.q * b.p).sign() >= 0;
}

}  // namespace

Number exact_distance(const LevelMotion& motion, const PlanePoint& point) {
  const Number p = point.p - motion.centre.p;
  const Number q = point.q - motion.centre.q;
  if (swept(motion, p, q)) {
    return exact::abs(exact_norm(p, q) -
                      exact_norm(motion.from.p - motion.centre.p, motion.from.q - motion.centre.q));
  }
  const Number to_from = exact_norm(point.p - motion.from.p, point.q - motion.from.q);
  const Number to_to = exact_norm(point.p - motion.to.p, point.q - motion.to.q);
  return min(to_from, to_to);
}

bool is_round(const LevelMotion& motion) {
  const auto radius2 = [&motion](const PlanePoint& end) {
    const Number p = end.p - motion.centre.p;
    const Number q = end.q - motion.centre.q;
    return p * p + q * q;
  };
  return radius2(motion.from) == radius2(motion.to);
}

std::function<double(double x, double y)> rough_distance_to_arc(const LevelMotion& motion) {
  return [arc = plain(motion, {})](double x, double y) { return arc.distance(x, y); };
}

namespace {

// A place of the path, every so often.
struct Sample {
  double x, y;
  bool clears;
  std::size_t motion;
};

std::vector<Sample> samples_of(const Job& job, double stride) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < job.motions.size(); ++i) {
    const LevelMotion& motion = job.motions[i];
    // A leftover that may be a whole turn or nothing says nothing here.
    const double ends = std::hypot(approximate(motion.to.p - motion.from.p),
                                   approximate(motion.to.q - motion.from.q));
    if (motion.is_arc && ends < 0.002 && !(motion.from == motion.to)) continue;
    const auto put = [&](double x, double y) { samples.push_back({x, y, motion.is_arc, i}); };
    if (motion.is_arc) {
      const PlainArc arc = plain(motion, job.level.centre);
      const int count =
          1 + static_cast<int>(std::fabs(arc.turn) * std::max(arc.r0, arc.r1) / stride);
      for (int k = 0; k <= count; ++k) {
        const double part = double(k) / count;
        const double angle = arc.start + arc.turn * part;
        const double r = arc.r0 + (arc.r1 - arc.r0) * part;
        put(arc.cx + r * std::cos(angle), arc.cy + r * std::sin(angle));
      }
    } else {
      const PlanePoint from = motion.from - job.level.centre;
      const PlanePoint way = motion.to - motion.from;
      const double dx = approximate(way.p);
      const double dy = approximate(way.q);
      const int count = 1 + static_cast<int>(std::hypot(dx, dy) / stride);
      for (int k = 0; k <= count; ++k) {
        put(approximate(from.p) + dx * k / count, approximate(from.q) + dy * k / count);
      }
    }
  }
  return samples;
}

// J-PKT-05 by its words: whether something supports the sample within the reach.
bool is_supported(const std::vector<Sample>& samples, std::size_t which, double reach,
                  const CircularLevel& level) {
  const Sample& at = samples[which];
  const double px = approximate(level.plunge.p - level.centre.p);
  const double py = approximate(level.plunge.q - level.centre.q);
  if (std::hypot(at.x - px, at.y - py) <= reach) return true;
  const double step = approximate(level.step);
  double farthest = at.clears ? 0 : 1e9;  // since
  for (std::size_t k = which; k-- > 0;) {
    const Sample& before = samples[k];
    if (!at.clears && before.motion == at.motion) continue;
    const double apart = std::hypot(at.x - before.x, at.y - before.y);
    if (before.clears && apart <= reach && farthest > std::max(step, apart + 1e-9)) return true;
    farthest = std::max(farthest, apart);
  }
  return false;
}

std::string flaw_of_disorder(const Job& job, const Finding& finding, double x, double y) {
  const CircularLevel& level = job.level;
  const double reach = approximate(level.step + level.tolerance * Number(3));
  if (finding.deviation < level.tolerance * Number(3)) return "deviation is within the tolerance";
  const double stride = approximate(level.step) / 200;
  const std::vector<Sample> samples = samples_of(job, stride);
  std::size_t nearest = 0;
  double least = 1e9;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double apart = std::hypot(samples[k].x - x, samples[k].y - y);
    if (samples[k].motion != finding.record || apart >= least) continue;
    least = apart;
    nearest = k;
  }
  if (least > stride) return "not on the motion";
  // The sample lies beside the witness, and so do those beside what supports it.
  if (is_supported(samples, nearest, reach - 2 * stride, level)) return "is supported";
  return {};
}

std::string flaw_of_order(const Job& job) {
  const CircularLevel& level = job.level;
  const double stride = approximate(level.step) / 20;
  const double reach = approximate(level.step + level.tolerance * Number(3));
  const std::vector<Sample> samples = samples_of(job, stride);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    // Rounded up to the next sample; a place just back within reach needs no more.
    const double slack = stride * stride / reach + 1e-6;
    if (is_supported(samples, k, reach + slack, level)) continue;
    if (is_supported(samples, k, reach + 2 * stride, level)) continue;
    return fmt::format("order: {}, {}", samples[k].x, samples[k].y);
  }
  return {};
}

std::string flaw_of_hole(const Job& job, const Finding& finding) {
  const CircularLevel& level = job.level;
  const bool cover = finding.rule == Rule::cover;
  const Number radius = cover ? level.pocket_radius : level.pocket_radius - level.tool_radius;
  const Number reach = (cover ? level.tool_radius : level.step / Number(2)) + level.tolerance;
  const PlanePoint& w = finding.witness;
  if (exact_norm(w.p - level.centre.p, w.q - level.centre.q) > radius) return "not in the disc";
  Number least = exact_norm(w.p - level.plunge.p, w.q - level.plunge.q) - reach;
  bool spirals = false;
  for (const LevelMotion& motion : job.motions) {
    if (!motion.is_arc) continue;
    spirals = spirals || !is_round(motion);
    if (is_round(motion)) least = min(least, exact_distance(motion, w) - reach);
  }
  if (least.sign() <= 0) return "within reach of an arc by " + least.text();
  const double rough = PlainPath(job).distance(approximate(w.p - level.centre.p),
                                               approximate(w.q - level.centre.q)) -
                       approximate(reach);
  const double said = approximate(finding.deviation);
  const double tau = approximate(level.tolerance);
  if (rough + tau < said - 1e-9 || said <= tau) {
    return fmt::format("deviation {} not {}", said, rough + tau);
  }
  const Number apart = least + level.tolerance;
  if (!spirals && exact::abs(apart - finding.deviation) > mm("1e-20")) return "deviation differs";
  return {};
}

// An arc that turns the other way; or a path that goes back about the middle, sampled.
std::string flaw_of_sense(const Job& job, const LevelMotion& motion) {
  if (motion.is_arc && (motion.rot > 0) != (job.level.sense > 0)) return "";
  const std::vector<Sample> samples = samples_of(job, 0.02);
  double back = 0;
  double most = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Sample& a = samples[k - 1];
    const Sample& b = samples[k];
    if (std::hypot(a.x, a.y) < 0.1 || std::hypot(b.x, b.y) < 0.1) continue;
    back -= job.level.sense * std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    back = std::max(back, 0.0);
    most = std::max(most, back);
  }
  return most > std::numbers::pi / 4 ? "" : "turns as it should";
}

}  // namespace

std::string flaw_of_finding(const Job& job, const Finding& finding) {
  const CircularLevel& level = job.level;
  const PlanePoint& w = finding.witness;
  if (finding.rule == Rule::cover || finding.rule == Rule::step) return flaw_of_hole(job, finding);
  const LevelMotion& motion = job.motions.at(finding.record.value());
  if (finding.rule == Rule::sense) return flaw_of_sense(job, motion);
  const double x = approximate(w.p - level.centre.p);
  const double y = approximate(w.q - level.centre.q);
  if (finding.rule == Rule::order) return flaw_of_disorder(job, finding, x, y);
  const double limit = approximate(level.pocket_radius - level.tool_radius);
  const double beyond = std::hypot(x, y) - limit;
  if (beyond < approximate(finding.deviation) - 1e-9) return "not so far outside";
  if (!(finding.deviation > level.tolerance)) return "deviation is within the tolerance";
  if (motion.is_arc && plain(motion, level.centre).distance(x, y) > 1e-8) return "not on the arc";
  return {};
}

std::string flaw_of_go(const Job& job) {
  const PlainPath path(job);
  const CircularLevel& level = job.level;
  const double tau = approximate(level.tolerance);
  const double pocket = approximate(level.pocket_radius);
  const double border = approximate(level.pocket_radius - level.tool_radius);
  const double step = approximate(level.step) / 2 + tau;
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> part(0, 1);
  for (int k = 0; k < 20'000; ++k) {
    const double angle = 2 * std::numbers::pi * part(random);
    const double along = k % 4 == 0 ? 1.0 : std::sqrt(part(random));
    const double x = along * std::cos(angle);
    const double y = along * std::sin(angle);
    const double cover = path.distance(pocket * x, pocket * y);
    if (cover > approximate(level.tool_radius) + tau + 1e-6) {
      return fmt::format("cover: {} at {}, {}", cover, pocket * x, pocket * y);
    }
    const double stepped = path.distance(border * x, border * y);
    if (stepped > step + 1e-6) {
      return fmt::format("step: {} at {}, {}", stepped, border * x, border * y);
    }
  }
  return flaw_of_order(job);
}

}  // namespace gonogo::oracle::region
