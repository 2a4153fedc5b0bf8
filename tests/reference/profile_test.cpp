// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine profile: its keys and defaults, the two notations, and what is said of a bad one.
#include "reference/profile.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace gonogo::reference {
namespace {

Number num(std::string_view text) {
  return Number::parse(text).value();
}

// The profile that a text gives; an error fails the test and gives the default one.
Profile taken(ProfileResult result) {
  if (const auto* error = std::get_if<ProfileError>(&result)) {
    ADD_FAILURE() << error->key << ": " << error->message;
    return {};
  }
  return std::get<Profile>(std::move(result));
}
Profile toml(std::string_view text) {
  return taken(profile_from_toml(text));
}
Profile json(std::string_view text) {
  return taken(profile_from_json(text));
}

// That a text is refused for `key`, with a message that holds every one of `says`.
void expect_refused(const ProfileResult& result, std::string_view key,
                    const std::vector<std::string_view>& says) {
  const auto* error = std::get_if<ProfileError>(&result);
  ASSERT_NE(error, nullptr) << "the profile was taken";
  EXPECT_EQ(error->key, key);
  EXPECT_FALSE(error->message.empty());
  for (std::string_view part : says) {
    EXPECT_NE(error->message.find(part), std::string::npos) << part << " in: " << error->message;
  }
}
void toml_refused(std::string_view text, std::string_view key,
                  const std::vector<std::string_view>& says) {
  SCOPED_TRACE(text);
  expect_refused(profile_from_toml(text), key, says);
}
void json_refused(std::string_view text, std::string_view key,
                  const std::vector<std::string_view>& says) {
  SCOPED_TRACE(text);
  expect_refused(profile_from_json(text), key, says);
}

constexpr std::string_view kFullToml = R"(
dialect = "gsk988ta"
units = "inch"
increment = "ISC"
resolution = "0.0005"
x_diameter = false
alarm_timing = "program"
block_skip = true
[initial]
x = "1.5"
y = "-2"
z = "11/3"
a = "30"
c = "90.25"
f = "200"
plane = "G17"
motion = "G01"
spindle = "M4"
[offsets.G54]
x = "10"
z = "-0.001"
[tools.10]
radius = "5"
[tools.11]
length = "-40.5"
[parameters]
3410 = "0.02"
5921 = "2"
"3403.6" = "0"
[reference_point]
x = "200"
z = "300"
[readings]
"gsk.pocket.end" = "r-plane"
"gsk.pocket.p-omitted" = "0.5"
"gsk.decimals" = "any"
)";

constexpr std::string_view kFullJson = R"({
"dialect":"gsk988ta","units":"inch","increment":"ISC","resolution":"0.0005","x_diameter":false,
"alarm_timing":"program","block_skip":true,
"initial":{"x":"1.5","y":"-2","z":"11/3","a":"30","c":"90.25","f":"200","plane":"G17",
           "motion":"G01","spindle":"M4"},
"offsets":{"G54":{"x":"10","z":"-0.001"}},"tools":{"10":{"radius":"5"},"11":{"length":"-40.5"}},
"parameters":{"3410":"0.02","5921":"2","3403.6":"0"},"reference_point":{"x":"200","z":"300"},
"readings":{"gsk.pocket.end":"r-plane","gsk.pocket.p-omitted":"0.5","gsk.decimals":"any"}})";

void expect_full(const Profile& profile) {
  EXPECT_EQ(profile.dialect, "gsk988ta");
  EXPECT_EQ(profile.units, Units::inch);
  EXPECT_EQ(profile.increment, Increment::isc);
  EXPECT_EQ(profile.resolution(), num("0.0005"));
  EXPECT_FALSE(profile.x_diameter);
  EXPECT_EQ(profile.alarm_timing, AlarmTiming::program);
  EXPECT_TRUE(profile.block_skip);
  const std::array<Number, kAxes> at = {num("1.5"), num("-2"), num("11/3"), num("30"),
                                        num("90.25")};
  EXPECT_EQ(profile.initial.at.at, at);
  EXPECT_EQ(profile.initial.feed, num("200"));
  EXPECT_EQ(profile.initial.plane, Plane::g17);
  EXPECT_EQ(profile.initial.motion, 1);
  EXPECT_EQ(profile.initial.spindle, 4);
  ASSERT_TRUE(profile.offsets.contains("G54"));
  EXPECT_EQ(profile.offsets.at("G54")[Axis::x], num("10"));
  EXPECT_EQ(profile.offsets.at("G54")[Axis::z], num("-0.001"));
  ASSERT_TRUE(profile.tools.contains("10"));
  EXPECT_EQ(profile.tools.at("10").radius, num("5"));
  EXPECT_EQ(profile.tools.at("11").length, num("-40.5"));
  EXPECT_EQ(profile.parameter("3410"), num("0.02"));
  EXPECT_EQ(profile.parameter("5921"), num("2"));
  EXPECT_EQ(profile.parameter("3403.6"), num("0"));
  EXPECT_FALSE(profile.parameter("5920").has_value());
  EXPECT_EQ(profile.reference_point[Axis::x], num("200"));
  EXPECT_EQ(profile.reference_point[Axis::z], num("300"));
  EXPECT_EQ(profile.readings.get("gsk.pocket.end"_key), "r-plane");
  EXPECT_EQ(profile.readings.get("gsk.pocket.p-omitted"_key), "0.5");
  EXPECT_EQ(profile.readings.get("gsk.decimals"_key), "any");
  EXPECT_EQ(profile.readings.get("gsk.x-depth"_key), "any");
}

