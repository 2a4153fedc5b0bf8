// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"

#include "publish/site/site.hpp"

namespace gonogo::oracle::site {
namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const Counts& counts) {
  Json json;
  for (std::size_t i = 0; i < kOutcomes; ++i) json[key(static_cast<Outcome>(i))] = counts.of[i];
  return json;
}

Json speed_json(const Speed& speed) {
  Json slowest = Json::array();
  for (const Speed::Slow& slow : speed.slowest()) {
    slowest.push_back({{"id", slow.id}, {"us", slow.microseconds}});
  }
  return {{"cases", speed.cases()},
          {"us", speed.microseconds()},
          {"half_below_us", speed.below(50)},
          {"most_below_us", speed.below(99)},
          {"slowest", std::move(slowest)}};
}

Json run_json(const Run& run) {
  Json cycles = Json::array();
  for (const auto& [cycle, counts] : run.cycles) {
    cycles.push_back(
        {{"dialect", cycle.dialect}, {"cycle", cycle.cycle}, {"counts", counts_json(counts)}});
  }
  Json clauses = Json::array();
  for (const auto& [clause, counts] : run.clauses) {
    clauses.push_back({{"clause", clause},
                       {"passed", counts.passed},
                       {"departed", counts.departed},
                       {"elsewhere", counts.elsewhere},
                       {"undecided", counts.undecided}});
  }
  Json causes = Json::array();
  for (const auto& [reason, about] : run.reasons) {
    causes.push_back({{"reason", reason}, {"cases", about.cases}, {"verdicts", about.verdicts}});
  }
  return {{"name", run.name},
          {"version", run.version},
          {"folder", run.stem},
          {"corpus", run.corpus},
          {"corpus_sha256", run.corpus_sha256},
          {"gonogo", run.gonogo},
          {"decision", run.decision},
          {"head", run.head},
          {"counts", counts_json(run.counts)},
          {"cycles", std::move(cycles)},
          {"clauses", std::move(clauses)},
          {"causes", std::move(causes)},
          {"speed", speed_json(run.speed)}};
}

Json departure_json(const Departure& departure) {
  Json shares = Json::array();
  for (const auto& [run, share] : departure.shares) {
    shares.push_back(
        {{"run", run}, {"cases", share.cases}, {"known", share.known}, {"first", share.first}});
  }
  return {{"dialect", departure.key.dialect},  {"verdict", name(departure.key.kind)},
          {"clause", departure.key.clause},    {"what", departure.key.what},
          {"cases", departure.cases},          {"cycles", departure.cycles},
          {"smallest", departure.smallest.id}, {"message", departure.smallest.message},
          {"runs", std::move(shares)}};
}

Json vote_json(const Gathered& gathered) {
  Json ballots;
  for (std::size_t i = 0; i < kBallots; ++i) {
    const auto ballot = static_cast<Ballot>(i);
    const auto found = gathered.votes.ballots().find(ballot);
    ballots[key(ballot)] = found == gathered.votes.ballots().end() ? 0 : found->second;
  }
  ballots["alone"] = gathered.votes.alone();
  Json agreements = Json::array();
  for (const Agreement* one : gathered.votes.list()) {
    agreements.push_back({{"ballot", key(one->key.ballot)},
                          {"dialect", one->key.dialect},
                          {"verdict", one->key.verdict},
                          {"clause", one->key.clause},
                          {"alike", one->key.alike},
                          {"with", one->key.with},
                          {"other", one->key.other},
                          {"cases", one->cases},
                          {"first_cases", one->first},
                          {"message", one->message}});
  }
  Json pairs = Json::array();
  for (std::size_t i = 0; i < gathered.voters.size(); ++i) {
    for (std::size_t k = i + 1; k < gathered.voters.size(); ++k) {
      const Pair pair = gathered.votes.pair(gathered.voters[i], gathered.voters[k]);
      pairs.push_back({{"runs", {gathered.voters[i], gathered.voters[k]}},
                       {"both", pair.both},
                       {"alike", pair.alike},
                       {"depart_alike", pair.depart_alike}});
    }
  }
  return {{"voters", gathered.voters},
          {"ballots", std::move(ballots)},
          {"agreements", std::move(agreements)},
          {"pairs", std::move(pairs)}};
}

Json step_json(const Step& step) {
  return {{"before", step.before},          {"after", step.after},
          {"compared", step.compared},      {"lost", step.lost.count},
          {"mended", step.mended.count},    {"moved", step.moved.count},
          {"first_lost", step.lost.first},  {"first_mended", step.mended.first},
          {"first_moved", step.moved.first}};
}

}  // namespace

std::string site_json(const Gathered& gathered, const std::string& title) {
  Json runs = Json::array();
  for (const Run& run : gathered.runs) runs.push_back(run_json(run));
  Json departures = Json::array();
  for (const Departure* one : gathered.departures.list())
    departures.push_back(departure_json(*one));
  Json steps = Json::array();
  for (const Step& step : gathered.steps) steps.push_back(step_json(step));
  const Json root = {{"format", 1},
                     {"title", title},
                     {"notes", gathered.notes},
                     {"cases", gathered.cases},
                     {"runs", std::move(runs)},
                     {"departures", std::move(departures)},
                     {"vote", vote_json(gathered)},
                     {"steps", std::move(steps)}};
  return dump(root, 1) + "\n";
}

}  // namespace gonogo::oracle::site
