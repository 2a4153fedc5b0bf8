// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/verdicts.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "checker/assignments.hpp"
#include "checker/corpus.hpp"
#include "checker/derive.hpp"
#include "checker/profile.hpp"
#include "checker/results.hpp"
#include "checker/roll.hpp"
#include "checker/trace.hpp"

namespace gonogo::checker {
namespace {

// Verdicts about how the subject behaved, or about the run as a whole: no trace can tell.
const std::map<std::string, std::string, std::less<>> kNoTraceTells = {
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
      : options_(options),
        out_(out),
        corpus_(options.corpus),
        results_(options.results),
        roll_(results_.header()) {}

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
    tell_what_no_line_shows();
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
    if (named.text_of("version") != corpus_.version()) {
      file_fault("The run names another version of the corpus than the one in " + options_.corpus +
                 ".");
    }
    for (const std::string& fault : header_faults(results_.header())) file_fault(fault);
    for (const std::string& fault : corpus_.faults()) say("corpus", options_.corpus, fault);
    file_faults_ += corpus_.faults().size();
  }

  bool has_known_failures() const {
    const Json* sum = results_.header().find("known_failures");
    return sum != nullptr && sum->is(Json::Kind::text);
  }
  void take(const Json& line);
  void note_readings(const Json& line);
  void take_skip(const Json& line, const Vector& vector);
  void unproven(const std::string& reason) {
    leave_out(reason);
    ++unproven_;
  }
  std::string stated_against(const std::string& verdict, const Derived& derived);
  void check_explaining(const Json& line, const Vector& vector, const Derived& derived);
  void check_assignments();
  void check_complete();
  void tell_what_no_line_shows();
  int summary();

