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
#include "checker/verdict_report.hpp"

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
        report_(options_, out),
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
        report_.differs(id, fault.what());
      }
    }
    check_assignments();
    for (const std::string& fault : results_.faults()) report_.file_fault(fault);
    check_complete();
    tell_what_no_line_shows();
    return report_.summary(results_.cases(), !results_.is_whole() || is_missing_);
  }

 private:
  void check_header() {
    const Json& named = results_.header().member("corpus", Json::Kind::object);
    if (named.text_of("sha256") != corpus_.sha256()) {
      report_.file_fault("The run was made with another corpus than the one in " + options_.corpus +
                         ".");
    }
    if (named.text_of("version") != corpus_.version()) {
      report_.file_fault("The run names another version of the corpus than the one in " +
                         options_.corpus + ".");
    }
    for (const std::string& fault : header_faults(results_.header())) report_.file_fault(fault);
    for (const std::string& fault : corpus_.faults()) report_.corpus_fault(fault);
  }

  bool has_known_failures() const {
    const Json* sum = results_.header().find("known_failures");
    return sum != nullptr && sum->is(Json::Kind::text);
  }
  void take(const Json& line);
  void note_readings(const Json& line);
  void take_skip(const Json& line, const Vector& vector);
  std::string stated_against(const std::string& verdict, const Derived& derived);
  void check_explaining(const Json& line, const Vector& vector, const Derived& derived);
  void check_assignments();
  void check_complete();
  void tell_what_no_line_shows();

  VerdictOptions options_;
  VerdictReport report_;
  Corpus corpus_;
  ResultsFile results_;
  Roll roll_;
  std::set<std::string> seen_;
  // Dialect and profile -> a case that the subject refused under them, and one that it ran.
  std::map<std::string, std::string> refused_;
  std::map<std::string, std::string> run_;
  Assignments assignments_;
  bool is_missing_ = false;  // a case that was asked for
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
  assignments_.add(readings->texts_of("explaining"));
}

// Empty: they agree, or the case is left out.
std::string Verdicts::stated_against(const std::string& verdict, const Derived& derived) {
  Decision stated = decision_of(verdict).value_or(Decision::undecided);
  // The motions of both depart; only what follows from that differs.
  if (verdict == "xfail" || verdict == "advice") stated = Decision::no_go;
  if (verdict == "xpass") stated = Decision::go;
  switch (derived.kind) {
    case Derived::Kind::undecided:
      report_.leave_out(derived.why);
      return {};
    case Derived::Kind::go:
      if (stated == Decision::undecided) {
        report_.leave_out("oracle-gap: the program could not tell");
        return {};
      }
      if (stated == Decision::no_go) return "The file says " + verdict + "; derived: GO.";
      report_.agrees(derived.kind);
      return {};
    case Derived::Kind::gap:
      if (stated != Decision::undecided) {
        return "The file says " + verdict + "; derived: the corpus does not cover it.";
      }
      report_.agrees(derived.kind);
      return {};
    case Derived::Kind::no_go:
      if (stated != Decision::no_go) {
        return "The file says " + verdict + "; derived: NO-GO. " + derived.why;
      }
      report_.agrees(derived.kind);
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
  const std::vector<std::string> explaining = readings->texts_of("explaining");
  return std::ranges::none_of(explaining, [&](const std::string& text) {
    return std::ranges::all_of(parse_assignment(text), is_stated);
  });
}

// The combinations of readings under which a GO is said to hold.
void Verdicts::check_explaining(const Json& line, const Vector& vector, const Derived& derived) {
  const Json* readings = line.find("readings");
  if (readings == nullptr) return;
  std::vector<Readings> explaining;
  for (const std::string& text : readings->texts_of("explaining")) {
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
    return report_.leave_out("skipped: the subject does not declare what it needs");
  }
  if (!options_.traces.empty() && read_trace_file(options_.traces + "/" + vector.id + ".jsonl")) {
    throw Fault("It was skipped, but there is a trace of it.");
  }
  const bool is_bytes = feature != nullptr && feature->text == "bytes";
  if (line.find("expected") != nullptr) {
    return report_.leave_out("skipped: the corpus expects no answer");
  }
  if (!roll_.declares() || roll_.is_recorded() || is_bytes) {
    return report_.unproven("skipped: only the subject can say why");
  }
  if (line.find("profile") == nullptr) {
    throw Fault("It was skipped, though the subject declares all that it needs.");
  }
  refused_.try_emplace(machine_of(line, results_.text()), vector.id);
  report_.unproven("skipped: only the subject can say whether it refuses the profile");
}

void Verdicts::take(const Json& line) {
  const std::string& id = line.text_of("id");
  // What was drawn in the run lies in no corpus; only its line describes it.
  if (!corpus_.has(id) && id.starts_with("fresh.")) return report_.unproven("a fresh program");
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
    return report_.leave_out(found->second);
  }
  if (!roll_.is_same_machine(*roll_.profile_of(vector.dialect, vector.profile), vector.profile)) {
    return report_.unproven("run under a profile of the certifier's");
  }
  std::optional<Trace> trace;
  if (!options_.traces.empty()) trace = read_trace_file(options_.traces + "/" + id + ".jsonl");
  if (!trace && line.find("trace") != nullptr) trace = trace_of_line(line);
  if (!trace) return report_.unproven("no trace is kept");
  // What runs on by a rule that no text states may be refused; nothing else of it is open.
  const bool may_be_advice = std::ranges::any_of(vector.expect, &Expectation::is_silent) ||
                             (departure != nullptr && departure->text.starts_with("fail.alarm"));
  if (verdict == "advice" && !may_be_advice) {
    return report_.differs(id, "The file says advice; a text states what the case expects.");
  }
  const Derived derived = derive(vector, *trace, results_.header());
  if (derived.kind == Derived::Kind::no_go && is_unstated(line, vector)) {
    return report_.leave_out("readings of which the vector does not speak");
  }
  if (const std::string difference = stated_against(verdict, derived); !difference.empty()) {
    report_.differs(id, difference);
  } else if (derived.kind == Derived::Kind::go) {
    check_explaining(line, vector, derived);
  } else if (verdict == "xfail") {
    report_.unproven("xfail: departs, but known failures are not read here");
  }
}

