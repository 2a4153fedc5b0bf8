// SPDX-License-Identifier: GPL-3.0-or-later
// One program of path commands in other axes (renamed, mirrored, turned by quarters) or moved gives
// the motions in those axes: for every dialect of path commands, in the reference exactly and in
// the expander within its own increment.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>

#include "expanders/registry.hpp"
#include "subjects/make_subject.hpp"
#include "tests/reference/path_trace.hpp"
#include "tests/reference/rs274/ngc_program.hpp"
#include "tests/reference/sinumerik/sie_program.hpp"

namespace gonogo::expanders::testing {
namespace {

namespace ngc = reference::testing::ngc;
namespace sie = reference::testing::sie;
using reference::Number;
using reference::testing::any_between;
using reference::testing::AxesChange;
using reference::testing::PathTrace;

struct Result {
  PathTrace trace;    // of the reference with its alarms
  std::string alarm;  // of the expander
  std::uint64_t alarm_block = 0;
};

Result result_of(oracle::Subject& subject, const std::string& text,
                 const reference::Profile& profile) {
  Result result;
  subject.configure(profile);
  const oracle::RunEnd end = subject.run("symmetry", text, [&](const reference::Record& record) {
    result.trace.push_back(reference::testing::path_item(record));
    return true;
  });
  RC_ASSERT(end.kind == oracle::RunEnd::Kind::ok || end.kind == oracle::RunEnd::Kind::alarm);
  result.alarm = end.alarm.alarm_class;
  result.alarm_block = end.alarm.block;
  return result;
}

// Twice the increment, and more where the centre of a shallow arc is far.
bool near(const Number& a, const Number& b) {
  return abs(a - b) <= Number::decimal(false, 2, 9) + abs(b) * Number::decimal(false, 1, 8);
}
template <typename Numbers>
bool all_near(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), near);
}

struct RulesOfNgc {
  using Program = ngc::Program;
  using Writing = ngc::Writing;
  static rc::Gen<Program> programs() { return ngc::programs(); }
  static Writing any_writing() {
    Writing writing;
    writing.incremental = any_between(0, 1) == 1;
    writing.absolute_centres = any_between(0, 1) == 1;
    return writing;
  }
  static std::string text(const Program& program, const Writing& writing) {
    return ngc::text(ngc::write(program, writing));
  }
  static constexpr const char* kExpander = "ngc";
};

struct RulesOfSinumerik {
  using Program = sie::Program;
  using Writing = sie::Writing;
  static rc::Gen<Program> programs() { return sie::programs(); }
  static Writing any_writing() {
    Writing writing;
    writing.ends = static_cast<sie::Ends>(any_between(0, 3));
    writing.absolute_centres = any_between(0, 1) == 1;
    return writing;
  }
  static std::string text(const Program& program, const Writing& writing) {
    return sie::text(sie::write(program, writing));
  }
  static constexpr const char* kExpander = "sinumerik";
};

template <typename Rules>
struct InReference : Rules {
  static Result look(const typename Rules::Program& program,
                     const typename Rules::Writing& writing) {
    return {
        reference::testing::path_trace(Rules::text(program, writing), machine(program, writing)),
        "", 0};
  }
  static void expect_agree(const PathTrace& got, const PathTrace& want) { RC_ASSERT(got == want); }
};

template <typename Rules>
struct InExpander : Rules {
  static Result look(const typename Rules::Program& program,
                     const typename Rules::Writing& writing) {
    static const auto subject = oracle::make_interface_subject(*find(Rules::kExpander));
    return result_of(*subject, Rules::text(program, writing), machine(program, writing));
  }
  static void expect_agree(PathTrace got, const PathTrace& want) {
    RC_LOG() << "got" << got << "\nwant" << want << "\n";
    RC_ASSERT(got.size() == want.size());
    for (std::size_t i = 0; i < want.size(); ++i) {
      RC_ASSERT(all_near(got[i].to, want[i].to));
      RC_ASSERT(all_near(got[i].via, want[i].via));
      RC_ASSERT(all_near(got[i].centre, want[i].centre));
      got[i].to = want[i].to;
      got[i].via = want[i].via;
      got[i].centre = want[i].centre;
    }
    RC_ASSERT(got == want);
  }
};

