// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "corpus/io/errata.hpp"
#include "corpus/io/recheck.hpp"

namespace gonogo::oracle {
namespace {

using Say = std::function<void(const std::string&)>;

class Linter {
 public:
  explicit Linter(const Say& say) : say_(say) {}

  void take(const Case& test) {
    ++cases_;
    if (expects_alarm(test)) ++alarming_;
    ids_.insert(test.id);
    clauses_.insert(test.clauses.begin(), test.clauses.end());
    for (const reference::Reading& reading : reference::readings()) {
      if (reading.belongs_to(test.dialect)) {
        readings_[reading.name].emplace(test.profile.readings.get(reading.key));
      }
    }
    check_id(test);
    const auto has_basis = [](const Expectation& expectation) {
      return expectation.basis.has_value();
    };
    if (!std::ranges::all_of(test.expect, has_basis)) {
      say_(fmt::format("{}: an expectation does not say on what basis it stands.", test.id));
    }
    if (auto fault = recheck(test)) say_(fmt::format("{}: {}", test.id, *fault));
    for (const std::string& sign : test.tags_sign) check_sign(test, sign);
  }

  void finish_triples() const {
    for (const auto& [triple, sides] : triples_) {
      if (sides.size() != 3) {
        say_(fmt::format("{}: of the cases below, on and above the limit only {} are there.",
                         triple, sides.size()));
      }
    }
  }

  void finish_whole() const {
    for (const reference::Clause& clause : reference::clauses()) {
      if (!clauses_.contains(std::string(clause.id))) {
        say_(fmt::format("The clause {} stands in no group.", clause.id));
      }
    }
    for (const reference::Reading& reading : reference::readings()) check_reading(reading);
    if (alarming_ * 100 < cases_ * 30 || alarming_ * 100 > cases_ * 40) {
      say_(fmt::format("{} of {} cases end in an alarm; 30 to 40 in a hundred should.", alarming_,
                       cases_));
    }
  }

  void check_errata(const Corpus& corpus) const {
    for (const Erratum& erratum : read_errata(corpus.folder())) {
      if (!covers(erratum, ids_) && !covers(erratum, corpus.retired())) {
        say_(fmt::format("The erratum {} is of no case, nor of one that is retired.", erratum.id));
      }
      if (is_before(corpus.version(), erratum.since)) {
        say_(fmt::format("The erratum {} is put right in {}, after this corpus.", erratum.id,
                         erratum.since));
      }
    }
  }

  std::size_t cases() const { return cases_; }

 private:
  template <typename Ids>
  static bool covers(const Erratum& erratum, const Ids& ids) {
    return std::ranges::any_of(ids,
                               [&](const std::string& id) { return is_covered(erratum.id, id); });
  }
  void check_id(const Case& test) const {
    static const std::regex kForm("[a-z0-9]+(\\.[a-z0-9-]+)+\\.[0-9]{6}");
    if (!std::regex_match(test.id, kForm)) {
      say_(fmt::format("{}: an id is words joined by points, and six digits.", test.id));
    }
  }

  // Generated triples have one id except for its last digit: "gsk.g94.sign-0123456789.000002".
  void check_sign(const Case& test, const std::string& sign) {
    const std::size_t place = test.id.rfind('.');
    if (test.id.find(".sign-") == std::string::npos) return;
    triples_[test.id.substr(0, place)].insert(sign.substr(sign.rfind(':') + 1));
    // Where readings are open, as the case was drawn: under the alternatives stated first.
    std::set<std::string_view> words;
    for (const ExpectedAlarm& alarm : test.expect.front().alarms) words.insert(alarm.word.text());
    if (words.size() > 1) {
      say_(fmt::format("{}: a case at a limit has one fault, this one alarms in several ways.",
                       test.id));
    }
  }

  void check_reading(const reference::Reading& reading) const {
    const auto found = readings_.find(reading.name);
    const std::set<std::string> none;
    const std::set<std::string>& set = found == readings_.end() ? none : found->second;
    // An open one is expected under its first alternative where nothing else is said.
    const bool is_open = reading.fallback == "any" && !reading.by_properties;
    const std::string_view shown = is_open ? reading.alternatives.front() : reading.fallback;
    for (const std::string_view alternative : reading.alternatives) {
      if (alternative == shown || set.contains(std::string(alternative))) continue;
      say_(fmt::format("The reading {}={} stands in no profile.", reading.name, alternative));
    }
  }

  const Say& say_;
  std::size_t cases_ = 0;
  std::size_t alarming_ = 0;
  std::set<std::string> ids_;
  std::set<std::string> clauses_;
  std::map<std::string_view, std::set<std::string>> readings_;
  std::map<std::string, std::set<std::string>> triples_;
};

}  // namespace

std::size_t lint(const Corpus& corpus, const LintOptions& options, const Say& say) {
  Linter linter(say);
  corpus.for_each([&](const Case& test) { linter.take(test); });
  if (!options.part) {
    linter.finish_triples();
    linter.finish_whole();
    linter.check_errata(corpus);
  }
  return linter.cases();
}

}  // namespace gonogo::oracle
