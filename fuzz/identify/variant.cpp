// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/variant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "reference/dialect.hpp"

namespace gonogo::identify {

std::optional<ChangedRun> with_program(const Observation& seen,
                                       std::optional<std::string> program) {
  if (!program) return std::nullopt;
  return ChangedRun{*std::move(program), seen.profile, seen.outcome, std::nullopt};
}

void add_model(std::string name, ModelChange change, Variants& out) {
  out.push_back(
      {std::move(name),
       [change = std::move(change)](const Observation& seen) -> std::optional<ChangedRun> {
         auto model = run_reference(seen.profile, seen.program);
         if (!model || model->not_covered || !change(seen, *model)) return std::nullopt;
         return ChangedRun{seen.program, seen.profile, seen.outcome, std::move(model)};
       }});
}

void add_text(std::string name, TextChange change, Variants& out) {
  out.push_back({std::move(name), [change = std::move(change)](const Observation& seen) {
                   return with_program(seen, change(ProgramText(seen.profile, seen.program)));
                 }});
}

void add_edit(std::string name, program::WordEdit edit, Variants& out) {
  add_text(
      std::move(name),
      [edit = std::move(edit)](const ProgramText& program) { return edited(program, edit); }, out);
}

void add_without(std::string name, program::WordTest goes, Variants& out) {
  add_text(
      std::move(name),
      [goes = std::move(goes)](const ProgramText& program) { return without_words(program, goes); },
      out);
}

void add_outcome(std::string name, OutcomeChange change, Variants& out) {
  out.push_back(
      {std::move(name),
       [change = std::move(change)](const Observation& seen) -> std::optional<ChangedRun> {
         ChangedRun trial{seen.program, seen.profile, seen.outcome, std::nullopt};
         change(seen, trial.outcome);
         if (trial.outcome.text() == seen.outcome.text() &&
             trial.outcome.end.alarm.block == seen.outcome.end.alarm.block) {
           return std::nullopt;
         }
         return trial;
       }});
}

bool has_same_words(const Code& a, const Code& b) {
  return std::ranges::equal(a.words, b.words, [](const auto& one, const auto& other) {
    return std::ranges::equal(one, other, {}, &CodeWord::address, &CodeWord::address);
  });
}

std::set<std::string> addresses_in(const ProgramText& program) {
  std::set<std::string> addresses;
  for (const TextBlock& block : program.blocks) {
    for (const TextWord& word : block.words) {
      if (is_word(word) && block.code_of(word).empty()) addresses.insert(name_of(word));
    }
  }
  return addresses;
}

bool is_parameter(const std::string& name) {
  return name.size() > 1 && name[0] == 'R' && name[1] >= '0' && name[1] <= '9';
}

std::set<std::string> addresses_with(const Descriptor& table, std::initializer_list<Role> roles,
                                     bool rotary) {
  std::set<std::string> addresses;
  for (const Code& code : table.codes) {
    for (const auto& list : code.words) {
      for (const CodeWord& word : list) {
        const bool is_asked = std::ranges::find(roles, word.role) != roles.end();
        const bool turns = word.address == "A" || word.address == "C";
        if (is_asked && turns == rotary) addresses.emplace(word.address);
      }
    }
  }
  std::erase_if(addresses,
                [](const std::string& address) { return address.find(' ') != std::string::npos; });
  return addresses;
}

std::vector<std::set<std::string>> kin_addresses(const Descriptor& table) {
  return {addresses_with(table, {Role::centre}),
          addresses_with(table, {Role::centre, Role::radius}),
          addresses_with(table, {Role::middle}),
          addresses_with(table, {Role::place}, true),
          addresses_with(table, {Role::size, Role::step}),
          addresses_with(table, {Role::way}),
          addresses_with(table, {Role::place})};
}

namespace {

Motions codes_of(const Descriptor& table, Kind kind) {
  Motions codes;
  for (const Code& code : table.codes) {
    if (code.kind == kind) codes.emplace(code.name);
  }
  return codes;
}

}  // namespace

std::vector<Motions> motions_concerned(const Observation& departure) {
  const ProgramText program(departure.profile, departure.program);
  const Code* const code = program.table->find(program.code_at(departure.verdict.block));
  if (code == nullptr) return {};
  // The same code turned the other way; codes with the same words; cycles of the same modal group;
  // all threads, all cycles.
  std::array<Motions, 5> kin;
  kin[0].emplace(code->name);
  if (code->kind == Kind::thread || code->kind == Kind::cycle) {
    kin[4] = codes_of(*program.table, code->kind);
  }
  for (const Code& other : program.table->codes) {
    if (other.kind != code->kind) continue;
    if (other.sense == 0) continue;
    if (other.feature == code->feature) kin[1].emplace(other.name);
    if (has_same_words(other, *code)) kin[2].emplace(other.name);
    if (other.group == code->group) kin[3].emplace(other.name);
  }
  std::vector<Motions> concerned;
  for (Motions& motions : kin) {
    const bool is_known = std::ranges::find(concerned, motions) != concerned.end();
    if (motions.contains(code->name) && !is_known) concerned.push_back(std::move(motions));
  }
  return concerned;
}

Number half_up(const Number& value, int places) {
  return reference::Number::parse(value.decimal_text(places)).value();
}

std::string names_of(const Motions& motions) {
  const bool is_all =
      std::ranges::any_of(reference::dialects(), [&](const reference::Dialect& dialect) {
        return motions == codes_of(*dialect.descriptor, Kind::cycle);
      });
  if (is_all && motions.size() > 1) return "all cycles";
  return fmt::format("{}", fmt::join(motions, " "));
}

bool is_of(const ProgramText& program, std::uint64_t line, const Motions& motions) {
  return motions.contains(program.code_at(line));
}

std::vector<BlockPath> paths_of(const Observation& seen, std::size_t blocks) {
  std::vector<BlockPath> paths(blocks + 2);
  const auto outcome = run_reference(seen.profile, seen.program);
  if (!outcome) return {};
  Position at = seen.profile.initial.at;
  std::size_t block = 0;
  const auto go_to = [&](std::size_t line) {
    while (block < line && block + 1 < paths.size()) paths[++block].start = at;
  };
  for (const Record& record : outcome->records) {
    go_to(record.block);
    if (record.block < paths.size()) paths[record.block].records.push_back(record);
    for (const Axis axis : reference::kAllAxes) {
      if (record.axes.has(axis)) at[axis] = record.to[axis];
    }
  }
  go_to(blocks + 1);
  return paths;
}

}  // namespace gonogo::identify
