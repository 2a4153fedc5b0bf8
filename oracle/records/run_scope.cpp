// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/run_scope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kFirst = 20;
// A subject may say another thing of each case; what is beyond so many is counted as one.
constexpr std::size_t kMostReasons = 200;
constexpr const char* kOtherReasons = "for further reasons";

constexpr std::string_view kNoGo = "NO-GO";

constexpr std::string_view kOfEverySubject[] = {"blocks", "m", "bytes"};

constexpr std::string_view kBasic = "basic";  // what nearly every program needs

bool is_of_every_subject(std::string_view feature) {
  return std::ranges::find(kOfEverySubject, feature) != std::end(kOfEverySubject);
}

void count(RunScope::Group& group, const std::string& id) {
  ++group.cases;
  if (group.first.size() < kFirst) group.first.push_back(id);
}

// The group of `key`; when there are too many, that of `rest`.
template <typename Groups, typename Key>
RunScope::Group& group_of(Groups& groups, Key key, Key rest) {
  const auto found = groups.find(key);
  if (found != groups.end()) return found->second;
  return groups[groups.size() < kMostReasons ? std::move(key) : std::move(rest)];
}

std::string with_dialect(const std::string& name, const std::string& dialect, bool needed) {
  return needed ? fmt::format("{} of {}", name, dialect) : name;
}

// "g90, g92 and 3 more features": at most so many names.
std::string folded(const std::vector<std::string>& names, std::size_t most) {
  const std::size_t shown = std::min(most, names.size());
  std::string text = fmt::format("{}", fmt::join(std::span(names).first(shown), ", "));
  if (shown == names.size()) return text;
  return text + " and " + counted(names.size() - shown, "more feature", "more features");
}

// "1 known failure is stale, 2 entries of the alarm map are stale"; empty: no entry is.
std::string stale_text(const std::vector<std::string>& stale) {
  const auto alarms = static_cast<std::size_t>(std::ranges::count_if(
      stale, [](const std::string& entry) { return entry.starts_with(kStaleAlarm); }));
  const std::size_t failures = stale.size() - alarms;
  std::string text;
  if (failures > 0) {
    text = counted(failures, "known failure is stale", "known failures are stale");
  }
  if (alarms > 0) {
    text += text.empty() ? "" : ", ";
    text +=
        counted(alarms, "entry of the alarm map is stale", "entries of the alarm map are stale");
  }
  return text;
}

}  // namespace

std::string grouped(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
  return digits;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", grouped(count), count == 1 ? one : many);
}

bool NaturalOrder::operator()(std::string_view a, std::string_view b) const {
  const std::string_view digits = "0123456789";
  const std::size_t own = a.find_first_of(digits);
  const std::size_t other = b.find_first_of(digits);
  if (own == other && own != std::string_view::npos && a.substr(0, own) == b.substr(0, own)) {
    auto number = [&](std::string_view text) {
      const std::size_t end = text.find_first_not_of(digits);
      return end == std::string_view::npos ? text.size() : end;
    };
    const std::size_t own_length = number(a.substr(own));
    const std::size_t other_length = number(b.substr(other));
    if (own_length != other_length) return own_length < other_length;
  }
  return a < b;
}

void RunScope::count_features(const CaseHead& line, VerdictKind kind) {
  const bool is_basic = std::ranges::all_of(line.features, [](const std::string& feature) {
    return is_of_every_subject(feature) || feature == kBasic;
  });
  const auto count_in = [&](Judged& seen, bool is_to_blame) {
    if (kind == VerdictKind::skip) {
      ++seen.skipped;
    } else if (!is_judged(kind)) {
      ++seen.unsettled;
    } else {
      ++seen.cases;
      if (decision(kind) != Decision::no_go) return;
      ++seen.no_go;
      if (is_to_blame) ++seen.to_blame;
    }
  };
  bool is_nameless = true;
  for (const std::string& feature : line.features) {
    if (is_of_every_subject(feature)) continue;
    is_nameless = false;
    count_in(features_[line.dialect][feature], is_basic || feature != kBasic);
  }
  if (is_nameless) count_in(nameless_[line.dialect], true);
}

// Whether the feature that a skip names is one that the case needs and the subject's declaration
// leaves out. A subject may give any name to a reason of its own (J-RUN-14).
bool RunScope::is_undeclared(const CaseHead& line) const {
  const std::string& feature = line.feature;
  if (feature.empty()) return false;
  const bool is_needed = line.features.empty() || std::ranges::count(line.features, feature) > 0;
  if (!is_needed || !subject_) return is_needed;
  return is_of_every_subject(feature) ? !subject_->features.contains(feature)
                                      : !subject_->declares(line.dialect, feature);
}

