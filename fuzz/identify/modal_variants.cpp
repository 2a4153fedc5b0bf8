// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words and codes that stay in force too long, or not long enough, or a block late.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

void add_text(std::string name,
              std::function<std::optional<std::string>(const ProgramText&)> change, Variants& out) {
  out.push_back({std::move(name),
                 [change = std::move(change)](const Observation& seen) -> std::optional<Trial> {
                   auto text = change(ProgramText(seen.profile, seen.program));
                   if (!text) return std::nullopt;
                   return Trial{std::move(*text), seen.profile, seen.outcome, std::nullopt};
                 }});
}

std::string text_of(const TextBlock& block, const TextWord& word) {
  return block.text.substr(word.where.begin, word.where.end - word.where.begin);
}

using BlockTest = bool (*)(const TextBlock&);

bool in_motion(const TextBlock& block) {
  return !block.motion.empty();
}

bool in_cycle(const TextBlock& block) {
  return block.in_cycle();
}

bool in_thread(const TextBlock& block) {
  return block.in_thread();
}

bool in_no_thread(const TextBlock& block) {
  return !block.in_thread() && !block.motion.empty();
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
      if (word != nullptr && from(block)) last[address] = text_of(block, *word);
    }
    return more;
  });
}

// A block of the code that lacks the word gets it with the value 0.
std::optional<std::string> zeroed(const ProgramText& program, const std::string& address) {
  std::set<std::string> seen;  // codes under which it was given
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.find(address) != nullptr) {
      seen.insert(block.motion);
      return "";
    }
    return seen.contains(block.motion) ? fmt::format(" {}0", address) : "";
  });
}

// Words and codes of `these` are taken out and written in the next block that has words.
std::optional<std::string> late(const ProgramText& program, const std::set<std::string>& these) {
  std::string waiting;
  const auto is_late = [&](const TextWord& word) {
    return these.contains(word.address) || (word.is_code() && these.contains(word.code()));
  };
  ProgramText changed = program;
  for (TextBlock& block : changed.blocks) {
    if (block.words.empty()) continue;
    std::string taken;
    std::string line = block.text;
    for (auto word = block.words.rbegin(); word != block.words.rend(); ++word) {
      if (!is_late(*word)) continue;
      taken.insert(0, " " + text_of(block, *word));
      line.erase(word->where.begin, word->where.end - word->where.begin);
    }
    // A word of the block itself comes after what waited for it: it is one for the next block.
    block.text = line + waiting;
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
                  if (word.address != address || block.own_motion || !where(block))
                    return std::nullopt;
                  return "";
                });
}

// A code of motion is forgotten with its block: the next one without a code is `instead`.
std::optional<std::string> forgotten(const ProgramText& program, const std::string& code,
                                     const std::string& instead) {
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    return !block.own_motion && block.motion == code ? " " + instead : "";
  });
}

// What follows the first end of the program is run too.
std::optional<std::string> without_end(const ProgramText& program) {
  return edited(program, [](const TextBlock&, const TextWord& word) -> std::optional<std::string> {
    const std::string code = word.code();
    if (code == "M2" || code == "M17" || code == "M30") return "";
    return std::nullopt;
  });
}

// Whether a block before this one has G90.
bool absolute_before(const ProgramText& program, const TextBlock& block) {
  const auto end = program.blocks.begin() + (&block - program.blocks.data());
  return std::any_of(program.blocks.begin(), end, [](const TextBlock& one) {
    return std::ranges::any_of(one.words,
                               [](const TextWord& word) { return word.code() == "G90"; });
  });
}

// Incremental mode is not to be had again once absolute mode was asked for.
std::optional<std::string> latched(const ProgramText& program) {
  return edited(program,
                [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                  if (word.code() != "G91" || !absolute_before(program, block)) return std::nullopt;
                  return "";
                });
}

// A motion that no code asks for after a dwell: G80 says that none is in force.
std::optional<std::string> no_motion_after_dwell(const ProgramText& program) {
  bool dwelt = false;
  return edited_in_order(program, [&](const TextBlock& block) -> std::string {
    if (block.own_motion) {
      dwelt = block.motion == "G4";
      return "";
    }
    return std::exchange(dwelt, false) ? " G80" : "";
  });
}

std::optional<std::string> without_last_mark(const ProgramText& program) {
  ProgramText changed = program;
  std::size_t marks = 0;
  for (TextBlock& block : changed.blocks) {
    if (!block.text.starts_with('%')) continue;
    if (marks++ > 0) block.text.clear();
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
    if (!block.motion.empty()) named.motions.insert(block.motion);
    for (const TextWord& word : block.words) {
      if (!word.is_code()) named.addresses.insert(word.address);
    }
  }
  return named;
}

void add_leaks(const std::set<std::string>& addresses, Variants& out) {
  std::vector<std::set<std::string>> sets;
  for (const std::string& address : addresses) sets.push_back({address});
  if (addresses.contains("R") && addresses.contains("Q")) sets.push_back({"R", "Q"});
  if (addresses.contains("I") && addresses.contains("K")) sets.push_back({"I", "K"});
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
        return late(text, {"G17", "G18", "G19"});
      },
      out);
  add_text(
      "R parameters change after their block",
      [addresses](const ProgramText& text) {
        std::set<std::string> parameters;
        for (const std::string& address : addresses) {
          if (address.size() > 1 && address[0] == 'R' && address[1] <= '9') {
            parameters.insert(address);
          }
        }
        return late(text, parameters);
      },
      out);
}

void add_forgotten_motions(const std::set<std::string>& motions, Variants& out) {
  for (const std::string& motion : motions) {
    for (const std::string instead : {"G0", "G1"}) {
      if (motion == instead || motion.front() != 'G') continue;
      add_text(
          fmt::format("after a block with {} the next one is {}", motion, instead),
          [=](const ProgramText& text) { return forgotten(text, motion, instead); }, out);
    }
  }
}

// The machine on which a text without an end is none that alarms.
reference::Profile without_need_of_an_end(reference::Profile profile) {
  profile.readings.set(reference::ReadingKey::ngc_program_end, "free");
  return profile;
}

std::optional<Trial> with_last_mark_ignored(const Observation& seen) {
  auto text = without_last_mark(ProgramText(seen.profile, seen.program));
  if (!text) return std::nullopt;
  return Trial{std::move(*text), without_need_of_an_end(seen.profile), seen.outcome, std::nullopt};
}

std::optional<Trial> with_end_ignored(const Observation& seen) {
  auto text = without_end(ProgramText(seen.profile, seen.program));
  if (!text) return std::nullopt;
  Trial trial{std::move(*text), without_need_of_an_end(seen.profile), seen.outcome, std::nullopt};
  // It is passed on all the same.
  std::erase_if(trial.outcome.records, [](const Record& record) {
    return record.kind == reference::RecordKind::m &&
           (record.m == 2 || record.m == 17 || record.m == 30);
  });
  return trial;
}

}  // namespace

void add_modal_variants(const Observation& departure, Variants& out) {
  const Named named = named_in(ProgramText(departure.profile, departure.program));
  add_leaks(named.addresses, out);
  add_lost_words(named.addresses, out);
  add_mode_slips(out);
  add_late_words(named.addresses, out);
  add_forgotten_motions(named.motions, out);
  out.push_back({"the end of the program is ignored", with_end_ignored});
  out.push_back({"the second % does not end the program", with_last_mark_ignored});
}

}  // namespace gonogo::identify
