// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/site/vote.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle::site {
namespace {

Votes::Answer go(std::size_t run) {
  return {run, true, {}, {}, {}, {}};
}

Votes::Answer departs_so(std::size_t run, const std::string& how) {
  return {run, false, how, "fail.geometry", "NGC-G81-01", "It goes elsewhere."};
}

CaseHead case_of(const std::string& id) {
  CaseHead head;
  head.id = id;
  head.dialect = "rs274";
  return head;
}

Ballot ballot_of(const std::vector<Votes::Answer>& answers) {
  Votes votes;
  votes.add(case_of("a"), answers);
  EXPECT_EQ(votes.ballots().size(), 1U);
  return votes.ballots().begin()->first;
}

TEST(Vote, IsOfThoseWhoAnswered) {
  EXPECT_EQ(ballot_of({go(0), go(1)}), Ballot::agreed);
  EXPECT_EQ(ballot_of({go(0), departs_so(1, "x")}), Ballot::lone);
  EXPECT_EQ(ballot_of({go(0), departs_so(1, "x"), departs_so(2, "y")}), Ballot::split);
  EXPECT_EQ(ballot_of({departs_so(0, "x"), departs_so(1, "x")}), Ballot::against);
  EXPECT_EQ(ballot_of({departs_so(0, "x"), departs_so(1, "y")}), Ballot::scattered);
  Votes votes;
  votes.add(case_of("a"), {departs_so(0, "x")});
  votes.add(case_of("b"), {});
  EXPECT_EQ(votes.alone(), 2U);
  EXPECT_TRUE(votes.ballots().empty());
}

TEST(Vote, CasesOfOneAgreementStandTogether) {
  Votes votes;
  votes.add(case_of("a"), {go(0), departs_so(1, "x"), departs_so(2, "x"), departs_so(3, "y")});
  votes.add(case_of("b"), {go(0), departs_so(1, "z"), departs_so(2, "z"), departs_so(3, "y")});
  votes.add(case_of("c"), {departs_so(1, "x"), departs_so(2, "x")});
  const auto list = votes.list();
  ASSERT_EQ(list.size(), 2U);
  // None says what the reference says: first.
  EXPECT_EQ(list[0]->key.ballot, Ballot::against);
  EXPECT_EQ(list[0]->first, std::vector<std::string>{"c"});
  EXPECT_EQ(list[1]->cases, 2U);
  EXPECT_EQ(list[1]->key.with, std::vector<std::size_t>{0});
  EXPECT_EQ(list[1]->key.alike, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(list[1]->key.other, std::vector<std::size_t>{3});
}

TEST(Vote, PairsAgreeWithAndAgainstTheReference) {
  Votes votes;
  votes.add(case_of("a"), {go(0), go(1)});
  votes.add(case_of("b"), {departs_so(0, "x"), departs_so(1, "x")});
  votes.add(case_of("c"), {departs_so(0, "x"), departs_so(1, "y")});
  votes.add(case_of("d"), {go(0)});
  const Pair pair = votes.pair(1, 0);
  EXPECT_EQ(pair.both, 3U);
  EXPECT_EQ(pair.alike, 2U);
  EXPECT_EQ(pair.depart_alike, 1U);
}

TEST(Vote, DeparturesAreAlikeWhateverTheSubjectCallsItsAlarm) {
  CaseHead one = case_of("a");
  one.verdict = "fail.alarm-spurious";
  one.block = 3;
  one.got = R"({"k":"alarm","class":"syntax","b":3,"native":"E12"})";
  CaseHead other = one;
  other.got = R"({"b":3,"class":"syntax","k":"alarm","native":"bad word","word":"X"})";
  EXPECT_EQ(departure_text(one), departure_text(other));
  other.got = R"({"b":3,"class":"arc-radius","k":"alarm"})";
  EXPECT_NE(departure_text(one), departure_text(other));
}

TEST(Vote, DeparturesBySoMuchAreToldByTheDeviation) {
  CaseHead one = case_of("a");
  one.verdict = "fail.geometry";
  one.deviation = "1/3";
  one.got = R"({"k":"feed","to":{"x":"1"}})";
  CaseHead other = one;
  other.got = R"({"k":"feed","to":{"x":"1","z":"5"}})";  // the same place, told in full
  EXPECT_EQ(departure_text(one), departure_text(other));
  other.deviation = "0.33334";  // rounded to its resolution
  EXPECT_EQ(departure_text(one), departure_text(other));
  other.block = 7;  // a subject without source lines is told another
  EXPECT_EQ(departure_text(one), departure_text(other));
  other.deviation = R"({"root":["0","1","2"]})";
  EXPECT_NE(departure_text(one), departure_text(other));
  other.deviation = "1/4";
  EXPECT_NE(departure_text(one), departure_text(other));
  // Known or not.
  other = one;
  other.verdict = "xfail";
  other.departure = "fail.geometry";
  EXPECT_EQ(departure_text(one), departure_text(other));
}

}  // namespace
}  // namespace gonogo::oracle::site