// What ended in neither GO nor NO-GO was not judged (J-RUN-14).
void RunScope::add(const CaseHead& line, VerdictKind kind) {
  dialects_.insert(line.dialect);
  Counts& cycle = cycles_[line.dialect][line.cycle];
  const auto tally = [&](std::size_t Counts::*what) {
    ++(all_.*what);
    ++(cycle.*what);
  };
  if (line.expected && (kind == VerdictKind::skip || kind == VerdictKind::oracle_gap)) {
    tally(&Counts::not_covered);
    return;
  }
  if (kind == VerdictKind::skip) {
    tally(&Counts::skipped);
    // One that the gauge did not even ask for, or a reason of the subject's own.
    const bool lacks = is_undeclared(line);
    const bool is_mute = line.message.empty() && !line.feature.empty();
    const std::string reason = is_mute ? "It skips " + line.feature + "." : line.message;
    const Skipped key{line.dialect, lacks ? line.feature : "", lacks ? "" : reason};
    count(group_of(not_claimed_, key, Skipped{line.dialect, "", kOtherReasons}), line.id);
    if (lacks) return;
  } else if (decision(kind) == Decision::undecided) {
    tally(&Counts::undecided);
  } else if (kind == VerdictKind::xfail) {
    tally(&Counts::known);
  } else if (kind == VerdictKind::advice) {
    tally(&Counts::advised);
    count(group_of(advices_, Advice{line.clause, line.departure}, Advice{}), line.id);
  } else {
    tally(decision(kind) == Decision::no_go ? &Counts::no_go : &Counts::go);
  }
  if (kind == VerdictKind::fail_declaration) {
    count(group_of(broken_, Broken{line.dialect, line.cycle, line.message},
                   Broken{line.dialect, line.cycle, kOtherReasons}),
          line.id);
  }
  count_features(line, kind);
}

bool RunScope::claims_every_dialect() const {
  return std::ranges::all_of(dialects_, [&](const std::string& dialect) {
    const auto named = features_.find(dialect);
    const auto nameless = nameless_.find(dialect);
    return (nameless != nameless_.end() && nameless->second.is_go()) ||
           (named != features_.end() && std::ranges::any_of(named->second, [](const auto& feature) {
              return feature.second.is_go();
            }));
  });
}

// "basic, g94 (10 of 12 cases) of gsk988ta; arc of hnc21t". A feature of which some cases were not
// judged says how many were. More than `most` of a dialect: the first, or none, and their number.
std::string RunScope::go_features(std::size_t most, Fold fold) const {
  std::string text;
  for (const auto& [dialect, features] : features_) {
    std::vector<std::string> names;
    for (const auto& [name, seen] : features) {
      if (!seen.is_go()) continue;
      names.push_back(
          seen.all() == seen.cases
              ? name
              : fmt::format("{} ({} of {} cases)", name, grouped(seen.cases), grouped(seen.all())));
    }
    if (names.empty()) continue;
    if (!text.empty()) text += "; ";
    const bool is_number = fold == Fold::number && names.size() > most;
    text += is_number ? counted(names.size(), "feature", "features") : folded(names, most);
    text += " of " + dialect;
  }
  return text;
}

// "g94 of gsk988ta fails 252 of 878 cases, g110 3 of 7, arc of hnc21t 3 of 9", of each dialect the
// one that fails most first; more than `most`: the first, and how many more.
std::string RunScope::failing_features(std::size_t most) const {
  std::string text;
  std::size_t count = 0;
  for (const auto& [dialect, features] : features_) {
    std::vector<const Features::value_type*> failing;
    for (const auto& feature : features) {
      if (feature.second.to_blame > 0) failing.push_back(&feature);
    }
    std::ranges::sort(failing, [](const auto* a, const auto* b) {
      const std::size_t own = a->second.no_go;
      const std::size_t other = b->second.no_go;
      return own != other ? own > other : NaturalOrder()(a->first, b->first);
    });
    std::string place = " of " + dialect;
    for (const auto* const feature : failing) {
      if (++count > most) continue;
      const Judged& seen = feature->second;
      const std::string cases =
          text.empty() ? counted(seen.cases, "case", "cases") : grouped(seen.cases);
      text += fmt::format("{}{}{}{} {} of {}", text.empty() ? "" : ", ", feature->first, place,
                          text.empty() ? " fails" : "", grouped(seen.no_go), cases);
      place.clear();
    }
  }
  if (count > most) text += ", and " + counted(count - most, "more feature", "more features");
  return text;
}

