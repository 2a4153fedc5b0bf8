// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo export: the programs of a corpus for a real controller. What comes back is judged with
// `gonogo certify --subject capture:DIR`.
#include <fmt/format.h>

#include "campaign/selection.hpp"
#include "capture/exporter.hpp"
#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"

namespace gonogo::cli {
namespace {

struct ExportArguments {
  std::string corpus;
  std::string out;
  std::vector<std::string> dialects;
  std::vector<std::string> only;
  std::string envelope;
  std::string feed_max;
  std::string header;
  std::string x_zero_at;
  std::string profile;
  std::vector<std::string> readings;
  bool all_profiles = false;
  bool expected = false;
};

oracle::ExportOptions export_options(const ExportArguments& arguments) {
  oracle::ExportOptions options;
  if (!arguments.envelope.empty()) {
    options.envelope = oracle::envelope_of(arguments.envelope);
    if (!options.envelope) {
      throw UsageError(fmt::format(
          "--envelope {} is not of the form X..X,Y..Y,Z..Z with decimals in mm, the lower first.",
          arguments.envelope));
    }
  }
  options.feed_max = decimal_option(arguments.feed_max, "--feed-max", "a feed in mm/min");
  if (!arguments.header.empty())
    options.header = read_file(arguments.header, "the text before each program");
  options.all_profiles = arguments.all_profiles;
  options.expected = arguments.expected;
  options.x_zero_at = length_option(arguments.x_zero_at, "--x-zero-at");
  return options;
}

// Which cases, on which machine, and the readings that it follows.
oracle::CampaignOptions campaign_of(const ExportArguments& arguments) {
  oracle::CampaignOptions campaign;
  campaign.dialects = arguments.dialects;
  campaign.only = arguments.only;
  campaign.readings = arguments.readings;
  if (!arguments.profile.empty()) {
    const bool one = arguments.dialects.size() == 1;
    load_machine(campaign, one ? arguments.dialects.front() : "", arguments.profile);
  }
  return campaign;
}

int run_export(const ExportArguments& arguments) {
  for (const std::string& dialect : arguments.dialects) load_profile({dialect, "", {}});
  const oracle::ExportOptions options = export_options(arguments);
  const oracle::CampaignOptions campaign = campaign_of(arguments);
  const oracle::Corpus corpus(corpus_folder(arguments.corpus));
  Output output;
  try {
    oracle::Exporter exporter(arguments.out, options,
                              {kVersion, corpus.version(), corpus.sha256()});
    corpus.for_each([&](const oracle::Case& test) {
      if (!is_selected(campaign, test)) return;
      if (const auto led = oracle::under(campaign, test)) exporter.add(*led);
    });
    output.text() = exporter.finish();
  } catch (const oracle::CorpusError&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
  output.flush();
  return kGo;
}

}  // namespace

void add_export(Command& program) {
  auto arguments = std::make_shared<ExportArguments>();
  Command command =
      program.add_command("export", "Write the corpus as programs for a real controller");
  command.option("--corpus", arguments->corpus, "folder of the corpus (the checked-in one)");
  command.needed("--out", arguments->out, "new folder for the programs and manifest.json");
  command.repeated_option("--dialect", arguments->dialects, "only this dialect");
  command.repeated_option("--only", arguments->only, "only ids that match the glob");
  command.option("--envelope", arguments->envelope,
                 "only paths inside X..X,Y..Y,Z..Z, mm, X of a lathe as a radius");
  command.option("--feed-max", arguments->feed_max, "only feeds up to this, mm/min");
  command.option("--header", arguments->header, "file with lines to put before each program");
  command.option("--x-zero-at", arguments->x_zero_at,
                 "of a lathe: radius at which its work offset puts X0, mm");
  command.option("--profile", arguments->profile, "the machine's profile");
  command.repeated_option("--reading", arguments->readings, "one reading as key=value");
  command.flag("--expected", arguments->expected,
               "with the expected paths and a comparer that says GO or NO-GO on the spot");
  command.flag("--all-profiles", arguments->all_profiles,
               "also cases that need the machine set up otherwise");
  command.run([arguments] { return run_export(*arguments); });
}

}  // namespace gonogo::cli
