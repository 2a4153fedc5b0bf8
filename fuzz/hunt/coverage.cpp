// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/coverage.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "fuzz/program/modes.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::hunt {
namespace {

using reference::Axis;
using reference::Item;
using reference::Record;

// What a feature is about; keeps equal numbers of different meaning apart.
enum class Part : std::uint64_t {
  plain,
  machine,
  code,
  earlier_code,
  clause_before,
  words,
  sparse
};

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9E3779B97F4A7C15U + (hash << 6) + (hash >> 2);
  hash *= 0xFF51AFD7ED558CCDU;
  return hash ^ hash >> 32;
}

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3U;
  return hash;
}

int sign_of(std::int64_t value) {
  return value < 0 ? -1 : value > 0 ? 1 : 0;
}

// How two words of a block compare, by their sizes and by their signs.
std::uint64_t relation(const program::SmallDecimal& x, const program::SmallDecimal& y) {
  const auto [a, b] = same_scale(x, y);
  const std::int64_t size_a = std::abs(a);
  const std::int64_t size_b = std::abs(b);
  const auto near = [](std::int64_t apart) { return apart >= -1 && apart <= 1; };
  std::uint64_t side = size_a > size_b ? 0 : 1;
  if (size_b != 0 && size_a % size_b == 0) side = 2;
  if (size_a != 0 && size_b % size_a == 0) side = 3;
  // Where a rule may turn over: equal, or one the double of the other, and the increments beside.
  if (near(size_a - size_b)) side = static_cast<std::uint64_t>(5 + size_a - size_b);
  if (near(size_a - 2 * size_b)) side = static_cast<std::uint64_t>(8 + size_a - 2 * size_b);
  if (near(2 * size_a - size_b)) side = static_cast<std::uint64_t>(11 + 2 * size_a - size_b);
  return side * 9 + static_cast<std::uint64_t>((sign_of(a) + 1) * 3 + sign_of(b) + 1);
}

class Collector {
 public:
  Collector(const generate::GeneratedProgram& program, CoverageDetail detail)
      : detail_(detail),
        text_(program.profile, program.text),
        at_(program.profile.initial.at),
        machine_(hash_of(machine_text(program.profile))) {}

  void take(const Item& item) {
    if (const auto* record = std::get_if<Record>(&item)) {
      if (record->kind != reference::RecordKind::end)
        note(record->block, record->clause, decided(*record));
    } else if (const auto* report = std::get_if<reference::AlarmReport>(&item)) {
      for (const reference::Alarm& alarm : report->alarms) {
        note(report->block, alarm.clause,
             mix(mix(hash_of("alarm"), static_cast<std::uint64_t>(alarm.alarm)),
                 hash_of(alarm.word.text())));
      }
    } else if (const auto* level = std::get_if<reference::PocketLevel>(&item)) {
      note(level->block, level->clause,
           mix(hash_of("level"), static_cast<std::uint64_t>(level->sense) + 1));
    } else if (const auto* helix = std::get_if<reference::HelixPocket>(&item)) {
      note(helix->block, helix->clause,
           mix(hash_of("helix"), static_cast<std::uint64_t>(helix->sense) + 1));
    } else if (const auto* thread = std::get_if<reference::ThreadMilling>(&item)) {
      note(thread->block, thread->clause,
           mix(mix(hash_of("thread"), thread->external ? 1 : 0),
               static_cast<std::uint64_t>(thread->travel.sign()) + 1));
    } else if (const auto* pocket = std::get_if<reference::PocketMilling>(&item)) {
      note(pocket->block, pocket->clause,
           mix(mix(hash_of("pocket"), pocket->finishing ? 1 : 0),
               static_cast<std::uint64_t>(pocket->sense) + 1));
    }
  }

  // Notes what was decided there, too.
  void note_in(Reached& reached) { reached_ = &reached; }

  std::vector<std::uint64_t> features() && {
    std::ranges::sort(features_);
    features_.erase(std::unique(features_.begin(), features_.end()), features_.end());
    return std::move(features_);
  }

 private:
  // Settings that hold for the whole program, without values of its own.
  static std::string machine_text(const reference::Profile& profile) {
    std::string text = reference::profile_json(profile);
    std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
    return text;
  }

  // Kind, plane, sense and signs of the travel. Follows the position.
  std::uint64_t decided(const Record& record) {
    std::uint64_t hash = mix(hash_of("record"), static_cast<std::uint64_t>(record.kind));
    hash = mix(hash, static_cast<std::uint64_t>(record.plane) * 3 +
                         static_cast<std::uint64_t>(record.feed_mode));
    hash = mix(hash, static_cast<std::uint64_t>(record.rot < 0 ? 0 : record.rot > 0 ? 2 : 1));
    for (const Axis axis : reference::kAllAxes) {
      if (!record.axes.has(axis)) continue;
      const int travel = (record.to[axis] - at_[axis]).sign();
      hash = mix(hash, reference::index(axis) * 3 + static_cast<std::uint64_t>(travel + 1));
      at_[axis] = record.to[axis];
    }
    return hash;
  }

