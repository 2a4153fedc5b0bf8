// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/vote.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tuple>

namespace gonogo::oracle::site {
namespace {

constexpr std::size_t kFirstOfAgreement = 5;
// The clause of more is not kept.
constexpr std::size_t kMostAgreements = 2'000;

struct BallotNames {
  std::string_view title;
  std::string_view key;
};
constexpr std::array<BallotNames, kBallots> kBallotNames = {
    {{"all with the reference", "agreed"},
     {"one alone departs", "lone"},
     {"several depart", "split"},
     {"all alike against the reference", "against"},
     {"all depart, each in its way", "scattered"}}};

// A record or an alarm without what is the subject's own affair: how it names its alarm, and source
// lines, which not every subject knows.
std::string plain(const std::string& text) {
  using Sorted = nlohmann::json;  // keys in order
  Sorted value = Sorted::parse(text, nullptr, false);
  if (!value.is_object()) return text;
  for (const char* own : {"native", "word", "clause", "b"}) value.erase(own);
  return value.dump(-1, ' ', false, Sorted::error_handler_t::replace);
}

// To a thousandth of a millimetre: subjects round what they put out. A decimal or a quotient; any
// other text is itself.
std::string rounded(const std::string& deviation) {
  char* end = nullptr;
  double value = std::strtod(deviation.c_str(), &end);
  if (*end == '/') value /= std::strtod(end + 1, &end);
  return *end == '\0' && std::isfinite(value) ? fmt::format("{:.3f}", value) : deviation;
}

// The place of the largest group of equal departures, the first of equally large ones.
std::vector<std::size_t> largest_group(const std::vector<Votes::Answer>& answers) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!answers[i].go) groups[answers[i].departure].push_back(i);
  }
  std::vector<std::size_t> largest;
  for (const auto& [text, group] : groups) {
    const bool earlier = !largest.empty() && group.size() == largest.size() && group < largest;
    if (group.size() > largest.size() || earlier) largest = group;
  }
  return largest;
}

Ballot ballot_of(std::size_t answers, std::size_t go, std::size_t alike) {
  if (go == answers) return Ballot::agreed;
  if (go > 0) return answers - go == 1 ? Ballot::lone : Ballot::split;
  return alike == answers ? Ballot::against : Ballot::scattered;
}

// Those before others come first.
auto rank(const Agreement& one) {
  return std::tuple(!one.key.with.empty(), -static_cast<std::int64_t>(one.key.alike.size()),
                    -static_cast<std::int64_t>(one.cases));
}

}  // namespace

std::string_view title(Ballot ballot) {
  return kBallotNames[static_cast<std::size_t>(ballot)].title;
}

std::string_view key(Ballot ballot) {
  return kBallotNames[static_cast<std::size_t>(ballot)].key;
}

std::string departure_text(const CaseHead& line) {
  const std::string& verdict = line.departure.empty() ? line.verdict : line.departure;
  return fmt::format("{} {} {}", verdict, line.clause,
                     line.deviation.empty() ? plain(line.got) : rounded(line.deviation));
}

void Votes::add(const CaseHead& test, const std::vector<Answer>& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (std::size_t k = i + 1; k < answers.size(); ++k) {
      Pair& pair = pairs_[{answers[i].run, answers[k].run}];
      const bool alike =
          answers[i].go == answers[k].go && answers[i].departure == answers[k].departure;
      ++pair.both;
      if (alike) ++pair.alike;
      if (alike && !answers[i].go) ++pair.depart_alike;
    }
  }
  if (answers.size() < 2) {
    ++alone_;
    return;
  }
  const auto go = static_cast<std::size_t>(std::ranges::count(answers, true, &Answer::go));
  const std::vector<std::size_t> alike = largest_group(answers);
  const Ballot ballot = ballot_of(answers.size(), go, alike.size());
  ++ballots_[ballot];
  if (alike.size() < 2) return;
  const Answer& first = answers[alike.front()];
  Agreement::Key key{ballot, {}, {}, {}, test.dialect, first.clause, first.verdict};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool in_group = std::ranges::find(alike, i) != alike.end();
    auto& group = answers[i].go ? key.with : in_group ? key.alike : key.other;
    group.push_back(answers[i].run);
  }
  if (agreements_.size() >= kMostAgreements && !agreements_.contains(key)) {
    key.clause.clear();
    key.verdict.clear();
  }
  Agreement& agreement = agreements_[key];
  agreement.key = key;
  if (agreement.cases++ == 0) agreement.message = first.message;
  if (agreement.first.size() < kFirstOfAgreement) agreement.first.push_back(test.id);
}

std::vector<const Agreement*> Votes::list() const {
  std::vector<const Agreement*> all;
  for (const auto& [key, agreement] : agreements_) all.push_back(&agreement);
  // In the order of the keys where all else is equal.
  std::ranges::sort(all, [](const Agreement* a, const Agreement* b) {
    const auto first = rank(*a);
    const auto second = rank(*b);
    return first != second ? first < second : a->key < b->key;
  });
  return all;
}

Pair Votes::pair(std::size_t one, std::size_t other) const {
  const auto found = pairs_.find({std::min(one, other), std::max(one, other)});
  return found == pairs_.end() ? Pair{} : found->second;
}

}  // namespace gonogo::oracle::site
