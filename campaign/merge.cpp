// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/results_reader.hpp"
#include "campaign/selection.hpp"
#include "corpus/io/id_set.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

using Texts = std::vector<std::string>;

// One of the files, read once to see what it is.
struct Shard {
  std::string path;
  unsigned number = 0;
  unsigned of = 0;
  Json header;
  std::optional<Json> footer;  // nothing: incomplete
  std::string sha256;
  std::uint64_t cases = 0;  // of the corpus
  IdSet ids;
};

ResultsReader open(const std::string& path) {
  const bool is_journal = path.ends_with(".part");
  return ResultsReader(path,
                       is_journal ? ResultsReader::Order::as_run : ResultsReader::Order::by_id);
}

Shard look_at(const std::string& path) {
  ResultsReader reader = open(path);
  Shard shard;
  shard.path = path;
  shard.header = reader.header();
  const std::string text = shard.header.value("shard", "");
  if (!read_shard(text, shard.number, shard.of)) {
    throw MergeError(fmt::format("{}: \"{}\" is no shard i/n.", path, text));
  }
  for (CaseHead head; reader.next(head);) {
    if (is_fresh(head.id)) continue;
    ++shard.cases;
    if (shard_of(head.id, shard.of) != shard.number) {
      throw MergeError(
          fmt::format("{}: the case {} does not belong to shard {}.", path, head.id, text));
    }
    shard.ids.insert(head.id);
  }
  shard.footer = reader.footer();
  shard.sha256 = reader.sha256();
  return shard;
}

// The same run, another part of it.
void check_same_run(const Shard& a, const Shard& b) {
  if (a.of != b.of) {
    throw MergeError(
        fmt::format("{} is one of {} shards, {} one of {}.", a.path, a.of, b.path, b.of));
  }
  for (const Shard* from : {&a, &b}) {
    for (const auto& [key, value] : from->header.items()) {
      if (key == "argv" || key == "shard" || key == "seed") continue;
      const Json& here = a.header.contains(key) ? a.header[key] : Json();
      const Json& there = b.header.contains(key) ? b.header[key] : Json();
      if (here != there) {
        throw MergeError(
            fmt::format("{} and {} are of different runs: \"{}\" is {} in one and {} in the other.",
                        a.path, b.path, key, here.dump(), there.dump()));
      }
    }
  }
}

// The more complete one of two files of a shard.
void choose(Shard shard, std::map<unsigned, Shard>& shards, std::vector<std::string>& notes) {
  auto [place, is_new] = shards.try_emplace(shard.number, shard);
  if (is_new) return;
  Shard& before = place->second;
  if (before.footer && shard.footer) {
    if (before.sha256 != shard.sha256) {
      throw MergeError(fmt::format("{} and {} are both shard {}/{}, and their cases differ.",
                                   before.path, shard.path, shard.number, shard.of));
    }
    notes.push_back(
        fmt::format("{} is shard {}/{} once more, with the same cases as {}: it counts "
                    "once.",
                    shard.path, shard.number, shard.of, before.path));
    return;
  }
  const bool later_is_better =
      shard.footer.has_value() || (!before.footer && shard.cases > before.cases);
  notes.push_back(fmt::format("{} is incomplete; of shard {}/{} {} counts.",
                              later_is_better ? before.path : shard.path, shard.number, shard.of,
                              later_is_better ? shard.path : before.path));
  if (later_is_better) before = std::move(shard);
}

// What the footers of the shards say together. The alarm map's entries that no case met are those
// that are unused in every shard; what is stale otherwise is so in each of them.
ResultsWriter::Ending ending_of(const std::map<unsigned, Shard>& shards) {
  ResultsWriter::Ending ending;
  const Json& first = *shards.begin()->second.footer;
  const bool alone = shards.begin()->second.of == 1;
  if (first.contains("unused_alarms")) ending.alarms = first["unused_alarms"].get<Texts>();
  const Texts stale = first.value("stale", Texts());
  ending.stale = stale;
  if (alone && ending.alarms) {
    // They stand among the stale ones already, at the end.
    ending.stale.resize(ending.stale.size() - std::min(ending.stale.size(), ending.alarms->size()));
  }
  for (const auto& [number, shard] : shards) {
    const Json& footer = *shard.footer;
    ending.left_out += footer.value("left_out", std::size_t{0});
    add_fresh(ending.fresh, fresh_from_json(footer.value("fresh", Json::object())));
    if (footer.value("stale", Texts()) != stale) {
      throw MergeError(fmt::format("{} and {} differ in the stale entries of the subject's files.",
                                   shards.begin()->second.path, shard.path));
    }
    if (!ending.alarms) continue;
    const Texts unused = footer.value("unused_alarms", Texts());
    std::erase_if(*ending.alarms, [&](const std::string& entry) {
      return std::ranges::find(unused, entry) == unused.end();
    });
  }
  return ending;
}

