// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/manual/example_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "publish/manual/motion_text.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle::manual {
namespace {

std::string alarm_text(const reference::AlarmReport& report) {
  return fmt::format("alarm `{}`", reference::name(report.alarms.front().alarm));
}

// Adds an item to the trial's steps and path, a step for each motion.
class Collector {
 public:
  Collector(ExampleRun& trial, report::PathSampler& sampler, const reference::Position& start)
      : trial_(trial), sampler_(sampler), texts_(start) {}

  void operator()(const reference::Record& record) {
    if (!sampler_.add(record)) throw std::runtime_error("an example is too long to be drawn");
    trial_.steps.push_back(
        {record.block, texts_.next(record), record.clause, is_motion(record.kind)});
  }
  void operator()(const reference::Renaming& renaming) {
    sampler_.rename(renaming.shift);
    texts_.rename(renaming.shift);
  }
  void operator()(const reference::AlarmReport& report) {
    const reference::ClauseId clause = report.alarms.front().clause;
    sampler_.add_end("alarm", report.block, reference::clause_name(clause), "");
    trial_.steps.push_back({report.block, alarm_text(report), clause, false});
    trial_.alarm = report;
  }
  void operator()(const reference::NotCovered& end) {
    sampler_.add_end("not-covered", end.block, {}, "");
    trial_.steps.push_back({end.block, "not covered: " + end.code, reference::kNoClause, false});
    trial_.not_covered = end.message;
  }
  template <typename Open>
  void operator()(const Open&) {}  // comes only where paths are left open

 private:
  ExampleRun& trial_;
  report::PathSampler& sampler_;
  MotionTexts texts_;
};

template <typename Take>
void for_each_item(const reference::Profile& profile, std::string_view program,
                   reference::OpenPaths open_paths, Take take) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, open_paths);
  while (const reference::Item* item = expander.next()) take(*item);
}

std::vector<const report::Motion*> moving_of(const report::Path& path) {
  std::vector<const report::Motion*> motions;
  for (const report::Motion& motion : path.motions) {
    if (motion.moves()) motions.push_back(&motion);
  }
  return motions;
}

double apart(const report::Point3& a, const report::Point3& b) {
  return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

// A program begins with a traverse from wherever the machine stood: a drawing begins at its end, so
// that what follows has the room. A program that is nothing but a traverse keeps it.
void leave_out_positioning(ExampleRun& trial) {
  std::vector<report::Motion>& motions = trial.path.motions;
  const auto moving = std::ranges::count_if(motions, &report::Motion::moves);
  const auto first = std::ranges::find_if(motions, &report::Motion::moves);
  if (first == motions.end() || !first->rapid || (moving < 2 && !trial.alarm)) return;
  for (auto motion = motions.begin(); motion != first; ++motion) {
    motion->points = {first->points.back()};
  }
  first->points = {first->points.back()};
}

}  // namespace

reference::Profile example_profile(std::string_view dialect, std::string_view lines) {
  auto result = reference::profile_from_toml(fmt::format("dialect = \"{}\"\n{}", dialect, lines));
  if (auto* error = std::get_if<reference::ProfileError>(&result)) {
    throw std::runtime_error("the profile of an example: " + error->message);
  }
  return std::get<reference::Profile>(std::move(result));
}

void choose(reference::Profile& profile, std::string_view reading, std::string_view value) {
  if (const auto error = reference::set_reading(profile, reading, value)) {
    throw std::runtime_error("the reading of an example: " + error->message);
  }
}

ExampleRun try_program(const reference::Profile& profile, std::string_view program) {
  ExampleRun trial;
  report::PathSampler sampler(profile.initial.at);
  Collector collect(trial, sampler, profile.initial.at);
  for_each_item(profile, program, reference::OpenPaths::shown,
                [&](const reference::Item& item) { std::visit(collect, item); });
  trial.path = sampler.take();
  leave_out_positioning(trial);
  for_each_item(profile, program, reference::OpenPaths::judged, [&](const reference::Item& item) {
    for (report::Limit& limit : report::limits_of(item)) trial.limits.push_back(std::move(limit));
  });
  return trial;
}

bool draw_the_same(const report::Path& a, const report::Path& b) {
  constexpr double kVisible = 0.003;  // of what the drawing spans
  const std::vector<const report::Motion*> first = moving_of(a);
  const std::vector<const report::Motion*> second = moving_of(b);
  double span = 0;
  for (const auto* motion : first) {
    for (const report::Point3& point : motion->points) {
      span = std::max(span, apart(first.front()->points.front(), point));
    }
  }
  const auto look_the_same = [&](const report::Point3& x, const report::Point3& y) {
    return apart(x, y) <= kVisible * span;
  };
  return std::ranges::equal(first, second, [&](const auto* x, const auto* y) {
    return x->rapid == y->rapid && std::ranges::equal(x->points, y->points, look_the_same);
  });
}

}  // namespace gonogo::oracle::manual
