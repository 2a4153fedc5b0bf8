// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_guide.hpp"

namespace gonogo::cli {
namespace {

std::vector<CommandGuide> guides_of_use() {
  constexpr const char* kUse = "Use";
  return {{"expand",
           kUse,
           {"expand groove.nc --dialect hnc21t --format table",
            "expand groove.nc --dialect hnc21t --format svg > groove.svg"}},
          {"explain",
           kUse,
           {"explain groove.nc --dialect hnc21t", "explain arc.nc --dialect rs274 --block 2"}},
          {"spec", kUse, {"spec --dialect hnc21t", "spec --features"}}};
}

std::vector<CommandGuide> guides_of_judging() {
  constexpr const char* kJudge = "Judge a controller";
  return {{"judge",
           kJudge,
           {"judge arc.nc --dialect rs274 --trace trace.jsonl",
            "judge arc.nc --dialect rs274 --subject \"pipe:python3 acme.py\""}},
          {"certify",
           kJudge,
           {"certify --subject lib:./acme.so --report acme",
            "certify --subject \"pipe:python3 acme.py\" --dialect rs274 --cycle arc"}},
          {"report", kJudge, {"report acme --out paper", "report acme --out paper --pdf acme.pdf"}},
          {"compare", kJudge, {"compare before after", "compare before/results.jsonl after"}},
          {"merge",
           kJudge,
           {"merge part/1 part/2 --out whole.jsonl", "merge part/1 --partial --out some.jsonl"}},
          {"site",
           kJudge,
           {"site acme-1 acme-2 --out site", "site acme other --out site --title Peers"}},
          {"verify", kJudge, {"verify certificate", "verify ../from-a-vendor/certificate"}},
          {"export",
           kJudge,
           {"export --out programs --dialect gsk988ta",
            "export --out programs --dialect gsk988ta --only 'gsk.arc.*' --feed-max 500"}},
          {"identify",
           kJudge,
           {"identify --subject lib:./acme.so --dialect hnc21t --out machine.toml",
            "identify --subject \"pipe:python3 acme.py\" --dialect rs274"}},
          {"host", kJudge, {"host ./acme.so", "certify --subject \"pipe:gonogo host ./acme.so\""}}};
}

std::vector<CommandGuide> guides_of_finding() {
  constexpr const char* kFind = "Find and reduce";
  return {{"hunt",
           kFind,
           {"hunt --subject lib:./acme.so --dialect rs274 --programs 2000 --out found",
            "hunt --subject lib:./acme.so --dialect rs274 --time 8h --campaign night"}},
          {"fuzz",
           kFind,
           {"fuzz --subject lib:./acme.so --dialect rs274",
            "fuzz --subject lib:./acme.so --dialect rs274 --out found"}},
          {"reduce",
           kFind,
           {"reduce field.nc --subject lib:./acme.so --dialect rs274",
            "reduce field.nc --subject lib:./acme.so --dialect rs274 > small.nc"}},
          {"ci",
           kFind,
           {"ci change --subject lib:./acme.so --dialect rs274 --report push",
            "ci batch --subject lib:./acme.so --dialect rs274 --campaign nights"}}};
}

std::vector<CommandGuide> guides_of_corpus() {
  constexpr const char* kCorpus = "Corpus and project";
  return {
      {"corpus", kCorpus, {"corpus list --only 'hnc.g74.*'", "corpus build recipes mine --review"}},
      {"generate",
       kCorpus,
       {"generate --dialect hnc21t --only hnc.g74 --strength 2 --out pairs",
        "generate --dialect hnc21t --programs 3000 --seed 1 --out fresh"}},
      {"selftest", kCorpus, {"selftest", "selftest --help"}},
      {"faults", kCorpus, {"faults --list", "faults --matrix"}},
      {"signs", kCorpus, {"signs", "signs --help"}},
      {"completion", kCorpus, {"completion", "completion > gonogo.bash"}},
      {"man", kCorpus, {"man", "man > gonogo.1"}}};
}

}  // namespace

const std::vector<CommandGuide>& command_guides() {
  static const std::vector<CommandGuide> kGuides = [] {
    std::vector<CommandGuide> all;
    for (const auto& some :
         {guides_of_use(), guides_of_judging(), guides_of_finding(), guides_of_corpus()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kGuides;
}

}  // namespace gonogo::cli