// Each shard has its cases of the run and no others (J-RUN-13). A shard whose lines were dropped
// looks complete by itself.
void check_cases(const Corpus& corpus, const std::map<unsigned, Shard>& shards) {
  CampaignOptions asked = asked_in(shards.begin()->second.header);
  const unsigned all = std::exchange(asked.shards, 1);
  std::map<unsigned, std::uint64_t> cases;
  std::map<unsigned, std::uint64_t> left_out;
  CaseReader reader(corpus, Detail::to_run, asked.dialects);
  while (std::optional<Case> test = reader.next()) {
    if (!is_selected(asked, *test)) continue;
    const std::string id = test->id;
    const unsigned number = shard_of(id, all);
    const bool is_run = under(asked, *std::move(test)).has_value();
    ++(is_run ? cases : left_out)[number];
    const Shard& shard = shards.at(number);
    if (is_run == shard.ids.contains(id)) continue;
    throw MergeError(is_run ? fmt::format("{}: the case {} is missing.", shard.path, id)
                            : fmt::format("{}: the run leaves the case {} out.", shard.path, id));
  }
  for (const auto& [number, shard] : shards) {
    if (shard.cases != cases[number]) {
      throw MergeError(fmt::format("{} has {} cases, and the run has {} in shard {}/{}.",
                                   shard.path, shard.cases, cases[number], number, all));
    }
    if (shard.footer->value("left_out", std::uint64_t{0}) != left_out[number]) {
      throw MergeError(fmt::format("{}: the run leaves {} cases out in shard {}/{}.", shard.path,
                                   left_out[number], number, all));
    }
  }
}

// 0: they have none in common.
std::uint64_t common_seed(const std::map<unsigned, Shard>& shards) {
  const auto seed_of = [](const Shard& shard) {
    return shard.header.value("seed", std::uint64_t{0});
  };
  const std::uint64_t seed = seed_of(shards.begin()->second);
  const bool is_common =
      std::ranges::all_of(shards, [&](const auto& entry) { return seed_of(entry.second) == seed; });
  return is_common ? seed : 0;
}

// What each shard was run with: fresh programs are drawn from its own seed, and its command line
// has the files and limits of the run. A file that was merged before keeps what it says of its own.
Json shards_json(const std::map<unsigned, Shard>& shards) {
  Json list = Json::array();
  for (const auto& [number, shard] : shards) {
    if (shards.size() == 1 && shard.header.contains("shards")) return shard.header["shards"];
    list.push_back(
        {{"shard", fmt::format("{}/{}", number, shard.of)},
         {"seed", shard.header.value("seed", std::uint64_t{0})},
         {"argv", shard.header.value("argv", Json::array())},
         {"fresh", shard.footer.value_or(Json::object()).value("fresh", Json::object())}});
  }
  return list;
}

void add_lines(const Shard& shard, ResultsWriter& writer) {
  ResultsReader reader = open(shard.path);
  for (CaseHead head; reader.next(head);) {
    // As it was before the readings of the shard alone were reconciled.
    const CaseFacts facts = facts_of(reader.text());
    writer.add_line(facts.readings ? reconciled_line(reader.text(), facts.verdict, std::nullopt,
                                                     PassEvidence::keep)
                                   : reader.text());
  }
}

}  // namespace

MergeOutcome merge_results(const MergeOptions& options) {
  MergeOutcome outcome;
  std::map<unsigned, Shard> shards;
  for (const std::string& path : options.results) {
    Shard shard = look_at(path);
    if (!shards.empty()) check_same_run(shards.begin()->second, shard);
    choose(std::move(shard), shards, outcome.notes);
  }
  if (shards.empty()) throw MergeError("There is nothing to merge.");
  const unsigned all = shards.begin()->second.of;
  for (unsigned number = 1; number <= all; ++number) {
    const auto shard = shards.find(number);
    if (shard == shards.end()) {
      outcome.missing.push_back(fmt::format("shard {}/{} is not there", number, all));
    } else if (!shard->second.footer) {
      outcome.missing.push_back(
          fmt::format("shard {}/{} is incomplete: {} has {} cases and no "
                      "footer",
                      number, all, shard->second.path, shard->second.cases));
    }
  }
  const auto run = shards.begin()->second.header.value("corpus", Json::object());
  outcome.has_corpus =
      options.corpus != nullptr && run.value("sha256", "") == options.corpus->sha256();
  if (!outcome.missing.empty() && !options.partial) return outcome;
  if (outcome.has_corpus && outcome.missing.empty()) check_cases(*options.corpus, shards);
  Json header = shards.begin()->second.header;
  header["shard"] = "1/1";
  header["argv"] = options.argv;
  header["seed"] = common_seed(shards);
  header["shards"] = shards_json(shards);
  ResultsWriter writer(options.out, header.dump());
  for (const auto& [number, shard] : shards) add_lines(shard, writer);
  if (outcome.missing.empty()) {
    outcome.footer = writer.close(ending_of(shards));
  } else {
    writer.close_without_footer();
  }
  outcome.written = true;
  return outcome;
}

}  // namespace gonogo::oracle
