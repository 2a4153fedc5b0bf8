// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/operation_hunt.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/hunt/property_hunt.hpp"
#include "fuzz/hunt/signature.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/dialect.hpp"

namespace gonogo::hunt {
namespace {

constexpr std::size_t kMostReductions = 30;  // of one shape

using relations::Operation;
using relations::OperationList;

// "holes (peck)", of the first operation.
std::string_view kind_of(const OperationList& list) {
  constexpr auto kKinds = std::to_array<std::string_view>({"contour", "face", "turn"});
  constexpr auto kHoles = std::to_array<std::string_view>(
      {"drill", "drill with dwell", "peck", "chip break", "ream", "bore"});
  const Operation& first = list.operations.front();
  return first.kind == relations::OperationKind::holes
             ? kHoles[static_cast<std::size_t>(first.hole)]
             : kKinds[static_cast<std::size_t>(first.kind)];
}

// Everything that is one step smaller, the greatest steps first.
std::vector<OperationList> smaller(const OperationList& list) {
  std::vector<OperationList> all;
  const std::size_t count = list.operations.size();
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    OperationList less = list;
    less.operations.erase(less.operations.begin() + static_cast<std::ptrdiff_t>(i));
    all.push_back(std::move(less));
  }
  const auto change = [&](std::size_t i, auto&& how) {
    OperationList less = list;
    how(less.operations[i]);
    all.push_back(std::move(less));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Operation& operation = list.operations[i];
    if (operation.places.size() > 1) change(i, [](Operation& one) { one.places.pop_back(); });
    // Each cut begins where the one before it ends; a lathe's last one leads out of the stock.
    const std::size_t needed = list.machine == relations::MachineKind::lathe ? 2 : 1;
    if (operation.cuts.size() > needed) {
      change(i, [&](Operation& one) {
        const relations::Cut last = one.cuts.back();
        one.cuts.pop_back();
        if (list.machine != relations::MachineKind::lathe) return;
        one.cuts.back() = last;
        one.cuts.back().to.p = one.cuts[one.cuts.size() - 2].to.p;
      });
    }
    if (operation.taper.sign() != 0) change(i, [](Operation& one) { one.taper = 0; });
    if (operation.per_revolution) {
      change(i, [](Operation& one) {
        one.per_revolution = false;
        one.feed = 100;
      });
    }
  }
  return all;
}

}  // namespace

std::string WrittenProgram::way() const {
  return fmt::format("{} {}", notation.dialect,
                     notation.has_cycles ? "with cycles" : "without cycles");
}

std::string OperationFinding::shape() const {
  if (breach) return fmt::format("{}: {}", name(breach->rule), second.way());
  if (!difference) return fmt::format("no answer: {}", second.way());
  return fmt::format("{}/{}: {}, {}", kind_in_text(difference->want), kind_in_text(difference->got),
                     first->way(), second.way());
}

std::string OperationFinding::signature() const {
  return fmt::format("{}, {}", kind_of(list), shape());
}

OperationHunt::OperationHunt(std::vector<Named> subjects, OperationOptions options)
    : options_(std::move(options)), dice_(options_.seed) {
  for (Named& named : subjects) {
    Seat seat{std::move(named.name), std::move(named.make), nullptr, {}};
    seat.subject = seat.make();
    seat.subject->set_run_limit(options_.run_limit);
    for (const reference::Dialect& dialect : reference::dialects()) {
      const bool is_asked =
          options_.dialects.empty() ||
          std::ranges::find(options_.dialects, dialect.name) != options_.dialects.end();
      if (!is_asked || !seat.subject->info().declares(std::string(dialect.name), "")) continue;
      seat.notations.push_back({dialect.name, false});
      seat.notations.push_back({dialect.name, true});
    }
    seats_.push_back(std::move(seat));
  }
}

std::vector<std::string> OperationHunt::ways() const {
  std::vector<std::string> ways;
  for (const Seat& seat : seats_) {
    for (const relations::Notation& notation : seat.notations) {
      ways.push_back(fmt::format("{} {}", seat.name, WrittenProgram{{}, notation, {}}.way()));
    }
  }
  return ways;
}

