// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/program_lines.hpp"
#include "grammar/parser.hpp"
#include "reference/dialect.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::identify {

using grammar::Block;
using grammar::NamedWord;
using grammar::Span;
using grammar::TermKind;
using reference::Number;

namespace {

// Codes that stay in force, and codes whose words are their own block's.
constexpr std::string_view kMotions[] = {
    "G0",  "G1",  "G2",   "G3",   "G5",   "G32",  "G74",  "G75",  "G80",  "G81",  "G82", "G90",
    "G92", "G94", "G110", "G111", "G112", "G113", "G114", "G115", "G116", "G117", "CIP", "CT"};
constexpr std::string_view kOwnBlock[] = {"G4",   "G28",    "G50",    "G158", "G258",
                                          "G259", "LCYC75", "LCYC82", "M98"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::optional<Number> number_in(std::string_view text) {
  std::string digits;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '+') digits += c;
  }
  if (!digits.empty() && digits.front() == '.') digits.insert(0, "0");
  if (digits.starts_with("-.")) digits.insert(1, "0");
  if (!digits.empty() && digits.back() == '.') digits.pop_back();
  if (digits.find_first_not_of("-.0123456789") != std::string::npos) return std::nullopt;
  return Number::parse(digits);
}

TextWord letter_word(std::string_view line, const grammar::Word& word) {
  TextWord text{
      std::string(1, word.address), {}, word.where, {word.where.begin + 1, word.where.end}};
  text.value = number_in(line.substr(text.number.begin, text.number.end - text.number.begin));
  return text;
}

TextWord named_word(std::string_view line, const Block& block, const NamedWord& word) {
  TextWord text{word.name, {}, word.where, {}};
  if (word.index) text.address += std::to_string(*word.index);
  const bool plain = word.terms == 1 ||
                     (word.terms == 2 && block.terms[word.first_term + 1].kind == TermKind::negate);
  if (!plain || block.terms[word.first_term].kind != TermKind::number) return text;
  text.number = block.terms[word.first_term].where;
  if (word.terms == 2) {
    const std::size_t sign = line.rfind('-', text.number.begin);
    if (sign != std::string_view::npos) text.number.begin = static_cast<std::uint32_t>(sign);
  }
  text.value = number_in(line.substr(text.number.begin, text.number.end - text.number.begin));
  return text;
}

// Codes of rs274 that are nearly whole as those that they count as, by ngc.whole.
void round_codes(std::vector<TextWord>& words, const reference::ReadingsInUse& readings) {
  using reference::rs274::NearWhole;
  using reference::rs274::Whole;
  for (TextWord& word : words) {
    if (!word.is_code() || !word.value) continue;
    const bool is_g = word.address == "G";
    const Number parts = is_g ? 10 : 1;
    const NearWhole number(*word.value * parts);
    if (number.is_whole()) continue;
    if (number.counts_as_whole(is_g ? Whole::g_tenths : Whole::m_function, readings)) {
      word.value = number.nearest() / parts;
    }
  }
}

// The modes that the words of a block stand in.
class Modes {
 public:
  explicit Modes(const reference::Profile& profile)
      : sinumerik_(profile.dialect.starts_with("sinumerik")),
        hnc_(profile.dialect == "hnc21t"),
        rs274_(profile.dialect == "rs274"),
        inch_(profile.units == reference::Units::inch),
        radius_(!profile.x_diameter),
        plane_(17 + static_cast<int>(profile.initial.plane)) {}
  void take(TextBlock& block);

 private:
  bool is_motion(std::string_view code) const;

  bool sinumerik_;
  bool hnc_;
  bool rs274_;
  bool inch_;
  bool radius_;
  bool incremental_ = false;
  bool absolute_centre_ = false;
  int plane_;
  std::string motion_;
};

bool Modes::is_motion(std::string_view code) const {
  // The same number says something else to another maker.
  if ((hnc_ || sinumerik_ || rs274_) && (code == "G90" || code == "G92" || code == "G94")) {
    return false;
  }
  if (sinumerik_ && (code == "G74" || code == "G75")) return false;
  return contains(kMotions, code);
}

