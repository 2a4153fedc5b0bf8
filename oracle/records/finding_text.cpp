// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

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

std::vector<std::string_view> lines_in(std::string_view program) {
  std::vector<std::string_view> lines;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    if (program[i] != '\n' && program[i] != '\r') continue;
    lines.push_back(program.substr(begin, i - begin));
    if (program[i] == '\r' && i + 1 < program.size() && program[i + 1] == '\n') ++i;
    begin = i + 1;
  }
  if (begin < program.size()) lines.push_back(program.substr(begin));
  return lines;
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
  constexpr std::size_t kBefore = 3;
  constexpr std::size_t kBehind = 1;
  const std::vector<std::string_view> lines = lines_in(program);
  if (line == 0 || line > lines.size()) return {};
  const std::size_t first = line > kBefore ? line - kBefore : 1;
  const std::size_t last = std::min<std::size_t>(lines.size(), line + kBehind);
  const std::size_t width = std::to_string(last).size();
  std::string text;
  for (std::size_t n = first; n <= last; ++n) {
    const std::string own = shown(lines[n - 1]);
    text += fmt::format("{:>{}} | {}\n", n, width, own);
    if (n == line)
      text +=
          fmt::format("{:>{}} | {:^<{}}\n", "", width, "", std::max<std::size_t>(1, own.size()));
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
