// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo hunt --method properties: a subject's answers to related programs, held against each
// other. The reference is not asked.
#include <fmt/format.h>

#include <filesystem>

#include "cli/exit_code.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "fuzz/hunt/property_hunt.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;

hunt::PropertyOptions property_options(const HuntWords& words) {
  const hunt::TrialOptions trial = trial_options(words.trial);
  const reference::Profile profile = load_profile({words.dialect, words.profile, words.readings});
  hunt::PropertyOptions options;
  options.dialect = profile.dialect;
  options.seed = static_cast<std::uint64_t>(words.seed);
  if (!words.profile.empty()) options.profile = profile;
  options.readings = readings_of(words.readings);
  options.settings = settings_option(words.settings);
  options.tolerance = trial.grants.tolerance;
  options.run_limit = trial.run_limit;
  return options;
}

std::string text_of(const hunt::PropertyFinding& finding) {
  const relations::Difference& difference = finding.difference;
  std::string text = fmt::format("  {}\n", finding.relation->sentence);
  if (difference.block != 0) text += fmt::format("  line       {}\n", difference.block);
  if (difference.record != 0) text += fmt::format("  record     {}\n", difference.record);
  text += finding_line("want", difference.want);
  text += finding_line("got", difference.got);
  text += finding_line("profile", reference::profile_json(finding.program.profile));
  text += "  program:\n" + listed(finding.program.text);
  text += finding_line("profile", reference::profile_json(finding.other.profile));
  text += "  the other program:\n" + listed(finding.other.text);
  if (!finding.is_reduced) text += "  It may not be the smallest.\n";
  return text;
}

// The two programs and what differs, below --out.
void keep(const HuntWords& words, std::size_t number, const hunt::PropertyFinding& finding) {
  if (words.trial.out.empty()) return;
  const fs::path folder = fs::path(words.trial.out) / "findings" /
                          fmt::format("properties.{}.{:06}-{}", finding.program.profile.dialect,
                                      number, finding.relation->name);
  fs::create_directories(folder);
  oracle::write_file(folder / "program.nc", finding.program.text);
  oracle::write_file(folder / "profile.json", oracle::profile_text(finding.program.profile));
  oracle::write_file(folder / "other.nc", finding.other.text);
  oracle::write_file(folder / "other-profile.json", oracle::profile_text(finding.other.profile));
  oracle::write_file(folder / "difference.txt", finding.signature() + "\n" + text_of(finding));
}

void report(const HuntWords& words, std::size_t number, const hunt::PropertyFinding& finding) {
  Output output;
  output.text() = fmt::format("{}. {}\n{}", number, finding.signature(), text_of(finding));
  output.text() += fmt::format("  again: {} --programs {}\n\n", command_of(words), finding.number);
  output.tell();
}

}  // namespace

int hunt_properties(const HuntWords& words) {
  hunt::PropertyOptions options = property_options(words);
  HuntWords named = words;
  named.dialect = options.dialect;
  const HuntEnd end(words);
  hunt::PropertyHunt hunt(trial_subject(words.trial), std::move(options));
  check_dialect(hunt.info(), named.dialect);
  std::size_t findings = 0;
  bool complete = true;
  try {
    while (!end.reached(hunt.count().programs, findings)) {
      std::optional<hunt::PropertyFinding> finding = hunt.step();
      if (!finding) continue;
      hunt.reduce(*finding, {});
      keep(named, ++findings, *finding);
      report(named, findings, *finding);
    }
  } catch (const oracle::SubjectUnusable& error) {
    complete = false;
    complain("gonogo: {}\n", error.what());
  }
  const hunt::PropertyCount& count = hunt.count();
  Output output;
  output.text() = fmt::format(
      "{}, {}: {} programs from seed {}, {} pairs compared, {} without an answer, {} pairs differ; "
      "{} findings{}\n",
      words.trial.subject, named.dialect, count.programs, words.seed, count.pairs, count.skipped,
      count.different, findings, complete ? "" : "; the hunt is incomplete");
  output.tell();
  if (findings > 0) return kNoGo;
  return complete && count.pairs > 0 ? kGo : kUndecided;
}

}  // namespace gonogo::cli
