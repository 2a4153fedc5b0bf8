// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words and codes that stay in force too long, or not long enough, or a block late.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "fuzz/identify/variant.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::identify {
namespace {

using reference::Kind;
using reference::Setting;

void add_text(std::string name,
              std::function<std::optional<std::string>(const ProgramText&)> change, Variants& out) {
  out.push_back(
      {std::move(name),
       [change = std::move(change)](const Observation& seen) -> std::optional<ChangedRun> {
         auto text = change(ProgramText(seen.profile, seen.program));
         if (!text) return std::nullopt;
         return ChangedRun{std::move(*text), seen.profile, seen.outcome, std::nullopt};
       }});
}

using BlockTest = bool (*)(const TextBlock&);

bool in_motion(const TextBlock& block) {
  return block.modes.code() != nullptr;
}

bool in_cycle(const TextBlock& block) {
  return block.modes.in_cycle();
}

bool in_thread(const TextBlock& block) {
  return block.modes.in_thread();
}

bool in_dwell(const TextBlock& block) {
  return block.modes.is_of(Kind::dwell);
}

bool in_no_thread(const TextBlock& block) {
  return !block.modes.in_thread() && block.modes.code() != nullptr;
}

// The last words of these addresses in blocks of one kind are written again in every later block of
// the other kind that lacks them.
std::optional<std::string> leaked(const ProgramText& program,
                                  const std::set<std::string>& addresses, BlockTest from,
                                  BlockTest to) {
  std::map<std::string, std::string> last;
  return edited_in_order(program, [&](const TextBlock& block) {
    std::string more;
    for (const std::string& address : addresses) {
      const TextWord* word = block.find(address);
      if (word == nullptr && to(block) && last.contains(address)) more += " " + last[address];
      if (word != nullptr && from(block)) last[address] = word->text;
      // A word of its own ends what came from the other kind.
      if (word != nullptr && !from(block) && to(block)) last.erase(address);
    }
    return more;
  });
}

// What ends a cycle, and ought to clear what it retains.
struct Passed {
  std::string name;
  std::set<Kind> kinds;
};

std::vector<Passed> passed_by(const reference::Descriptor& table) {
  const std::set<Kind> motions = {Kind::traverse, Kind::line, Kind::arc, Kind::circle};
  const std::set<Kind> others = {Kind::reference_point, Kind::rename};
  std::vector<Passed> all = {{"motions", motions},
                             {"straight motions", {Kind::traverse, Kind::line}},
                             {"reference points and coordinates", others}};
  if (const reference::Code* off = table.find(Kind::off)) {
    std::set<Kind> both = motions;
    both.insert(Kind::off);
    all.push_back({std::string(off->name), {Kind::off}});
    all.push_back({fmt::format("motions and {}", off->name), std::move(both)});
  }
  return all;
}

bool names_something(const TextBlock& block) {
  return std::ranges::any_of(block.words, program::is_word);
}

// A cycle that lacks a word takes that of a cycle before it, across blocks of these kinds alone.
std::optional<std::string> retained_past(const ProgramText& program,
                                         const std::set<std::string>& addresses,
                                         const std::set<Kind>& passed) {
  std::map<std::string, std::string> given;  // since the last such block
  std::map<std::string, std::string> kept;   // before it
  return edited_in_order(program, [&](const TextBlock& block) {
    std::string more;
    if (!names_something(block) || block.modes.is_of(Kind::dwell)) return more;
    if (!in_cycle(block)) {
      const bool is_passed =
          block.modes.code() != nullptr && passed.contains(block.modes.code()->kind);
      if (is_passed) {
        for (const auto& [address, word] : given) kept[address] = word;
      } else if (block.modes.code() != nullptr) {
        kept.clear();
      }
      given.clear();
      return more;
    }
    for (const std::string& address : addresses) {
      const reference::CodeWord* const meant = block.modes.code()->find(address);
      const TextWord* const word = block.find(address);
      // The same letter may be a number of times to another cycle.
      if (meant != nullptr && meant->role == reference::Role::count) continue;
      if (word != nullptr) {
        given[address] = word->text;
        kept.erase(address);
      } else if (meant != nullptr && kept.contains(address)) {
        more += " " + kept[address];
      }
    }
    return more;
  });
}

// The place along an axis and the way to it are one word to a cycle.
constexpr std::array<std::pair<const char*, const char*>, 3> kPlacesAndWays = {
    {{"X", "U"}, {"Y", "V"}, {"Z", "W"}}};

std::string counterpart_of(const std::string& name) {
  for (const auto& [place, way] : kPlacesAndWays) {
    if (name == place) return way;
    if (name == way) return place;
  }
  return {};
}

// Whether the cycle has a taper across its depth: such ones turn, others drill and mill.
bool has_taper(const reference::Code& code) {
  return std::ranges::any_of(code.words, [](const auto& list) {
    return std::ranges::any_of(list, [](const reference::CodeWord& word) {
      return word.role == reference::Role::along_p || word.role == reference::Role::along_q;
    });
  });
}

// What cycles have given since the last code that is none.
struct Held {
  const reference::Code* code = nullptr;  // the last
  std::map<std::string, std::string> words;

