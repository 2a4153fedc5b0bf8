// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/explanation.hpp"

#include <algorithm>

#include "fuzz/identify/same_path.hpp"
#include "fuzz/program/text.hpp"
#include "grammar/parser.hpp"
#include "reference/dialect.hpp"

namespace gonogo::identify {

using oracle::Decision;

std::vector<ProgramAsked> spread(const std::vector<ProgramAsked>& all, std::size_t most) {
  std::vector<ProgramAsked> some;
  const std::size_t count = std::min(most, all.size());
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

namespace {

// The lines of `changed` before the line of this number, and those of `original` from it on.
std::string spliced(std::string_view changed, std::string_view original, std::uint64_t line,
                    const Profile& profile) {
  const ProgramText before(profile, changed);
  const ProgramText after(profile, original);
  if (before.blocks.size() != after.blocks.size()) return std::string(changed);
  std::string text;
  for (std::size_t i = 0; i < before.blocks.size(); ++i) {
    text += program::line_text((i + 1 < line ? before : after).blocks[i]);
  }
  return text;
}

bool is_same_but_for_case(std::string_view a, std::string_view b) {
  const auto capital = [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  };
  return std::ranges::equal(a, b, {}, capital, capital);
}

// A line that cannot be read stays as it is, and so does one of comments alone.
std::string printed(grammar::Dialect dialect, std::string line) {
  grammar::Block block;
  if (grammar::parse_block(dialect, line, block)) return line;
  std::string text = grammar::print(dialect, block);
  // Small letters are read, and may be what the subject does not read.
  return text.empty() || is_same_but_for_case(line, text) ? line : text;
}

// The program as the grammar prints it, where it means the same: mistakes are of words and codes,
// and "G0 2" is read by the grammar alone.
std::string plainly_spelled(const ProgramAsked& asked, const KeptOutcome& meant) {
  const reference::Dialect* dialect = reference::find_dialect(asked.profile.dialect);
  std::vector<program::TextLine> lines = program::lines_of(asked.program);
  for (program::TextLine& line : lines) {
    const std::string text = program::line_text({line.words, line.rest, ""});
    line = {{{"", printed(dialect->grammar, text)}}, "", line.end};
  }
  std::string plain = program::text_of(lines);
  const auto same = run_reference(asked.profile, plain);
  return same && same->text() == meant.text() ? plain : asked.program;
}

}  // namespace

oracle::Tolerances Explainer::tolerances(const Profile& profile) const {
  oracle::Tolerances tolerances = make_tolerances(subject_.info(), profile, options_.grants);
  tolerances.strict = true;  // what it follows, not what a text states
  return tolerances;
}

std::optional<Observation> Explainer::observe(const ProgramAsked& asked) {
  if (!configured_ || *configured_ != asked.profile) {
    configured_ = asked.profile;
    subject_.configure(asked.profile);
    before_ = {};
  }
  Observation seen{asked.id, asked.program, asked.profile, {}, {}, 0, {}, before_};
  seen.outcome = run_subject(subject_, asked.id, asked.program);
  const auto shown = run_reference(asked.profile, asked.program);
  if (shown) seen.program = plainly_spelled(asked, *shown);
  before_.take(asked.profile, seen.program, seen.outcome);
  if (!seen.outcome.answered()) return std::nullopt;
  seen.verdict = judge_outcome(asked.profile, asked.program, tolerances(asked.profile),
                               seen.outcome.records, seen.outcome.end)
                     .verdict;
  if (decision(seen.verdict.kind) == Decision::undecided) return std::nullopt;
  // A pass without an alarm is one under an alternative that has none there.
  const bool ran_on = !seen.departs() && seen.outcome.end.kind == oracle::RunEnd::Kind::ok;
  if (shown && !ran_on) {
    seen.alarm = shown->end.alarm.block;
    seen.alarms = shown->admitted;
  }
  return seen;
}

Fit Explainer::judge_trial(const ChangedRun& trial, const Observation& seen) {
  spent_ += trial.outcome.records.size();
  if (is_spent()) return Fit::no;
  const oracle::Tolerances on = tolerances(trial.profile);
  if (trial.model) {
    return same_path(*trial.model, trial.outcome, trial.profile.initial.at, on) ? Fit::full
                                                                                : Fit::no;
  }
  // One that would put out far more than the subject did need not be followed to its end.
  const std::size_t most = 1'000 + 20 * trial.outcome.records.size();
  const auto shown = run_reference(trial.profile, trial.program, most);
  spent_ += shown ? shown->records.size() : most;
  if (!shown) return Fit::no;
  const oracle::VerdictKind said =
      judge_outcome(trial.profile, trial.program, on, trial.outcome.records, trial.outcome.end)
          .verdict.kind;
  if (decision(said) == Decision::go) return Fit::full;
  // The rule that ends the reference may be checked on the word as it is written.
  const bool is_cut_short =
      seen.departs() && seen.alarm == 0 && said == oracle::VerdictKind::fail_alarm_missing;
  return is_cut_short ? Fit::cut_short : Fit::no;
}

// What an enclosure leaves open is not explained.
Fit Explainer::fit(const Variant& variant, const Observation& seen) try {
  if (variant.holds && variant.holds(seen)) return Fit::full;
  if (!variant.apply) return Fit::no;
  auto trial = variant.apply(seen);
  if (!trial) return seen.departs() ? Fit::no : Fit::full;
  const Fit as_a_whole = judge_trial(*trial, seen);
  if (as_a_whole != Fit::no) return as_a_whole;
  // Rules may be checked on the words as they are written, before anything is made of them.
  if (seen.alarm == 0 || trial->model || trial->program == seen.program) return Fit::no;
  trial->program = spliced(trial->program, seen.program, seen.alarm, seen.profile);
  return judge_trial(*trial, seen);
} catch (const exact::Undecided&) {
  return Fit::no;
}

namespace {

void add_misread(void (*add)(const Observation&, Variants&), const Observation& departure,
                 Variants& out) {
  const std::size_t first = out.size();
  add(departure, out);
  for (std::size_t i = first; i < out.size(); ++i) out[i].is_misread = true;
}

}  // namespace

Variants variants_for(const Observation& departure) {
  Variants variants;
  add_alarm_variants(departure, variants);
  add_limit_variants(departure, variants);
  add_clause_variants(departure, variants);
  add_machine_variants(departure, variants);
  add_record_variants(departure, variants);
  add_misread(add_word_variants, departure, variants);
  add_misread(add_bracket_variants, departure, variants);
  add_retained_variants(departure, variants);
  add_modal_variants(departure, variants);
  add_misread(add_code_variants, departure, variants);
  add_reference_point_variants(departure, variants);
  add_way_variants(departure, variants);
  add_model_variants(departure, variants);
  return variants;
}

}  // namespace gonogo::identify
