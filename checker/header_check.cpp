// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of results against the command lines that it names.
#include <algorithm>
#include <string>
#include <vector>

#include "checker/real.hpp"
#include "checker/roll.hpp"

namespace gonogo::checker {
namespace {

using Words = std::vector<std::string>;

// The values of an option, given as two words or with '='.
Words values_of(const Words& argv, const std::string& option) {
  Words values;
  for (std::size_t i = 0; i < argv.size(); ++i) {
    if (argv[i] == option && i + 1 < argv.size()) {
      values.push_back(argv[++i]);
    } else if (argv[i].starts_with(option + "=")) {
      values.push_back(argv[i].substr(option.size() + 1));
    }
  }
  return values;
}

bool same_number(const Words& asked, const std::string& told) {
  if (asked.empty() || told.empty()) return asked.empty() && told.empty();
  try {
    return parse_rational(asked.back()) == parse_rational(told);
  } catch (const Fault&) {
    return false;
  }
}

// Whether the last word of a flag sets it: the bare flag, or one with a value that is not no.
bool is_set(const Words& argv, const std::string& flag) {
  bool holds = false;
  for (const std::string& word : argv) {
    if (word == flag) holds = true;
    if (!word.starts_with(flag + "=")) continue;
    std::string value = word.substr(flag.size() + 1);
    for (char& c : value) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    const bool is_zero = value.ends_with('0') && value.find_first_not_of("+0") == std::string::npos;
    const bool is_no = value == "false" || value == "off" || value == "no" || value == "disable" ||
                       value == "f" || value == "n" || value.starts_with("-");
    holds = !is_zero && !is_no;
  }
  return holds;
}

Words declared_dialects(const Json& header) {
  Words names;
  const Json* declared = header.member("subject", Json::Kind::object).find("dialects");
  if (declared == nullptr || !declared->is(Json::Kind::object)) return names;
  for (const JsonMember& dialect : declared->members) names.push_back(dialect.key);
  return names;
}

// Which cases were asked for. A run of those that failed before adds them.
bool are_cases_asked(const Words& argv, const Words& told) {
  const Words asked = values_of(argv, "--case");
  if (values_of(argv, "--failed-of").empty()) return asked == told;
  return told.size() > asked.size() && std::equal(asked.begin(), asked.end(), told.begin());
}

void check_selection(const Json& header, const Words& argv, const auto& need) {
  const Json* selection = header.find("selection");
  if (selection == nullptr) return;
  Words cases = selection->texts_at("cases");
  if (const std::string one = selection->text_at("case"); !one.empty()) cases = {one};
  need("--case", are_cases_asked(argv, cases));
  need("--only", values_of(argv, "--only") == selection->texts_at("only"));
  need("--cycle", values_of(argv, "--cycle") == selection->texts_at("cycles"));
  need("--clause", values_of(argv, "--clause") == selection->texts_at("clauses"));
  const Words dialects = values_of(argv, "--dialect");
  const Words told = selection->texts_at("dialects");
  // J-RUN-14: without the option they are those that the subject declares.
  const bool narrows = dialects.empty() &&
                       (values_of(argv, "--subject").empty() || told == declared_dialects(header));
  need("--dialect", narrows || dialects == told);
}

// Of one run, or of one shard.
void check_header(const Json& header, const Words& argv, const std::string& shard,
                  std::vector<std::string>& faults) {
  if (argv.empty() || (argv.front() != "certify" && argv.front() != "ci")) {
    faults.emplace_back("The header names no command line that runs a campaign.");
    return;
  }
  const auto need = [&](const std::string& option, bool holds) {
    if (!holds) faults.push_back("The header and its command line differ in " + option + ".");
  };
  const auto key_of = [](const char* option) {
    std::string key(option + 2);
    std::ranges::replace(key, '-', '_');
    return key;
  };
  for (const char* option :
       {"--tolerance", "--chord", "--feed-resolution", "--blend", "--feed-tolerance"}) {
    need(option, same_number(values_of(argv, option), header.text_at(key_of(option))));
  }
  for (const char* option : {"--known-failures", "--alarm-map"}) {
    need(option, values_of(argv, option).empty() == header.text_at(key_of(option)).empty());
  }
  const Words shards = values_of(argv, "--shard");
  need("--shard", shard == (shards.empty() ? "1/1" : shards.back()));
  need("--reading", values_of(argv, "--reading") == header.texts_at("readings"));
  for (const char* option : {"--strict", "--show-ids"}) {
    const Json* told = header.find(key_of(option));
    need(option, is_set(argv, option) == (told != nullptr && told->truth));
  }
  const Words subjects = values_of(argv, "--subject");
  const std::string spec = header.member("subject", Json::Kind::object).text_at("spec");
  need("--subject", subjects.empty() || std::ranges::find(subjects, spec) != subjects.end());
  const Words sandbox = values_of(argv, "--sandbox");
  const std::string sandboxed = header.text_at("sandbox");
  need("--sandbox", sandbox.empty() || sandbox.back() == "auto" || sandboxed.empty() ||
                        (sandbox.back() == "off") == (sandboxed == "none"));
  // What is built in has no process of its own.
  need("--sandbox", !spec.starts_with("builtin:") || sandboxed.empty() || sandboxed == "none");
  const bool has_profile = header.find("machine") != nullptr ||
                           !header.member("profile", Json::Kind::object).members.empty();
  need("--profile", has_profile == !values_of(argv, "--profile").empty());
  check_selection(header, argv, need);
}

// Whether a command line asks for programs that are in no corpus. Whether a file of known failures
// is empty is not known here.
bool asks_fresh(const Json& header, const Words& argv) {
  const Words named = values_of(argv, "--fresh");
  if (!named.empty()) return named.back().find_first_not_of('0') != std::string::npos;
  const Json* selection = header.find("selection");
  const bool is_part =
      selection != nullptr &&
      (!selection->texts_at("only").empty() || !selection->texts_at("cases").empty() ||
       !selection->text_at("case").empty() || !selection->texts_at("cycles").empty() ||
       !selection->texts_at("clauses").empty());
  const std::string spec = header.member("subject", Json::Kind::object).text_at("spec");
  return !argv.empty() && argv.front() == "certify" && !is_part && !spec.starts_with("capture:") &&
         !is_set(argv, "--fail-fast") && values_of(argv, "--write-known-failures").empty();
}

// The shards of a merged run; null: it is none.
const Json* shards_of(const Json& header) {
  const Words argv = header.texts_at("argv");
  const bool is_merged = !argv.empty() && argv.front() == "merge";
  const Json* shards = header.find("shards");
  if (is_merged != (shards != nullptr && !shards->items.empty())) {
    throw Fault("A merged run names its shards, and no other does.");
  }
  return shards;
}

}  // namespace

std::vector<std::string> header_faults(const Json& header) try {
  std::vector<std::string> faults;
  const std::string& shard = header.text_of("shard");
  const Json* shards = shards_of(header);
  if (shards == nullptr) {
    check_header(header, header.texts_at("argv"), shard, faults);
    return faults;
  }
  const auto all = std::to_string(shards->items.size());
  if (shard != "1/1") faults.emplace_back("A merged run is a shard.");
  for (std::size_t i = 0; i < shards->items.size(); ++i) {
    const Json& one = shards->items[i];
    const std::string due = std::to_string(i + 1) + "/" + all;
    if (one.text_of("shard") != due) faults.push_back("Shard " + due + " is not in its place.");
    check_header(header, one.texts_of("argv"), due, faults);
  }
  return faults;
} catch (const Fault& fault) {
  return {fault.what()};
}

std::string fresh_fault(const Json& header, const Json& fresh) {
  const auto is_wrong = [&](const Json& counts, const Words& argv) {
    return !counts.members.empty() && !asks_fresh(header, argv);
  };
  const Json* shards = header.find("shards");
  const bool is_any = shards == nullptr ? is_wrong(fresh, header.texts_at("argv"))
                                        : std::ranges::any_of(shards->items, [&](const Json& one) {
                                            return is_wrong(one.member("fresh", Json::Kind::object),
                                                            one.texts_of("argv"));
                                          });
  return is_any ? "There are fresh programs, and the command line asks for none." : "";
}

}  // namespace gonogo::checker
