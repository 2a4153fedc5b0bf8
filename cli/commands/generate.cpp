// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo generate: vectors from the models of a dialect, with their completeness counted; or from
// its generator, for a corpus that nobody has seen.
#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/subjects.hpp"
#include "cli/version.hpp"
#include "corpus/io/folder_writer.hpp"
#include "fuzz/generate/cover/cases.hpp"
#include "fuzz/generate/valid_programs.hpp"
#include "fuzz/hunt/drawn_vectors.hpp"
#include "fuzz/hunt/supported_features.hpp"
#include "oracle/records/features.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

using cover::CoverCases;
using cover::Making;
using cover::Model;

struct GenerateWords {
  std::string dialect;
  std::string out;
  std::vector<std::string> only;  // globs over names of models; empty: all
  long strength = 0;              // 0: the model's own
  long fault_strength = 0;
  long seed = 1;
  long signs = 24;
  long programs = 0;  // drawn at random; 0: rows of covering arrays
  std::string settings;
  bool valid = false;  // of those that are drawn
  std::string profile;
  std::vector<std::string> features;  // that they may need; empty: all
  std::string subject;                // ... or those that it declares
};

std::vector<const Model*> models_of(const GenerateWords& words) {
  std::vector<const Model*> chosen;
  for (const Model* model : cover::models()) {
    if (model->dialect != words.dialect) continue;
    const std::string name(model->name);
    const bool named = std::ranges::any_of(words.only, [&](const std::string& glob) {
      return ::fnmatch(glob.c_str(), name.c_str(), 0) == 0;
    });
    if (words.only.empty() || named) chosen.push_back(model);
  }
  if (chosen.empty()) {
    throw UsageError(fmt::format(
        "No model of {} has such a name. Leave --only out for all of them.", words.dialect));
  }
  return chosen;
}

Making making_of(const Model& model, const GenerateWords& words) {
  Making making;
  making.model = &model;
  making.strength = model.strength;
  if (words.strength != 0) making.strength.valid = static_cast<unsigned>(words.strength);
  if (words.fault_strength != 0) {
    making.strength.faulty = static_cast<unsigned>(words.fault_strength);
  }
  making.seed = static_cast<std::uint64_t>(words.seed);
  making.signs = static_cast<std::size_t>(words.signs);
  return making;
}

std::string file_of(const Model& model) {
  const std::string_view name = model.name.substr(model.name.find('.') + 1);
  return fmt::format("vectors/{}/cover-{}.json", model.dialect, name);
}

// The line of one model, from the cases as they were written.
std::string line_of(const Making& making, const std::vector<oracle::Case>& cases) {
  const cover::TupleCount count =
      cover::count_cases(cover::parse_parameters(making.model->parameters), making.strength, cases);
  std::size_t alarms = 0;
  std::size_t signs = 0;
  for (const oracle::Case& test : cases) {
    if (!test.tags_sign.empty()) ++signs;
    if (oracle::expects_alarm(test)) ++alarms;
  }
  return fmt::format(
      "{:<14} t {} (faults {})  {:>6} tuples, {:>6} covered, {:>5} excluded  {:>5} cases, {:>4} "
      "alarm, {:>3} at a limit\n",
      making.model->name, making.strength.valid, making.strength.faulty, count.allowed,
      count.covered, count.excluded, cases.size(), alarms, signs);
}

// Rows of covering arrays and cases at limits.
int generate_rows(const GenerateWords& words) {
  oracle::CorpusFolder folder;
  folder.version = cover::kModelsVersion;
  std::vector<Making> makings;
  Output output;
  std::size_t disagreements = 0;
  for (const Model* model : models_of(words)) {
    makings.push_back(making_of(*model, words));
    CoverCases made = cover::cover_cases(makings.back());
    disagreements += made.disagreements.size();
    for (const std::string& disagreement : made.disagreements) {
      output.text() += fmt::format("left out: {}\n", disagreement);
    }
    folder.files[file_of(*model)] = std::move(made.cases);
  }
  oracle::write_corpus(words.out, folder);
  std::size_t cases = 0;
  for (const Making& making : makings) {
    const std::string file = words.out + "/" + file_of(*making.model);
    const std::vector<oracle::Case> written = oracle::read_vector_file(file);
    cases += written.size();
    output.text() += line_of(making, written);
  }
  output.text() += fmt::format("{} cases in {}\n", cases, words.out);
  output.flush();
  return disagreements == 0 ? kGo : kUndecided;
}

