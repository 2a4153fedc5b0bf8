// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/start_reply.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

std::variant<SubjectInfo, JsonFault> read(std::string_view text) {
  JsonDocument document;
  auto parsed = document.parse(text);
  if (auto* fault = std::get_if<JsonFault>(&parsed)) return *fault;
  return read_start_reply(std::get<simdjson::dom::object>(parsed));
}

std::string with(const std::string& more) {
  return R"({"protocol":1,"subject":{"name":"acme","version":"3.2.1"})" + more + "}";
}

SubjectInfo info_of(const std::string& more) {
  auto reply = read(with(more));
  if (auto* fault = std::get_if<JsonFault>(&reply)) ADD_FAILURE() << fault->message;
  return std::holds_alternative<SubjectInfo>(reply) ? std::get<SubjectInfo>(reply) : SubjectInfo();
}

bool refused(const std::string& text) {
  auto reply = read(text);
  auto* fault = std::get_if<JsonFault>(&reply);
  return fault != nullptr && !fault->message.empty();
}

TEST(StartReply, SayingNothingOfDialectsDeclaresEverything) {
  const SubjectInfo info = info_of("");
  EXPECT_TRUE(info.everything);
  EXPECT_TRUE(info.declares("hnc21t", "g80"));
  EXPECT_EQ(info.numeric_kind, "exact");
  EXPECT_EQ(info.max_in_flight, 1);
}

TEST(StartReply, AListOfDialectsDeclaresAllInThem) {
  const SubjectInfo info = info_of(R"(,"dialects":["gsk988ta"])");
  EXPECT_TRUE(info.declares("gsk988ta", "g110"));
  EXPECT_FALSE(info.declares("hnc21t", "g80"));
}

TEST(StartReply, AnObjectOfDialectsDeclaresTheNamedFeatures) {
  const SubjectInfo info = info_of(R"(,"dialects":{"gsk988ta":["g94"],"hnc21t":[]})");
  EXPECT_TRUE(info.declares("gsk988ta", "g94"));
  EXPECT_TRUE(info.declares("gsk988ta", ""));
  EXPECT_FALSE(info.declares("gsk988ta", "g110"));
  EXPECT_TRUE(info.declares("hnc21t", "g80"));
}

TEST(StartReply, ReadsTheNumericDeclaration) {
  const SubjectInfo info = info_of(
      R"(,"numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"1/10","chord":"0"},)"
      R"("max_in_flight":256)");
  EXPECT_EQ(info.numeric_kind, "fixed");
  EXPECT_EQ(info.resolution, Number(1) / Number(1000));
  EXPECT_EQ(info.feed_resolution, Number(1) / Number(10));
  EXPECT_EQ(info.chord, Number(0));
  EXPECT_EQ(info.max_in_flight, 256);
}

// A number of a record may be a root or an enclosure; nothing is rounded to a multiple of one.
TEST(StartReply, WhatIsRoundedToIsADecimal) {
  for (const char* key : {"resolution", "feed_resolution", "chord"}) {
    for (const char* form : {R"({"root":["0","1/10000","2"]})", R"({"root":["0","1","4"]})",
                             R"({"enclosure":["0.001","0.001"]})"}) {
      auto reply = read(with(fmt::format(R"(,"numeric":{{"{}":{}}})", key, form)));
      const auto* fault = std::get_if<JsonFault>(&reply);
      ASSERT_NE(fault, nullptr) << key << form;
      EXPECT_EQ(fault->message,
                fmt::format("\"{}\" must be a decimal in quotes, no root and no enclosure.", key));
    }
  }
}

TEST(StartReply, NamesTheReadingsThatTheSubjectKnows) {
  const reference::Reading& one = *reference::find_reading("gsk.g94.rewrite");
  const reference::Reading& other = *reference::find_reading("gsk.g94.after-00");
  EXPECT_FALSE(info_of("").knows(one));
  const SubjectInfo named = info_of(R"(,"readings":["gsk.g94.rewrite"])");
  EXPECT_TRUE(named.knows(one));
  EXPECT_FALSE(named.knows(other));
  EXPECT_TRUE(info_of(R"(,"readings":["*"])").knows(other));
  EXPECT_TRUE(refused(with(R"(,"readings":["gsk.g94.rewritten"])")));
}

TEST(StartReply, AKeyOfTheSubjectsOwnBeginsWithX) {
  EXPECT_EQ(info_of(R"(,"x-homepage":"x","x-build":{"os":"linux"})").name, "acme");
}

// A misspelled word of these would be taken as left out: cases skipped, M functions not compared,
// and still a GO.
TEST(StartReply, RefusesWordsThatItDoesNotKnow) {
  for (const char* more :
       {R"(,"feature":["m"])", R"(,"homepage":"x")", R"(,"numeric":{"resolutions":"0.1"})",
        R"(,"features":["M"])", R"(,"features":["block"])", R"(,"features":["basic"])",
        R"(,"dialects":{"rs274":["basic","arcs"]})", R"(,"dialects":{"gsk988ta":["g80"]})"}) {
    EXPECT_TRUE(refused(with(more))) << more;
  }
  EXPECT_TRUE(refused(R"({"protocol":1,"subject":{"name":"a","vesion":"1"}})"));
}

TEST(StartReply, FeaturesOfADialectThatTheGaugeDoesNotHaveAreTheSubjectsOwn) {
  EXPECT_TRUE(
      info_of(R"(,"dialects":{"othermill":["g73"],"rs274":["arc"]})").declares("rs274", "arc"));
}

TEST(StartReply, RefusesWhatBreaksTheContract) {
  EXPECT_TRUE(refused(R"({"subject":{"name":"a"}})"));
  EXPECT_TRUE(refused(R"({"protocol":2,"subject":{"name":"a"}})"));
  EXPECT_TRUE(refused(R"({"protocol":"1","subject":{"name":"a"}})"));
  EXPECT_TRUE(refused(R"({"protocol":1})"));
  EXPECT_TRUE(refused(R"({"protocol":1,"subject":{"name":""}})"));
  EXPECT_TRUE(refused(R"({"protocol":1,"subject":{"name":"a","version":"master"}})"));
  for (const char* more :
       {R"(,"dialects":"gsk988ta")", R"(,"dialects":[1])", R"(,"dialects":{"gsk988ta":"g94"})",
        R"(,"numeric":{"resolution":0.001})", R"(,"numeric":{"resolution":"0"})",
        R"(,"numeric":{"chord":"-1"})", R"(,"numeric":{"kind":"decimal"})", R"(,"max_in_flight":0)",
        R"(,"max_in_flight":257)", R"(,"max_in_flight":"4")", R"(,"features":{"m":true})",
        R"(,"protocol":1)"}) {
    EXPECT_TRUE(refused(with(more))) << more;
  }
}

TEST(SubjectSpec, IsAKindAColonAndTheRest) {
  const auto spec = parse_subject_spec("pipe:./acme --fast x:y");
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->kind, "pipe");
  EXPECT_EQ(spec->rest, "./acme --fast x:y");
  for (const char* text : {"", "pipe", "pipe:", ":x", "./a b:c"}) {
    EXPECT_FALSE(parse_subject_spec(text)) << text;
  }
}

}  // namespace
}  // namespace gonogo::oracle
