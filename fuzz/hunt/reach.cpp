// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/reach.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "fuzz/program/features.hpp"
#include "reference/dialect.hpp"

namespace gonogo::hunt {
namespace {

using Json = nlohmann::ordered_json;
using oracle::Decision;

// Cases of the corpus may be longer than what a hunt tries.
constexpr std::size_t kMostCost = 200'000;

bool is_judged(const std::optional<oracle::Verdict>& verdict) {
  if (!verdict) return false;
  const Decision decided = decision(verdict->kind);
  return decided == Decision::go || decided == Decision::no_go;
}

void count_in(ReachCount& count, ProgramSource source,
              const std::optional<oracle::Verdict>& verdict) {
  ++(source == ProgramSource::corpus ? count.corpus : count.campaign);
  if (!verdict) return;
  if (is_judged(verdict)) ++count.judged;
  if (decision(verdict->kind) == Decision::no_go) ++count.no_go;
  if (verdict->kind == oracle::VerdictKind::skip) ++count.skipped;
}

Json count_json(const ReachCount& count) {
  return {{"corpus", count.corpus},
          {"campaign", count.campaign},
          {"judged", count.judged},
          {"no_go", count.no_go},
          {"skipped", count.skipped}};
}

std::string row(const std::string& name, const ReachCount& count, const std::string& more) {
  return fmt::format("{:<24}{:>8}{:>10}{:>8}{:>8}{:>9}{}\n", name, count.corpus, count.campaign,
                     count.judged, count.no_go, count.skipped, more);
}

std::string head(const char* what, const char* more) {
  return fmt::format("{:<24}{:>8}{:>10}{:>8}{:>8}{:>9}{}\n", what, "corpus", "campaign", "judged",
                     "not GO", "skipped", more);
}

// How many of all clauses or features any program reached, and a judged one.
struct Share {
  std::size_t all = 0;
  std::size_t reached = 0;
  std::size_t judged = 0;

  void add(const ReachCount& count) {
    ++all;
    if (count.programs() > 0) ++reached;
    if (count.judged > 0) ++judged;
  }
};

Share share_of(const std::map<std::string, ClauseReach>& clauses) {
  Share share;
  for (const auto& [id, reach] : clauses) share.add(reach.count);
  return share;
}

Share share_of(const std::map<std::string, ReachCount>& features) {
  Share share;
  for (const auto& [name, count] : features) share.add(count);
  return share;
}

Share ways_of(const std::map<std::string, ClauseReach>& clauses) {
  Share share;
  for (const auto& [id, reach] : clauses) {
    share.all += reach.ways.size();
    share.judged += reach.judged_ways.size();
  }
  share.reached = share.all;
  return share;
}

Json share_json(const Share& share) {
  return {{"all", share.all}, {"reached", share.reached}, {"judged", share.judged}};
}

}  // namespace

Reach::Reach(const std::string& dialect) : dialect_(dialect) {
  const reference::Dialect* known = reference::find_dialect(dialect);
  for (const reference::Clause& clause : known->clauses) clauses_[std::string(clause.id)];
  for (const reference::DialectFeature& feature : known->descriptor->features) {
    features_[std::string(feature.name)];
  }
}

void Reach::add(ProgramSource source, const generate::GeneratedProgram& program,
                const std::optional<oracle::Verdict>& verdict,
                const std::vector<std::string>& features) {
  count_in(programs_, source, verdict);
  std::set<std::string> needed = program::features_needed({program.profile, program.text});
  needed.insert(features.begin(), features.end());
  for (const std::string& feature : needed) {
    count_in(features_[feature], source, verdict);
  }
  const auto reached = reached_by(program, kMostCost);
  if (!reached) return;
  for (const auto& [clause, ways] : *reached) {
    ClauseReach& reach = clauses_[std::string(reference::clause_name(clause))];
    count_in(reach.count, source, verdict);
    reach.ways.insert(ways.begin(), ways.end());
    if (is_judged(verdict)) reach.judged_ways.insert(ways.begin(), ways.end());
  }
}

void Reach::add_about(const std::string& clause) {
  const auto known = clauses_.find(clause);
  if (known != clauses_.end()) ++known->second.about;
}

std::string Reach::text() const {
  std::string text = head("clause", "   about    ways");
  for (const auto& [id, reach] : clauses_) {
    text += row(id, reach.count,
                fmt::format("{:>8}{:>8}", reach.about,
                            fmt::format("{}/{}", reach.judged_ways.size(), reach.ways.size())));
  }
  text += "\n" + head("feature", "");
  for (const auto& [name, count] : features_) text += row(name, count, "");
  const Share clauses = share_of(clauses_);
  const Share features = share_of(features_);
  const Share ways = ways_of(clauses_);
  text += fmt::format(
      "\n{}: {} programs of the corpus, {} of the campaign; {} judged, {} not GO, {} skipped\n"
      "clauses   {} of {} with a record or an alarm, {} of them judged\n"
      "ways      {} met in which a clause decides, {} of them judged\n"
      "features  {} of {} needed by a program, {} of them judged\n",
      dialect_, programs_.corpus, programs_.campaign, programs_.judged, programs_.no_go,
      programs_.skipped, clauses.reached, clauses.all, clauses.judged, ways.all, ways.judged,
      features.reached, features.all, features.judged);
  return text;
}

std::string Reach::json(const std::string& subject) const {
  Json clauses = Json::object();
  for (const auto& [id, reach] : clauses_) {
    Json one = count_json(reach.count);
    one["about"] = reach.about;
    one["ways"] = reach.ways.size();
    one["judged_ways"] = reach.judged_ways.size();
    clauses[id] = std::move(one);
  }
  Json features = Json::object();
  for (const auto& [name, count] : features_) features[name] = count_json(count);
  const Json all = {{"format", 1},
                    {"dialect", dialect_},
                    {"subject", subject},
                    {"programs", count_json(programs_)},
                    {"reached",
                     {{"clauses", share_json(share_of(clauses_))},
                      {"ways", share_json(ways_of(clauses_))},
                      {"features", share_json(share_of(features_))}}},
                    {"clauses", std::move(clauses)},
                    {"features", std::move(features)}};
  return oracle::dump(all, 1) + "\n";
}

}  // namespace gonogo::hunt
