// SPDX-License-Identifier: GPL-3.0-or-later
//
// docs/domain.md in a hunt: what a subject does with places that no machine has is not told.
#include <gtest/gtest.h>

#include "hunting.hpp"
#include "oracle/differential/domain.hpp"

namespace gonogo::hunt::testing {
namespace {

using reference::Axis;
using reference::Number;
using reference::Record;

// The built-in expander, 1 mm beside where X is `from` mm or more.
class FarOff : public WrappedSubject {
 public:
  explicit FarOff(Number from) : WrappedSubject(builtin("gsk")()), from_(std::move(from)) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    return WrappedSubject::run(id, program, [&](const Record& record) {
      Record moved = record;
      if (from_ <= moved.to[Axis::x]) moved.to[Axis::x] += Number(1);
      return sink(moved);
    });
  }

 private:
  Number from_;
};

Hunt hunt_of(std::int64_t from, bool everywhere) {
  HuntOptions options = hunting("gsk988ta");
  options.everywhere = everywhere;
  options.settings = generate::read_settings("boundary=1").value();
  return {[from] { return std::make_unique<FarOff>(Number(from)); }, {}, options};
}

TEST(HuntDomain, ADepartureBeyondTenMetresIsCountedAndNotTold) {
  Hunt hunt = hunt_of(10'001, false);
  while (hunt.count().programs < 2'000) {
    const std::optional<Finding> found = hunt.step();
    EXPECT_FALSE(found.has_value()) << found->reproducer.program.text << found->verdict.message;
  }
  EXPECT_GT(hunt.count().outside, 0U);
  EXPECT_EQ(hunt.count().no_go, 0U);
}

TEST(HuntDomain, EverywhereItIsAFinding) {
  Hunt hunt = hunt_of(10'001, true);
  bool found = false;
  while (hunt.count().programs < 2'000 && !found) found = hunt.step().has_value();
  EXPECT_TRUE(found);
  EXPECT_EQ(hunt.count().outside, 0U);
}

TEST(HuntDomain, AFindingIsNotMadeSmallOutside) {
  Hunt hunt = hunt_of(40, false);
  std::optional<Finding> finding;
  while (hunt.count().programs < 500 && !finding) finding = hunt.step();
  ASSERT_TRUE(finding);
  hunt.reduce(*finding, {});
  const generate::GeneratedProgram& left = finding->reproducer.program;
  EXPECT_EQ(oracle::outside_domain(left.profile, left.text), "") << left.text;
}

}  // namespace
}  // namespace gonogo::hunt::testing
