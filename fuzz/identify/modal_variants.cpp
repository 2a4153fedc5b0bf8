// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words and codes that stay in force too long, or not long enough, or a block late.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "fuzz/identify/variant.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::identify {
namespace {

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
      if (block.modes.inverse_time && name_of(word) == "F") continue;  // it is of this block alone
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
  return without_words(program, [&](const TextBlock& block, const TextWord& word) {
    const bool repeats = block.modes.own == nullptr && where(block);
    return repeats && name_of(word) == address;
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
  return without_words(program, [&](const TextBlock& block, const TextWord& word) {
    const Code* const code = program.table->find(block.code_of(word));
    return code != nullptr && code->kind == Kind::program_end;
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
  const Code* const absolute = program.table->find(Setting::absolute);
  const Code* const incremental = program.table->find(Setting::incremental);
  if (absolute == nullptr || incremental == nullptr) return std::nullopt;
  return without_words(program, [&](const TextBlock& block, const TextWord& word) {
    return block.code_of(word) == incremental->name &&
           stands_before(absolute->name, program, block);
  });
}

// A motion that no code asks for after a dwell: a code of its own says that none is in force.
std::optional<std::string> no_motion_after_dwell(const ProgramText& program) {
  const Code* const off = program.table->find(Kind::off);
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

void add_leaks(const Descriptor& table, const std::set<std::string>& addresses, Variants& out) {
  std::vector<std::set<std::string>> sets;
  for (const std::string& address : addresses) sets.push_back({address});
  for (const std::set<std::string>& kin : kin_addresses(table)) {
    std::set<std::string> present;
    std::ranges::set_intersection(kin, addresses, std::inserter(present, present.end()));
    if (present.size() > 1) sets.push_back(std::move(present));
  }
  for (const std::set<std::string>& set : sets) {
    const std::string names = fmt::format("{}", fmt::join(set, " "));
    add_text(
        fmt::format("{} stays in force in later blocks", names),
        [set](const ProgramText& text) { return leaked(text, set, in_motion, in_motion); }, out);
    add_text(
        fmt::format("{} stays in force from cycle to cycle", names),
        [set](const ProgramText& text) { return leaked(text, set, in_cycle, in_cycle); }, out);
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

void add_forgotten_motions(const ProgramText& program, Variants& out) {
  std::set<std::string> motions;
  for (const TextBlock& block : program.blocks) {
    if (block.modes.code() != nullptr) motions.emplace(block.modes.code_name());
  }
  for (const std::string& motion : motions) {
    for (const Kind kind : {Kind::traverse, Kind::line}) {
      const std::string instead(program.table->find(kind)->name);
      if (motion == instead || motion.front() != 'G') continue;
      add_text(
          fmt::format("after a block with {} the next one is {}", motion, instead),
          [=](const ProgramText& text) { return forgotten(text, motion, instead); }, out);
    }
  }
}

// On a machine on which a text without an end is none that alarms.
std::optional<ChangedRun> run_without_end(const Observation& seen,
                                          std::optional<std::string> program) {
  auto trial = with_program(seen, std::move(program));
  if (trial) trial->profile.readings.set("ngc.program-end=free"_reading);
  return trial;
}

std::optional<ChangedRun> with_last_mark_ignored(const Observation& seen) {
  return run_without_end(seen, without_last_mark(ProgramText(seen.profile, seen.program)));
}

std::optional<ChangedRun> with_end_ignored(const Observation& seen) {
  auto trial = run_without_end(seen, without_end(ProgramText(seen.profile, seen.program)));
  if (!trial) return std::nullopt;
  // It is passed on all the same.
  std::erase_if(trial->outcome.records, [](const Record& record) {
    return record.kind == RecordKind::m && (record.m == 2 || record.m == 17 || record.m == 30);
  });
  return trial;
}

}  // namespace

void add_modal_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  const std::set<std::string> addresses = addresses_in(program);
  add_leaks(*program.table, addresses, out);
  add_lost_words(addresses, out);
  add_mode_slips(out);
  add_late_words(addresses, out);
  add_forgotten_motions(program, out);
  out.push_back({"the end of the program is ignored", with_end_ignored});
  out.push_back({"the second % does not end the program", with_last_mark_ignored});
}

}  // namespace gonogo::identify
