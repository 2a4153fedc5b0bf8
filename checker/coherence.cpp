// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/coherence.hpp"

#include "checker/motion_match.hpp"
#include "checker/path.hpp"
#include "checker/profile.hpp"

namespace gonogo::checker {
namespace {

constexpr const char* kRenamedEnd =
    "the end, because the program renames the position and is not read here";
constexpr const char* kRenamedArc =
    "the start of an arc, because the program renames the position and is not read here";

bool is_cut(const Record& record) {
  return record.kind == RecordKind::feed || record.kind == RecordKind::arc ||
         record.kind == RecordKind::arc3;
}

// Whether two enclosures can be no closer than this and still be called equal as far as they tell.
const Rational kEnclosed = Rational(1, 1000000000000);

// How far the radii of an arc may differ at its ends, given both squared. The limits are those of
// GSK-COM-05, HNC-COM-01, NGC-ARC-03 and SIE-ARC-07.
class RadiusLimit {
 public:
  RadiusLimit(const Vector& vector, const Readings& when) : vector_(vector), when_(when) {}

  // Arcs that a programmer gives by centre and end; those of cycles and corrected ones are exact.
  bool applies_to(const Record& record) const {
    const std::string_view clause = record.clause;
    if (clause.starts_with("SIE-")) {
      return clause.starts_with("SIE-ARC-") && in_force("sie.arc.correct") == "programmed";
    }
    return clause == "GSK-COM-05" || clause == "HNC-COM-01" || clause.starts_with("NGC-ARC-");
  }
  Truth admits(const Real& start2, const Real& end2) const {
    const auto differ_by = [&](const Real& limit) {
      return root_at_most(start2, end2, limit) && root_at_most(end2, start2, limit);
    };
    const Json& profile = vector_.profile;
    if (vector_.dialect == "rs274") return differ_by(of_rs274());
    if (vector_.dialect == "gsk988ta" || vector_.dialect == "hnc21t") {
      const Rational limit = parameter(profile, "3410", Rational(1, 100));
      return is_off(limit) ? Truth::yes : differ_by(limit);
    }
    const Rational least = parameter(profile, "CIRCLE_ERROR_CONST", Rational(1, 100));
    const Rational factor = parameter(profile, "CIRCLE_ERROR_FACTOR", Rational(1, 1000));
    // abs(rS - rE) <= factor rS: (1 - factor) rS <= rE <= (1 + factor) rS, squared.
    const Real above = Rational((1 + factor) * (1 + factor));
    const Real below = Rational((1 - factor) * (1 - factor));
    return differ_by(least) || (at_most(end2, above * start2) && at_most(below * start2, end2));
  }

 private:
  std::string in_force(const std::string& key) const {
    const auto found = when_.find(key);
    return found != when_.end() ? found->second : shown_reading(vector_.profile, key);
  }
  bool is_off(const Rational& limit) const {
    if (limit < 0) return true;
    return limit == 0 && vector_.dialect == "gsk988ta" &&
           in_force("gsk.arc.tolerance-zero") != "exact";
  }
  // Programs are not read here: where one may be in inches, the limit of inches holds.
  Real of_rs274() const {
    const Json* units = vector_.profile.find("units");
    const bool may_be_inch =
        (units != nullptr && units->text == "inch") || line_of_code(vector_.program, 20) != 0;
    const Rational inch(254, 10);
    if (in_force("ngc.arc-tolerance") == "nist") {
      return may_be_inch ? Rational(inch / 5000) : Rational(1, 500);
    }
    return Real::root(0, may_be_inch ? Rational(inch / 5) : Rational(2), 2);
  }

  const Vector& vector_;
  const Readings& when_;
};

class Checker {
 public:
  explicit Checker(const Vector& vector) : vector_(vector), lines_(line_count(vector.program)) {}

  Coherence run() {
    for (std::size_t i = 0; i < vector_.expect.size(); ++i) {
      check_expectation(vector_.expect[i]);
      for (std::size_t j = 0; j < i; ++j) check_exclusive(vector_.expect[j], vector_.expect[i]);
    }
    return std::move(found_);
  }

 private:
  void need(Truth holds, const std::string& sentence) {
    if (holds == Truth::no) found_.faults.push_back(sentence);
    if (holds == Truth::unknown) found_.undecided.push_back("too wide enclosures: " + sentence);
  }
  void need(bool holds, const std::string& sentence) {
    need(holds ? Truth::yes : Truth::no, sentence);
  }

  // Two expectations must not hold together.
  void check_exclusive(const Expectation& x, const Expectation& y) {
    for (const auto& [key, value] : x.when) {
      const auto other = y.when.find(key);
      if (other != y.when.end() && other->second != value) return;
    }
    need(false, "Two expectations have readings that do not exclude each other.");
  }

  void check_expectation(const Expectation& expectation) {
    const long renaming = renaming_line(vector_.dialect, vector_.program);
    Position at = initial_position(vector_.profile);
    long block = 1;
    const bool renamed = renaming != 0;
    const bool comes_again = lines_come_again(vector_.dialect, vector_.program);
    for (const Record& record : expectation.records) {
      const std::string which = text(record);
      need(record.block >= block || comes_again, "The source lines do not ascend: " + which + ".");
      need(record.block <= lines_, "The program has no such line: " + which + ".");
      block = record.block;
      if (renaming != 0 && block > renaming) {
        at = Position();
      }
      check_motion(expectation, record, at);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (record.to[axis]) at[axis] = record.to[axis];
      }
    }
    check_ending(expectation, at, block, renamed);
  }