TEST(Profile, TomlGivesEveryKey) {
  expect_full(toml(kFullToml));
}

TEST(Profile, JsonGivesEveryKey) {
  expect_full(json(kFullJson));
}

TEST(Profile, TomlAndJsonReadTheSame) {
  EXPECT_EQ(toml(kFullToml), json(kFullJson));
}

TEST(Profile, AnEmptyOneIsThePowerOnState) {
  for (const Profile& profile :
       {toml(""), json("{}"), taken(default_profile("gsk988ta")), Profile{}}) {
    EXPECT_EQ(profile.units, Units::mm);
    EXPECT_EQ(profile.increment, Increment::isb);
    EXPECT_TRUE(profile.x_diameter);
    EXPECT_EQ(profile.initial.at, Position{});
    EXPECT_EQ(profile.initial.feed, Number(0));
    EXPECT_EQ(profile.initial.plane, Plane::g18);
    EXPECT_EQ(profile.initial.motion, 0);
    EXPECT_TRUE(profile.offsets.empty());
    EXPECT_TRUE(profile.tools.empty());
    EXPECT_TRUE(profile.parameters.empty());
    EXPECT_EQ(profile.reference_point, Position{});
    EXPECT_EQ(profile.alarm_timing, AlarmTiming::block);
    EXPECT_FALSE(profile.block_skip);
    for (const Reading& reading : readings()) {
      EXPECT_EQ(profile.readings.get(reading.key), reading.fallback) << reading.name;
    }
  }
}

TEST(Profile, ASinumerikMillsInMicrometres) {
  const Profile profile = json(R"({"dialect":"sinumerik840d"})");
  EXPECT_EQ(profile.resolution(), num("0.001"));
  EXPECT_FALSE(profile.x_diameter);
  EXPECT_EQ(profile.initial.plane, Plane::g17);
  EXPECT_EQ(profile.initial.motion, kNoMotion);
  json(R"({"dialect":"sinumerik840d","parameters":{"CIRCLE_ERROR_CONST":"0.02"}})");
  json(R"({"dialect":"sinumerik840d","readings":{"sie.arc.correct":"project"}})");
  json_refused(R"({"dialect":"sinumerik840d","parameters":{"3410":"1"}})", "parameters.3410",
               {"CIRCLE_ERROR_FACTOR"});
  json_refused(R"({"dialect":"rs274","readings":{"sie.arc.correct":"project"}})",
               "readings.sie.arc.correct", {"rs274"});
}

// SIE-ARC-08 holds for both controls, and so does its reading on the wire.
TEST(Profile, AReadingOfTwoDialectsIsWrittenForBoth) {
  for (const char* dialect : {"sinumerik840d", "sinumerik802s"}) {
    auto profile = std::get<Profile>(default_profile(dialect));
    set_reading(profile, "sie.arc.correct", "project");
    EXPECT_EQ(profile_json(profile), R"({"readings":{"sie.arc.correct":"project"}})") << dialect;
  }
}

TEST(Profile, TheLeastIncrementFollowsTheIncrementSystem) {
  EXPECT_EQ(toml("").resolution(), num("0.001"));
  EXPECT_EQ(toml("increment = \"ISB\"").resolution(), num("0.001"));
  EXPECT_EQ(toml("increment = \"ISC\"").resolution(), num("0.0001"));
  EXPECT_EQ(toml("increment = \"ISC\"\nresolution = \"0.01\"").resolution(), num("0.01"));
}

TEST(Profile, AnUnknownKeyIsRefusedWithTheKnownOnes) {
  toml_refused("speed = \"1\"", "speed", {"units", "increment", "x_diameter", "block_skip"});
  json_refused(R"({"Units":"mm"})", "Units", {"units"});
  toml_refused("[initial]\nw = \"1\"", "initial.w", {"x", "plane", "spindle"});
  toml_refused("[offsets.G54]\nX = \"1\"", "offsets.G54.X", {"x, y, z"});
  toml_refused("[reference_point]\nf = \"1\"", "reference_point.f", {"x, y, z"});
  json_refused(R"({"tools":{"10":{"diameter":"5"}}})", "tools.10.diameter", {"radius"});
}

