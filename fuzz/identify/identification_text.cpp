// SPDX-License-Identifier: GPL-3.0-or-later
//
// An identification for people, and as a profile.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/identify/identify.hpp"
#include "fuzz/program/lines.hpp"

namespace gonogo::identify {
namespace {

using oracle::RunEnd;

void append_program(const Probe& probe, std::string& out) {
  for (const program::ProgramLine& line : program::program_lines(probe.program)) {
    if (!line.text.empty()) out += fmt::format("      {}\n", line.text);
  }
}

std::string answer_text(const RunEnd& end) {
  const bool is_skipped = end.kind == RunEnd::Kind::skip || end.kind == RunEnd::Kind::refused;
  return fmt::format("The subject {}: {}", is_skipped ? "skips it" : "gives no answer",
                     end.message);
}

void append_run(const ProbeRun& run, std::size_t number, std::string& out) {
  out += fmt::format("Program {}: {}", number, run.probe->id);
  const std::string machine = reference::profile_json(run.probe->profile);
  out += machine == "{}" ? "\n" : fmt::format(", machine {}\n", machine);
  append_program(*run.probe, out);
  if (!run.outcome.answered()) {
    out += fmt::format("    {}\n", answer_text(run.outcome.end));
  } else if (run.learnt.empty()) {
    out += "    Nothing new.\n";
  }
  for (const std::string& sentence : run.learnt) out += fmt::format("    {}.\n", sentence);
}

void append_contradiction(const Identification& found, std::string& out) {
  out += "The subject follows no readings consistently.\n";
  const auto& those = found.contradiction;
  const std::string& last = found.runs[those.front()].probe->id;
  out += fmt::format("  What it does in program {}, {}, contradicts", those.front() + 1, last);
  for (std::size_t i = 1; i < those.size(); ++i) {
    out += fmt::format("{} program {}, {}", i == 1 ? "" : " together with", those[i] + 1,
                       found.runs[those[i]].probe->id);
  }
  out += ": no one combination of readings explains them all.\n";
}

void append_aside(const Identification& found, std::string& out) {
  for (const std::size_t run : found.aside) {
    out += fmt::format("Program {}, {}, departs under every reading: a fault, and no reading.\n",
                       run + 1, found.runs[run].probe->id);
  }
}

// A value as TOML has it; what profile_json writes.
void append_toml(const std::string& prefix, const nlohmann::ordered_json& table, std::string& out) {
  std::string tables;
  for (const auto& [key, value] : table.items()) {
    const std::string name = nlohmann::ordered_json(key).dump();
    if (value.is_object()) {
      const std::string path = prefix.empty() ? name : prefix + "." + name;
      tables += fmt::format("\n[{}]\n", path);
      append_toml(path, value, tables);
    } else {
      out += fmt::format("{} = {}\n", name, value.dump());
    }
  }
  out += tables;
}

}  // namespace

std::string identification_text(const Identification& found, std::string_view subject,
                                std::string_view dialect) {
  std::string out;
  for (std::size_t i = 0; i < found.runs.size(); ++i) append_run(found.runs[i], i + 1, out);
  out += fmt::format("\n{} in {}: {} programs", subject, dialect, found.answered());
  if (found.runs.size() != found.answered()) {
    out += fmt::format(" and {} without an answer", found.runs.size() - found.answered());
  }
  out += fmt::format(" (2^{:.0f} combinations)\n", found.bits);
  if (found.is_thin()) {
    out += "Most of the programs had no answer: what follows is not what the subject does.\n";
  }
  append_aside(found, out);
  if (!found.contradiction.empty()) {
    append_contradiction(found, out);
    return out;
  }
  for (const ReadingFound& one : found.readings) {
    out += fmt::format("  {:<24} {}{}\n", reference::reading(one.key).name,
                       fmt::join(one.values, " or "),
                       one.why.empty() ? "" : fmt::format("  ({})", one.why));
  }
  if (!found.coordinates.empty()) {
    out += fmt::format("  coordinates: {}\n", found.coordinates.text());
  }
  return out;
}

std::string identification_toml(const Identification& found, const Profile& machine) {
  std::string out = fmt::format("dialect = \"{}\"\n", machine.dialect);
  Profile plain = machine;
  plain.readings = reference::ReadingChoice();
  append_toml("", nlohmann::ordered_json::parse(reference::profile_json(plain)), out);
  out += "\n[readings]\n";
  for (const ReadingFound& one : found.readings) {
    const std::string_view name = reference::reading(one.key).name;
    if (one.values.size() == 1) {
      out += fmt::format("\"{}\" = \"{}\"\n", name, one.values.front());
    } else {
      out += fmt::format("# \"{}\" is {}: {}\n", name, fmt::join(one.values, " or "), one.why);
    }
  }
  return out;
}

}  // namespace gonogo::identify
