// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/identify.hpp"
#include "fuzz/generate/choices.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "pools.hpp"
#include "secret_subject.hpp"

namespace gonogo::identify {
namespace {

using reference::ReadingChoice;
using testing::builtin;
using testing::default_machine;
using testing::pool_of;
using testing::SecretSubject;

ReadingChoice with(const std::vector<std::pair<ReadingKey, std::string_view>>& values) {
  ReadingChoice choice;
  for (const auto& [key, value] : values) choice.set(key, value);
  return choice;
}

const ReadingFound& found_of(const Identification& found, ReadingKey key) {
  return *std::ranges::find(found.readings, key, &ReadingFound::key);
}

// A pecking machine that is not the standard one.
ReadingChoice other_lathe() {
  return with({{"hnc.peck.from"_key, "withdrawn"},
               {"hnc.g75.end"_key, "last"},
               {"hnc.missing-axis"_key, "keep"},
               {"hnc.modal.f"_key, "forgotten"}});
}

TEST(Identify, FindsReadingsThatTheSubjectFollowsSecretly) {
  SecretSubject subject(builtin("hnc"), other_lathe());
  const Identification found = identify_readings(subject, pool_of("hnc21t"), {});
  ASSERT_TRUE(found.contradiction.empty());
  for (const ReadingFound& one : found.readings) {
    // What is open the expander does as it is shown.
    const std::string secret(other_lathe().shown().get(one.key));
    EXPECT_NE(std::ranges::find(one.values, secret), one.values.end())
        << reference::reading(one.key).name;
  }
  EXPECT_EQ(found_of(found, "hnc.peck.from"_key).values, (std::vector<std::string>{"withdrawn"}));
  EXPECT_EQ(found_of(found, "hnc.g75.end"_key).values, (std::vector<std::string>{"last"}));
}

TEST(Identify, TellsTheSubjectNoReading) {
  SecretSubject subject(builtin("hnc"), other_lathe());
  identify_readings(subject, pool_of("hnc21t"), {});
  EXPECT_FALSE(subject.told_a_reading());
}

TEST(Identify, NeedsFewerProgramsThanThereAreBits) {
  // 14 readings of two values, one of three and one more of two: 3 * 2^15 assignments.
  SecretSubject subject(builtin("hnc"), other_lathe());
  const Identification found = identify_readings(subject, pool_of("hnc21t"), {});
  EXPECT_GT(found.bits, 16);
  EXPECT_LT(static_cast<double>(found.answered()), found.bits);
}

TEST(Identify, WritesAProfileThatSaysWhatWasFound) {
  SecretSubject subject(builtin("hnc"), other_lathe());
  const Identification found = identify_readings(subject, pool_of("hnc21t"), {});
  const auto read =
      reference::profile_from_toml(identification_toml(found, default_machine("hnc21t")));
  ASSERT_TRUE(std::holds_alternative<Profile>(read));
  Profile expected = default_machine("hnc21t");
  for (const ReadingFound& one : found.readings) {
    if (one.values.size() == 1) expected.readings.set(one.key, one.values.front());
  }
  EXPECT_EQ(std::get<Profile>(read), expected);
  EXPECT_EQ(expected.readings.get("hnc.modal.f"_key), "forgotten");
}

// gsk.pocket.p-omitted is 0 by default, and 0 is all that the catalog names.
TEST(Identify, FindsALengthThatTheCatalogDoesNotName) {
  for (const std::string_view length : {"0.375", "1", "2.5"}) {
    SecretSubject subject(std::make_unique<testing::ReferenceSubject>(),
                          with({{"gsk.pocket.p-omitted"_key, length}}));
    const Identification found = identify_readings(subject, pool_of("gsk988ta"), {});
    EXPECT_TRUE(found.contradiction.empty()) << length;
    EXPECT_EQ(found_of(found, "gsk.pocket.p-omitted"_key).values,
              (std::vector<std::string>{std::string(length)}));
  }
}

TEST(Identify, FindsTheLengthOfTheDefault) {
  SecretSubject subject(builtin("gsk"), {});
  const Identification found = identify_readings(subject, pool_of("gsk988ta"), {});
  EXPECT_EQ(found_of(found, "gsk.pocket.p-omitted"_key).values, (std::vector<std::string>{"0"}));
}

// A tool that goes down from the R plane each time: what is longer than the pocket is deep
// explains it as well.
TEST(Identify, SaysWhenALengthIsLongerThanThereIsRoomFor) {
  SecretSubject subject(std::make_unique<testing::ReferenceSubject>(),
                        with({{"gsk.pocket.p-omitted"_key, "100000"}}));
  const Identification found = identify_readings(subject, pool_of("gsk988ta"), {});
  const ReadingFound& clearance = found_of(found, "gsk.pocket.p-omitted"_key);
  EXPECT_EQ(clearance.values.back(), "another length");
  EXPECT_EQ(clearance.why, "the programs that show it have room for no more than they show");
}

TEST(Identify, WhatDepartsUnderEveryReadingIsSetAside) {
  const auto subject = builtin("hnc", "withdrawal-twice");
  const Identification found = identify_readings(*subject, pool_of("hnc21t"), {});
  EXPECT_FALSE(found.aside.empty());
  EXPECT_TRUE(found.contradiction.empty());
  EXPECT_EQ(found_of(found, "hnc.g75.i"_key).values, std::vector<std::string>{"I"});
  EXPECT_NE(identification_text(found, "hnc", "hnc21t").find("departs under every reading"),
            std::string::npos);
}

// Skips every program with a thread cycle.
class WithoutThreads final : public SecretSubject {
 public:
  WithoutThreads() : SecretSubject(builtin("hnc"), {}) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    if (program.find("G82") == std::string_view::npos) return SecretSubject::run(id, program, sink);
    oracle::RunEnd end;
    end.kind = oracle::RunEnd::Kind::skip;
    end.feature = "g82";
    end.message = "There is no thread cycle.";
    return end;
  }
};

TEST(Identify, SaysThatASubjectSkipsWhatWouldTell) {
  WithoutThreads subject;
  const Identification found = identify_readings(subject, pool_of("hnc21t"), {});
  ASSERT_TRUE(found.contradiction.empty());
  const ReadingFound& exit = found_of(found, "hnc.g82.exit"_key);
  EXPECT_EQ(exit.values.size(), 2U);
  EXPECT_EQ(exit.why, "the subject skips the programs that show it");
  EXPECT_EQ(found_of(found, "hnc.g75.end"_key).values.size(), 1U);
}

// Readings of the dialect at random, of those that the expander has.
ReadingChoice random_readings(std::string_view dialect, oracle::Subject& subject,
                              generate::Choices& choices) {
  ReadingChoice secret;
  for (const ReadingKey key : reading_kinds(dialect).choices) {
    const auto& alternatives = reference::reading(key).alternatives;
    const auto count = static_cast<std::uint32_t>(alternatives.size());
    Profile profile = default_machine(dialect);
    profile.readings.set(key, alternatives[choices.below(count)]);
    subject.configure(profile);
    const auto end = subject.run("", "", [](const Record&) { return true; });
    if (end.kind != oracle::RunEnd::Kind::refused) secret.set(key, profile.readings.get(key));
  }
  return secret;
}

struct Bed {
  const char* dialect;
  const char* expander;
  std::uint64_t assignments;  // how many are tried
};

void PrintTo(const Bed& bed, std::ostream* out) {
  *out << bed.dialect;
}

class IdentifyAnything : public ::testing::TestWithParam<Bed> {};

// For all readings that an expander may follow: none of them is struck out, and few programs are
// needed.
TEST_P(IdentifyAnything, StrikesOutNoReadingThatIsFollowed) {
  const auto& [dialect, expander, assignments] = GetParam();
  double programs = 0;
  double bits = 0;
  for (std::uint64_t seed = 1; seed <= assignments; ++seed) {
    generate::Choices choices(seed);
    auto inner = builtin(expander);
    const ReadingChoice secret = random_readings(dialect, *inner, choices);
    SecretSubject subject(std::move(inner), secret);
    const Identification found = identify_readings(subject, pool_of(dialect), {});
    ASSERT_TRUE(found.contradiction.empty()) << "seed " << seed;
    for (const ReadingFound& one : found.readings) {
      const std::string value(secret.get(one.key));
      if (value == "any") continue;
      EXPECT_NE(std::ranges::find(one.values, value), one.values.end())
          << "seed " << seed << ": " << reference::reading(one.key).name << " = " << value;
    }
    programs += static_cast<double>(found.answered());
    bits = found.bits;
  }
  const double mean = programs / static_cast<double>(assignments);
  RecordProperty("mean_programs", fmt::format("{:.1f}", mean));
  EXPECT_LE(mean, bits + 1);
}

INSTANTIATE_TEST_SUITE_P(Expanders, IdentifyAnything,
                         ::testing::Values(Bed{"hnc21t", "hnc", 30}, Bed{"rs274", "ngc", 30},
                                           Bed{"gsk988ta", "gsk", 5},
                                           Bed{"sinumerik840d", "sinumerik", 30}),
                         [](const auto& bed) { return std::string(bed.param.dialect); });

}  // namespace
}  // namespace gonogo::identify
