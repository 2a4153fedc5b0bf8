// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/region/paths.hpp"

#include "oracle/region/arc.hpp"

namespace gonogo::oracle::region {

Number mm(std::string_view text) {
  return Number::parse(text).value();
}

CircularLevel i16_l3_d4(int sense) {
  CircularLevel level;
  level.pocket_radius = 16;
  level.tool_radius = 4;
  level.step = 3;
  level.sense = sense;
  level.tolerance = mm("0.001");
  return level;
}

namespace {

PlanePoint here(const Job& job) {
  return job.motions.empty() ? job.level.plunge : job.motions.back().to;
}

Number rounded(const Number& value) {
  return (value * Number(1000) + mm("0.5")).floor() / Number(1000);
}

}  // namespace

void line_to(Job& job, const PlanePoint& to) {
  LevelMotion motion;
  motion.from = here(job);
  motion.to = to;
  motion.record = job.motions.size();
  job.motions.push_back(motion);
}

void arc_to(Job& job, const PlanePoint& to, const PlanePoint& centre, int rot) {
  line_to(job, to);
  job.motions.back().is_arc = true;
  job.motions.back().centre = centre;
  job.motions.back().rot = rot;
}

void circle(Job& job, const Number& radius, const PlanePoint& direction) {
  const PlanePoint start{radius * direction.p, radius * direction.q};
  line_to(job, start);
  arc_to(job, start, {}, job.level.sense);
}

Job concentric(const CircularLevel& level, const std::vector<Number>& radii) {
  Job job{level, {}};
  for (const Number& radius : radii) circle(job, radius, {1, 0});
  return job;
}

Job semicircles(const CircularLevel& level, bool closing_circle) {
  Job job{level, {}};
  const Number end = level.pocket_radius - level.tool_radius;
  Number s;
  for (int k = 1; exact::abs(s) < end; ++k) {
    const Number size = min(Number(k) * level.step / Number(2), end);
    const Number next = k % 2 != 0 ? size : -size;
    arc_to(job, {next, 0}, {(s + next) / Number(2), 0}, level.sense);
    s = next;
  }
  if (closing_circle) arc_to(job, {s, 0}, {}, level.sense);
  return job;
}

Job moved(Job job, const PlanePoint& by) {
  job.level.centre = job.level.centre + by;
  job.level.plunge = job.level.plunge + by;
  for (LevelMotion& motion : job.motions) {
    motion.from = motion.from + by;
    motion.to = motion.to + by;
    motion.centre = motion.centre + by;
  }
  return job;
}

Job rounded(Job job) {
  for (LevelMotion& motion : job.motions) {
    for (PlanePoint* point : {&motion.from, &motion.to, &motion.centre}) {
      *point = {rounded(point->p), rounded(point->q)};
    }
  }
  return job;
}

LevelVerdict judge(const Job& job) {
  return judge_level(job.level, job.motions);
}

}  // namespace gonogo::oracle::region
