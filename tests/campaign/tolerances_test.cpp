// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/tolerances.hpp"

#include <gtest/gtest.h>

#include "oracle/judge/judge_session.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {
namespace {

Number number(const char* text) {
  return *Number::parse(text);
}

reference::Profile profile_of(const char* dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

SubjectInfo coarse() {
  SubjectInfo subject;
  subject.features = {"blocks"};
  subject.resolution = number("0.01");
  subject.feed_resolution = number("1000000");
  subject.chord = number("0.5");
  return subject;
}

VerdictKind judged(const Tolerances& tolerances, const char* feed) {
  const reference::Profile profile = profile_of("gsk988ta");
  TraceReader reader;
  std::vector<reference::Record> records;
  const std::string line = std::string(R"({"k":"feed","b":1,"to":{"z":"5"},"f":)") + feed + "}";
  records.push_back(std::get<reference::Record>(reader.read(line)));
  return judge_outcome(profile, std::string("G98 G01 Z5 F0.2\n"), tolerances, records, RunEnd{})
      .verdict.kind;
}

// J-RUN-02: the machine's least increment is 0.001, of rs274 0.0001.
TEST(Tolerances, DeclarationsCountUpToTheLeastIncrement) {
  const Tolerances gsk = make_tolerances(coarse(), profile_of("gsk988ta"), Grants{});
  EXPECT_EQ(gsk.tolerance, number("0.001"));
  EXPECT_EQ(gsk.resolution, number("0.001"));
  EXPECT_EQ(gsk.feed_resolution, number("0.001"));
  EXPECT_EQ(gsk.chord, number("0"));
  const Tolerances ngc = make_tolerances(coarse(), profile_of("rs274"), Grants{});
  EXPECT_EQ(ngc.feed_resolution, number("0.0001"));
}

// J-RUN-02
TEST(Tolerances, TheCertifierGrantsMore) {
  Grants grants;
  grants.feed_resolution = number("0.1");
  grants.chord = number("0.5");
  grants.strict = true;
  const Tolerances tolerances = make_tolerances(coarse(), profile_of("gsk988ta"), grants);
  EXPECT_EQ(tolerances.feed_resolution, number("0.1"));
  EXPECT_EQ(tolerances.chord, number("0.5"));
  EXPECT_TRUE(tolerances.strict);
}

TEST(Tolerances, SayWhatCountsForLess) {
  const auto found = capped(coarse(), profile_of("gsk988ta"), Grants{});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].what, "feed_resolution");
  EXPECT_EQ(found[1].declared, number("1000000"));
  EXPECT_EQ(found[1].counts, number("0.001"));
  Grants grants;
  grants.feed_resolution = number("1");
  EXPECT_EQ(capped(coarse(), profile_of("gsk988ta"), grants).size(), 2U);
  EXPECT_TRUE(capped(SubjectInfo{}, profile_of("gsk988ta"), Grants{}).empty());
}

// A subject that declares a feed resolution of 1,000,000 and sends F1 everywhere.
TEST(Tolerances, AFeedOfAnythingIsNoRounding) {
  EXPECT_EQ(judged(make_tolerances(coarse(), profile_of("gsk988ta"), Grants{}), R"("1")"),
            VerdictKind::fail_feed);
}

// 0.2 as a double, printed by %a; and 0.2000001, which is neither that nor 0.2 rounded.
TEST(Tolerances, ADoubleIsRightForOneThatComputesInDoubles) {
  SubjectInfo subject;
  subject.features = {"blocks"};
  const char* feed = R"("0x1.999999999999ap-3")";
  for (const char* kind : {"exact", "binary64"}) {
    subject.numeric_kind = kind;
    const Tolerances tolerances = make_tolerances(subject, profile_of("gsk988ta"), Grants{});
    EXPECT_EQ(decision(judged(tolerances, feed)), Decision::go) << kind;
    EXPECT_EQ(judged(tolerances, R"("0.2000001")"), VerdictKind::fail_feed) << kind;
  }
}

}  // namespace
}  // namespace gonogo::oracle
