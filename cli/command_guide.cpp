// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_guide.hpp"

namespace gonogo::cli {
namespace {

CommandGroup use_commands() {
  return {"Use",
          {{"expand",
            {"expand groove.nc --dialect hnc21t --format table",
             "expand groove.nc --dialect hnc21t --format svg > groove.svg"}},
           {"explain",
            {"explain groove.nc --dialect hnc21t", "explain arc.nc --dialect rs274 --block 2"}},
           {"spec", {"spec --dialect gsk988ta --about g94", "spec --features"}}}};
}

CommandGroup judging_commands() {
  return {"Judge a controller",
          {{"judge",
            {"judge arc.nc --dialect rs274 --trace trace.jsonl",
             "judge arc.nc --dialect rs274 --subject \"pipe:python3 acme.py\" --sheet arc.svg"}},
           {"certify",
            {"certify --subject lib:./acme.so --report acme",
             "certify --subject \"pipe:python3 acme.py\" --dialect rs274 --cycle arc"}},
           {"report", {"report acme --out paper", "report acme --out paper --pdf acme.pdf"}},
           {"compare", {"compare before after", "compare before/results.jsonl after"}},
           {"merge",
            {"merge part/1 part/2 --out whole.jsonl", "merge part/1 --partial --out some.jsonl"}},
           {"site", {"site acme-1 acme-2 --out site", "site acme other --out site --title Peers"}},
           {"verify", {"verify certificate", "verify ../from-a-vendor/certificate"}},
           {"export",
            {"export --out programs --dialect gsk988ta",
             "export --out programs --dialect gsk988ta --only 'gsk.arc.*' --feed-max 500"}},
           {"identify",
            {"identify --subject lib:./acme.so --dialect hnc21t --out machine.toml",
             "identify --subject \"pipe:python3 acme.py\" --dialect rs274"}},
           {"host", {"host ./acme.so", "certify --subject \"pipe:gonogo host ./acme.so\""}}}};
}

CommandGroup finding_commands() {
  return {"Find and reduce",
          {{"hunt",
            {"hunt --subject lib:./acme.so --dialect rs274 --programs 2000 --out found",
             "hunt --subject lib:./acme.so --dialect rs274 --time 8h --campaign night"}},
           {"fuzz",
            {"fuzz --subject lib:./acme.so --dialect rs274",
             "fuzz --subject lib:./acme.so --dialect rs274 --out found"}},
           {"reduce",
            {"reduce field.nc --subject lib:./acme.so --dialect rs274",
             "reduce field.nc --subject lib:./acme.so --dialect rs274 > small.nc"}},
           {"ci",
            {"ci change --subject lib:./acme.so --dialect rs274 --report push",
             "ci batch --subject lib:./acme.so --dialect rs274 --campaign nights"}}}};
}

CommandGroup corpus_commands() {
  return {"Corpus and project",
          {{"corpus", {"corpus list --only 'hnc.g74.*'", "corpus build recipes mine --review"}},
           {"generate",
            {"generate --dialect hnc21t --only hnc.g74 --strength 2 --out pairs",
             "generate --dialect hnc21t --programs 3000 --seed 1 --out fresh"}},
           {"selftest", {"selftest", "selftest --help"}},
           {"faults", {"faults --list", "faults --matrix"}},
           {"signs", {"signs", "signs --help"}},
           {"completion", {"completion", "completion > gonogo.bash"}},
           {"man", {"man", "man > gonogo.1"}}}};
}

}  // namespace

std::vector<CommandGroup> command_groups() {
  return {use_commands(), judging_commands(), finding_commands(), corpus_commands()};
}

}  // namespace gonogo::cli