void Modes::take(TextBlock& block) {
  std::string own;
  for (const TextWord& word : block.words) {
    const std::string code = word.address == "G" ? word.code() : word.address;
    if (code == "G17" || code == "G18" || code == "G19") plane_ = std::stoi(code.substr(1));
    if (code == (sinumerik_ ? "G70" : "G20")) inch_ = true;
    if (code == (sinumerik_ ? "G71" : "G21")) inch_ = false;
    const bool has_g91 = sinumerik_ || hnc_ || rs274_;
    if (has_g91 && (code == "G90" || code == "G91")) incremental_ = code == "G91";
    if (hnc_ && (code == "G36" || code == "G37")) radius_ = code == "G37";
    if (code == "G90.1" || code == "G91.1") absolute_centre_ = code == "G90.1";
    if (is_motion(code)) motion_ = own = code;
    if (contains(kOwnBlock, code)) own = code;
  }
  block.own_motion = !own.empty();
  block.motion = own.empty() ? motion_ : own;
  block.plane = plane_;
  block.inch = inch_;
  block.incremental = incremental_;
  block.x_radius = radius_;
  block.absolute_centre = absolute_centre_;
}

}  // namespace

std::string TextWord::code() const {
  return address + (value ? value->text() : "");
}

const TextWord* TextBlock::find(std::string_view address) const {
  const auto found = std::ranges::find(words, address, &TextWord::address);
  return found == words.end() ? nullptr : &*found;
}

bool TextBlock::in_cycle() const {
  constexpr std::string_view kPlain[] = {"",   "G0",  "G1",  "G2",  "G3",
                                         "G4", "G28", "G50", "CIP", "CT"};
  return !contains(kPlain, motion);
}

ProgramText::ProgramText(const reference::Profile& profile, std::string_view program) {
  const grammar::Dialect dialect = reference::find_dialect(profile.dialect)->grammar;
  const reference::ReadingsInUse readings(profile.readings);
  Modes modes(profile);
  Block block;
  for (const fuzz::ProgramLine& written : fuzz::program_lines(program)) {
    TextBlock& line = blocks.emplace_back();
    line.text = written.text;
    line.end = written.end;
    block.clear();
    if (!parse_block(dialect, line.text, block)) {
      for (const grammar::Word& word : block.words) {
        line.words.push_back(letter_word(line.text, word));
      }
      for (const NamedWord& word : block.named) {
        line.words.push_back(named_word(line.text, block, word));
      }
    }
    if (profile.dialect == "rs274") round_codes(line.words, readings);
    modes.take(line);
  }
}

std::string ProgramText::text() const {
  std::string text;
  for (const TextBlock& block : blocks) text += block.text + block.end;
  return text;
}

std::optional<std::string> edited(const ProgramText& program, const WordEdit& edit) {
  std::string out;
  bool changed = false;
  for (const TextBlock& block : program.blocks) {
    std::string line = block.text;
    // From the back, so that places before stay what they are.
    for (auto word = block.words.rbegin(); word != block.words.rend(); ++word) {
      const auto text = edit(block, *word);
      const std::size_t size = word->where.end - word->where.begin;
      if (!text || line.compare(word->where.begin, size, *text) == 0) continue;
      line.replace(word->where.begin, size, *text);
      changed = true;
    }
    out += line + block.end;
  }
  return changed ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::string> edited_in_order(const ProgramText& program, const BlockEdit& add) {
  std::string out;
  bool changed = false;
  for (const TextBlock& block : program.blocks) {
    std::string line = block.text;
    if (!block.words.empty()) {
      const std::string more = add(block);
      line.insert(block.words.back().where.end, more);
      changed = changed || !more.empty();
    }
    out += line + block.end;
  }
  return changed ? std::optional(std::move(out)) : std::nullopt;
}

std::string with_value(const TextBlock& block, const TextWord& word, const Number& value) {
  const auto part = [&](std::uint32_t begin, std::uint32_t end) {
    return block.text.substr(begin, end - begin);
  };
  // Quotients by 25.4 have no last decimal.
  const std::string text = value.text();
  const bool decimal = text.find('/') == std::string::npos;
  return part(word.where.begin, word.number.begin) + (decimal ? text : value.decimal_text(15)) +
         part(word.number.end, word.where.end);
}

}  // namespace gonogo::identify
