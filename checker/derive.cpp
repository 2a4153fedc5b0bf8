// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/derive.hpp"

#include "checker/profile.hpp"
#include "checker/trace.hpp"

namespace gonogo::checker {
namespace {

bool allows_chords(const Json& header) {
  const Json* chord = header.find("chord");
  return chord != nullptr && chord->is(Json::Kind::text) && parse_rational(chord->text) > 0;
}

}  // namespace

Derived derive(const Vector& vector, const Trace& trace, const Json& header) {
  const Tolerances tolerances = tolerances_of(header, vector.dialect, vector.profile);
  Derived derived;
  bool fits = false;
  bool fits_gap = false;
  bool undecided = false;
  for (const Expectation& expectation : vector.expect) {
    derived.answers.push_back(Answer::undecided);
    if (!is_admissible(expectation.when, vector.profile)) continue;
    Judgement finding = match(vector, expectation, trace, tolerances);
    if (finding.answer == Answer::departs && allows_chords(header)) {
      finding = {Answer::undecided, "the certifier allows chords for arcs"};
    }
    if (finding.answer == Answer::departs && expectation.has_others) {
      finding = {Answer::undecided, "an open reading gives the program other outcomes, too"};
    }
    const bool is_gap = expectation.ending == Expectation::Ending::not_covered;
    if (!is_gap && !finding.is_doubtful) derived.answers.back() = finding.answer;
    fits = fits || (finding.answer == Answer::fits && !is_gap);
    fits_gap = fits_gap || (finding.answer == Answer::fits && is_gap);
    undecided = undecided || finding.answer == Answer::undecided;
    const bool tells = derived.why.empty() || finding.answer == Answer::undecided;
    if (tells && !finding.why.empty()) derived.why = finding.why;
  }
  if (vector.expect.empty() || derived.answers.empty()) throw Fault("Nothing is expected.");
  derived.kind = fits        ? Derived::Kind::go
                 : undecided ? Derived::Kind::undecided
                 : fits_gap  ? Derived::Kind::gap
                             : Derived::Kind::no_go;
  return derived;
}

}  // namespace gonogo::checker