  VerdictOptions options_;
  std::FILE* out_;
  Corpus corpus_;
  ResultsFile results_;
  Roll roll_;
  std::set<std::string> seen_;
  // Dialect and profile -> a case that the subject refused under them, and one that it ran.
  std::map<std::string, std::string> refused_;
  std::map<std::string, std::string> run_;
  Assignments assignments_;
  std::size_t derived_go_ = 0;
  std::size_t derived_no_go_ = 0;
  std::size_t derived_gap_ = 0;
  std::size_t differing_ = 0;
  std::size_t file_faults_ = 0;
  std::size_t missing_ = 0;
  std::size_t unproven_ = 0;
  std::map<std::string, std::size_t> left_out_;
};

// As it was before the readings of the run were reconciled.
std::string verdict_before(const Json& line) {
  const Json* readings = line.find("readings");
  return (readings == nullptr ? line : *readings).text_of("verdict");
}

// What stands for the profile of a line among those of its dialect.
std::string machine_of(const Json& line, const std::string& text) {
  const Json* profile = line.find("profile");
  return line.text_of("dialect") +
         (profile == nullptr ? "" : text.substr(profile->begin, profile->end - profile->begin));
}

void Verdicts::note_readings(const Json& line) {
  const Json* readings = line.find("readings");
  const std::string& verdict = line.text_of("verdict");
  // What is known to contradict other cases and does not is xpass: it passes, too.
  const bool passes = decision_of(verdict) == Decision::go || verdict == "xpass";
  if (readings == nullptr || !passes) return;
  assignments_.add(readings->member("explaining", Json::Kind::list).texts());
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

// Whether a GO is said to hold under readings of which no expectation speaks alone.
bool is_unstated(const Json& line, const Vector& vector) {
  const Json* readings = line.find("readings");
  if (readings == nullptr) return false;
  const auto is_stated = [&](const auto& choice) {
    return shown_reading(vector.profile, choice.first) == choice.second ||
           std::ranges::any_of(vector.expect, [&](const Expectation& expectation) {
             return expectation.when.contains(choice.first);
           });
  };
  const std::vector<std::string> explaining =
      readings->member("explaining", Json::Kind::list).texts();
  return std::ranges::none_of(explaining, [&](const std::string& text) {
    return std::ranges::all_of(parse_assignment(text), is_stated);
  });
}

// The combinations of readings under which a GO is said to hold.
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

// Whether the subject may have skipped it.
void Verdicts::take_skip(const Json& line, const Vector& vector) {
  const Json* feature = line.find("feature");
  if (const std::string lacks = roll_.undeclared(vector); !lacks.empty()) {
    if (feature == nullptr || feature->text != lacks) {
      throw Fault("It was not skipped for " + lacks + ", which the subject does not declare.");
    }
    return leave_out("skipped: the subject does not declare what it needs");
  }
  if (!options_.traces.empty() && read_trace_file(options_.traces + "/" + vector.id + ".jsonl")) {
    throw Fault("It was skipped, but there is a trace of it.");
  }
  const bool is_bytes = feature != nullptr && feature->text == "bytes";
  if (line.find("expected") != nullptr) {
    return leave_out("skipped: the corpus expects no answer");
  }
  if (!roll_.declares() || roll_.is_recorded() || is_bytes) {
    return unproven("skipped: only the subject can say why");
  }
  if (line.find("profile") == nullptr) {
    throw Fault("It was skipped, though the subject declares all that it needs.");
  }
  refused_.try_emplace(machine_of(line, results_.text()), vector.id);
  unproven("skipped: only the subject can say whether it refuses the profile");
}

void Verdicts::take(const Json& line) {
  const std::string& id = line.text_of("id");
  // What was drawn in the run lies in no corpus; only its line describes it.
  if (!corpus_.has(id) && id.starts_with("fresh.")) return unproven("a fresh program");
  if (!corpus_.has(id)) throw Fault("The corpus has no such case.");
  const Vector vector = corpus_.read(id);
  roll_.check_words(line, vector);
  if (line.text_of("verdict") == "skip") return take_skip(line, vector);
  if (const std::string lacks = roll_.undeclared(vector); !lacks.empty()) {
    throw Fault("The subject does not declare " + lacks + ": such a case is skipped.");
  }
  run_.try_emplace(machine_of(line, results_.text()), id);
  const std::string verdict = verdict_before(line);
  const bool is_known = verdict == "xfail" || verdict == "xpass";
  if (is_known && !has_known_failures()) {
    throw Fault("It is " + verdict + ", and the run had no known failures.");
  }
  const Json* departure = line.find("departure");
  const std::string what = verdict == "xfail" && departure != nullptr ? departure->text : verdict;
  if (const auto found = kNoTraceTells.find(what); found != kNoTraceTells.end()) {
    leave_out(found->second);
    return;
  }
  if (!roll_.is_same_machine(*roll_.profile_of(vector.dialect, vector.profile), vector.profile)) {
    unproven("run under a profile of the certifier's");
    return;
  }
  std::optional<Trace> trace;
  if (!options_.traces.empty()) trace = read_trace_file(options_.traces + "/" + id + ".jsonl");
  if (!trace && line.find("trace") != nullptr) trace = trace_of_line(line);
  if (!trace) {
    unproven("no trace is kept");
    return;
  }
  // What runs on by a rule that no text states may be refused; nothing else of it is open.
  const Json* stated = line.find("departure");
  const bool may_be_advice = std::ranges::any_of(vector.expect, &Expectation::is_silent) ||
                             (stated != nullptr && stated->text.starts_with("fail.alarm"));
  if (verdict == "advice" && !may_be_advice) {
    return differs(id, "The file says advice; a text states what the case expects.");
  }
  const Derived derived = derive(vector, *trace, results_.header());
  if (derived.kind == Derived::Kind::no_go && is_unstated(line, vector)) {
    leave_out("readings of which the vector does not speak");
    return;
  }
  if (const std::string difference = stated_against(verdict, derived); !difference.empty()) {
    differs(id, difference);
  } else if (derived.kind == Derived::Kind::go) {
    check_explaining(line, vector, derived);
  } else if (verdict == "xfail") {
    unproven("xfail: departs, but known failures are not read here");
  }
}

void Verdicts::check_assignments() {
  if (!results_.is_whole()) return;
  const Json& stated = results_.footer()->member("assignments", Json::Kind::list);
  const std::string difference = assignments_.against(stated.texts());
  if (!difference.empty()) file_fault(difference);
}

// Which cases there must be; those that the certifier's profile contradicts are left out.
void Verdicts::check_complete() {
  std::size_t missing = 0;
  long left_out = 0;
  std::string first;
  corpus_.for_each([&](const std::string& id, const Topic& topic) {
    const bool is_there = seen_.contains(id);
    if (!roll_.takes(id, topic)) {
      if (is_there) file_fault("The case " + id + " was not asked for.");
    } else if (!roll_.profile_of(topic.dialect, corpus_.profile_of(id))) {
      ++left_out;
    } else if (!is_there && ++missing == 1) {
      first = id;
    }
  });
  missing_ = missing;
  if (missing > 0) {
    file_fault(std::to_string(missing) + " cases that were asked for are not there, " + first +
               " among them.");
  }
  for (const auto& [machine, skipped] : refused_) {
    const auto run = run_.find(machine);
    if (run == run_.end()) continue;
    file_fault("The case " + skipped + " was skipped, but " + run->second +
               " was run under the same profile.");
  }
  if (!results_.is_whole()) return file_fault("There is no footer: the run did not end.");
  const Json* told = results_.footer()->find("left_out");
  if ((told == nullptr ? 0 : told->integer()) != left_out) {
    file_fault("The footer leaves another number of cases out than the certifier's profile does: " +
               std::to_string(left_out) + ".");
  }
}

void Verdicts::tell_what_no_line_shows() {
  if (has_known_failures()) {
    say("open", options_.results, "Which passes are known to fail was not derived.");
    ++unproven_;
  }
  const Json* fresh = results_.is_whole() ? results_.footer()->find("fresh") : nullptr;
  if (fresh == nullptr) return;
  for (const auto& [dialect, count] : fresh->members) {
    say("open", options_.results,
        "No line shows what the subject did with " + std::to_string(count.integer_of("programs")) +
            " fresh programs of " + dialect + ".");
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
  return unproven_ > 0 || derived_go_ + derived_no_go_ == 0 ? 3 : 0;
}

}  // namespace

int check_verdicts(const VerdictOptions& options, std::FILE* out) {
  return Verdicts(options, out).run();
}

}  // namespace gonogo::checker