  // Takes the words of the block that hold; returns what it lacks of those of another code.
  std::string take(const TextBlock& block) {
    std::map<std::string, std::string> own;
    for (const TextWord& word : block.words) {
      const reference::CodeWord* const meant = block.modes.code()->find(name_of(word));
      const bool holds = meant != nullptr && meant->life == reference::Life::modal;
      if (holds) own[name_of(word)] = word.text;
    }
    if (own.empty()) return {};
    std::string more;
    for (const auto& [name, text] : words) {
      const bool is_given = own.contains(name) || own.contains(counterpart_of(name));
      const bool is_meant = block.modes.code()->find(name) != nullptr;
      if (block.modes.code() != code && is_meant && !is_given) more += " " + text;
    }
    code = block.modes.code();
    for (const auto& [name, text] : own) {
      words.erase(counterpart_of(name));
      words[name] = text;
    }
    return more;
  }
};

// The first block of one of these cycles behind one of another takes the words that it lacks.
std::optional<std::string> carried_over(const ProgramText& program, const Motions& cycles) {
  Held held;
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (cycles.contains(block.modes.code_name())) return held.take(block);
    const bool clears = block.modes.code() != nullptr && !block.modes.is_of(Kind::cycle);
    if (clears && !block.modes.is_of(Kind::dwell)) held = {};
    return "";
  });
}

// Those that turn, or those that do not, as the code that departs.
Motions cycles_like(const reference::Descriptor& table, const reference::Code& code) {
  Motions cycles;
  for (const reference::Code& other : table.codes) {
    const bool is_alike = other.kind == Kind::cycle && has_taper(other) == has_taper(code);
    if (is_alike) cycles.emplace(other.name);
  }
  return cycles;
}

void add_carried_over(const Observation& departure, const ProgramText& program, Variants& out) {
  const reference::Code* const code = program.table->find(program.code_at(departure.verdict.block));
  if (code == nullptr || code->kind != Kind::cycle) return;
  const Motions cycles = cycles_like(*program.table, *code);
  if (cycles.size() < 2) return;
  add_text(
      fmt::format("what one of {} retains stays in force under another", names_of(cycles)),
      [cycles](const ProgramText& text) { return carried_over(text, cycles); }, out);
}

// A block of the code that lacks the word gets it with the value 0.
std::optional<std::string> zeroed(const ProgramText& program, const std::string& address) {
  std::set<std::string> seen;  // codes under which it was given
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.find(address) != nullptr) {
      seen.emplace(block.modes.code_name());
      return "";
    }
    const bool was_given = seen.contains(std::string(block.modes.code_name()));
    return was_given ? fmt::format(" {}0", address) : "";
  });
}