// Those that the subject declares of the dialect; empty: everything. Throws UsageError.
std::set<std::string> features_of_subject(const GenerateWords& words) {
  if (!words.features.empty()) {
    throw UsageError("The subject says which features it has. Leave --feature or --subject out.");
  }
  const std::unique_ptr<oracle::Subject> subject =
      subject_maker(words.subject, LimitOptions().limits())();
  const oracle::SubjectInfo& info = subject->info();
  if (info.everything) return {};
  const auto declared = info.dialects.find(words.dialect);
  if (declared == info.dialects.end()) {
    throw UsageError(fmt::format("{} does not name the dialect {}. Leave --subject out.",
                                 words.subject, words.dialect));
  }
  return declared->second;
}

// Those of --feature. Throws UsageError.
std::set<std::string> named_features(const GenerateWords& words) {
  std::set<std::string> features;
  for (const std::string& name : words.features) {
    std::string known;
    bool is_known = false;
    for (const oracle::Feature& feature : oracle::feature_vocabulary()) {
      if (feature.dialect != words.dialect) continue;
      known += fmt::format("{}{}", known.empty() ? "" : ", ", feature.name);
      is_known = is_known || feature.name == name;
    }
    if (!is_known) {
      throw UsageError(
          fmt::format("{} has no feature \"{}\". Write one of: {}.", words.dialect, name, known));
    }
    features.insert(name);
  }
  return features;
}

// The features that programs may need; empty: all. Throws UsageError.
std::set<std::string> declared_features(const GenerateWords& words) {
  std::set<std::string> features =
      words.subject.empty() ? named_features(words) : features_of_subject(words);
  if (!features.empty()) features.insert("basic");
  return features;
}

generate::ValidOptions valid_options(const GenerateWords& words) {
  generate::ValidOptions options;
  options.settings = settings_option(words.settings);
  // near-invalid is what is drawn where --settings says nothing of it.
  if (words.settings.find("near-invalid") != std::string::npos || options.settings.kinds.raw > 0) {
    throw UsageError(
        "--valid writes nothing wrong: leave near-invalid and raw out of --settings; valid, "
        "boundary and tiny are weights that go with it.");
  }
  options.features = declared_features(words);
  if (!words.profile.empty()) options.profile = load_profile({words.dialect, words.profile, {}});
  return options;
}

std::string valid_line(const generate::ValidCount& count) {
  std::string why;
  for (const auto& [rule, times] : count.refused_by) why += fmt::format("\n  {} {}", rule, times);
  return fmt::format(
      "{} of {} blocks were refused or not declared and are left out, {} of {} programs thrown "
      "out{}\n",
      count.left_out, count.blocks, count.thrown_out, count.programs, why);
}

// What the generator writes, without what needs a feature that is not among these.
hunt::ProgramDraw drawn_within(const GenerateWords& words, const std::set<std::string>& features) {
  oracle::SubjectInfo info;
  info.everything = features.empty();
  if (!features.empty()) info.dialects[words.dialect] = features;
  const auto supported = std::make_shared<const hunt::SupportedFeatures>(info, words.dialect);
  const generate::Generator& generator = generate::generator_of(words.dialect);
  return [supported, &generator, settings = settings_option(words.settings)](std::uint64_t seed) {
    generate::Choices choices(seed);
    return supported->fitted(generator.generate(choices, settings, nullptr));
  };
}