// Nothing: the list is not written so, or the subject does not do such programs.
std::optional<OperationHunt::Answer> OperationHunt::answer(Seat& seat,
                                                           const relations::Notation& notation,
                                                           const OperationList& list) {
  if (notation.has_cycles && !has_cycle_for(list, notation.dialect)) return std::nullopt;
  Answer answer;
  answer.program = {seat.name, notation, written(list, notation)};
  if (answer.program.text.empty()) return std::nullopt;
  const auto profile =
      std::get<reference::Profile>(reference::default_profile(std::string(notation.dialect)));
  answer.trace = trace_of(*seat.subject, {profile, answer.program.text});
  if (answer.trace.end.given_up) {
    seat.subject = seat.make();
    seat.subject->set_run_limit(options_.run_limit);
  }
  using Kind = oracle::RunEnd::Kind;
  const Kind kind = answer.trace.end.kind;
  if (kind == Kind::skip || kind == Kind::refused || kind == Kind::error) {
    ++count_.skipped;
    return std::nullopt;
  }
  ++count_.programs;
  answer.legs = legs_of(answer.trace, profile.initial.at);
  answer.tolerance = seat.subject->info().resolution.value_or(profile.resolution());
  return answer;
}

std::vector<OperationFinding> OperationHunt::findings_of(const OperationList& list) {
  std::vector<Answer> answers;
  std::vector<OperationFinding> found;
  for (Seat& seat : seats_) {
    for (const relations::Notation& notation : seat.notations) {
      std::optional<Answer> one = answer(seat, notation, list);
      if (!one) continue;
      OperationFinding finding{list, std::nullopt, one->program, {}, {}, {}, count_.lists};
      if (one->trace.end.kind != oracle::RunEnd::Kind::ok) {
        // These programs are right in every dialect: an alarm is none that any of them asks for.
        const bool is_alarm = one->trace.end.kind == oracle::RunEnd::Kind::alarm;
        finding.breakdown =
            is_alarm ? oracle::alarm_text(one->trace.end.alarm) : one->trace.end.message;
        found.push_back(std::move(finding));
        continue;
      }
      const reference::Number tolerance = options_.tolerance.value_or(one->tolerance);
      for (relations::Breach& breach : breaches(list, one->legs, tolerance)) {
        finding.breach = std::move(breach);
        found.push_back(finding);
      }
      answers.push_back(*std::move(one));
    }
  }
  for (std::size_t i = 1; i < answers.size(); ++i) {
    const Answer& first = answers.front();
    const Answer& second = answers[i];
    ++count_.pairs;
    const reference::Number tolerance =
        options_.tolerance.value_or(max(first.tolerance, second.tolerance));
    auto difference = relations::first_difference(first.legs, second.legs, tolerance);
    if (!difference) continue;
    found.push_back(
        {list, first.program, second.program, std::move(difference), {}, {}, count_.lists});
  }
  return found;
}

OperationFinding OperationHunt::reduced(OperationFinding finding) {
  const std::string shape = finding.shape();
  const std::size_t number = finding.number;
  for (bool is_smaller = true; is_smaller;) {
    is_smaller = false;
    for (const OperationList& less : smaller(finding.list)) {
      std::vector<OperationFinding> found = findings_of(less);
      const auto same = std::ranges::find_if(found, [&](const OperationFinding& each) {
        return each.shape() == shape && each.second.subject == finding.second.subject;
      });
      if (same == found.end()) continue;
      finding = std::move(*same);
      is_smaller = true;
      break;
    }
  }
  finding.number = number;
  return finding;
}

std::vector<OperationFinding> OperationHunt::step() {
  ++count_.lists;
  const auto machine =
      dice_.one_in(2) ? relations::MachineKind::mill : relations::MachineKind::lathe;
  const OperationList list = relations::draw_operations(dice_, machine);
  std::vector<OperationFinding> fresh;
  for (OperationFinding& finding : findings_of(list)) {
    ++count_.findings;
    // Which operation it comes from shows when the others are gone.
    if (++reductions_[finding.second.subject + " " + finding.shape()] > kMostReductions) continue;
    OperationFinding small = reduced(std::move(finding));
    if (!known_.insert(small.second.subject + " " + small.signature()).second) continue;
    fresh.push_back(std::move(small));
  }
  return fresh;
}

}  // namespace gonogo::hunt