void Verdicts::check_assignments() {
  if (!results_.is_whole()) return;
  const Json& stated = results_.footer()->member("assignments", Json::Kind::list);
  const std::string difference = assignments_.against(stated.texts());
  if (!difference.empty()) report_.file_fault(difference);
}

// Which cases there must be; those that the certifier's profile contradicts are left out.
void Verdicts::check_complete() {
  std::size_t missing = 0;
  long left_out = 0;
  std::string first;
  corpus_.for_each([&](const std::string& id, const Topic& topic) {
    const bool is_there = seen_.contains(id);
    if (!roll_.takes(id, topic)) {
      if (is_there) report_.file_fault("The case " + id + " was not asked for.");
    } else if (!roll_.profile_of(topic.dialect, corpus_.profile_of(id))) {
      ++left_out;
    } else if (!is_there && ++missing == 1) {
      first = id;
    }
  });
  is_missing_ = missing > 0;
  if (is_missing_) {
    report_.file_fault(std::to_string(missing) + " cases that were asked for are not there, " +
                       first + " among them.");
  }
  for (const auto& [machine, skipped] : refused_) {
    const auto run = run_.find(machine);
    if (run == run_.end()) continue;
    report_.file_fault("The case " + skipped + " was skipped, but " + run->second +
                       " was run under the same profile.");
  }
  if (!results_.is_whole()) return report_.file_fault("There is no footer: the run did not end.");
  const Json* told = results_.footer()->find("left_out");
  if ((told == nullptr ? 0 : told->integer()) != left_out) {
    report_.file_fault(
        "The footer leaves another number of cases out than the certifier's profile does: " +
        std::to_string(left_out) + ".");
  }
}

void Verdicts::tell_what_no_line_shows() {
  if (has_known_failures()) {
    report_.open("Which passes are known to fail was not derived.");
    report_.note_unproven();
  }
  const Json* fresh = results_.is_whole() ? results_.footer()->find("fresh") : nullptr;
  if (fresh == nullptr) return;
  const std::string unasked = fresh_fault(results_.header(), *fresh);
  if (!unasked.empty()) report_.file_fault(unasked);
  for (const auto& [dialect, count] : fresh->members) {
    report_.open("No line shows what the subject did with " +
                 std::to_string(count.integer_of("programs")) + " fresh programs of " + dialect +
                 ".");
  }
}

}  // namespace

int check_verdicts(const VerdictOptions& options, std::FILE* out) {
  return Verdicts(options, out).run();
}

}  // namespace gonogo::checker
