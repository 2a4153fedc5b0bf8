// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "publish/evidence/results_side.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::site {
namespace {

using Json = ResultsReader::Json;
using evidence::ResultsSide;
using report::text_of;

constexpr std::size_t kFirstOfStep = 50;

struct Opened {
  Run run;
  std::unique_ptr<ResultsSide> side;
};

bool is_before(const Run& a, const Run& b) {
  const NaturalOrder before;
  if (a.name != b.name) return before(a.name, b.name);
  if (a.version != b.version) return before(a.version, b.version);
  return false;
}

Opened open(const Source& source) {
  Opened opened;
  opened.side = std::make_unique<ResultsSide>(source.path);
  const Json& header = opened.side->reader().header();
  const Json subject = header.value("subject", Json::object());
  const Json corpus = header.value("corpus", Json::object());
  Run& run = opened.run;
  run.path = source.path;
  run.name = source.name;
  run.version = source.version;
  if (run.name.empty()) run.name = text_of(subject, "name");
  if (run.name.empty()) run.name = text_of(subject, "spec");
  if (run.version.empty()) run.version = text_of(subject, "version");
  run.corpus = text_of(corpus, "version");
  run.corpus_sha256 = text_of(corpus, "sha256");
  run.gonogo = text_of(header, "gonogo");
  return opened;
}

void refuse_equal_names(const std::vector<Opened>& all) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Run& a = all[i - 1].run;
    const Run& b = all[i].run;
    if (a.name != b.name || a.version != b.version) continue;
    throw SiteError(
        fmt::format("{} and {} are both of {}. Say which is which: \"NAME@VERSION={}\".", a.path,
                    b.path, a.title(), b.path));
  }
}

void refuse_mixed_corpora(const std::vector<Opened>& all) {
  for (const Opened& one : all) {
    const Run& first = all.front().run;
    if (one.run.corpus_sha256 == first.corpus_sha256) continue;
    throw SiteError(fmt::format(
        "{} was judged with the corpus {} (SHA-256 {:.12}...), {} with {} ({:.12}...): their cases "
        "are not the same. Judge both with one corpus, or compare what has the same id with "
        "--mixed-corpus.",
        first.path, first.corpus, first.corpus_sha256, one.run.path, one.run.corpus,
        one.run.corpus_sha256));
  }
}

// Folder names of reports differ even without regard to capitals.
void name_folders(std::vector<Opened>& all) {
  std::map<std::string, int> used;
  for (Opened& one : all) {
    const std::string stem = folder_stem(one.run.title());
    const int times = ++used[stem];
    one.run.stem = times == 1 ? stem : fmt::format("{}-{}", stem, times);
  }
}

void note_mixed(const std::vector<Run>& runs, std::vector<std::string>& notes) {
  std::map<std::string, std::vector<std::string>, NaturalOrder> by_corpus;
  for (const Run& run : runs) by_corpus[run.corpus].push_back(run.title());
  if (by_corpus.size() < 2) return;
  std::string text = "The runs were not judged with the same corpus:";
  for (const auto& [corpus, titles] : by_corpus) {
    text += fmt::format(" {} ({})", corpus, fmt::join(titles, ", "));
  }
  notes.push_back(text + ". Cases of one id are compared; what an id expects may have changed.");
}

// What one run says of the case that is up.
struct Answer {
  Outcome outcome = Outcome::skip;
  std::string departure;  // empty: GO
};

void add_step(const std::string& id, const Answer& before, const Answer& after, Step& step) {
  const auto answered = [](const Answer& one) {
    return one.outcome == Outcome::go || departs(one.outcome);
  };
  const bool was_go = before.outcome == Outcome::go;
  const bool is_go = after.outcome == Outcome::go;
  // A pass that is none any more is lost, under any new verdict (J-RUN-16).
  const bool is_lost = was_go && !is_go;
  if (!is_lost && (!answered(before) || !answered(after))) return;
  ++step.compared;
  if (is_lost) step.lost.add(id, kFirstOfStep);
  if (!was_go && is_go) step.mended.add(id, kFirstOfStep);
  if (!was_go && !is_go && before.departure != after.departure) step.moved.add(id, kFirstOfStep);
}