int generate_drawn(const GenerateWords& words) {
  const auto seed = static_cast<std::uint64_t>(words.seed);
  const auto programs = static_cast<std::size_t>(words.programs);
  const std::string gonogo = fmt::format("gonogo {}", kVersion);
  std::optional<generate::ValidPrograms> valid;
  hunt::ProgramDraw source;
  if (words.valid) {
    valid.emplace(generate::generator_of(words.dialect), valid_options(words));
    source = [&](std::uint64_t one) { return valid->of_seed(one); };
  } else {
    source = drawn_within(words, declared_features(words));
  }
  hunt::DrawnVectors drawn = hunt::draw_vectors(source, seed, programs, gonogo);
  if (drawn.cases.empty()) {
    throw UsageError(
        "None of the programs is a case: nothing can be said of them. Draw more, or from another "
        "seed.");
  }
  Output output;
  output.text() = fmt::format(
      "{} programs from seed {} on: {} show something new, {} of these alarm; {} left out\n"
      "{} cases in {}\n",
      words.programs, words.seed, drawn.cases.size(), drawn.alarms, drawn.left_out,
      drawn.cases.size(), words.out);
  if (valid) output.text() += valid_line(valid->count());
  oracle::CorpusFolder folder;
  folder.version = oracle::kUnreleased;
  folder.files[fmt::format("vectors/{}/drawn.json", words.dialect)] = std::move(drawn.cases);
  oracle::write_corpus(words.out, folder);
  output.flush();
  return kGo;
}

int generate(const GenerateWords& words) {
  check_dialect_name(words.dialect);
  std::error_code ignored;
  if (std::filesystem::exists(words.out, ignored) &&
      !std::filesystem::is_empty(words.out, ignored)) {
    throw UsageError(fmt::format("{} is there and not empty. Name a new folder.", words.out));
  }
  if (!words.valid && !words.profile.empty()) {
    throw UsageError("--profile is about valid programs: give --valid too.");
  }
  if (words.programs == 0) {
    if (words.valid) {
      throw UsageError("--valid is about programs that are drawn at random: give --programs too.");
    }
    if (!words.settings.empty() || !words.features.empty() || !words.subject.empty()) {
      throw UsageError(
          "--settings, --feature and --subject are about programs that are drawn at random: give "
          "--programs too.");
    }
    return generate_rows(words);
  }
  if (!words.only.empty() || words.strength != 0 || words.fault_strength != 0) {
    throw UsageError(
        "--programs draws at random; --only and strengths are about models. Leave either out.");
  }
  return generate_drawn(words);
}

}  // namespace

void add_generate(Command& program) {
  auto words = std::make_shared<GenerateWords>();
  Command command = program.add_command(
      "generate", "Make vectors: of every tuple of classes, or of programs drawn at random");
  command.needed("--dialect", words->dialect, "dialect of the programs");
  command.needed("--out", words->out, "new folder for the vectors");
  command.number("--strength", words->strength, 1, 4,
                 "how many classes of valid values together (each model's own)");
  command.number("--fault-strength", words->fault_strength, 1, 4,
                 "the same of a class that must alarm and those beside it");
  command.number("--seed", words->seed, 1, 2'000'000'000, "of the choices among equals (1)");
  command.number("--signs", words->signs, 0, 1000,
                 "triples at the reference's limits, at most so many a model (24)");
  command.repeated_option("--only", words->only, "models by a glob: gsk.g11*");
  command.number("--programs", words->programs, 1, 100'000'000,
                 "draw so many programs instead, and keep those that show something new");
  command.option("--settings", words->settings,
                 "with --programs, what these are like: valid=1,boundary=2,blocks=4");
  command.flag("--valid", words->valid,
               "with --programs, only such that no rule refuses, under no reading left open");
  command.option("--profile", words->profile,
                 "with --valid, the machine of every program; without: any");
  command.repeated_option("--feature", words->features,
                          "with --programs, one that they may need (all)");
  command.option("--subject", words->subject,
                 "with --programs, they need no feature but those that this subject declares");
  command.run([words] { return generate(*words); });
}

}  // namespace gonogo::cli