  void add(Part part, std::uint64_t what, std::uint64_t state) {
    features_.push_back(mix(mix(what, static_cast<std::uint64_t>(part)), state));
  }

  void note(std::uint64_t block, reference::ClauseId clause, std::uint64_t decision) {
    if (reached_ != nullptr && clause != reference::kNoClause) {
      (*reached_)[clause].insert(decision);
    }
    const std::uint64_t what = mix(decision, clause);
    const std::size_t line = block == 0 ? 0 : static_cast<std::size_t>(block - 1);
    add(Part::plain, what, 0);
    const bool all = detail_ == CoverageDetail::all;
    if (all) add(Part::machine, what, machine_);
    add(Part::clause_before, what, clause_before_);
    if (line < text_.blocks.size()) {
      add(Part::code, what, hash_of(text_.code_at(block)));
      if (all && block != block_) enter(line);
      if (all && clause != clause_before_) {
        for (const std::uint64_t code : earlier_codes_) add(Part::earlier_code, clause, code);
        compare_words(line, clause);
      }
    }
    block_ = block;
    clause_before_ = clause;
  }

  // A block begins: the codes of the lines up to it have been written.
  void enter(std::size_t line) {
    for (; next_line_ <= line; ++next_line_) {
      for (const std::string& code : text_.blocks[next_line_].codes) {
        if (!code.empty()) earlier_codes_.push_back(hash_of(code));
      }
    }
    std::ranges::sort(earlier_codes_);
    earlier_codes_.erase(std::unique(earlier_codes_.begin(), earlier_codes_.end()),
                         earlier_codes_.end());
  }

  void compare_words(std::size_t line, reference::ClauseId clause) {
    constexpr std::size_t kMostWords = 10;
    const std::vector<program::TextWord>& words = text_.blocks[line].words;
    const std::size_t count = std::min(words.size(), kMostWords);
    const std::uint64_t what = mix(clause, hash_of(text_.blocks[line].modes.code_name()));
    for (std::size_t i = 0; i < count; ++i) {
      const auto a = value_of(words[i]);
      if (!a || !code_of(words[i]).empty()) continue;
      const std::uint64_t address = hash_of(address_of(words[i]));
      add(Part::sparse, mix(what, address), static_cast<std::uint64_t>(sign_of(a->value)) + 1);
      for (std::size_t j = i + 1; j < count; ++j) {
        const auto b = value_of(words[j]);
        if (!b || !code_of(words[j]).empty()) continue;
        add(Part::words, mix(mix(what, address), hash_of(address_of(words[j]))), relation(*a, *b));
      }
    }
  }

  CoverageDetail detail_;
  program::ProgramText text_;
  reference::Position at_;
  std::uint64_t machine_;
  std::vector<std::uint64_t> earlier_codes_;
  std::size_t next_line_ = 0;
  std::uint64_t block_ = 0;
  std::uint64_t clause_before_ = reference::kNoClause;
  std::vector<std::uint64_t> features_;
  Reached* reached_ = nullptr;
};

// An area that is left open costs the judge as much as many records. Without that a few pockets
// of a thousand levels took three quarters of a hunt's time.
std::size_t cost_of(const Item& item) {
  constexpr std::size_t kArea = 20;
  return std::holds_alternative<Record>(item) ||
                 std::holds_alternative<reference::AlarmReport>(item)
             ? 1
             : kArea;
}

// All that the reference does with the program, and what that costs; nothing: more than that.
std::optional<std::size_t> collect(const generate::GeneratedProgram& program, std::size_t most_cost,
                                   Collector& collector) {
  std::size_t cost = 0;
  oracle::ProgramInput input(program.text);
  reference::Expander expander(program.profile, input.lines, reference::OpenPaths::judged);
  try {
    while (const Item* item = expander.next()) {
      cost += cost_of(*item);
      if (cost > most_cost) return std::nullopt;
      collector.take(*item);
    }
  } catch (const exact::Undecided&) {
    // The judge comes to the same place and says so.
  }
  return cost;
}

}  // namespace

std::optional<Coverage> coverage_of(const generate::GeneratedProgram& program,
                                    std::size_t most_cost, CoverageDetail detail) {
  Collector collector(program, detail);
  const auto cost = collect(program, most_cost, collector);
  if (!cost) return std::nullopt;
  return Coverage{std::move(collector).features(), *cost};
}

std::optional<Reached> reached_by(const generate::GeneratedProgram& program,
                                  std::size_t most_cost) {
  Reached reached;
  Collector collector(program, CoverageDetail::clauses);
  collector.note_in(reached);
  if (!collect(program, most_cost, collector)) return std::nullopt;
  return reached;
}

}  // namespace gonogo::hunt
