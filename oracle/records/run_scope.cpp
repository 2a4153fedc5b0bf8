// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/run_scope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gonogo::oracle {
namespace {

constexpr std::size_t kFirst = 20;
// A subject may say another thing of each case; what is beyond so many is counted as one.
constexpr std::size_t kMostReasons = 200;
constexpr const char* kOtherReasons = "for further reasons";

constexpr std::string_view kOfEverySubject[] = {"blocks", "m", "bytes"};

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

// A skip is neither GO nor judged (J-RUN-05), and an advice is judged (J-RUN-04).
void RunScope::add(const CaseHead& line, VerdictKind kind) {
  dialects_.insert(line.dialect);
  if (line.expected && (kind == VerdictKind::skip || kind == VerdictKind::oracle_gap)) {
    ++not_covered_;
    return;
  }
  if (kind == VerdictKind::skip) {
    ++skipped_;
    // One that the gauge did not even ask for, or a reason of the subject's own.
    const bool lacks = !line.feature.empty() &&
                       (line.features.empty() ||
                        std::ranges::find(line.features, line.feature) != line.features.end());
    const Skipped key{line.dialect, lacks ? line.feature : "", lacks ? "" : line.message};
    count(group_of(not_claimed_, key, Skipped{line.dialect, "", kOtherReasons}), line.id);
    if (lacks) return;
  } else if (decision(kind) == Decision::undecided) {
    ++undecided_;
    return;
  } else {
    ++judged_;
    if (decision(kind) == Decision::no_go) ++no_go_;
    if (kind == VerdictKind::xfail) ++known_;
  }
  if (kind == VerdictKind::advice) {
    ++advised_;
    count(group_of(advices_, Advice{line.clause, line.departure}, Advice{}), line.id);
  } else if (kind == VerdictKind::fail_declaration) {
    count(group_of(broken_, Broken{line.dialect, line.cycle, line.message},
                   Broken{line.dialect, line.cycle, kOtherReasons}),
          line.id);
  }
  for (const std::string& feature : line.features) {
    if (is_of_every_subject(feature)) continue;
    Judged& seen = features_[line.dialect][feature];
    ++(kind == VerdictKind::skip ? seen.skipped : seen.cases);
  }
}

// "basic, g94 of gsk988ta; arc of hnc21t". A feature of which cases were skipped for other reasons
// than another feature says how many were judged. More than `most` of a dialect: their number.
std::string RunScope::judged_features(std::size_t most) const {
  std::string text;
  for (const auto& [dialect, features] : features_) {
    std::vector<std::string> names;
    for (const auto& [name, seen] : features) {
      if (seen.cases == 0) continue;
      names.push_back(seen.skipped == 0
                          ? name
                          : fmt::format("{} ({} of {} cases)", name, grouped(seen.cases),
                                        grouped(seen.cases + seen.skipped)));
    }
    if (names.empty()) continue;
    if (!text.empty()) text += "; ";
    text += names.size() > most ? counted(names.size(), "feature", "features")
                                : fmt::format("{}", fmt::join(names, ", "));
    text += " of " + dialect;
  }
  return text;
}

std::string RunScope::counts() const {
  std::string text = fmt::format("{} judged", grouped(judged_));
  auto put = [&](std::size_t number, std::string_view one, std::string_view many) {
    if (number > 0) text += ", " + counted(number, one, many);
  };
  put(no_go_, "NO-GO", "NO-GO");
  put(advised_, "advice", "advices");
  put(known_, "known to fail", "known to fail");
  put(undecided_, "undecided", "undecided");
  put(not_covered_, "not covered by the gauge", "not covered by the gauge");
  return text;
}

std::string RunScope::skips() const {
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
  if (skipped_ == 0) return text;
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
    text += fmt::format("{} ({})", fmt::join(names, ", "), counted(lacking, "case", "cases"));
  }
  if (skipped_ > lacking) {
    text += fmt::format("{}{}{}", lacking > 0 ? ", and " : "",
                        counted(skipped_ - lacking, "case", "cases"),
                        lacking > 0 ? " for other reasons" : "");
  }
  return text;
}

// J-RUN-01.
std::string RunScope::head(std::string_view decision) const {
  const std::string features = judged_features(std::numeric_limits<std::size_t>::max());
  std::string text(decision);
  if (!features.empty()) text += " for " + features;
  return text + ": " + counts() + skips();
}

std::string RunScope::short_head(std::string_view decision) const {
  constexpr std::string_view kDot = " \xC2\xB7 ";
  constexpr std::size_t kMostNames = 4;
  std::string text(decision);
  if (const std::string features = judged_features(kMostNames); !features.empty()) {
    text.append(kDot).append(features);
  }
  text.append(kDot);
  text += no_go_ > 0 ? fmt::format("{} of {} judged", grouped(no_go_), grouped(judged_))
                     : fmt::format("{} judged", grouped(judged_));
  if (advised_ > 0) text += ", " + counted(advised_, "advice", "advices");
  if (skipped_ > 0) text += fmt::format(", {} not claimed", grouped(skipped_));
  return text;
}

}  // namespace gonogo::oracle