// Words and codes of `these` are taken out and written in the next block that has words.
std::optional<std::string> late(const ProgramText& program, const std::set<std::string>& these) {
  std::string waiting;
  ProgramText changed = program;
  for (TextBlock& block : changed.blocks) {
    if (std::ranges::none_of(block.words, program::is_word)) continue;
    std::string taken;
    for (TextWord& word : block.words) {
      if (!these.contains(name_of(word)) && !these.contains(block.code_of(word))) continue;
      taken += " " + word.text;
      word.text.clear();
    }
    // A word of the block itself comes after what waited for it: it is one for the next block.
    block.rest.insert(0, waiting);
    waiting = taken;
  }
  std::string text = changed.text();
  return text == program.text() ? std::nullopt : std::optional(std::move(text));
}

// Words of the address count only in a block with a code of motion; or only so in cycles.
std::optional<std::string> stuck(const ProgramText& program, const std::string& address,
                                 BlockTest where) {
  return edited(program,
                [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                  const bool repeats = block.modes.own == nullptr && where(block);
                  if (name_of(word) != address || !repeats) return std::nullopt;
                  return "";
                });
}

// A later block of a cycle names one axis: the others of the cycle do not move, where they have the
// last end point. A way of nothing says so.
std::optional<std::string> standing_still(const ProgramText& program, const Motions& motions) {
  std::set<std::string> ways;  // along the axes that the cycle has named so far
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.modes.is_of(Kind::dwell)) return "";
    if (!motions.contains(block.modes.code_name())) {
      ways.clear();
      return "";
    }
    std::string more;
    bool moves = false;
    for (const auto& [place, way] : kPlacesAndWays) {
      const reference::CodeWord* const word = block.modes.code()->find(way);
      if (word == nullptr || word->role != reference::Role::way) continue;
      const bool is_given = block.find(place) != nullptr || block.find(way) != nullptr;
      moves = moves || is_given;
      if (is_given) ways.insert(way);
      if (!is_given && ways.contains(way)) more += fmt::format(" {}0", way);
    }
    return moves ? more : "";
  });
}

// A code of motion is forgotten with its block: the next one without a code is `instead`.
std::optional<std::string> forgotten(const ProgramText& program, const std::string& code,
                                     const std::string& instead) {
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    const bool repeats = block.modes.own == nullptr && block.modes.code_name() == code;
    return repeats ? " " + instead : "";
  });
}

// What follows the first end of the program is run too.
std::optional<std::string> without_end(const ProgramText& program) {
  return edited(program,
                [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                  const reference::Code* const code = program.table->find(block.code_of(word));
                  const bool ends = code != nullptr && code->kind == Kind::program_end;
                  return ends ? std::optional("") : std::nullopt;
                });
}

// Whether a block before this one has the code.
bool stands_before(std::string_view code, const ProgramText& program, const TextBlock& block) {
  const auto end = program.blocks.begin() + (&block - program.blocks.data());
  return std::any_of(program.blocks.begin(), end,
                     [&](const TextBlock& one) { return one.has_code(code); });
}

// Incremental mode is not to be had again once absolute mode was asked for.
std::optional<std::string> latched(const ProgramText& program) {
  const reference::Code* const absolute = program.table->find(Setting::absolute);
  const reference::Code* const incremental = program.table->find(Setting::incremental);
  if (absolute == nullptr || incremental == nullptr) return std::nullopt;
  return edited(program,
                [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                  const bool is_late = block.code_of(word) == incremental->name &&
                                       stands_before(absolute->name, program, block);
                  return is_late ? std::optional("") : std::nullopt;
                });
}

// A motion that no code asks for after a dwell: a code of its own says that none is in force.
std::optional<std::string> no_motion_after_dwell(const ProgramText& program) {
  const reference::Code* const off = program.table->find(Kind::off);
  if (off == nullptr) return std::nullopt;
  bool dwelt = false;
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.modes.own != nullptr) {
      dwelt = block.modes.own->kind == Kind::dwell;
      return "";
    }
    return std::exchange(dwelt, false) ? fmt::format(" {}", off->name) : "";
  });
}

