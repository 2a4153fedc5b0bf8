// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/evidence/text.hpp"
#include "publish/site/site.hpp"

namespace gonogo::oracle::site {
namespace {

using evidence::markdown_text;

std::string results(const Gathered& gathered) {
  std::string out =
      "## Results\n\n| subject | version | cases | GO | skip | undecided | advice | NO-GO | known "
      "to depart | causes |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const Run& run : gathered.runs) {
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                       markdown_text(run.name), markdown_text(run.version),
                       grouped(run.counts.cases()), grouped(run.counts[Outcome::go]),
                       grouped(run.counts[Outcome::skip]), grouped(run.counts[Outcome::undecided]),
                       grouped(run.counts[Outcome::advice]), grouped(run.counts[Outcome::no_go]),
                       grouped(run.counts[Outcome::known]), grouped(run.reasons.size()));
  }
  return out;
}

std::string cycles(const Gathered& gathered) {
  std::string out = "\n## GO of the answered cases, by cycle\n\n| dialect | cycle |";
  std::string line = "|---|---|";
  for (const Run& run : gathered.runs) {
    out += " " + markdown_text(run.title()) + " |";
    line += "--:|";
  }
  out += "\n" + line + "\n";
  for (const CycleKey& cycle : gathered.cycles()) {
    out += fmt::format("| {} | {} |", markdown_text(cycle.dialect), markdown_text(cycle.cycle));
    for (const Run& run : gathered.runs) {
      const Counts counts = run.of_cycle(cycle);
      if (counts.answered() == 0) {
        out += " |";
      } else {
        out += fmt::format(" {}/{} |", grouped(counts[Outcome::go]), grouped(counts.answered()));
      }
    }
    out += "\n";
  }
  return out;
}

std::string causes(const Gathered& gathered) {
  std::string out;
  for (const Run& run : gathered.runs) {
    if (run.reasons.empty()) continue;
    out += fmt::format("\n## Known of {}\n\n| what it does | verdict | cases |\n|---|---|--:|\n",
                       markdown_text(run.title()));
    for (const auto& [reason, about] : run.reasons) {
      out += fmt::format("| {} | {} | {} |\n", markdown_text(reason),
                         fmt::join(about.verdicts, ", "), grouped(about.cases));
    }
  }
  return out;
}

std::string departures(const Gathered& gathered) {
  if (gathered.departures.empty()) return {};
  std::string out =
      "\n## Departures, each once\n\n| departure | dialect | cases | who |\n|---|---|--:|---|\n";
  for (const Departure* one : gathered.departures.list()) {
    std::vector<std::string> who;
    for (const auto& [run, share] : one->shares) {
      who.push_back(
          fmt::format("{} {}", markdown_text(gathered.runs[run].title()), grouped(share.cases)));
    }
    out += fmt::format("| {} | {} | {} | {} |\n", markdown_text(one->text()),
                       markdown_text(one->key.dialect), grouped(one->cases), fmt::join(who, ", "));
  }
  return out;
}

}  // namespace

std::string site_markdown(const Gathered& gathered, const std::string& title) {
  std::string out = "# " + markdown_text(title) + "\n\n";
  for (const std::string& note : gathered.notes) out += "- " + markdown_text(note) + "\n";
  if (!gathered.notes.empty()) out += "\n";
  return out + results(gathered) + cycles(gathered) + causes(gathered) + departures(gathered);
}

}  // namespace gonogo::oracle::site
