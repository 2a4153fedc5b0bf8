// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::report {

using Json = nlohmann::ordered_json;

namespace {

// What a verdict depends on, besides the subject and the case.
constexpr std::array<std::string_view, 17> kKept = {
    "--corpus",    "--profile", "--reading",        "--tolerance", "--chord",   "--feed-resolution",
    "--blend",     "--columns", "--feed-tolerance", "--manifest",  "--timeout", "--memory",
    "--alarm-map", "--env",     "--known-failures", "--sandbox",   "--bind"};
// Those of them that the header holds as well.
constexpr std::array<std::string_view, 5> kNumbers = {"--tolerance", "--chord", "--feed-resolution",
                                                      "--blend", "--feed-tolerance"};

}  // namespace

std::vector<std::string> option_values(const Json& argv, std::string_view option) {
  std::vector<std::string> values;
  if (!argv.is_array()) return values;
  for (std::size_t i = 0; i < argv.size(); ++i) {
    if (!argv[i].is_string()) continue;
    const auto& word = argv[i].get_ref<const std::string&>();
    if (word == option && i + 1 < argv.size() && argv[i + 1].is_string()) {
      values.push_back(argv[++i].get<std::string>());
    } else if (word.starts_with(option) && word.substr(option.size()).starts_with('=')) {
      values.push_back(word.substr(option.size() + 1));
    }
  }
  return values;
}

bool is_flag_set(const Json& argv, std::string_view option) {
  bool is_set = false;
  if (!argv.is_array()) return is_set;
  for (const Json& one : argv) {
    if (!one.is_string()) continue;
    const auto& word = one.get_ref<const std::string&>();
    if (word == option) is_set = true;
    if (!word.starts_with(option) || word.substr(option.size(), 1) != "=") continue;
    std::string value = word.substr(option.size() + 1);
    for (char& letter : value) {
      letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    // The words and numbers for no that the command line takes.
    constexpr std::array<std::string_view, 6> kNo = {"false", "off", "no", "disable", "f", "n"};
    const bool is_zero = value.ends_with('0') && value.find_first_not_of("+0") == std::string::npos;
    is_set = std::ranges::find(kNo, value) == kNo.end() && !is_zero && !value.starts_with('-');
  }
  return is_set;
}

std::string program_word() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path()) {
    if (fs::is_regular_file(at / "gonogo", ignored) &&
        fs::exists(at / "CMakePresets.json", ignored)) {
      return fs::equivalent(at, fs::current_path(ignored), ignored)
                 ? "./gonogo"
                 : shell_quoted((at / "gonogo").string());
    }
  }
  // A copy that was called as ./gonogo is found again as ./gonogo.
  std::string called;
  std::ifstream words("/proc/self/cmdline");
  std::getline(words, called, '\0');
  return called.starts_with("./") ? shell_quoted(called) : "gonogo";
}

std::string command_for_case(const Json& header, CaseOf of) {
  const Json subject = header.value("subject", Json::object());
  std::string command =
      program_word() + " certify --subject " + shell_quoted(text_of(subject, "spec"));
  auto add = [&](std::string_view option, const std::string& value) {
    command += ' ';
    command += option;
    command += ' ' + shell_quoted(value);
  };
  const Json argv = header.value("argv", Json::array());
  for (std::string_view option : kKept) {
    if (of == CaseOf::fresh && option == "--corpus") {
      const std::vector<std::string> report = option_values(argv, "--report");
      add(option, fmt::format("{}/{}", report.empty() ? "report" : report.back(), kFreshRoom));
      continue;
    }
    const std::vector<std::string> values = option_values(argv, option);
    for (const std::string& value : values) add(option, value);
    // A merged run has another command line; what the header says of itself still holds.
    if (!values.empty()) continue;
    if (option == "--reading" && header.contains("readings")) {
      for (const Json& reading : header["readings"]) {
        if (reading.is_string()) add(option, reading.get<std::string>());
      }
    }
    if (std::ranges::find(kNumbers, option) != kNumbers.end()) {
      std::string key(option.substr(2));
      std::ranges::replace(key, '-', '_');
      const std::string value = text_of(header, key.c_str());
      if (!value.empty()) add(option, value);
    }
  }
  if (header.value("strict", Json(false)) == true) command += " --strict";
  if (header.value("show_ids", Json(false)) == true) command += " --show-ids";
  return command + " --case ";
}

}  // namespace gonogo::oracle::report