class Gatherer {
 public:
  Gatherer(Gathered& out, const evidence::ResultsSides& sides) : out_(out), sides_(sides) {
    for (const std::vector<std::size_t>& versions : out_.implementations()) {
      out_.voters.push_back(versions.back());
      for (std::size_t i = 1; i < versions.size(); ++i) {
        out_.steps.push_back({versions[i - 1], versions[i], 0, {}, {}, {}});
      }
    }
    answers_.resize(sides_.size());
  }

  // The next case of all of them; false: there is none.
  bool add_next() {
    const CaseHead* const first = first_line(sides_);
    if (first == nullptr) return false;
    ++out_.cases;
    test_ = *first;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      answers_[i].reset();
      if (sides_[i]->is_at(test_.id)) add_line(*sides_[i]->line(), i);
    }
    vote();
    for (Step& step : out_.steps) {
      const auto& before = answers_[step.before];
      const auto& after = answers_[step.after];
      if (before && after) add_step(test_.id, *before, *after, step);
    }
    step_past(sides_, test_.id);
    return true;
  }

 private:
  void add_line(const CaseHead& line, std::size_t run) {
    const VerdictKind kind = verdict_kind(line.verdict).value_or(VerdictKind::oracle_error);
    const Outcome outcome = outcome_of(kind);
    out_.runs[run].add(line, outcome);
    out_.departures.add(line, kind, run);
    answers_[run] = Answer{outcome, departs(outcome) ? departure_text(line) : std::string()};
  }

  void vote() {
    std::vector<Votes::Answer> votes;
    for (const std::size_t run : out_.voters) {
      const auto& answer = answers_[run];
      if (!answer || (answer->outcome != Outcome::go && !departs(answer->outcome))) continue;
      if (answer->outcome == Outcome::go) {
        votes.push_back({run, true, {}, {}, {}, {}});
        continue;
      }
      const CaseHead& line = *sides_[run]->line();
      votes.push_back({run, false, answer->departure,
                       line.departure.empty() ? line.verdict : line.departure, line.clause,
                       line.message.empty() ? line.known : line.message});
    }
    out_.votes.add(test_, votes);
  }

  Gathered& out_;
  const evidence::ResultsSides& sides_;
  std::vector<std::optional<Answer>> answers_;
  CaseHead test_;
};

void take_footer(const ResultsReader& reader, bool partial, Run& run,
                 std::vector<std::string>& notes) {
  if (reader.footer()) {
    run.decision = text_of(*reader.footer(), "decision");
    run.head = text_of(*reader.footer(), "head");
    return;
  }
  if (!partial) {
    throw SiteError(fmt::format(
        "{} is incomplete: it has no footer, and cases are missing. End the run with `gonogo "
        "certify --resume`, or take what is there with --partial.",
        run.path));
  }
  run.decision = run.counts[Outcome::no_go] > 0 ? "NO-GO" : "INCOMPLETE";
  notes.push_back(fmt::format("The run of {} is incomplete: cases are missing.", run.title()));
}

}  // namespace

std::vector<std::vector<std::size_t>> Gathered::implementations() const {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i == 0 || runs[i].name != runs[i - 1].name) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

std::set<CycleKey> Gathered::cycles() const {
  std::set<CycleKey> all;
  for (const Run& run : runs) {
    for (const auto& [cycle, counts] : run.cycles) all.insert(cycle);
  }
  return all;
}

Gathered gather(const std::vector<Source>& sources, const GatherOptions& options) {
  std::vector<Opened> all;
  for (const Source& source : sources) all.push_back(open(source));
  std::ranges::sort(all, [](const Opened& a, const Opened& b) { return is_before(a.run, b.run); });
  refuse_equal_names(all);
  if (!options.mixed_corpus) refuse_mixed_corpora(all);
  name_folders(all);
  Gathered gathered;
  evidence::ResultsSides sides;
  for (Opened& one : all) {
    gathered.runs.push_back(std::move(one.run));
    sides.push_back(std::move(one.side));
  }
  Gatherer gatherer(gathered, sides);
  while (gatherer.add_next()) {
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    take_footer(sides[i]->reader(), options.partial, gathered.runs[i], gathered.notes);
  }
  note_mixed(gathered.runs, gathered.notes);
  return gathered;
}

}  // namespace gonogo::oracle::site
