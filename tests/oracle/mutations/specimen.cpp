// SPDX-License-Identifier: GPL-3.0-or-later
#include "specimen.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "corpus/io/corpus.hpp"
#include "open_parts.hpp"
#include "reference/expander.hpp"

namespace gonogo::mutations {

using reference::AlarmReport;
using reference::Item;
using reference::Renaming;

namespace {

std::vector<Item> items_of(const Specimen& specimen, reference::OpenPaths open_paths) {
  std::vector<Item> items;
  oracle::ProgramInput input(specimen.program);
  reference::Expander expander(specimen.profile, input.lines, open_paths);
  while (const Item* item = expander.next()) items.push_back(*item);
  return items;
}

PartKind kind_of(const Item& item) {
  if (std::holds_alternative<reference::PocketLevel>(item)) return PartKind::level;
  if (std::holds_alternative<reference::HelixPocket>(item)) return PartKind::helix_pocket;
  if (std::holds_alternative<reference::ThreadMilling>(item)) return PartKind::thread;
  if (std::holds_alternative<reference::PocketMilling>(item)) return PartKind::pocket_milling;
  return PartKind::none;
}

std::uint64_t block_of(const Item& part) {
  return std::visit(
      [](const auto& item) -> std::uint64_t {
        if constexpr (requires { item.block; }) return item.block;
        return 0;
      },
      part);
}

std::shared_ptr<const OpenPart> conditions_of(const Item& part) {
  switch (kind_of(part)) {
    case PartKind::level:
      return open_level(std::get<reference::PocketLevel>(part));
    case PartKind::helix_pocket:
      return open_helix_pocket(std::get<reference::HelixPocket>(part));
    case PartKind::thread:
      return open_thread(std::get<reference::ThreadMilling>(part));
    case PartKind::pocket_milling:
      return open_pocket_milling(std::get<reference::PocketMilling>(part));
    case PartKind::none:
      break;
  }
  return nullptr;
}

// Each turn of a helix is a place where the bench looks.
constexpr std::int32_t kMostTurnsOfAHelix = 1000;

// The trace that is shown. False where it ends in what is not covered.
bool take_shown(Specimen& specimen, std::size_t most) {
  reference::Position here = specimen.profile.initial.at;
  for (const Item& item : items_of(specimen, reference::OpenPaths::shown)) {
    if (const auto* record = std::get_if<Record>(&item)) {
      if (specimen.right.records.size() >= most || std::abs(record->rot) > kMostTurnsOfAHelix)
        return false;
      specimen.before.push_back(here);
      if (is_motion(record->kind)) {
        for (const reference::Axis axis : reference::kAllAxes) {
          if (record->axes.has(axis)) here[axis] = record->to[axis];
        }
      }
      specimen.after.push_back(here);
      specimen.right.records.push_back(*record);
    } else if (const auto* renaming = std::get_if<Renaming>(&item)) {
      for (const reference::Axis axis : reference::kAllAxes) here[axis] += renaming->shift[axis];
      specimen.renamings.push_back(*renaming);
      specimen.names.push_back({renaming->block, place_of(renaming->shift)});
    } else if (const auto* report = std::get_if<AlarmReport>(&item)) {
      specimen.right.end.kind = oracle::RunEnd::Kind::alarm;
      specimen.right.end.alarm.block = report->block;
      specimen.right.end.alarm.alarm_class = reference::name(report->alarms.front().alarm);
      for (const reference::Alarm& alarm : report->alarms) {
        specimen.admissible.push_back(alarm.alarm);
      }
    } else {
      return false;
    }
  }
  return true;
}

// Lays what the judge is told beside what is shown: between two records that both have, the records
// that only one has are an open part.
void find_open_parts(Specimen& specimen) {
  const std::vector<Record>& shown = specimen.right.records;
  specimen.part.assign(shown.size(), PartKind::none);
  specimen.part_number.assign(shown.size(), 0);
  const std::vector<Item> told = items_of(specimen, reference::OpenPaths::judged);
  std::size_t at = 0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    if (std::holds_alternative<Record>(told[i])) ++at;
    if (kind_of(told[i]) == PartKind::none) continue;
    const Record* next = i + 1 < told.size() ? std::get_if<Record>(&told[i + 1]) : nullptr;
    const std::uint64_t block = block_of(told[i]);
    specimen.items.push_back(told[i]);
    for (; at < shown.size() && shown[at].block == block; ++at) {
      const bool is_next = next != nullptr && next->block == block &&
                           next->kind == shown[at].kind && next->clause == shown[at].clause;
      if (is_next) break;
      specimen.part[at] = kind_of(told[i]);
      specimen.part_number[at] = specimen.items.size() - 1;
    }
  }
}

void build_path(Specimen& specimen) {
  const std::vector<Stroke> strokes = specimen.strokes(specimen.right);
  const auto number_of = [&](const Stroke& stroke) -> std::ptrdiff_t {
    if (specimen.part[stroke.number] == PartKind::none) return -1;
    return static_cast<std::ptrdiff_t>(specimen.part_number[stroke.number]);
  };
  for (std::size_t i = 0; i < strokes.size();) {
    const std::ptrdiff_t number = number_of(strokes[i]);
    std::size_t end = i;
    while (end < strokes.size() && number_of(strokes[end]) == number) ++end;
    PathElement element;
    element.strokes = joined(std::span(strokes).subspan(i, end - i));
    if (number >= 0) {
      element.open = conditions_of(specimen.items[static_cast<std::size_t>(number)]);
    }
    if (!element.strokes.empty()) specimen.path.push_back(std::move(element));
    i = end;
  }
}

void check_conditions(const Specimen& specimen) {
  const double tau = specimen.tolerance();
  for (const PathElement& element : specimen.path) {
    if (element.open == nullptr) continue;
    const std::string broken = element.open->broken_by(element.strokes, {tau, 4 * tau, tau});
    if (!broken.empty()) {
      throw std::logic_error(specimen.id + ": the shown path breaks a condition: " + broken);
    }
  }
}

}  // namespace