  void check_ending(const Expectation& expectation, const Position& at, long block, bool renamed) {
    if (expectation.ending == Expectation::Ending::end) {
      for (const auto& coordinate : expectation.end) {
        need(coordinate.has_value(), "The end does not name every axis.");
      }
      if (renamed) {
        found_.undecided.push_back(kRenamedEnd);
        return;
      }
      need(same_place(expectation.end, at),
           "The end is at " + text(expectation.end) + ", the last motion at " + text(at) + ".");
      return;
    }
    for (const ExpectedAlarm& alarm : expectation.any_of) {
      need(alarm.block >= 1 && alarm.block <= lines_, "The alarm is in line " +
                                                          std::to_string(alarm.block) + " of " +
                                                          std::to_string(lines_) + ".");
      // A text that ends too early has run its last line. NGC-CYC-29: a control may look late.
      // NGC-G4-02: it may dwell first.
      const bool may_have_run = alarm.kind == "program-end" ||
                                allows(expectation, "ngc.cycle.alarm-at", "late") ||
                                allows(expectation, "ngc.alarm-dwell", "dwells");
      const bool has_run = may_have_run && block == alarm.block;
      need(expectation.records.empty() || block < alarm.block || has_run ||
               lines_come_again(vector_.dialect, vector_.program),
           "A record of line " + std::to_string(block) + " stands before the alarm of line " +
               std::to_string(alarm.block) + ".");
    }
  }

  // Exactly the same; two enclosures are the same when they are written alike.
  static Truth same_place(const Position& p, const Position& q) {
    Truth same = Truth::yes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!p[axis] || !q[axis] || p[axis]->text() == q[axis]->text()) continue;
      same = same && equal(*p[axis], *q[axis]);
    }
    return same;
  }

  // Whether the expectation is one of machines that read so.
  bool allows(const Expectation& expectation, const std::string& key,
              std::string_view choice) const {
    if (vector_.dialect != "rs274") return false;
    const auto found = expectation.when.find(key);
    return (found != expectation.when.end() ? found->second
                                            : shown_reading(vector_.profile, key)) == choice;
  }

  void check_motion(const Expectation& expectation, const Record& record, const Position& from) {
    const std::string which = text(record) + " from " + text(from) + ".";
    // NGC-CYC-20, NGC-G33-05: where a machine does not look.
    const bool may_be_still = allows(expectation, "ngc.cycle.feed", "free");
    const bool may_lead_nowhere = allows(expectation, "ngc.g33.k", "free") ||
                                  allows(expectation, "ngc.g76.checks", "linuxcnc");
    if (is_cut(record) && !may_be_still) {
      need(record.feed.is_positive(), "A cut has no feed above zero: " + which);
    }
    if (record.kind == RecordKind::thread && !may_lead_nowhere) {
      need(record.lead.is_positive(), "A thread has no lead above zero: " + which);
    }
    if (record.kind == RecordKind::dwell) {
      need(!record.seconds.is_negative(), "A dwell is negative: " + which);
    }
    if (record.kind == RecordKind::arc) check_arc(expectation, record, from);
    if (record.kind == RecordKind::arc3) check_arc3(record, from);
  }

  void check_arc(const Expectation& expectation, const Record& record, const Position& from) {
    const Plane& plane = record.plane;
    const std::string which = text(record) + " from " + text(from) + ".";
    if (!from[plane.first] || !from[plane.second]) {
      found_.undecided.push_back(kRenamedArc);
      return;
    }
    const Real start2 = distance2(plane, from, record.centre);
    const Real end2 = distance2(plane, record.to, record.centre);
    need(start2.is_positive(), "An arc has no radius: " + which);
    // Equal to 1e-12 mm^2 is all that enclosures can tell.
    const Real difference = start2 - end2;
    const bool is_enclosed =
        !difference.is_exact() && difference.high() - difference.low() < kEnclosed;
    const Truth equals = difference.is_zero();
    if (equals == Truth::yes || (equals == Truth::unknown && is_enclosed)) {
      if (is_enclosed) ++found_.enclosed_arcs;
      return;
    }
    const RadiusLimit limit(vector_, expectation.when);
    need(limit.applies_to(record) ? limit.admits(start2, end2) : equals,
         "The centre of an arc is not as far from its end as from its start: " + which);
  }

  // The three points of a circle are no line: some cross product of the ways is not zero.
  void check_arc3(const Record& record, const Position& from) {
    Truth is_line = Truth::yes;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (!from[i] || !from[j]) return;
      const Real cross_product = (*record.via[i] - *from[i]) * (*record.to[j] - *from[j]) -
                                 (*record.via[j] - *from[j]) * (*record.to[i] - *from[i]);
      is_line = is_line && cross_product.is_zero();
    }
    need(!is_line, "The three points of a circle lie on a line: " + text(record) + ".");
  }

  const Vector& vector_;
  long lines_;
  Coherence found_;
};

}  // namespace

Coherence coherence_of(const Vector& vector) {
  return Checker(vector).run();
}

}  // namespace gonogo::checker
