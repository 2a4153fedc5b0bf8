// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "campaign/encoding.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::oracle::evidence {
namespace {

using report::option_values;
using report::text_of;

// Options that come to a list of the selection.
struct ListOption {
  const char* option;
  const char* key;
};
constexpr std::array<ListOption, 5> kLists = {{{"--dialect", "dialects"},
                                               {"--only", "only"},
                                               {"--case", "cases"},
                                               {"--cycle", "cycles"},
                                               {"--clause", "clauses"}}};
// Options that come to a number or a file of the header.
constexpr std::array<const char*, 5> kNumbers = {"--tolerance", "--chord", "--feed-resolution",
                                                 "--blend", "--feed-tolerance"};
constexpr std::array<const char*, 2> kFlags = {"--strict", "--show-ids"};
constexpr std::array<const char*, 2> kFiles = {"--known-failures", "--alarm-map"};

std::string key_of(std::string_view option) {
  std::string key(option.substr(2));
  std::ranges::replace(key, '-', '_');
  return key;
}

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
    if (argv_.empty() || argv_.front() != "certify") return {};
    check_lists();
    for (const char* option : kNumbers) {
      const std::string told = text_of(header_, key_of(option).c_str());
      need(option, is_same_number(option_values(argv_, option), told), Json(told));
    }
    for (const char* option : kFiles) {
      const std::string told = text_of(header_, key_of(option).c_str());
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
    if (!option_values(argv_, "--failed-of").empty()) return;
    const Json selection = header_.value("selection", Json::object());
    for (const ListOption& list : kLists) {
      std::vector<std::string> told = selection.value(list.key, std::vector<std::string>());
      if (const std::string one = text_of(selection, "case");
          !one.empty() && list.key == std::string_view("cases")) {
        told = {one};
      }
      const std::vector<std::string> asked = option_values(argv_, list.option);
      const bool narrows = list.key == std::string_view("dialects") && asked.empty() &&
                           (option_values(argv_, "--subject").empty() || are_declared(told));
      need(list.option, asked == told || narrows, Json(told));
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
      const Json flag = header_.value(key_of(option), Json(false));
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

}  // namespace

// J-RUN-13.
std::vector<std::string> header_faults(const Json& header) {
  return HeaderCheck(header).run();
}

}  // namespace gonogo::oracle::evidence