std::vector<Stroke> Specimen::strokes(const Trace& trace) const {
  return strokes_of(trace.records, start, names);
}

std::optional<std::vector<Record>> shown_under(const reference::Profile& profile,
                                               const std::string& program) {
  std::vector<Record> records;
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  while (const Item* item = expander.next()) {
    if (const auto* record = std::get_if<Record>(item)) {
      records.push_back(*record);
    } else if (!std::holds_alternative<Renaming>(*item)) {
      return std::nullopt;
    }
  }
  return records;
}

RawCases cases_of_corpus(const std::string& folder) {
  RawCases cases;
  oracle::Corpus(folder).for_each([&](const oracle::Case& test) {
    RawCase raw{test.id, test.dialect + "/" + test.cycle, test.program, test.profile, {}};
    for (const oracle::Expectation& expected : test.expect) {
      if (!expected.not_covered) raw.assignments.push_back(expected.when);
    }
    if (!raw.assignments.empty()) cases[raw.group].push_back(std::move(raw));
  });
  return cases;
}

std::unique_ptr<Specimen> make_specimen(const RawCase& raw, const RawCase::Assignment& readings,
                                        std::size_t most) {
  auto specimen = std::make_unique<Specimen>();
  specimen->id = raw.id;
  specimen->group = raw.group;
  specimen->program = raw.program;
  specimen->profile = raw.profile;
  for (const auto& [name, value] : readings) {
    specimen->id += " " + name + "=" + value;
    if (set_reading(specimen->profile, name, value)) return nullptr;
  }
  // What is wrong may be the path of another alternative.
  specimen->profile.readings = specimen->profile.readings.shown();
  oracle::SubjectInfo subject;
  subject.features = {"blocks", "m"};
  subject.numeric_kind = "exact";
  subject.says_numeric = true;
  specimen->tolerances = make_tolerances(subject, specimen->profile);
  specimen->start = place_of(specimen->profile.initial.at);
  if (!take_shown(*specimen, most)) return nullptr;
  find_open_parts(*specimen);
  build_path(*specimen);
  check_conditions(*specimen);
  return specimen;
}

}  // namespace gonogo::mutations
