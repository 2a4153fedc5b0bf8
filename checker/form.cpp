// SPDX-License-Identifier: GPL-3.0-or-later
//
// Written from the description of the format (corpus/schema/vectors-2.schema.json).
#include "checker/form.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <span>
#include <string_view>

#include "checker/profile.hpp"

namespace gonogo::checker {
namespace {

using Names = std::vector<std::string_view>;

const Names kDialects = {"gsk988ta", "hnc21t", "sinumerik802s", "sinumerik840d", "rs274"};
const Names kBases = {"text", "derived", "silent"};
const Names kAlarms = {"syntax",
                       "undefined-code",
                       "duplicate-word",
                       "conflicting-words",
                       "missing-word",
                       "value-out-of-range",
                       "value-sign",
                       "not-an-integer",
                       "direction-conflict",
                       "tool-too-large",
                       "step-too-large",
                       "depth-exceeds-tool",
                       "axis-not-in-plane",
                       "plane-not-allowed",
                       "taper-limit",
                       "retract-pair",
                       "retract-ratio",
                       "arc-end-point",
                       "arc-intermediate-point",
                       "arc-tangent",
                       "arc-radius",
                       "feed-missing",
                       "lead-missing",
                       "spindle-stopped",
                       "no-tool",
                       "reference-plane",
                       "unused-word",
                       "program-end",
                       "machining-type",
                       "direction-parameter",
                       "allowance-too-large",
                       "pocket-size"};

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// A dotted name in lower case that ends in six digits.
bool is_id(std::string_view id) {
  const std::size_t dot = id.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return false;
  const std::string_view rest = id.substr(0, dot);
  return id.size() - dot == 7 && is_digits(id.substr(dot + 1)) &&
         rest.find('.') != std::string_view::npos && rest.find("..") == std::string_view::npos &&
         rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-.") == std::string_view::npos;
}

// "-12.5", and "11/3" where rationals are allowed. Vectors have no exponents.
bool is_number(std::string_view text, bool rational) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t mark = text.find_first_of(rational ? "./" : ".");
  if (mark == std::string_view::npos) return is_digits(text);
  const std::string_view rest = text.substr(mark + 1);
  const bool is_ratio = text[mark] == '/';
  return is_digits(text.substr(0, mark)) && is_digits(rest) && !(is_ratio && rest[0] == '0');
}

// Throws Fault.
void need_keys(const Json& object, const std::string& what, const Names& needed,
               const Names& optional) {
  if (!object.is(Json::Kind::object)) throw Fault(what + " is no object.");
  for (const std::string_view key : needed) {
    if (object.find(key) == nullptr) throw Fault(what + " lacks \"" + std::string(key) + "\".");
  }
  for (const auto& [key, value] : object.members) {
    if (!is_one_of(key, needed) && !is_one_of(key, optional)) {
      throw Fault(what + " has the unknown key \"" + key + "\".");
    }
  }
}

void need_number(const Json& value) {
  const auto need = [](const std::string& text) {
    if (!is_number(text, true)) throw Fault("\"" + text + "\" is no number of a vector.");
  };
  if (value.is(Json::Kind::text)) return need(value.text);
  for (const auto& [name, parts] : value.members) {
    for (const std::string& text : parts.texts()) need(text);
  }
}

void check_record(const Json& record) {
  const std::string& kind = record.text_of("k");
  const std::string what = "A record \"" + kind + "\"";
  if (kind == "end") return need_keys(record, what, {"k", "to"}, {"clause"});
  if (kind == "rapid") {
    need_keys(record, what, {"k", "b", "to"}, {"clause"});
  } else if (kind == "feed") {
    need_keys(record, what, {"k", "b", "to", "f"}, {"fm", "clause"});
  } else if (kind == "arc") {
    need_keys(record, what, {"k", "b", "to", "f", "plane", "c", "rot"}, {"fm", "clause"});
  } else if (kind == "arc3") {
    need_keys(record, what, {"k", "b", "to", "f", "via"}, {"fm", "clause"});
  } else if (kind == "thread") {
    need_keys(record, what, {"k", "b", "to", "lead", "start"}, {"clause"});
  } else if (kind == "dwell") {
    need_keys(record, what, {"k", "b", "s"}, {"clause"});
  } else {
    need_keys(record, what, {"k", "b", "m"}, {"clause"});
  }
  for (const std::string_view key : {"f", "lead", "start", "s"}) {
    if (const Json* number = record.find(key)) need_number(*number);
  }
  for (const std::string_view key : {"to", "c", "via"}) {
    const Json* position = record.find(key);
    if (position == nullptr) continue;
    if (position->members.empty()) throw Fault(what + " has an empty position.");
    for (const auto& [axis, number] : position->members) need_number(number);
  }
}

// Open parts follow each other within the records.
void check_open(const Json& expectation) {
  const Json* open = expectation.find("open");
  if (open == nullptr) return;
  const auto records =
      static_cast<long>(expectation.member("records", Json::Kind::list).items.size());
  long before = 0;
  for (const Json& part : open->items) {
    need_keys(part, "An open part", {"from", "to", "clause", "path", "conditions"}, {});
    const long from = part.integer_of("from");
    const long to = part.integer_of("to");
    if (from < before || to < from || to > records) {
      throw Fault("The open parts do not follow each other within the records.");
    }
    before = to;
  }
}

void check_expectation(const Json& expectation) {
  need_keys(expectation, "An expectation", {"basis", "records"},
            {"when", "open", "alarm", "not_covered", "others"});
  if (!is_one_of(expectation.text_of("basis"), kBases)) {
    throw Fault("The basis " + expectation.text_of("basis") + " is unknown.");
  }
  for (const Json& record : expectation.member("records", Json::Kind::list).items) {
    check_record(record);
  }
  if (const Json* when = expectation.find("when")) {
    for (const auto& [key, value] : when->members) {
      if (!default_reading(key)) throw Fault("The reading " + key + " is unknown.");
    }
  }
  check_open(expectation);
  const Json* alarm = expectation.find("alarm");
  if (alarm == nullptr) return;
  need_keys(*alarm, "An alarm", {"any_of"}, {});
  for (const Json& choice : alarm->member("any_of", Json::Kind::list).items) {
    need_keys(choice, "An alarm", {"class", "b"}, {"word"});
    if (!is_one_of(choice.text_of("class"), kAlarms)) {
      throw Fault("The alarm class " + choice.text_of("class") + " is unknown.");
    }
  }
}

void check_case(const Json& one) {
  need_keys(one, "The case", {"id", "comment", "program", "expect", "tags", "provenance"}, {});
  if (!is_id(one.text_of("id"))) throw Fault("The id is not of the form name.name.000000.");
  if (one.text_of("comment").empty()) throw Fault("The comment is empty.");
  if (one.text_of("provenance").empty()) throw Fault("The provenance is empty.");
  need_keys(one.member("tags", Json::Kind::object), "The tags", {"tway", "sign"}, {});
  const auto& expect = one.member("expect", Json::Kind::list).items;
  if (expect.empty()) throw Fault("Nothing is expected.");
  for (const Json& expectation : expect) check_expectation(expectation);
}

void check_group(const Json& group) {
  need_keys(group, "The group", {"gid", "features", "clauses", "profile", "cases"}, {});
  for (const std::string_view key : {"features", "clauses"}) {
    const auto names = group.texts_of(key);
    if (names.empty() || std::set(names.begin(), names.end()).size() != names.size()) {
      throw Fault("The list \"" + std::string(key) + "\" is empty or names something twice.");
    }
  }
  const Json& profile = group.member("profile", Json::Kind::object);
  need_keys(profile, "The profile", {},
            {"units", "increment", "resolution", "x_diameter", "initial", "reference_point",
             "offsets", "tools", "parameters", "readings", "alarm_timing", "block_skip"});
  for (const auto& [key, value] : profile.members) {
    if (key == "parameters") {
      for (const auto& [name, number] : value.members) {
        if (!is_number(number.text, false))
          throw Fault("The parameter " + name + " is no decimal.");
      }
    } else if (key == "readings") {
      for (const auto& [name, choice] : value.members) {
        if (!default_reading(name)) throw Fault("The reading " + name + " is unknown.");
      }
    } else if (value.is(Json::Kind::number)) {
      throw Fault("A number of the profile is not in quotes.");
    }
  }
}

std::string name_of(const Json& object, std::string_view key) {
  const Json* name = object.find(key);
  return name == nullptr ? "(without a name)" : name->text;
}

}  // namespace

std::vector<std::string> form_faults(const Json& file, const std::string& corpus_version) {
  std::vector<std::string> faults;
  const auto attempt = [&](const std::string& where, const std::function<void()>& check) {
    try {
      check();
    } catch (const Fault& fault) {
      faults.push_back(where + ": " + fault.what());
    }
  };
  attempt("file", [&] {
    need_keys(file, "The file", {"format", "corpus", "dialect", "cycle", "groups"}, {});
    const long format = file.integer_of("format");
    if (format != 1 && format != 2) throw Fault("The format is not 1 or 2.");
    if (file.text_of("corpus") != corpus_version) throw Fault("It is of another corpus.");
    if (!is_one_of(file.text_of("dialect"), kDialects)) throw Fault("The dialect is unknown.");
  });
  for (const Json& group : file.member("groups", Json::Kind::list).items) {
    attempt(name_of(group, "gid"), [&] { check_group(group); });
    for (const Json& one : group.member("cases", Json::Kind::list).items) {
      attempt(name_of(one, "id"), [&] { check_case(one); });
    }
  }
  return faults;
}

}  // namespace gonogo::checker