std::optional<std::string> without_last_mark(const ProgramText& program) {
  ProgramText changed = program;
  std::size_t marks = 0;
  for (TextBlock& block : changed.blocks) {
    if (block.words.empty() || !block.words.front().text.starts_with('%')) continue;
    if (marks++ > 0) block.words.clear();
  }
  if (marks < 2) return std::nullopt;
  return changed.text();
}

// What the blocks of a program name.
struct Named {
  std::set<std::string> addresses;  // but G and M
  std::set<std::string> motions;
};

Named named_in(const ProgramText& program) {
  Named named;
  for (const TextBlock& block : program.blocks) {
    if (block.modes.code() != nullptr) named.motions.emplace(block.modes.code_name());
    for (const TextWord& word : block.words) {
      if (is_word(word) && block.code_of(word).empty()) named.addresses.insert(name_of(word));
    }
  }
  return named;
}

void add_leaks(const reference::Descriptor& table, const std::set<std::string>& addresses,
               Variants& out) {
  std::vector<std::set<std::string>> sets;
  for (const std::string& address : addresses) sets.push_back({address});
  for (const std::set<std::string>& kin : kin_addresses(table)) {
    std::set<std::string> present;
    std::ranges::set_intersection(kin, addresses, std::inserter(present, present.end()));
    if (present.size() > 1) sets.push_back(std::move(present));
  }
  for (const std::set<std::string>& set : sets) {
    std::string names;
    for (const std::string& address : set) names += (names.empty() ? "" : " ") + address;
    add_text(
        fmt::format("{} stays in force in later blocks", names),
        [set](const ProgramText& text) { return leaked(text, set, in_motion, in_motion); }, out);
    add_text(
        fmt::format("{} stays in force from cycle to cycle", names),
        [set](const ProgramText& text) { return leaked(text, set, in_cycle, in_cycle); }, out);
  }
}

std::set<std::string> tapers_of(const reference::Descriptor& table) {
  std::set<std::string> tapers;
  for (const reference::Code& code : table.codes) {
    if (const reference::CodeWord* const taper = taper_of(code)) tapers.emplace(taper->address);
  }
  return tapers;
}

// Words of cycles that stand in the program, each alone and all together.
void add_retained(const reference::Descriptor& table, const std::set<std::string>& addresses,
                  Variants& out) {
  std::set<std::string> all;
  for (const reference::Code& code : table.codes) {
    if (code.kind != Kind::cycle) continue;
    std::ranges::copy_if(addresses, std::inserter(all, all.end()),
                         [&](const std::string& address) { return code.find(address) != nullptr; });
  }
  std::vector<std::pair<std::string, std::set<std::string>>> sets;
  for (const std::string& address : all) sets.push_back({address + " of a cycle", {address}});
  if (all.size() > 1) sets.push_back({"what a cycle retains", all});
  // The tapers of all cycles, where one variable keeps them.
  std::set<std::string> tapers = tapers_of(table);
  if (tapers.size() > 1) {
    const std::string names = fmt::format("{} of a cycle", fmt::join(tapers, " "));
    sets.push_back({names, std::move(tapers)});
  }
  for (const auto& [what, set] : sets) {
    for (const Passed& passed : passed_by(table)) {
      add_text(
          fmt::format("{} stays in force past {}", what, passed.name),
          [set, kinds = passed.kinds](const ProgramText& text) {
            return retained_past(text, set, kinds);
          },
          out);
    }
  }
}

void add_lost_words(const std::set<std::string>& addresses, Variants& out) {
  for (const std::string& address : addresses) {
    add_text(
        fmt::format("{} holds for its own block only", address),
        [address](const ProgramText& text) { return zeroed(text, address); }, out);
    add_text(
        fmt::format("{} of a block that repeats a code has no effect", address),
        [address](const ProgramText& text) { return stuck(text, address, in_motion); }, out);
    add_text(
        fmt::format("{} of a block that repeats a cycle has no effect", address),
        [address](const ProgramText& text) { return stuck(text, address, in_cycle); }, out);
  }
}

