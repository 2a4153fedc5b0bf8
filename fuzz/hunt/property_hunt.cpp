// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/property_hunt.hpp"

#include <fmt/format.h>

#include "fuzz/hunt/signature.hpp"
#include "fuzz/program/modes.hpp"

namespace gonogo::hunt {
namespace {

// Whether there was no answer at all, rather than one that says that it cannot.
bool broke_down(const relations::Trace& trace) {
  using Kind = oracle::RunEnd::Kind;
  const Kind kind = trace.end.kind;
  return kind == Kind::crash || kind == Kind::timeout || kind == Kind::out_of_memory ||
         kind == Kind::protocol;
}

}  // namespace

relations::Trace trace_of(oracle::Subject& subject, const generate::GeneratedProgram& program) {
  constexpr std::size_t kMostRecords = 5'000;
  relations::Trace trace;
  subject.configure(program.profile);
  trace.end = subject.run("related", program.text, [&](const reference::Record& record) {
    trace.records.push_back(record);
    return trace.records.size() <= kMostRecords;
  });
  return trace;
}

std::string PropertyFinding::signature() const {
  std::string text = fmt::format("{} {}/{}", relation->name, kind_in_text(difference.want),
                                 kind_in_text(difference.got));
  return code.empty() ? text : text + " in " + code;
}

PropertyHunt::PropertyHunt(SubjectMaker make, PropertyOptions options)
    : make_(std::move(make)),
      options_(std::move(options)),
      generator_(generate::generator_of(options_.dialect)),
      subject_(make_()),
      dice_(options_.seed) {
  subject_->set_run_limit(options_.run_limit);
}

relations::Trace PropertyHunt::run(const generate::GeneratedProgram& program) {
  relations::Trace trace = trace_of(*subject_, program);
  if (trace.end.given_up) {
    subject_ = make_();
    subject_->set_run_limit(options_.run_limit);
  }
  return trace;
}

reference::Number PropertyHunt::tolerance_of(const relations::Relation& relation,
                                             const reference::Profile& profile) const {
  if (options_.tolerance) return *options_.tolerance;
  if (relation.exact) return 0;
  return subject_->info().resolution.value_or(profile.resolution());
}

// Without line numbers nobody knows where a beginning ends, or which motion is made in halves.
bool PropertyHunt::can_show(const relations::Relation& relation) const {
  return !relation.needs_lines || subject_->info().features.contains("blocks");
}

// Nothing where they agree, or one of them has no answer that can be compared.
std::optional<PropertyFinding> PropertyHunt::compare(const relations::Relation& relation,
                                                     std::size_t variant,
                                                     const generate::GeneratedProgram& program,
                                                     const relations::Trace& trace) {
  std::optional<relations::Related> related = relation.relate(program, variant);
  if (!related) return std::nullopt;
  const relations::Trace other = run(related->program);
  if (!other.answered() && !broke_down(other)) {
    ++count_.skipped;
    return std::nullopt;
  }
  ++count_.pairs;
  std::optional<relations::Difference> difference;
  if (broke_down(other)) {
    difference = relations::Difference{0, 0, "an answer", other.end.message};
  } else {
    difference = relations::first_difference(trace, other, *related,
                                             tolerance_of(relation, program.profile));
  }
  if (!difference || options_.blind) return std::nullopt;
  PropertyFinding finding{&relation,   variant, program,        std::move(related->program),
                          *difference, {},      count_.programs};
  finding.code = program::ProgramText(program.profile, program.text).code_at(difference->block);
  return finding;
}

// Both programs in fresh processes: what differs no longer came from the programs before.
std::optional<PropertyFinding> PropertyHunt::alone(const PropertyFinding& finding) {
  if (!subject_->keeps_state()) return finding;
  subject_->renew();
  const relations::Trace trace = run(finding.program);
  subject_->renew();
  if (!trace.answered()) return std::nullopt;
  std::optional<PropertyFinding> same =
      compare(*finding.relation, finding.variant, finding.program, trace);
  if (same) return same;
  PropertyFinding leak = finding;
  leak.relation = relations::find_relation("again");
  leak.variant = 0;
  return leak;
}

std::optional<PropertyFinding> PropertyHunt::step() {
  ++count_.programs;
  constexpr std::size_t kBytes = 512;
  std::vector<std::uint8_t> bytes(kBytes);
  for (std::uint8_t& byte : bytes) byte = dice_.byte();
  generate::Choices choices{std::span<const std::uint8_t>(bytes)};
  generate::GeneratedProgram program = generator_.generate(choices, options_.settings, nullptr);
  options_.put_in(program.profile);
  const relations::Trace trace = run(program);
  if (!trace.answered()) {
    ++count_.skipped;
    return std::nullopt;
  }
  std::optional<PropertyFinding> found;
  for (const relations::Relation& relation : relations::relations()) {
    const std::size_t variants = relation.variants(program);
    if (variants == 0 || !can_show(relation)) continue;
    const std::size_t variant = dice_.below(variants);
    const std::optional<PropertyFinding> finding = compare(relation, variant, program, trace);
    if (!finding) continue;
    ++count_.different;
    if (found || !known_.insert(finding->signature()).second) continue;
    found = alone(*finding);
    if (found && found->signature() != finding->signature() &&
        !known_.insert(found->signature()).second) {
      found.reset();
    }
  }
  return found;
}

bool PropertyHunt::differs(const generate::GeneratedProgram& program,
                           const relations::Relation& relation, std::size_t variant) {
  if (variant >= relation.variants(program)) return false;
  const relations::Trace trace = run(program);
  return trace.answered() && compare(relation, variant, program, trace);
}

void PropertyHunt::reduce(PropertyFinding& finding, ReduceLimits limits, const StillShows& also) {
  limits.needs_right_path = false;
  std::optional<PropertyFinding> last;
  const StillShows shows = [&](const Reproducer& reproducer) {
    if (!options_.is_in(reproducer)) return false;
    const relations::Trace trace = run(reproducer.program);
    if (!trace.answered()) return false;
    // Where a beginning ends depends on the lines that are left.
    const bool any_variant = finding.relation->name == "beginning";
    const std::size_t variants = finding.relation->variants(reproducer.program);
    for (std::size_t variant = any_variant ? 0 : finding.variant; variant < variants; ++variant) {
      std::optional<PropertyFinding> smaller =
          compare(*finding.relation, variant, reproducer.program, trace);
      if (smaller && smaller->signature() == finding.signature() &&
          (also == nullptr || also(reproducer))) {
        smaller->number = finding.number;
        last = std::move(smaller);
        return true;
      }
      if (!any_variant) break;
    }
    return false;
  };
  const Reproducer whole{{}, finding.program};
  if (!shows(whole)) return;
  Reduced reduced = hunt::reduce(whole, shows, limits);
  if (!shows(reduced.reproducer)) return;
  finding = *std::move(last);
  finding.reduce_runs = reduced.runs;
  finding.is_reduced = reduced.finished;
}

}  // namespace gonogo::hunt
