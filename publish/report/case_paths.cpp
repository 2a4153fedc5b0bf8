// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/case_paths.hpp"

#include <fmt/format.h>

#include <exception>

#include "campaign/encoding.hpp"
#include "oracle/records/trace_reader.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle::report {
namespace {

using reference::Axis;

std::string json_of(const reference::AlarmReport& report) {
  const reference::Alarm& alarm = report.alarms.front();
  Json line = {{"k", "alarm"}, {"class", name(alarm.alarm)}, {"b", report.block}};
  if (!alarm.word.empty()) line["word"] = alarm.word.text();
  line["message"] = alarm.message;
  if (alarm.clause != reference::kNoClause) line["clause"] = reference::clause_name(alarm.clause);
  for (const reference::AdmittedClass& other : reference::admitted_classes(report)) {
    if (other.alarm != alarm.alarm) line["also"].push_back(name(other.alarm));
  }
  return dump(line);
}

struct AddItem {
  PathSampler& sampler;
  std::string& note;

  bool operator()(const reference::Record& record) const { return sampler.add(record); }
  bool operator()(const reference::PocketLevel&) const { return true; }
  bool operator()(const reference::HelixPocket&) const { return true; }
  bool operator()(const reference::ThreadMilling&) const { return true; }
  bool operator()(const reference::PocketMilling&) const { return true; }
  bool operator()(const reference::Renaming& renaming) const {
    sampler.rename(renaming.shift);
    return true;
  }
  bool operator()(const reference::AlarmReport& report) const {
    if (report.alarms.empty()) return false;
    sampler.add_end("alarm", report.block, reference::clause_name(report.alarms.front().clause),
                    json_of(report));
    return true;
  }
  bool operator()(const reference::NotCovered& end) const {
    note = fmt::format("The reference ends in block {}: {}", end.block, end.message);
    sampler.add_end("not-covered", end.block, {},
                    dump({{"k", "not-covered"}, {"b", end.block}, {"code", end.code}}));
    return true;
  }
};

}  // namespace

std::variant<reference::Profile, std::string> case_profile(const std::string& dialect,
                                                           const Json& profile) {
  Json whole = profile.is_object() ? profile : Json::object();
  whole["dialect"] = dialect;
  auto result = reference::profile_from_json(dump(whole));
  if (auto* error = std::get_if<reference::ProfileError>(&result)) return error->message;
  return std::get<reference::Profile>(std::move(result));
}

DrawnPath reference_path(const reference::Profile& profile, std::string_view program) {
  DrawnPath drawn;
  PathSampler sampler(profile.initial.at);
  try {
    grammar::MemorySource bytes(program);
    grammar::LineSource lines(bytes);
    reference::Expander expander(profile, lines, reference::OpenPaths::shown);
    expander.on_places([&](std::uint64_t block, const reference::CyclePlaces& places) {
      sampler.add_names(block, places);
    });
    const AddItem add{sampler, drawn.note};
    while (const reference::Item* item = expander.next()) {
      if (!std::visit(add, *item)) break;
    }
  } catch (const std::exception& failure) {
    // A drawing is no verdict: show what there is and say why it ends.
    drawn.note = fmt::format("The reference path ends early: {}", failure.what());
  }
  drawn.path = sampler.take();
  return drawn;
}

std::vector<Limit> limits_of_program(const reference::Profile& profile, std::string_view program) {
  constexpr std::size_t kMostLimits = 40;
  std::vector<Limit> limits;
  try {
    grammar::MemorySource bytes(program);
    grammar::LineSource lines(bytes);
    reference::Expander expander(profile, lines, reference::OpenPaths::judged);
    while (const reference::Item* item = expander.next()) {
      for (Limit& limit : limits_of(*item)) limits.push_back(std::move(limit));
      if (limits.size() >= kMostLimits) break;
    }
  } catch (const std::exception&) {
    return limits;  // as many as there are: a drawing is no verdict
  }
  return limits;
}

DrawnPath subject_path(const reference::Position& start, const Json& trace) {
  DrawnPath drawn;
  PathSampler sampler(start);
  TraceReader reader;
  for (const Json& entry : trace) {
    std::string text = dump(entry);
    const TraceLine line = reader.read(text);
    if (const auto* record = std::get_if<reference::Record>(&line)) {
      if (!sampler.add(*record, std::move(text))) break;
    } else if (const auto* alarm = std::get_if<SubjectAlarm>(&line)) {
      sampler.add_end("alarm", alarm->block, {}, std::move(text));
    } else {
      drawn.note = fmt::format("The subject's path ends at a record that cannot be read: {}",
                               std::get<TraceFault>(line).message);
      break;
    }
  }
  drawn.path = sampler.take();
  return drawn;
}

std::optional<Point3> read_point(const Json& point, const Point3& at) {
  if (!point.is_object() || point.empty()) return std::nullopt;
  TraceReader reader;
  const TraceLine line = reader.read(dump({{"k", "end"}, {"to", point}}));
  const auto* record = std::get_if<reference::Record>(&line);
  if (record == nullptr) return std::nullopt;
  const Point3 given = approximate(record->to);
  return Point3{record->axes.has(Axis::x) ? given.x : at.x,
                record->axes.has(Axis::y) ? given.y : at.y,
                record->axes.has(Axis::z) ? given.z : at.z};
}

}  // namespace gonogo::oracle::report