TEST(Profile, AnOffsetAToolAndAParameterThatTheDialectLacksAreRefused) {
  toml_refused("[offsets.G60]\nz = \"1\"", "offsets.G60", {"G54", "G59"});
  toml_refused("[tools.T10]\nradius = \"5\"", "tools.T10", {"digits"});
  toml_refused("[tools.10]\nradius = \"-5\"", "tools.10.radius", {"negative"});
  json_refused(R"({"parameters":{"9999":"1"}})", "parameters.9999", {"3410", "5921"});
  json_refused(R"({"dialect":"hnc21t","parameters":{"5920":"1"}})", "parameters.5920", {"3410"});
}

TEST(Profile, AFloatIsRefusedWithWhatToWrite) {
  toml_refused("resolution = 0.001", "resolution", {"\"0.001\"", "quotes"});
  toml_refused("[initial]\nx = 1.5", "initial.x", {"quotes"});
  toml_refused("[offsets.G54]\nz = -1e3", "offsets.G54.z", {"quotes"});
  toml_refused("[tools.10]\nradius = 5.0", "tools.10.radius", {"quotes"});
  toml_refused("[parameters]\n3410 = 0.02", "parameters.3410", {"quotes"});
  toml_refused("resolution = nan", "resolution", {"quotes"});
  json_refused(R"({"resolution":0.001})", "resolution", {"quotes", "\"0.001\""});
  json_refused(R"({"parameters":{"3410":2e-2}})", "parameters.3410", {"quotes"});
}

TEST(Profile, AFloatAsTheValueOfAReadingIsRefused) {
  toml_refused("[readings]\n\"gsk.pocket.p-omitted\" = 0.5", "readings.gsk.pocket.p-omitted",
               {"quotes"});
  json_refused(R"({"readings":{"gsk.pocket.p-omitted":0.5}})", "readings.gsk.pocket.p-omitted",
               {"quotes"});
}

TEST(Profile, ADecimalIsTakenExactly) {
  EXPECT_EQ(toml("[initial]\nx = \"0.1\"").initial.at[Axis::x] * 10, Number(1));
  const Profile fine = json(R"({"initial":{"x":"0.12345678901234567890123"}})");
  EXPECT_EQ(fine.initial.at[Axis::x].text(), "0.12345678901234567890123");
}

TEST(Profile, AValueThatIsNoChoiceIsRefusedWithTheChoices) {
  toml_refused("units = \"cm\"", "units", {"cm", "\"mm\"", "\"inch\""});
  toml_refused("increment = \"ISD\"", "increment", {"ISD", "\"ISB\"", "\"ISC\""});
  toml_refused("alarm_timing = \"load\"", "alarm_timing", {"\"block\"", "\"program\""});
  toml_refused("[initial]\nplane = \"G20\"", "initial.plane", {"\"G17\"", "\"G18\"", "\"G19\""});
  toml_refused("[initial]\nmotion = \"G94\"", "initial.motion", {"\"G00\"", "\"G01\""});
  toml_refused("[initial]\nspindle = \"M6\"", "initial.spindle", {"\"M3\"", "\"M4\"", "\"M5\""});
  json_refused(R"({"units":25})", "units", {"\"mm\""});
}

TEST(Profile, AFlagIsTrueOrFalse) {
  toml_refused("x_diameter = \"yes\"", "x_diameter", {"true", "false"});
  toml_refused("block_skip = 1", "block_skip", {"true", "false"});
  json_refused(R"({"x_diameter":null})", "x_diameter", {"true", "false"});
}

// G7 of rs274 says it in the program.
TEST(Profile, ADiameterIsRefusedWhereXIsALengthAtPowerOnAndACodeMakesItOne) {
  json_refused(R"({"dialect":"rs274","x_diameter":true})", "x_diameter", {"rs274", "length"});
}

TEST(Profile, NoOffsetsAreNamedWhereADialectHasNone) {
  json_refused(R"({"dialect":"sinumerik840d","offsets":{"G54":{"x":"1"}}})", "offsets.G54",
               {"no work offsets"});
}

TEST(Profile, ATextThatIsNoNumberIsRefused) {
  for (std::string_view text : {"", "one", "1,5", "0x", "1.2.3", "nan", "inf", "1/0"}) {
    toml_refused("[initial]\nx = \"" + std::string(text) + "\"", "initial.x", {"quotes"});
  }
}

TEST(Profile, TheResolutionIsAboveZero) {
  toml_refused("resolution = \"0\"", "resolution", {"above zero"});
  toml_refused("resolution = \"-0.001\"", "resolution", {"above zero"});
}

