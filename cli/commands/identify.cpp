// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo identify: which readings a black box follows, or what a departure is likely to come from.
#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subjects.hpp"
#include "fuzz/identify/attribution.hpp"
#include "fuzz/identify/identify.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::cli {
namespace {

struct IdentifyWords {
  std::string subject;
  std::string alarm_map;
  std::string departure;
  std::string corpus;
  std::string out;
  ProfileOptions profile;
  LimitOptions limits;
};

// The dialect that was named, or the only one that the subject names.
std::string dialect_of(const IdentifyWords& words, const oracle::SubjectInfo& info) {
  if (!words.profile.file.empty()) return load_profile(words.profile).dialect;
  if (!words.profile.dialect.empty()) {
    check_dialect_name(words.profile.dialect);
    return words.profile.dialect;
  }
  if (info.dialects.size() == 1) return info.dialects.begin()->first;
  throw UsageError(fmt::format("The subject {} one dialect. Name the one to identify: --dialect.",
                               info.dialects.empty() ? "does not name" : "has more than"));
}

int find_readings(const IdentifyWords& words, oracle::Subject& subject) {
  if (!words.profile.readings.empty()) {
    throw UsageError("The readings are what identify finds. Leave --reading out.");
  }
  const std::string dialect = dialect_of(words, subject.info());
  reference::Profile machine = load_profile({dialect, words.profile.file, {}});
  std::optional<reference::Profile> of_pool;
  if (!words.profile.file.empty()) {
    of_pool = machine;
    of_pool->readings = reference::ReadingChoice();
  }
  const oracle::Corpus corpus(corpus_folder(words.corpus));
  const identify::ProbePool pool = identify::make_pool(corpus, dialect, of_pool);
  const identify::Identification found = identify_readings(subject, pool, words.limits.grants());
  Output output;
  output.text() = identification_text(found, subject.info().name, dialect);
  if (!found.contradiction.empty()) {
    output.tell();
    return kNoGo;
  }
  if (found.is_thin()) {
    output.tell();
    return kUndecided;
  }
  if (!words.out.empty()) {
    oracle::write_file(words.out, identification_toml(found, machine));
    output.text() += fmt::format("The profile is in {}.\n", words.out);
  }
  output.tell();
  return found.aside.empty() ? kGo : kNoGo;
}

// A case of the corpus by its id, or a program.
identify::ProgramAsked asked_for(const IdentifyWords& words, const oracle::Corpus& corpus,
                                 const oracle::SubjectInfo& info) {
  std::error_code ignored;
  if (words.departure == "-" || std::filesystem::exists(words.departure, ignored)) {
    ProfileOptions options = words.profile;
    if (options.file.empty()) options.dialect = dialect_of(words, info);
    return {words.departure, read_file(words.departure), load_profile(options)};
  }
  oracle::CaseReader reader(corpus, oracle::Detail::to_run);
  while (const auto test = reader.next()) {
    if (test->id != words.departure) continue;
    const bool other =
        !words.profile.dialect.empty() && words.profile.dialect != test->profile.dialect;
    if (other || !words.profile.file.empty() || !words.profile.readings.empty()) {
      throw UsageError(fmt::format(
          "{} is a case of {} with a profile of its own. Leave --dialect, --profile and "
          "--reading out.",
          test->id, test->profile.dialect));
    }
    return {test->id, test->program, test->profile};
  }
  throw UsageError(fmt::format("{} is neither a file nor a case of the corpus. Name one of them.",
                               words.departure));
}

int find_cause(const IdentifyWords& words, oracle::Subject& subject) {
  if (!words.out.empty()) throw UsageError("--out goes without --departure.");
  const oracle::Corpus corpus(corpus_folder(words.corpus));
  const identify::ExplanationOptions options{words.limits.grants()};
  const identify::Attribution attribution =
      attribute(subject, corpus, asked_for(words, corpus, subject.info()), options);
  Output output;
  output.text() = attribution_text(attribution);
  output.tell();
  if (attribution.departures == 0) return kUndecided;
  return attribution.complete.empty() ? kNoGo : kGo;
}

int identify_subject(IdentifyWords words) {
  check_capture_options(words.limits, {words.subject});
  words.limits.stated = stated_machine(words.profile);
  const std::unique_ptr<oracle::Subject> subject = with_alarm_map(
      subject_maker(words.subject,
                    sandboxed(words.limits.limits(), words.limits.sandbox, words.subject, {}))(),
      load_alarm_map(words.alarm_map));
  return words.departure.empty() ? find_readings(words, *subject) : find_cause(words, *subject);
}

}  // namespace

void add_identify(Command& program) {
  auto words = std::make_shared<IdentifyWords>();
  Command command = program.add_command(
      "identify", "Find which readings a subject follows, or what a departure comes from");
  command.needed("--subject", words->subject, "subject, as certify takes it");
  command.option("--alarm-map", words->alarm_map, "TOML file of what its own alarms mean");
  command.option(
      "--departure", words->departure,
      "a program, or a case of the corpus, on which the subject departs: name the cause");
  command.option("--corpus", words->corpus, "folder of the corpus (the checked-in one)");
  command.option("--out", words->out, "write the profile that was found to this file");
  add_profile_options(command, words->profile);
  add_subject_options(command, words->limits);
  add_sandbox_options(command, words->limits.sandbox, "off");
  command.run([words] { return identify_subject(*words); });
}

}  // namespace gonogo::cli