template <typename Maker>
class AxesSymmetry : public ::testing::Test {
 protected:
  using Program = typename Maker::Program;

  static void expect_changed(const Program& program, const AxesChange& change) {
    auto writing = Maker::any_writing();
    const Result plain = Maker::look(program, writing);
    writing.axes = change;
    RC_LOG() << Maker::text(program, writing);
    const Result other = Maker::look(program, writing);
    RC_ASSERT(other.alarm == plain.alarm);
    RC_ASSERT(other.alarm_block == plain.alarm_block);
    Maker::expect_agree(other.trace, changed(plain.trace, change));
  }

  // `changes` gives the changes that a program is tried under.
  template <typename Changes>
  static void expect_changed_by(const char* what, Changes changes) {
    EXPECT_TRUE(rc::check(what, [&] {
      const Program program = *Maker::programs();
      for (const AxesChange& change : changes()) expect_changed(program, change);
    }));
  }
};

using Makers = ::testing::Types<InReference<RulesOfNgc>, InExpander<RulesOfNgc>,
                                InReference<RulesOfSinumerik>, InExpander<RulesOfSinumerik>>;

struct MakerNames {
  template <typename Maker>
  static std::string GetName(int) {
    const bool expands = std::is_same_v<Maker, InExpander<RulesOfNgc>> ||
                         std::is_same_v<Maker, InExpander<RulesOfSinumerik>>;
    return std::string(expands ? "expander_" : "reference_") + Maker::kExpander;
  }
};
TYPED_TEST_SUITE(AxesSymmetry, Makers, MakerNames);

TYPED_TEST(AxesSymmetry, ATranslatedProgramMovesByTheSameShift) {
  TestFixture::expect_changed_by("translation", [] {
    AxesChange change;
    change.shift = reference::testing::any_shift();
    return std::vector{change};
  });
}

// (X, Y; Z) of G17 becomes (Z, X; Y) of G18 and (Y, Z; X) of G19.
TYPED_TEST(AxesSymmetry, APlaneOnlyNamesTheAxes) {
  TestFixture::expect_changed_by("planes", [] {
    std::vector<AxesChange> changes(2);
    changes[0].axis = {2, 0, 1};
    changes[1].axis = {1, 2, 0};
    return changes;
  });
}

TYPED_TEST(AxesSymmetry, AQuarterTurnInAPlaneTurnsTheProgram) {
  TestFixture::expect_changed_by("quarter turns", [] {
    std::vector<AxesChange> changes(3);
    for (std::size_t third = 0; third < 3; ++third) {
      AxesChange& change = changes[third];
      std::swap(change.axis[(third + 1) % 3], change.axis[(third + 2) % 3]);
      change.sign[(third + 2) % 3] = -1;
    }
    return changes;
  });
}

TYPED_TEST(AxesSymmetry, TheMirrorImageTurnsTheOtherWay) {
  TestFixture::expect_changed_by("mirror images", [] {
    std::vector<AxesChange> changes(3);
    for (std::size_t axis = 0; axis < 3; ++axis) changes[axis].sign[axis] = -1;
    return changes;
  });
}

TYPED_TEST(AxesSymmetry, AnySymmetryOfTheAxesAndAnyShift) {
  TestFixture::expect_changed_by("any symmetry", [] {
    AxesChange change = reference::testing::any_symmetry();
    change.shift = reference::testing::any_shift();
    return std::vector{change};
  });
}

// The distance modes of rs274 are two ways to write one path.
TEST(NgcDistanceModes, Agree) {
  using Ngc = InExpander<RulesOfNgc>;
  EXPECT_TRUE(rc::check("distance modes", [] {
    const ngc::Program program = *Ngc::programs();
    ngc::Writing writing = Ngc::any_writing();
    const Result one = Ngc::look(program, writing);
    writing.incremental = !writing.incremental;
    writing.absolute_centres = !writing.absolute_centres;
    const Result other = Ngc::look(program, writing);
    RC_ASSERT(other.alarm == one.alarm);
    Ngc::expect_agree(other.trace, one.trace);
  }));
}

}  // namespace
}  // namespace gonogo::expanders::testing
