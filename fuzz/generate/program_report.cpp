// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/program_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::generate {
namespace {

using reference::Item;
using reference::Profile;
using reference::Record;
using reference::RecordKind;

constexpr std::size_t kMostRecords = 10'000;

void count_machine(const Profile& profile, Distribution& distribution) {
  const Profile standard = std::get<Profile>(reference::default_profile(profile.dialect));
  const auto count = [&](bool has, const std::string& what) {
    if (has) ++distribution["machine: " + what];
  };
  count(profile == standard, "of defaults");
  count(profile.units != standard.units, "inches");
  count(profile.increment != standard.increment, "least increment");
  count(profile.x_diameter != standard.x_diameter, "X a radius");
  count(profile.initial != standard.initial, "state at power-on");
  count(profile.block_skip, "block skip");
  count(profile.readings != standard.readings, "a reading");
  for (const auto& [name, at] : profile.offsets) count(true, "offset " + name);
  for (const auto& [name, radius] : profile.tools) count(true, "tool " + name);
  for (const auto& [name, value] : profile.parameters) count(true, "parameter " + name);
}

// "GSK-G94" of "GSK-G94-03": the class of what a block does.
std::string_view clause_class(reference::ClauseId clause) {
  const std::string_view name = reference::clause_name(clause);
  return name.substr(0, name.rfind('-'));
}

class OutcomeCounter {
 public:
  explicit OutcomeCounter(Distribution& distribution) : distribution_(distribution) {}

  void take(const Record& record) {
    if (record.kind == RecordKind::end) return count("program ends");
    ++records_;
    shows_ = shows_ || is_motion(record.kind);
    count("record", name(record.kind));
    note("clause", clause_class(record.clause));
    if (record.kind == RecordKind::arc)
      note("arc plane", fmt::format("G{}", plane_code(record.plane)));
  }
  void take(const reference::AlarmReport& report) {
    shows_ = true;
    count("program alarms");
    for (const reference::Alarm& alarm : report.alarms) {
      note("alarm", name(alarm.alarm));
      note("refused by",
           fmt::format("{} {}", reference::clause_name(alarm.clause), name(alarm.alarm)));
    }
  }
  void take(const reference::NotCovered&) { count("program not covered"); }
  // Open paths do not come, since they are shown.
  template <class Other>
  void take(const Other&) {}

  void finish() {
    distribution_["records"] += records_;
    if (!shows_) count("programs without motion or alarm");
    for (const std::string& what : once_) count(what);
  }
  std::size_t records() const { return records_; }

 private:
  void count(std::string_view what, std::string_view which = {}) {
    ++distribution_[which.empty() ? std::string(what) : fmt::format("{} {}", what, which)];
  }
  // Once a program.
  void note(std::string_view what, std::string_view which) {
    once_.insert(fmt::format("{} {}", what, which));
  }

  Distribution& distribution_;
  std::size_t records_ = 0;
  bool shows_ = false;  // a motion or an alarm
  std::set<std::string> once_;
};

}  // namespace

void count_program(const GeneratedProgram& program, Distribution& distribution) {
  ++distribution["programs"];
  distribution["blocks"] += static_cast<std::size_t>(std::ranges::count(program.text, '\n'));
  count_machine(program.profile, distribution);
  OutcomeCounter counter(distribution);
  oracle::ProgramInput input(program.text);
  reference::Expander expander(program.profile, input.lines, reference::OpenPaths::shown);
  try {
    while (const Item* item = expander.next()) {
      std::visit([&](const auto& each) { counter.take(each); }, *item);
      if (counter.records() == kMostRecords) break;
    }
  } catch (const exact::Undecided&) {
    ++distribution["program undecided"];
  }
  counter.finish();
}

std::string distribution_text(const Distribution& distribution) {
  const auto found = distribution.find("programs");
  const double programs = found == distribution.end()
                              ? 1
                              : static_cast<double>(std::max<std::size_t>(1, found->second));
  std::string text;
  for (const auto& [what, times] : distribution) {
    text += fmt::format("  {:<48} {:>10} {:>10.4f}\n", what, times,
                        static_cast<double>(times) / programs);
  }
  return text;
}

}  // namespace gonogo::generate