TEST(Profile, ATableMustBeATable) {
  for (std::string_view key :
       {"initial", "offsets", "tools", "parameters", "readings", "reference_point"}) {
    json_refused("{\"" + std::string(key) + "\":\"1\"}", key, {"table"});
  }
  json_refused(R"({"tools":{"10":"5"}})", "tools.10", {"table"});
  json_refused(R"({"offsets":{"G54":"5"}})", "offsets.G54", {"table"});
  expect_refused(profile_from_json("[]"), "profile", {"table"});
}

TEST(Profile, AnUnknownDialectIsRefusedWithTheKnownOnes) {
  toml_refused("dialect = \"gsk980\"", "dialect", {"gsk980", "gsk988ta"});
  expect_refused(default_profile("fanuc"), "dialect", {"fanuc", "gsk988ta"});
}

TEST(Profile, AnUnknownReadingIsRefusedWithWhereTheyAreListed) {
  toml_refused("[readings]\n\"gsk.pocket.ends\" = \"initial\"", "readings.gsk.pocket.ends",
               {"gsk.pocket.ends", "gonogo spec"});
  json_refused(R"({"readings":{"end":"initial"}})", "readings.end", {"gonogo spec"});
}

TEST(Profile, AValueThatAReadingLacksIsRefusedWithItsAlternatives) {
  toml_refused("[readings]\n\"gsk.pocket.end\" = \"R\"", "readings.gsk.pocket.end",
               {"\"R\"", "any", "initial", "r-plane"});
  json_refused(R"({"readings":{"gsk.pocket.p-omitted":"-0.1"}})", "readings.gsk.pocket.p-omitted",
               {"length"});
  json_refused(R"({"readings":{"gsk.pocket.end":true}})", "readings.gsk.pocket.end", {"quotes"});
}

TEST(Profile, ANameOfAReadingWithoutQuotesMeansTheSameInToml) {
  EXPECT_EQ(toml("[readings]\ngsk.pocket.end = \"r-plane\"\ngsk.decimals = \"alarm\""),
            toml("[readings]\n\"gsk.pocket.end\" = \"r-plane\"\n\"gsk.decimals\" = \"alarm\""));
}

TEST(Profile, AKeyTwiceInJsonIsRefused) {
  json_refused(R"({"units":"mm","units":"inch"})", "units", {"twice"});
  json_refused(R"({"initial":{"x":"1","x":"2"}})", "x", {"twice"});
  // The same name in two objects is no repetition.
  json(R"({"initial":{"x":"1"},"reference_point":{"x":"2"}})");
}

TEST(Profile, WhatIsNoTomlOrJsonIsRefusedWithThePlace) {
  toml_refused("units = \"mm\"\nincrement = ", "", {"line 2"});
  toml_refused("units = \"mm\"\nunits = \"inch\"", "", {"line 2"});
  expect_refused(profile_from_json("{\"units\":"), "", {"JSON", "column"});
}

TEST(Profile, SettingAReadingIsAsTheProfileSaysIt) {
  Profile profile;
  EXPECT_FALSE(set_reading(profile, "gsk.pocket.end", "r-plane").has_value());
  EXPECT_EQ(profile, toml("[readings]\n\"gsk.pocket.end\" = \"r-plane\""));
  EXPECT_TRUE(set_reading(profile, "gsk.pocket.end", "R").has_value());
  EXPECT_TRUE(set_reading(profile, "gsk.nothing", "any").has_value());
  EXPECT_EQ(profile.readings.get("gsk.pocket.end"_key), "r-plane");
}

TEST(Profile, TheDefaultsAreWrittenAsNothing) {
  EXPECT_EQ(profile_json(Profile{}), "{}");
}

TEST(Profile, OnlyWhatDiffersIsWritten) {
  EXPECT_EQ(profile_json(toml("increment = \"ISC\"\n[initial]\nx = \"1.5\"")),
            R"({"increment":"ISC","initial":{"x":"1.5"}})");
}

TEST(Profile, WhatIsWrittenReadsBackTheSame) {
  const Profile full = toml(kFullToml);
  EXPECT_EQ(json(profile_json(full)), full);
  for (const Reading& reading : readings()) {
    for (std::string_view alternative : reading.alternatives) {
      Profile profile = std::get<Profile>(default_profile(reading.dialect));
      ASSERT_FALSE(set_reading(profile, reading.name, alternative).has_value());
      // The dialect is written apart.
      std::string text = profile_json(profile);
      text.insert(1,
                  "\"dialect\":\"" + std::string(reading.dialect) + (text == "{}" ? "\"" : "\","));
      EXPECT_EQ(json(text), profile) << reading.name << " = " << alternative;
    }
  }
}

}  // namespace
}  // namespace gonogo::reference
