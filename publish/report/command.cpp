// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>

#include "oracle/records/fresh_counts.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::report {

namespace {

// What a verdict depends on, besides the subject and the case.
constexpr std::array<std::string_view, 17> kKept = {
    "--corpus",    "--profile", "--reading",        "--tolerance", "--chord",   "--feed-resolution",
    "--blend",     "--columns", "--feed-tolerance", "--manifest",  "--timeout", "--memory",
    "--alarm-map", "--env",     "--known-failures", "--sandbox",   "--bind"};

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

std::string header_key(std::string_view option) {
  std::string key(option.substr(2));
  std::ranges::replace(key, '-', '_');
  return key;
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

Json run_argv(const Json& header) {
  const Json shards = header.value("shards", Json::array());
  const bool is_merged = shards.is_array() && !shards.empty() && shards.front().is_object();
  return (is_merged ? shards.front() : header).value("argv", Json::array());
}

std::string subject_folder(const std::string& subject) {
  constexpr std::size_t kLongest = 60;
  std::string name;
  for (const char c : subject) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '_' || c == '+';
    if (plain && !(c == '.' && name.empty())) {
      name += c;
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
    if (name.size() == kLongest) break;
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "subject" : name;
}

std::string report_folder(const Json& header) {
  const Json argv = run_argv(header);
  // Which of the shards asked it their results do not say.
  if (header.value("shards", Json::array()).size() > 1) return "SHARD";
  const std::vector<std::string> named = option_values(argv, "--report");
  const bool are_few =
      !option_values(argv, "--case").empty() || !option_values(argv, "--failed-of").empty();
  const std::string report = !named.empty() ? named.back()
                             : are_few      ? kFewCasesFolder
                                            : kReportFolder;
  const std::vector<std::string> subjects = option_values(argv, "--subject");
  const bool is_of_results = !option_values(argv, "--failed-of").empty();  // they name the subject
  if (subjects.size() == 1 || (subjects.empty() && is_of_results)) return report;
  const std::string spec = text_of(header.value("subject", Json::object()), "spec");
  if (subjects.empty()) return report + "/" + spec.substr(spec.find(':') + 1);
  // Each subject of several has a folder, and two of one name have two.
  std::set<std::string> names;
  for (const std::string& subject : subjects) {
    std::string name = subject_folder(subject);
    while (!names.insert(name).second) name += "-again";
    if (subject == spec) return report + "/" + name;
  }
  return report;
}

namespace {

// Without the cases.
std::string command_begin(const Json& header, CaseOf of) {
  const Json subject = header.value("subject", Json::object());
  std::string command =
      program_word() + " certify --subject " + shell_quoted(text_of(subject, "spec"));
  auto add = [&](std::string_view option, const std::string& value) {
    command += ' ';
    command += option;
    command += ' ' + shell_quoted(value);
  };
  const Json argv = run_argv(header);
  for (std::string_view option : kKept) {
    if (of == CaseOf::fresh && option == "--corpus") {
      add(option, fmt::format("{}/{}", report_folder(header), kFreshRoom));
      continue;
    }
    const std::vector<std::string> values = option_values(argv, option);
    for (const std::string& value : values) add(option, value);
    // Merged results may not name the command lines of their shards; the header still says these.
    if (!values.empty()) continue;
    if (option == "--reading") {
      for (const std::string& reading : texts_of(header, "readings")) add(option, reading);
    }
    if (std::ranges::find(kNumberOptions, option) != kNumberOptions.end()) {
      const std::string value = text_of(header, header_key(option).c_str());
      if (!value.empty()) add(option, value);
    }
  }
  if (header.value("strict", Json(false)) == true) command += " --strict";
  if (header.value("show_ids", Json(false)) == true) command += " --show-ids";
  return command;
}

}  // namespace

std::string command_for_case(const Json& header, CaseOf of) {
  return command_begin(header, of) + " --case ";
}

std::string command_for_run(const Json& header) {
  std::string command = command_begin(header, CaseOf::corpus);
  const Json selection = header.value("selection", Json::object());
  const auto add = [&](std::string_view option, const std::string& value) {
    command += fmt::format(" {} {}", option, shell_quoted(value));
  };
  for (const auto& [option, key] : kSelectionOptions) {
    for (const std::string& value : texts_of(selection, key)) add(option, value);
  }
  if (const std::string one = text_of(selection, "case"); !one.empty()) add("--case", one);
  if (const std::string shard = text_of(header, "shard"); shard != "1/1" && !shard.empty()) {
    add("--shard", shard);
  }
  for (const std::string& fresh : option_values(run_argv(header), "--fresh")) add("--fresh", fresh);
  if (const auto seed = count_of(header, "seed"); seed && *seed != 0) {
    add("--seed", std::to_string(*seed));
  }
  return command + " --jobs 1 --report " + kFewCasesFolder;
}

}  // namespace gonogo::oracle::report
