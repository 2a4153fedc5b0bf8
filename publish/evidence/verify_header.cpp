// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "campaign/encoding.hpp"
#include "campaign/results_shape.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::oracle::evidence {
namespace {

using report::header_key;
using report::option_values;
using report::text_of;

constexpr std::array<const char*, 2> kFlags = {"--strict", "--show-ids"};
// shard, seed, argv, fresh
constexpr std::size_t kKeysOfShard = 4;
constexpr std::array<const char*, 2> kFiles = {"--known-failures", "--alarm-map"};

bool is_same_number(const std::vector<std::string>& asked, const std::string& told) {
  if (asked.empty() || told.empty()) return asked.empty() && told.empty();
  const auto a = reference::Number::parse(asked.back());
  const auto b = reference::Number::parse(told);
  return a && b && *a == *b;
}

class HeaderCheck {
 public:
  explicit HeaderCheck(const Json& header)
      : header_(header), argv_(header.value("argv", Json::array())) {}

  std::vector<std::string> run() {
    if (argv_.empty() || (argv_.front() != "certify" && argv_.front() != "ci")) {
      return {"The header names no command line that runs a campaign."};
    }
    check_lists();
    for (const std::string_view option : report::kNumberOptions) {
      const std::string told = text_of(header_, header_key(option).c_str());
      need(option, is_same_number(option_values(argv_, option), told), Json(told));
    }
    for (const char* option : kFiles) {
      const std::string told = text_of(header_, header_key(option).c_str());
      need(option, option_values(argv_, option).empty() == told.empty(), Json(told));
    }
    check_rest();
    return std::move(faults_);
  }

 private:
  void need(std::string_view option, bool holds, const Json& told) {
    if (holds) return;
    faults_.push_back(fmt::format("The header says {} of {}, but its command line does not.",
                                  dump(told), option));
  }

  // Dialects that no option names are those that the subject declares (J-RUN-14).
  bool are_declared(const std::vector<std::string>& dialects) const {
    const Json declared =
        header_.value("subject", Json::object()).value("dialects", Json::object());
    std::vector<std::string> names;
    if (declared.is_object()) {
      for (const auto& [dialect, features] : declared.items()) names.push_back(dialect);
    }
    return dialects == names;
  }

  // A run of the cases that failed before adds them, one without a subject names its dialects.
  void check_lists() {
    const bool adds_cases = !option_values(argv_, "--failed-of").empty();
    const Json selection = header_.value("selection", Json::object());
    for (const auto& [option, key] : report::kSelectionOptions) {
      std::vector<std::string> told = selection.value(key, std::vector<std::string>());
      if (const std::string one = text_of(selection, "case"); !one.empty() && option == "--case") {
        told = {one};
      }
      const std::vector<std::string> asked = option_values(argv_, option);
      const bool narrows = option == "--dialect" && asked.empty() &&
                           (option_values(argv_, "--subject").empty() || are_declared(told));
      const bool adds = adds_cases && option == "--case";
      const bool are_asked =
          adds ? told.size() > asked.size() && std::equal(asked.begin(), asked.end(), told.begin())
               : asked == told;
      need(option, are_asked || narrows, Json(told));
    }
  }

  void check_rest() {
    const auto readings = header_.value("readings", std::vector<std::string>());
    need("--reading", option_values(argv_, "--reading") == readings, Json(readings));
    const std::vector<std::string> shard = option_values(argv_, "--shard");
    const std::string told = text_of(header_, "shard");
    need("--shard", told == (shard.empty() ? "1/1" : shard.back()), Json(told));
    const std::vector<std::string> seed = option_values(argv_, "--seed");
    const Json drawn = header_.value("seed", Json(0));
    need("--seed", seed.empty() || is_same_number({seed.back()}, dump(drawn)), drawn);
    for (const char* option : kFlags) {
      const Json flag = header_.value(header_key(option), Json(false));
      need(option, report::is_flag_set(argv_, option) == (flag == true), flag);
    }
    const std::vector<std::string> sandbox = option_values(argv_, "--sandbox");
    const std::string sandboxed = text_of(header_, "sandbox");
    const bool may_be = sandbox.empty() || sandbox.back() == "auto" || sandboxed.empty() ||
                        (sandbox.back() == "off") == (sandboxed == "none");
    need("--sandbox", may_be, Json(sandboxed));
    // What is built in has no process of its own.
    const std::string spec = text_of(header_.value("subject", Json::object()), "spec");
    const bool has_process = !spec.starts_with("builtin:");
    need("--sandbox", has_process || sandboxed.empty() || sandboxed == "none", Json(sandboxed));
    const Json profile = header_.value("profile", Json::object());
    const bool has_profile = header_.contains("machine") || !profile.empty();
    need("--profile", has_profile == !option_values(argv_, "--profile").empty(), profile);
    const std::vector<std::string> subjects = option_values(argv_, "--subject");
    need("--subject", subjects.empty() || std::ranges::find(subjects, spec) != subjects.end(),
         Json(spec));
  }

  const Json& header_;
  Json argv_;
  std::vector<std::string> faults_;
};

// What all shards have in common is held against the command line of each.
void check_shards(const Json& header, const Json& shards, std::vector<std::string>& faults) {
  const auto seed_of = [](const Json& one) { return one.value("seed", Json(0)); };
  const bool is_common = std::ranges::all_of(
      shards, [&](const Json& shard) { return seed_of(shard) == seed_of(shards.front()); });
  const Json seed = is_common && !shards.empty() ? seed_of(shards.front()) : Json(0);
  if (text_of(header, "shard") != "1/1" || seed_of(header) != seed) {
    faults.emplace_back("A merged run is shard 1/1, and has the seed of all its shards, else 0.");
  }
  for (std::size_t i = 0; i < shards.size(); ++i) {
    Json of_shard = header;
    for (const char* key : {"shard", "seed", "argv"}) of_shard[key] = shards[i].value(key, Json());
    const std::string told = text_of(of_shard, "shard");
    const std::string due = fmt::format("{}/{}", i + 1, shards.size());
    if (told != due) {
      faults.push_back(fmt::format("The header has shard {} in the place of {}.", told, due));
    }
    if (shards[i].size() > kKeysOfShard) {
      faults.push_back(fmt::format("Shard {} has more than {} keys.", told, kKeysOfShard));
    }
    for (const std::string& fault : HeaderCheck(of_shard).run()) {
      faults.push_back(fmt::format("Shard {}: {}", told, fault));
    }
  }
}

}  // namespace

// J-RUN-13.
std::vector<std::string> header_faults(const Json& header) {
  const Json argv = header.value("argv", Json::array());
  const bool is_merged = !argv.empty() && argv.front() == "merge";
  const Json shards = header.value("shards", Json::array());
  std::vector<std::string> faults;
  if (!is_merged) faults = HeaderCheck(header).run();
  if (const std::string place = header_surplus(header); !place.empty()) {
    faults.push_back(fmt::format("A header has no {}.", place));
  }
  if (is_merged == shards.empty()) {
    faults.emplace_back(is_merged ? "The header of a merged run does not name its shards."
                                  : "The header names shards, and its command line merges none.");
  }
  if (is_merged) check_shards(header, shards, faults);
  return faults;
}

}  // namespace gonogo::oracle::evidence
