// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/verdicts.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "checker/assignments.hpp"
#include "checker/corpus.hpp"
#include "checker/derive.hpp"
#include "checker/results.hpp"
#include "checker/selection.hpp"
#include "checker/trace.hpp"

namespace gonogo::checker {
namespace {

// Verdicts about how the subject behaved, or about the run as a whole: no trace can tell.
const std::map<std::string, std::string, std::less<>> kNoTraceTells = {
    {"skip", "skipped: the subject was not asked or did not have it"},
    {"fail.reading", "fail.reading: a matter of the run as a whole"},
    {"fail.declaration", "fail.declaration: the subject skipped what it declares"},
    {"state-leak", "state-leak: a matter of two runs"},
    {"crash", "crash: there is no outcome"},
    {"timeout", "timeout: there is no outcome"},
    {"out-of-memory", "out-of-memory: there is no outcome"},
    {"protocol", "protocol: there is no outcome"},
    {"oracle-error", "oracle-error: the program said nothing"},
};

class Verdicts {
 public:
  Verdicts(const VerdictOptions& options, std::FILE* out)
      : options_(options), out_(out), corpus_(options.corpus), results_(options.results) {}

  int run() {
    check_header();
    Json line;
    while (results_.next(line)) {
      const std::string& id = line.text_of("id");
      seen_.insert(id);
      try {
        note_readings(line);
        take(line);
      } catch (const Fault& fault) {
        differs(id, fault.what());
      }
    }
    check_assignments();
    for (const std::string& fault : results_.faults()) say("file", options_.results, fault);
    file_faults_ += results_.faults().size();
    check_complete();
    return summary();
  }

 private:
  void say(const char* what, const std::string& where, const std::string& sentence) {
    std::fprintf(out_, "%s  %s: %s\n", what, where.c_str(), sentence.c_str());
  }
  void file_fault(const std::string& sentence) {
    say("file", options_.results, sentence);
    ++file_faults_;
  }
  void differs(const std::string& id, const std::string& sentence) {
    say("differs", id, sentence);
    ++differing_;
  }
  void leave_out(const std::string& reason) { ++left_out_[reason]; }

  void check_header() {
    const Json& named = results_.header().member("corpus", Json::Kind::object);
    if (named.text_of("sha256") != corpus_.sha256()) {
      file_fault("The run was made with another corpus than the one in " + options_.corpus + ".");
    }
    for (const std::string& fault : corpus_.faults()) say("corpus", options_.corpus, fault);
    file_faults_ += corpus_.faults().size();
  }

  // Whether the case ran under the profile of its vector.
  bool has_own_profile(const Json& line, const Vector& vector) {
    const Json none = parse_json("{}");
    const Json* said = line.find("profile");
    return vector.profile.same_as(said == nullptr ? none : *said);
  }
  bool is_overridden() const {
    const Json& header = results_.header();
    const Json* readings = header.find("readings");
    return !header.member("profile", Json::Kind::object).members.empty() ||
           (readings != nullptr && !readings->items.empty());
  }

  void take(const Json& line);
  void note_readings(const Json& line);
  void check_words(const Json& line, const Vector& vector);
  std::string stated_against(const std::string& verdict, const Derived& derived);
  void check_explaining(const Json& line, const Vector& vector, const Derived& derived);
  void check_assignments();
  void check_complete();
  int summary();

