// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/supported_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/program/features.hpp"
#include "oracle/differential/reference_run.hpp"

namespace gonogo::hunt {

using program::ProgramText;
using program::TextBlock;
using program::TextWord;

namespace {

constexpr std::string_view kFeature = "feature ";
constexpr std::string_view kSetting = "setting ";
constexpr std::size_t kLearning = 400;    // programs
constexpr std::size_t kMostTogether = 3;  // parts that are tried at once

bool is_code_or_word(const std::string& part) {
  return part.starts_with("code ") || part.starts_with("word ");
}

Parts codes_and_words(const TextBlock& block, const reference::Descriptor& table) {
  Parts parts = parts_of_block(block, table);
  std::erase_if(parts, [](const std::string& part) { return !is_code_or_word(part); });
  return parts;
}

bool is_feature(const std::string& part) {
  return part.starts_with(kFeature);
}

bool is_setting(const std::string& part) {
  return part.starts_with(kSetting);
}

std::string setting(std::size_t part) {
  return fmt::format("{}{}", kSetting, part);
}

// What of the profile is not the default: its parts but the first, which is all readings at once.
std::vector<std::size_t> settings_of(const reference::Profile& profile) {
  std::vector<std::size_t> parts = parts_set(profile);
  std::erase(parts, std::size_t{0});
  return parts;
}

// A single block of the program and its last one, on the default machine: of so few parts that most
// of what a subject does comes to light. Every other time the block is written plainly, and M2 or
// M30 ends the program.
generate::GeneratedProgram single_block(const generate::GeneratedProgram& program,
                                        std::size_t which) {
  generate::GeneratedProgram made = program;
  for (const std::size_t part : settings_of(made.profile)) reset_part(made.profile, part);
  const ProgramText text(made.profile, made.text);
  std::vector<const TextBlock*> blocks;
  for (const TextBlock& block : text.blocks) {
    if (!block.words.empty()) blocks.push_back(&block);
  }
  if (blocks.size() < 2) return made;
  if (which % 2 == 0) {
    made.text =
        plainly(*blocks[which / 2 % (blocks.size() - 1)]) + (which % 4 == 0 ? "M2\n" : "M30\n");
    return made;
  }
  made.text =
      program::line_text(*blocks[which % (blocks.size() - 1)]) + program::line_text(*blocks.back());
  return made;
}

// How many blocks ran for sure, by the reference: those before an alarm, and as far as there are
// records.
std::size_t blocks_run(const generate::GeneratedProgram& program) {
  constexpr std::size_t kMostRecords = 5'000;
  const oracle::ReferenceRun run =
      oracle::run_reference(program.profile, program.text, kMostRecords);
  if (!run.alarms.empty()) return static_cast<std::size_t>(run.end.alarm.block - 1);
  std::uint64_t last = 0;
  for (const reference::Record& record : run.records) last = std::max(last, record.block);
  return static_cast<std::size_t>(last);
}

// The block by itself as it runs by the reference, for why one with an alarm is skipped says
// nothing of its parts; with a word of another block where it does not run without (G1 and the F in
// force).
std::optional<generate::GeneratedProgram> runs_alone(const reference::Profile& machine,
                                                     const ProgramText& text,
                                                     const TextBlock& block, Numbers numbers,
                                                     const char* end) {
  const auto runs = [&](const TextBlock& alone) {
    generate::GeneratedProgram made = {machine, plainly(alone, numbers) + end};
    const bool whole = blocks_run(made) >= program::count_blocks(made.text);
    return whole ? std::optional(std::move(made)) : std::nullopt;
  };
  if (block.words.empty()) return std::nullopt;
  if (auto made = runs(block)) return made;
  for (const TextBlock& other : text.blocks) {
    for (const TextWord& word : other.words) {
      if (!program::is_word(word) || !other.code_of(word).empty()) continue;
      TextBlock longer = block;
      longer.words.push_back(word);
      longer.codes.emplace_back();
      if (auto made = runs(longer)) return made;
    }
  }
  return std::nullopt;
}

}  // namespace

SupportedFeatures::SupportedFeatures(const oracle::SubjectInfo& info, std::string dialect)
    : info_(info), dialect_(std::move(dialect)) {}

Parts SupportedFeatures::parts_of(const generate::GeneratedProgram& program,
                                  std::size_t blocks) const {
  const ProgramText text(program.profile, program.text);
  Parts parts;
  for (const TextBlock& block :
       std::span(text.blocks).first(std::min(blocks, text.blocks.size()))) {
    parts.merge(parts_of_block(block, *text.table));
  }
  for (const std::size_t part : settings_of(program.profile)) parts.insert(setting(part));
  return parts;
}

bool SupportedFeatures::is_declared(const generate::GeneratedProgram& program) const {
  if (info_.everything) return true;
  return std::ranges::all_of(
      program::features_needed({program.profile, program.text}),
      [&](const std::string& feature) { return info_.declares(dialect_, feature); });
}

bool SupportedFeatures::is_undeclared(const std::string& part) const {
  return is_feature(part) && !info_.declares(dialect_, part.substr(kFeature.size()));
}

// A subject that took none of several settings takes no other.
bool SupportedFeatures::is_like_what_is_out(const std::string& part) const {
  constexpr std::ptrdiff_t kEnough = 4;
  const auto is_one = [](const auto& other) { return is_setting(other.first); };
  return is_setting(part) && std::ranges::none_of(in_, is_one) &&
         std::ranges::count_if(out_, is_one) >= kEnough;
}

// What stands together may be to blame for a number that it had once: it is tried twice.
bool SupportedFeatures::is_out(const std::string& part) const {
  const auto blamed = out_.find(part);
  if (blamed == out_.end()) return false;
  return blamed->second >= (rank_of_part(part) == kBlockRank ? 2U : 1U);
}

bool SupportedFeatures::admits(const std::string& part, Trying& trying) const {
  if (is_undeclared(part)) return false;
  if (!skips_ || in_.contains(part) || trying.parts.contains(part)) return true;
  // It comes with a code or word, which is tried in its place.
  if (rank_of_part(part) > 0 && !is_out(part)) return true;
  if (is_feature(part)) return false;
  if (trying.more == 0 || is_out(part) || is_like_what_is_out(part)) return false;
  --trying.more;
  trying.parts.insert(part);
  return true;
}

// Words alone go where the rest may stay: without its code a block means something else.
std::string SupportedFeatures::fitted_block(const TextBlock& block,
                                            const reference::Descriptor& table,
                                            Trying& trying) const {
  const auto is_admitted = [&](const std::string& part) { return admits(part, trying); };
  std::string text = rewritten(block, is_admitted);
  if (text != program::line_text(block)) return text;  // looked at again
  program::TextLine kept{{}, block.rest, block.end};
  for (const TextWord& word : block.words) {
    const bool is_code = program::is_word(word) && !block.code_of(word).empty();
    const bool stays = is_code || std::ranges::all_of(parts_of_word(block, word), is_admitted);
    if (stays) kept.words.push_back(word);
  }
  if (kept.words.size() != block.words.size()) return program::line_text(kept);  // likewise
  return std::ranges::all_of(parts_of_block(block, table), is_admitted) ? text : std::string();
}

// Later only now and then: what is untried is mostly skipped.
SupportedFeatures::Turn SupportedFeatures::turn() const {
  constexpr std::size_t kTryOneIn = 50;
  if (!skips_ || has_stopped_trying_ || (runs_ > kLearning && runs_ % kTryOneIn != 0)) {
    return Turn::what_runs;
  }
  const std::size_t number = runs_ > kLearning ? runs_ / kTryOneIn : runs_;
  if (number % 2 == 0) return Turn::untried;
  return number % 4 == 1 ? Turn::again : Turn::together;
}

SupportedFeatures::Trying SupportedFeatures::next_try(
    const generate::GeneratedProgram& program) const {
  Trying trying;
  if (turn() == Turn::what_runs) return trying;
  const std::optional<std::string> again =
      turn() == Turn::again ? least_blamed(program) : std::nullopt;
  if (again) trying.parts.insert(*again);
  trying.more = again ? 0 : 1;
  return trying;
}

// What the program has and is out, so that what was blamed for something else comes back soon.
std::optional<std::string> SupportedFeatures::least_blamed(
    const generate::GeneratedProgram& program) const {
  std::optional<std::string> least;
  for (const std::string& part : parts_of(program, std::string::npos)) {
    if (!is_out(part) || is_setting(part)) continue;
    if (!least || out_.at(part) < out_.at(*least)) least = part;
  }
  return least;
}

// A block by itself with codes and words that are not known to run, that which was least tried:
// some run together only (G1 and its F), whether or not one of them ran elsewhere.
std::optional<generate::GeneratedProgram> SupportedFeatures::together(
    const generate::GeneratedProgram& program) const {
  const ProgramText text(program.profile, program.text);
  reference::Profile machine = program.profile;
  for (const std::size_t part : settings_of(machine)) reset_part(machine, part);
  const Numbers numbers = runs_ / 4 % 2 == 0 ? Numbers::whole : Numbers::as_written;
  const char* const end = in_.contains("code M2") ? "M2\n" : "M30\n";
  std::optional<std::size_t> least;
  std::optional<generate::GeneratedProgram> chosen;
  for (const TextBlock& block : text.blocks) {
    auto made = runs_alone(machine, text, block, numbers, end);
    if (!made || !is_declared(*made)) continue;
    const ProgramText alone(made->profile, made->text);
    const Parts parts = codes_and_words(alone.blocks.front(), *alone.table);
    const auto unknown = static_cast<std::size_t>(
        std::ranges::count_if(parts, [&](const std::string& part) { return !in_.contains(part); }));
    if (parts.size() < 2 || unknown == 0 || unknown > kMostTogether) continue;
    const auto tried = together_.find(parts);
    const std::size_t times = tried == together_.end() ? 0 : tried->second;
    if (least && times >= *least) continue;
    least = times;
    chosen = std::move(made);
  }
  return chosen;
}

std::optional<generate::GeneratedProgram> SupportedFeatures::fitted(
    const generate::GeneratedProgram& program) const {
  constexpr std::size_t kSingleBlocks = 60;
  constexpr std::size_t kLeast = 2;  // blocks
  if (!skips_ && is_declared(program)) return program;
  if (skips_ && !has_stopped_trying_ && runs_ <= kSingleBlocks) {
    const generate::GeneratedProgram single = single_block(program, runs_);
    if (is_declared(single)) return single;
  }
  if (turn() == Turn::together) {
    if (auto alone = together(program)) return alone;
  }
  Trying trying = next_try(program);
  generate::GeneratedProgram made = program;
  for (const std::size_t part : settings_of(made.profile)) {
    if (!admits(setting(part), trying)) reset_part(made.profile, part);
  }
  // What is left may mean something else, and need something else.
  while (true) {
    const ProgramText text(made.profile, made.text);
    std::string next;
    for (const TextBlock& block : text.blocks) next += fitted_block(block, *text.table, trying);
    if (next == made.text) break;
    made.text = std::move(next);
  }
  const bool is_whole = made.text == program.text;
  if (!is_whole && program::count_blocks(made.text) < kLeast) return std::nullopt;
  if (!is_declared(made)) return std::nullopt;
  return made;
}

void SupportedFeatures::ran(const generate::GeneratedProgram& program) {
  skips_ ? learn_ran(program) : note(program, true);
}

void SupportedFeatures::skipped(const generate::GeneratedProgram& program) {
  skips_ ? learn_skipped(program) : note(program, false);
}

void SupportedFeatures::note(const generate::GeneratedProgram& program, bool ran) {
  constexpr std::size_t kMostBefore = 64;
  constexpr std::size_t kFewSkipped = 3;
  constexpr std::size_t kSkippedOneIn = 20;
  before_.push_back({program, ran});
  if (before_.size() > kMostBefore) before_.pop_front();
  ++tried_;
  if (!ran) ++skipped_before_;
  skips_ = skipped_before_ >= kFewSkipped && skipped_before_ * kSkippedOneIn >= tried_;
  if (!skips_) return;
  for (const Tried& tried : std::exchange(before_, {})) {
    tried.ran ? learn_ran(tried.program) : learn_skipped(tried.program);
  }
}

void SupportedFeatures::start_again_where_nothing_runs() {
  const auto is_word_part = [](const auto& part) { return part.first.starts_with("word "); };
  if (runs_ < kLearning || std::ranges::any_of(in_, is_word_part)) return;
  out_.clear();
  runs_ = 0;
}

void SupportedFeatures::learn_ran(const generate::GeneratedProgram& program) {
  ++runs_;
  for (const std::string& part : parts_of(program, blocks_run(program))) {
    ++in_[part].ran;
    out_.erase(part);
  }
  start_again_where_nothing_runs();
}

void SupportedFeatures::learn_skipped(const generate::GeneratedProgram& program) {
  // Known parts together with others: a part that hardly ever ran, and why it did is unclear
  // (an alarm before it).
  constexpr std::size_t kSkippedOften = 4;
  constexpr std::size_t kToOneThatRan = 1;
  ++runs_;
  const Parts parts = parts_of(program, std::string::npos);
  const ProgramText text(program.profile, program.text);
  if (text.blocks.size() == 2) ++together_[codes_and_words(text.blocks.front(), *text.table)];
  Parts untried;
  std::ranges::copy_if(parts, std::inserter(untried, untried.end()), [&](const std::string& part) {
    return !in_.contains(part) && !is_undeclared(part);
  });
  int rank = kBlockRank;
  for (const std::string& part : untried) rank = std::min(rank, rank_of_part(part));
  std::erase_if(untried, [&](const std::string& part) { return rank_of_part(part) > rank; });
  if (untried.size() == 1) ++out_[*untried.begin()];
  if (!untried.empty()) return;
  for (const std::string& part : parts) {
    const auto known = in_.find(part);
    if (known == in_.end()) continue;
    Runs& runs = known->second;
    ++runs.skipped;
    if (runs.skipped < kSkippedOften || runs.skipped < kToOneThatRan * runs.ran) continue;
    in_.erase(known);
    ++out_[part];
  }
}

std::string SupportedFeatures::left_out() const {
  std::map<std::string, std::string> kinds;
  for (const auto& [part, times] : out_) {
    const std::size_t blank = part.find(' ');
    std::string& names = kinds[part.substr(0, blank)];
    names += (names.empty() ? "" : " ") + part.substr(blank + 1);
  }
  std::string text;
  for (const auto& [kind, names] : kinds) {
    // Numbers say nothing to people, and what stands together is too much to print.
    if (kind == "setting" || kind == "block") continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", kind, names);
  }
  return text;
}

}  // namespace gonogo::hunt
