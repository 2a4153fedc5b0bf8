// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/id_spans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/trials.hpp"

namespace gonogo::oracle {
namespace {

using Ids = std::vector<std::string>;

// Files as they are added, and read anew.
struct Files {
  std::vector<Ids> files;
  std::size_t reads = 0;
  IdSpans spans{[this](std::size_t file) {
    ++reads;
    return files.at(file);
  }};

  std::optional<std::string> add(Ids ids) {
    files.push_back(std::move(ids));
    return spans.add(files.back());
  }
};

TEST(IdSpans, KeepNoIdsOfFilesThatStandApart) {
  Files files;
  EXPECT_EQ(files.add({"b.1", "b.2"}), std::nullopt);
  EXPECT_EQ(files.add({"d.1", "d.9"}), std::nullopt);
  EXPECT_EQ(files.add({}), std::nullopt);
  EXPECT_EQ(files.add({"c.1"}), std::nullopt);
  EXPECT_EQ(files.add({"a.1", "a.2"}), std::nullopt);
  EXPECT_EQ(files.spans.kept(), 0U);
  EXPECT_EQ(files.reads, 0U);
}

TEST(IdSpans, TellAnIdOfTwoFilesWhereverItStands) {
  for (const char* again : {"b.1", "b.2", "b.3"}) {
    Files files;
    EXPECT_EQ(files.add({"a.1"}), std::nullopt);
    EXPECT_EQ(files.add({"b.1", "b.2", "b.3"}), std::nullopt);
    EXPECT_EQ(files.add({"c.1"}), std::nullopt);
    Ids ids = {"a.5", again, "c.0"};
    EXPECT_EQ(files.add(ids), again);
  }
}

TEST(IdSpans, KeepTheIdsOfFilesThatInterleave) {
  Files files;
  EXPECT_EQ(files.add({"a.1", "a.3"}), std::nullopt);
  EXPECT_EQ(files.add({"a.5", "a.7"}), std::nullopt);
  EXPECT_EQ(files.add({"a.2", "a.6"}), std::nullopt);
  EXPECT_EQ(files.spans.kept(), 3U);
  EXPECT_EQ(files.add({"a.4", "a.5"}), "a.5");
}

// Against a set of all ids; a file is read anew once at most.
TEST(IdSpans, SayWhatASetOfAllIdsSays) {
  constexpr long kTrials = 2'000;
  long repeated = 0;
  each_trial(kTrials, [&](Chance& chance) {
    Files files;
    std::set<std::string> all;
    for (std::size_t file = 0; file < 12; ++file) {
      std::set<std::string> own;
      const std::size_t begin = chance.below(2'000);
      for (std::size_t count = chance.below(5); count > 0; --count) {
        own.insert(std::to_string(10'000 + begin + chance.below(60)));
      }
      const auto again =
          std::ranges::find_if(own, [&](const auto& id) { return all.contains(id); });
      const auto said = files.add(Ids(own.begin(), own.end()));
      ASSERT_EQ(said.has_value(), again != own.end());
      if (said) {
        ASSERT_EQ(*said, *again);
        ++repeated;
        break;
      }
      all.insert(own.begin(), own.end());
    }
    ASSERT_LE(files.reads, files.files.size());
  });
  EXPECT_GT(repeated, trial_count(kTrials) / 20);
}

}  // namespace
}  // namespace gonogo::oracle