// Features of which the greater part was not judged; those that were skipped altogether are not
// claimed.
std::string RunScope::hardly_judged() const {
  std::vector<std::string> names;
  for (const auto& [dialect, features] : features_) {
    for (const auto& [name, seen] : features) {
      if (seen.is_judged() || seen.all() == seen.skipped) continue;
      names.push_back(fmt::format("{} ({} of {} cases)",
                                  with_dialect(name, dialect, dialects_.size() > 1),
                                  grouped(seen.cases), grouped(seen.all())));
    }
  }
  if (names.empty()) return {};
  return fmt::format("; not judged for the most part: {}", fmt::join(names, ", "));
}

std::string RunScope::score() const {
  if (no_go() == 0) return fmt::format("{} judged", grouped(judged()));
  return fmt::format("{} of {} judged {} GO", grouped(all_.go), grouped(judged()),
                     all_.go == 1 ? "is" : "are");
}

std::string RunScope::counts() const {
  std::string text = score();
  auto put = [&](std::size_t number, std::string_view one, std::string_view many) {
    if (number > 0) text += ", " + counted(number, one, many);
  };
  put(all_.advised, "advice", "advices");
  put(all_.known, "known to fail", "known to fail");
  put(all_.undecided, "undecided", "undecided");
  put(all_.not_covered, "not covered by the gauge", "not covered by the gauge");
  return text;
}

std::string RunScope::skips(std::size_t most) const {
  std::string text;
  if (!broken_.empty()) {
    std::map<std::pair<std::string, std::string>, std::size_t> places;
    for (const auto& [key, group] : broken_) places[{key.dialect, key.cycle}] += group.cases;
    std::vector<std::string> names;
    for (const auto& [place, cases] : places) {
      names.push_back(
          fmt::format("{} of {} ({})", place.second, place.first, counted(cases, "case", "cases")));
    }
    text += fmt::format("; declared, but skipped: {}", fmt::join(names, ", "));
  }
  if (all_.skipped == 0) return text;
  std::vector<std::string> names;
  std::size_t lacking = 0;
  for (const auto& [key, group] : not_claimed_) {
    if (key.feature.empty()) continue;
    lacking += group.cases;
    names.push_back(with_dialect(key.feature, key.dialect, dialects_.size() > 1));
  }
  std::ranges::sort(names, NaturalOrder());
  text += "; not claimed: ";
  if (lacking > 0) {
    text += fmt::format("{} ({})", folded(names, most), counted(lacking, "case", "cases"));
  }
  if (all_.skipped > lacking) {
    text += fmt::format("{}{}{}", lacking > 0 ? ", and " : "",
                        counted(all_.skipped - lacking, "case", "cases"),
                        lacking > 0 ? " for other reasons" : "");
  }
  return text;
}

// J-RUN-01.
std::string RunScope::head(std::string_view decision, std::size_t most,
                           const Entries& stale) const {
  const std::string go = go_features(most, Fold::first);
  std::string text(decision);
  if (decision == kNoGo) {
    text += ": ";
    if (const std::string failing = failing_features(most); !failing.empty())
      text += failing + "; ";
    if (!stale.empty()) text += stale_text(stale) + "; ";
    if (!go.empty()) text += "GO: " + go + "; ";
  } else {
    text += (go.empty() ? "" : " for " + go) + ": ";
  }
  return text + counts() + skips(most) + hardly_judged();
}

std::string RunScope::short_head(std::string_view decision, const Entries& stale) const {
  constexpr std::size_t kMostNames = 4;
  std::string text(decision);
  const auto put = [&](std::string_view name, const std::string& names) {
    if (!names.empty()) text += fmt::format(" \xC2\xB7 {}{}", name, names);
  };
  if (decision == kNoGo) {
    const std::size_t most = kMostNames / std::max<std::size_t>(1, features_.size());
    put("", failing_features(kMostNames));
    put("", stale_text(stale));
    put("GO: ", go_features(std::max<std::size_t>(1, most), Fold::first));
  } else {
    put("", go_features(kMostNames, Fold::number));
  }
  put("", score());
  if (all_.advised > 0) text += ", " + counted(all_.advised, "advice", "advices");
  if (all_.known > 0) text += fmt::format(", {} known to fail", grouped(all_.known));
  if (all_.skipped > 0) text += fmt::format(", {} not claimed", grouped(all_.skipped));
  return text;
}

}  // namespace gonogo::oracle