  VerdictOptions options_;
  std::FILE* out_;
  Corpus corpus_;
  ResultsFile results_;
  std::set<std::string> seen_;
  Assignments assignments_;
  std::size_t derived_go_ = 0;
  std::size_t derived_no_go_ = 0;
  std::size_t derived_gap_ = 0;
  std::size_t differing_ = 0;
  std::size_t file_faults_ = 0;
  std::size_t missing_ = 0;
  std::map<std::string, std::size_t> left_out_;
};

void Verdicts::note_readings(const Json& line) {
  const Json* readings = line.find("readings");
  if (readings == nullptr || decision_of(line.text_of("verdict")) != Decision::go) return;
  assignments_.add(readings->member("explaining", Json::Kind::list).texts());
}

void Verdicts::check_words(const Json& line, const Vector& vector) {
  if (line.text_of("dialect") != vector.dialect) {
    throw Fault("The line names another dialect than the vector.");
  }
  const Json* program = line.find("program");
  if (program != nullptr && line.text_of("verdict") != "fail.reading" &&
      program_bytes(*program) != vector.program) {
    throw Fault("The program of the line is not that of the vector.");
  }
  const bool expects_gap = std::ranges::any_of(vector.expect, [](const Expectation& one) {
    return one.ending == Expectation::Ending::not_covered;
  });
  if (line.find("expected") != nullptr && !expects_gap) {
    throw Fault("The line says that the corpus expects an oracle-gap, and it does not.");
  }
}

// Empty: they agree, or the case is left out.
std::string Verdicts::stated_against(const std::string& verdict, const Derived& derived) {
  Decision stated = decision_of(verdict).value_or(Decision::undecided);
  // The motions of both depart; only what follows from that differs.
  if (verdict == "xfail" || verdict == "advice") stated = Decision::no_go;
  if (verdict == "xpass") stated = Decision::go;
  switch (derived.kind) {
    case Derived::Kind::undecided:
      leave_out(derived.why);
      return {};
    case Derived::Kind::go:
      if (stated == Decision::undecided) {
        leave_out("oracle-gap: the program could not tell");
        return {};
      }
      if (stated == Decision::no_go) return "The file says " + verdict + "; derived: GO.";
      ++derived_go_;
      return {};
    case Derived::Kind::gap:
      if (stated != Decision::undecided) {
        return "The file says " + verdict + "; derived: the corpus does not cover it.";
      }
      ++derived_gap_;
      return {};
    case Derived::Kind::no_go:
      if (stated != Decision::no_go) {
        return "The file says " + verdict + "; derived: NO-GO. " + derived.why;
      }
      ++derived_no_go_;
      return {};
  }
  return {};
}

// The assignments of readings under which a GO is said to hold.
void Verdicts::check_explaining(const Json& line, const Vector& vector, const Derived& derived) {
  const Json* readings = line.find("readings");
  if (readings == nullptr) return;
  std::vector<Readings> explaining;
  for (const std::string& text : readings->member("explaining", Json::Kind::list).texts()) {
    explaining.push_back(parse_assignment(text));
  }
  for (std::size_t i = 0; i < vector.expect.size(); ++i) {
    const Readings& when = vector.expect[i].when;
    if (when.empty() || derived.answers[i] == Answer::undecided) continue;
    const bool is_told = std::ranges::any_of(
        explaining, [&](const Readings& assignment) { return admits(assignment, when); });
    if (is_told == (derived.answers[i] == Answer::fits)) continue;
    std::string choice;
    for (const auto& [key, value] : when) choice += " " + key + "=" + value;
    throw Fault((is_told ? "The file says that these readings explain the trace, and they do not:"
                         : "These readings explain the trace, and the file does not say so:") +
                choice + ".");
  }
}

void Verdicts::take(const Json& line) {
  const std::string& id = line.text_of("id");
  const std::string& verdict = line.text_of("verdict");
  if (!corpus_.has(id)) throw Fault("The corpus has no such case.");
  const Vector vector = corpus_.read(id);
  check_words(line, vector);
  if (const auto found = kNoTraceTells.find(verdict); found != kNoTraceTells.end()) {
    leave_out(found->second);
    return;
  }
  if (!has_own_profile(line, vector)) {
    if (!is_overridden()) throw Fault("It ran under another profile than that of its vector.");
    leave_out("run under a profile of the certifier's");
    return;
  }
  std::optional<Trace> trace;
  if (!options_.traces.empty()) trace = read_trace_file(options_.traces + "/" + id + ".jsonl");
  if (!trace && line.find("trace") != nullptr) trace = trace_of_line(line);
  if (!trace) {
    leave_out("no trace is kept");
    return;
  }
  const Derived derived = derive(vector, *trace, results_.header());
  if (const std::string difference = stated_against(verdict, derived); !difference.empty()) {
    differs(id, difference);
  } else if (derived.kind == Derived::Kind::go) {
    check_explaining(line, vector, derived);
  }
}

void Verdicts::check_assignments() {
  if (!results_.is_whole()) return;
  const Json& stated = results_.footer()->member("assignments", Json::Kind::list);
  const std::string difference = assignments_.against(stated.texts());
  if (!difference.empty()) file_fault(difference);
}

void Verdicts::check_complete() {
  const Selection selection(results_.header());
  std::size_t missing = 0;
  std::string first;
  corpus_.for_each([&](const std::string& id, const Topic& topic) {
    if (!selection.takes(id, topic) || seen_.contains(id)) return;
    if (++missing == 1) first = id;
  });
  for (const std::string& id : seen_) {
    if (corpus_.has(id) && !selection.takes(id, corpus_.topic_of(id))) {
      file_fault("The case " + id + " was not asked for.");
    }
  }
  long left_out = 0;
  if (results_.is_whole()) {
    const Json* told = results_.footer()->find("left_out");
    if (told != nullptr) left_out = told->integer();
  } else {
    file_fault("There is no footer: the run did not end.");
  }
  missing_ = missing;
  if (missing == static_cast<std::size_t>(left_out)) {
    missing_ = 0;
  } else {
    file_fault(std::to_string(missing) + " cases that were asked for are not there, " + first +
               " among them; the footer accounts for " + std::to_string(left_out) + ".");
  }
}

int Verdicts::summary() {
  const std::size_t derived = derived_go_ + derived_no_go_ + derived_gap_;
  std::size_t left = 0;
  for (const auto& [reason, count] : left_out_) left += count;
  std::fprintf(out_, "%zu cases: %zu verdicts derived again (%zu GO, %zu NO-GO, %zu not covered), ",
               results_.cases(), derived, derived_go_, derived_no_go_, derived_gap_);
  std::fprintf(out_, "%zu differ, %zu not decided here\n", differing_, left);
  for (const auto& [reason, count] : left_out_) {
    std::fprintf(out_, "  %6zu  %s\n", count, reason.c_str());
  }
  if (file_faults_ > 0) std::fprintf(out_, "%zu things do not hold of the file\n", file_faults_);
  const bool is_incomplete = !results_.is_whole() || missing_ > 0;
  if (differing_ > 0) return 1;
  if (is_incomplete) return 3;
  if (file_faults_ > 0) return 1;
  return derived_go_ + derived_no_go_ == 0 ? 3 : 0;
}

}  // namespace

int check_verdicts(const VerdictOptions& options, std::FILE* out) {
  return Verdicts(options, out).run();
}

}  // namespace gonogo::checker
