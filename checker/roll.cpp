// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/roll.hpp"

#include <algorithm>
#include <array>

#include "checker/profile.hpp"
#include "checker/results.hpp"

namespace gonogo::checker {
namespace {

using Words = std::vector<std::string>;

Json* member_of(Json& object, std::string_view key) {
  const auto found = std::ranges::find(object.members, key, &JsonMember::key);
  return found == object.members.end() ? nullptr : &found->value;
}

// False when both set one key to different values; else `into` has the keys of both.
bool join(Json& into, const Json& from) {
  for (const auto& [key, value] : from.members) {
    Json* own = member_of(into, key);
    if (own == nullptr) {
      into.members.push_back({key, value});
    } else if (own->is(Json::Kind::object) && value.is(Json::Kind::object)) {
      if (!join(*own, value)) return false;
    } else if (!own->same_as(value)) {
      return false;
    }
  }
  return true;
}

// The families of readings; some of SINUMERIK are of the 802S alone.
bool is_of(const std::string& reading, const std::string& dialect) {
  constexpr std::array<std::string_view, 12> kBoth = {
      "sie.arc.correct", "sie.cr.tolerance",   "sie.cr.centre",       "sie.arc.plane",
      "sie.ar.zero",     "sie.ap.g91",         "sie.pole.same-plane", "sie.cip.collinear",
      "sie.spindle",     "sie.initial-motion", "sie.g70.f",           "sie.feed-change"};
  if (reading.starts_with("gsk.")) return dialect == "gsk988ta";
  if (reading.starts_with("hnc.")) return dialect == "hnc21t";
  if (reading.starts_with("ngc.")) return dialect == "rs274";
  const bool is_both = std::ranges::find(kBoth, reading) != kBoth.end();
  return dialect == "sinumerik802s" || (dialect == "sinumerik840d" && is_both);
}

// A profile names what is not the default; an object of readings that is empty is none.
void drop_default_readings(Json& profile) {
  Json* readings = member_of(profile, "readings");
  if (readings == nullptr) return;
  std::erase_if(readings->members, [](const JsonMember& one) {
    const auto otherwise = default_reading(one.key);
    return otherwise && *otherwise == one.value.text;
  });
  if (!readings->members.empty()) return;
  std::erase_if(profile.members, [](const JsonMember& one) { return one.key == "readings"; });
}

// The certifier's choice of a reading; false: the case chooses another.
bool choose(Json& profile, const std::string& key, const std::string& value) {
  const std::string own = reading(profile, key);
  const auto otherwise = default_reading(key);
  if (own != otherwise && own != value) return false;
  Json* readings = member_of(profile, "readings");
  if (readings == nullptr) {
    profile.members.push_back({"readings", parse_json("{}")});
    readings = &profile.members.back().value;
  }
  Json choice;
  choice.kind = Json::Kind::text;
  choice.text = value;
  if (Json* before = member_of(*readings, key)) {
    *before = choice;
  } else {
    readings->members.push_back({key, choice});
  }
  return true;
}

}  // namespace

Roll::Roll(const Json& header)
    : selection_(header), machine_(header.member("profile", Json::Kind::object)) {
  readings_ = header.find("readings");
  if (const Json* machine = header.find("machine")) {
    machine_dialect_ = machine->text_of("dialect");
    sets_ = &machine->member("sets", Json::Kind::list);
  } else if (!machine_.members.empty()) {
    const Json* selection = header.find("selection");
    const Words dialects = selection == nullptr ? Words() : selection->texts_at("dialects");
    if (dialects.size() != 1)
      throw Fault("The header does not say of which dialect its profile is.");
    machine_dialect_ = dialects.front();
  }
  const Json& subject = header.member("subject", Json::Kind::object);
  const Json* declared = subject.find("dialects");
  if (declared != nullptr && declared->is(Json::Kind::object)) dialects_ = declared;
  features_ = subject.texts_at("features");
  is_recorded_ = subject.text_at("spec").starts_with("capture:");
}

// Whether the profile says the key, which is a path of names.
bool Roll::is_set(const Json& profile, const Json& key) const {
  const Json* at = &profile;
  for (const std::string& name : key.texts()) {
    at = at->is(Json::Kind::object) ? at->find(name) : nullptr;
    if (at == nullptr) return false;
  }
  return true;
}

std::optional<Json> Roll::profile_of(const std::string& dialect, const Json& profile) const {
  Json merged = profile;
  if (!machine_dialect_.empty()) {
    if (machine_dialect_ != dialect) return std::nullopt;
    // What the certifier sets to the default and the case does not.
    const auto contradicts = [&](const Json& key) {
      return is_set(profile, key) && !is_set(machine_, key);
    };
    if (sets_ != nullptr && std::ranges::any_of(sets_->items, contradicts)) return std::nullopt;
    if (!join(merged, machine_)) return std::nullopt;
  }
  for (const std::string& choice : readings_ == nullptr ? Words() : readings_->texts()) {
    const std::size_t equals = choice.find('=');
    const std::string key = choice.substr(0, equals);
    if (!default_reading(key)) throw Fault("The header names the unknown reading " + key + ".");
    if (is_of(key, dialect) && !choose(merged, key, choice.substr(equals + 1))) return std::nullopt;
  }
  return merged;
}

bool Roll::is_same_machine(Json one, Json other) const {
  drop_default_readings(one);
  drop_default_readings(other);
  return one.same_as(other);
}

bool Roll::has_feature(const std::string& name) const {
  return std::ranges::find(features_, name) != features_.end();
}

std::string Roll::undeclared(const Vector& vector) const {
  if (dialects_ == nullptr) return {};
  const Json* declared = dialects_->find(vector.dialect);
  for (const std::string& feature : vector.features) {
    if (has_feature(feature)) continue;
    const Words known = declared == nullptr ? Words() : declared->texts();
    const bool has =
        declared != nullptr && (known.empty() || std::ranges::find(known, feature) != known.end());
    if (!has) return feature;
  }
  return {};
}

void Roll::check_words(const Json& line, const Vector& vector) const {
  const auto need = [](bool holds, const std::string& what) {
    if (!holds) throw Fault("The line names " + what + " than the vector.");
  };
  need(line.text_of("dialect") == vector.dialect, "another dialect");
  need(line.text_of("cycle") == vector.cycle, "another cycle");
  need(line.texts_at("features") == vector.features, "other features");
  need(line.texts_at("clauses") == vector.clauses, "other clauses");
  const std::string& verdict = line.text_of("verdict");
  const Json* program = line.find("program");
  if (program != nullptr && program_bytes(*program) != vector.program) {
    throw Fault("The program of the line is not that of the vector.");
  }
  const auto decision = decision_of(verdict);
  const bool needs_program = decision != Decision::go && verdict != "skip";
  if (program == nullptr && needs_program) throw Fault("The line has no program.");
  if (line.find("trace") == nullptr && needs_program) throw Fault("The line has no trace.");
  const std::string want = line.text_at("want");
  if (!want.empty() && want == line.text_at("got"))
    throw Fault("It departs, and got what it wanted.");
  const bool expects_gap = std::ranges::any_of(vector.expect, [](const Expectation& one) {
    return one.ending == Expectation::Ending::not_covered;
  });
  const bool says_nothing = verdict == "skip" || verdict == "oracle-gap";
  if ((line.find("expected") != nullptr) != (expects_gap && says_nothing)) {
    throw Fault(expects_gap ? "The line does not say that the corpus expects an oracle-gap."
                            : "The line says that the corpus expects an oracle-gap, and it does "
                              "not.");
  }
  const auto profile = profile_of(vector.dialect, vector.profile);
  if (!profile) throw Fault("It contradicts the certifier's profile: the run leaves it out.");
  const Json* said = line.find("profile");
  if (!is_same_machine(*profile, said == nullptr ? parse_json("{}") : *said)) {
    throw Fault("It ran under another profile than that of its vector and the header.");
  }
}

}  // namespace gonogo::checker