void add_mode_slips(Variants& out) {
  add_text(
      "F of a thread becomes the feed",
      [](const ProgramText& text) { return leaked(text, {"F"}, in_thread, in_no_thread); }, out);
  add_text(
      "the feed serves as the lead of a thread without F",
      [](const ProgramText& text) { return leaked(text, {"F"}, in_no_thread, in_thread); }, out);
  add_text(
      "F of a dwell becomes the feed",
      [](const ProgramText& text) { return leaked(text, {"F"}, in_dwell, in_no_thread); }, out);
  add_text("G91 has no effect after G90", latched, out);
  add_text("after a dwell no motion code is in force", no_motion_after_dwell, out);
}

void add_late_words(const std::set<std::string>& addresses, Variants& out) {
  add_text(
      "F holds from the next block on", [](const ProgramText& text) { return late(text, {"F"}); },
      out);
  add_text(
      "a plane code holds from the next block on",
      [](const ProgramText& text) {
        std::set<std::string> planes;
        for (const Setting plane : {Setting::plane_xy, Setting::plane_zx, Setting::plane_yz}) {
          planes.emplace(text.table->find(plane)->name);
        }
        return late(text, planes);
      },
      out);
  add_text(
      "R parameters change after their block",
      [addresses](const ProgramText& text) {
        std::set<std::string> parameters;
        std::ranges::copy_if(addresses, std::inserter(parameters, parameters.end()), is_parameter);
        return late(text, parameters);
      },
      out);
}

void add_forgotten_motions(const reference::Descriptor& table, const std::set<std::string>& motions,
                           Variants& out) {
  for (const std::string& motion : motions) {
    for (const Kind kind : {Kind::traverse, Kind::line}) {
      const std::string instead(table.find(kind)->name);
      if (motion == instead || motion.front() != 'G') continue;
      add_text(
          fmt::format("after a block with {} the next one is {}", motion, instead),
          [=](const ProgramText& text) { return forgotten(text, motion, instead); }, out);
    }
  }
}

// The machine on which a text without an end is none that alarms.
reference::Profile without_need_of_an_end(reference::Profile profile) {
  profile.readings.set("ngc.program-end=free"_reading);
  return profile;
}

std::optional<ChangedRun> with_last_mark_ignored(const Observation& seen) {
  auto text = without_last_mark(ProgramText(seen.profile, seen.program));
  if (!text) return std::nullopt;
  return ChangedRun{std::move(*text), without_need_of_an_end(seen.profile), seen.outcome,
                    std::nullopt};
}

std::optional<ChangedRun> with_end_ignored(const Observation& seen) {
  auto text = without_end(ProgramText(seen.profile, seen.program));
  if (!text) return std::nullopt;
  ChangedRun trial{std::move(*text), without_need_of_an_end(seen.profile), seen.outcome,
                   std::nullopt};
  // It is passed on all the same.
  std::erase_if(trial.outcome.records, [](const Record& record) {
    return record.kind == reference::RecordKind::m &&
           (record.m == 2 || record.m == 17 || record.m == 30);
  });
  return trial;
}

}  // namespace

void add_modal_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  const Named named = named_in(program);
  add_retained(*program.table, named.addresses, out);
  add_carried_over(departure, program, out);
  add_leaks(*program.table, named.addresses, out);
  add_lost_words(named.addresses, out);
  for (const Motions& motions : motions_concerned(departure)) {
    add_text(
        fmt::format("an axis that a later block of {} does not name does not move",
                    names_of(motions)),
        [motions](const ProgramText& text) { return standing_still(text, motions); }, out);
  }
  add_mode_slips(out);
  add_late_words(named.addresses, out);
  add_forgotten_motions(*program.table, named.motions, out);
  out.push_back({"the end of the program is ignored", with_end_ignored});
  out.push_back({"the second % does not end the program", with_last_mark_ignored});
}

}  // namespace gonogo::identify
