// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "grammar/line_source.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

// Numbers are texts, but for those of three kinds (docs/formats.md).
std::string plain(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// " Z-7 X3" of {"z":"-7","x":"3"}
std::string words_of(const Json& values) {
  std::string text;
  if (!values.is_object()) return text;
  for (const auto& [axis, value] : values.items()) {
    std::string letter = axis;
    std::ranges::transform(letter, letter.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    text += " " + letter + plain(value);
  }
  return text;
}

// The values of a step that tell it from others, behind its name.
std::string further_words(const Json& step) {
  std::string text = words_of(step.value("to", Json::object()));
  if (step.contains("via")) text += " via" + words_of(step["via"]);
  if (step.contains("c")) text += " about" + words_of(step["c"]);
  for (const auto& [key, word] :
       {std::pair("rot", " turning "), std::pair("f", " F"), std::pair("lead", " lead "),
        std::pair("start", " start "), std::pair("s", " s "), std::pair("m", " M")}) {
    if (step.contains(key)) text += word + plain(step[key]);
  }
  if (step.contains("fm") && step["fm"] == "rev") text += " a revolution";
  return text;
}

std::string shown(std::string_view line) {
  constexpr std::size_t kLongest = 100;
  std::string text(line.substr(0, kLongest));
  for (char& c : text) {
    if (c == '\t') c = ' ';
    if (c < ' ' || c > '~') c = '?';
  }
  return line.size() > kLongest ? text + " ..." : text;
}

// "units inch", "initial.feed 100": of each key its value, objects key by key.
void collect(const Json& profile, const std::string& prefix, std::vector<std::string>& out) {
  for (const auto& [key, value] : profile.items()) {
    if (value.is_object()) {
      collect(value, key == "readings" ? std::string() : prefix + key + ".", out);
    } else if (key != "dialect") {
      out.push_back(fmt::format("{}{} {}", prefix, key, plain(value)));
    }
  }
}

}  // namespace

std::string short_step(std::string_view json) {
  const Json step = Json::parse(json, nullptr, false);
  if (!step.is_object()) return std::string(json);
  if (step.contains("class")) {
    std::string text = "alarm " + plain(step["class"]);
    if (step.contains("word")) text += " of " + plain(step["word"]);
    return step.contains("b") ? text + " in line " + plain(step["b"]) : text;
  }
  if (!step.contains("k")) return std::string(json);
  return plain(step["k"]) + further_words(step);
}

std::string want_and_got(std::string_view want, std::string_view got) {
  if (want.empty() && got.empty()) return {};
  if (want.empty()) return "want nothing / got " + short_step(got);
  return fmt::format("want {} / got {}", short_step(want),
                     got.empty() ? "nothing" : short_step(got));
}

std::string marked_blocks(std::string_view program, std::uint64_t line) {
  constexpr std::uint64_t kBefore = 3;
  constexpr std::uint64_t kBehind = 1;
  std::map<std::uint64_t, std::string> blocks;
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  for (grammar::Line one; lines.next(one) && one.number <= line + kBehind;) {
    if (one.number + kBefore >= line) blocks[one.number] = shown(one.text);
  }
  if (line == 0 || !blocks.contains(line)) return {};
  const std::size_t width = std::to_string(blocks.rbegin()->first).size();
  std::string text;
  for (const auto& [number, block] : blocks) {
    text += fmt::format("{:>{}} | {}\n", number, width, block);
    if (number != line) continue;
    const std::size_t carets = std::max<std::size_t>(1, block.size());
    text += fmt::format("{:>{}} | {:^<{}}\n", "", width, "", carets);
  }
  return text;
}

std::string other_machine(std::string_view profile) {
  std::vector<std::string> parts;
  const Json own = Json::parse(profile, nullptr, false);
  if (own.is_object()) collect(own, "", parts);
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace gonogo::oracle
