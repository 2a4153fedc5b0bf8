// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/tried_subject.hpp"

#include <fmt/format.h>

#include "expanders/registry.hpp"
#include "oracle/differential/differential.hpp"
#include "reference/dialect.hpp"
#include "subjects/library_file.hpp"

namespace gonogo::fuzz {
namespace {

using oracle::SubjectUnusable;

std::unique_ptr<oracle::Subject> make_builtin(const std::string& name, const std::string& fault) {
  const gonogo_subject_v1* const expander = expanders::find(name, fault);
  if (expander != nullptr) return oracle::make_interface_subject(*expander);
  if (expanders::find(name) == nullptr) {
    throw SubjectUnusable(fmt::format("There is no built-in expander {}.", name));
  }
  throw SubjectUnusable(fmt::format("The expander {} has no fault {}.", name, fault));
}

const generate::Generator* generator_for(const oracle::SubjectInfo& info, std::string dialect) {
  if (dialect.empty() && info.dialects.size() == 1) dialect = info.dialects.begin()->first;
  if (dialect.empty()) {
    throw SubjectUnusable("The subject does not say which dialect it reads. Name one: --dialect.");
  }
  if (reference::find_dialect(dialect) == nullptr) {
    throw SubjectUnusable(fmt::format("There is no dialect {}. Choose one of {}.", dialect,
                                      reference::dialect_names()));
  }
  if (!info.declares(dialect, "")) {
    throw SubjectUnusable(fmt::format("The subject does not name the dialect {}.", dialect));
  }
  return &generate::generator_of(dialect);
}

}  // namespace

std::unique_ptr<oracle::Subject> make_subject_here(const std::string& text,
                                                   const oracle::StatedMachine& stated) {
  const oracle::SubjectSpec spec =
      oracle::parse_subject_spec(text).value_or(oracle::SubjectSpec{"builtin", text});
  if (spec.kind == "builtin") {
    const std::size_t plus = spec.rest.find('+');
    return make_builtin(spec.rest.substr(0, plus),
                        plus == std::string::npos ? "" : spec.rest.substr(plus + 1));
  }
  if (spec.kind == "lib") {
    return oracle::make_interface_subject(oracle::load_library(spec.rest), stated);
  }
  oracle::Limits limits;
  limits.stated = stated;
  if (spec.kind == "pipe") return oracle::make_pipe_subject(spec.rest, limits);
  if (spec.kind == "oneshot") return oracle::make_oneshot_subject(spec.rest, limits);
  throw SubjectUnusable(
      fmt::format("\"{}\" names no subject. Write NAME, NAME+FAULT, lib:PATH.so, pipe:COMMAND or "
                  "oneshot:COMMAND.",
                  text));
}

TriedSubject::TriedSubject(const std::string& text, const std::string& dialect,
                           const BeforeRun& before_run)
    : subject_(make_subject_here(text)) {
  const auto spec = oracle::parse_subject_spec(text);
  if (!spec || spec->kind == "builtin") {
    const std::string rest = spec ? spec->rest : text;
    const std::string name = rest.substr(0, rest.find('+'));
    generator_ = generate::find_generator(name, dialect);
    if (generator_ != nullptr) return;
    throw SubjectUnusable(fmt::format("{} does not expand {}.", name, dialect));
  }
  const oracle::SubjectInfo& info = subject_->info();
  generator_ = generator_for(info, dialect);
  supported_.emplace(info, std::string(generator_->dialect));
  learn(before_run);
}

void TriedSubject::learn(const BeforeRun& before_run) {
  constexpr std::size_t kRuns = 2'000;
  constexpr std::uint64_t kMostDrawn = 50 * kRuns;
  constexpr std::size_t kMostRecords = 5'000;
  std::size_t runs = 0;
  for (std::uint64_t seed = 1; seed <= kMostDrawn && runs < kRuns; ++seed) {
    generate::Choices choices(seed);
    const auto program = supported_->fitted(generator_->generate(choices, nullptr));
    if (!program) continue;
    ++runs;
    if (before_run) before_run(*program);
    const auto ended =
        oracle::run_alone(*subject_, program->profile, program->text, kMostRecords).kind;
    const bool is_skipped =
        ended == oracle::RunEnd::Kind::skip || ended == oracle::RunEnd::Kind::refused;
    is_skipped ? supported_->skipped(*program) : supported_->ran(*program);
  }
  supported_->stop_trying();
}

std::optional<generate::GeneratedProgram> TriedSubject::fitted(
    generate::GeneratedProgram program) const {
  if (!supported_) return program;
  return supported_->fitted(program);
}

}  // namespace gonogo::fuzz
