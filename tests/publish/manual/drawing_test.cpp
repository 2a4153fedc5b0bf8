// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawings of the pages, as far as a machine can look at them: nothing cut off, no number on
// another, a legend for each kind of line, axes and units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "publish/manual/page.hpp"

namespace gonogo::oracle::manual {
namespace {

struct Text {
  double x, y, left, right;
  std::string style, words;
};

// The texts of a drawing with the room they take, at 0.58 of the font's size a letter.
std::vector<Text> texts_of(const std::string& svg) {
  static const std::regex tag(
      R"rx(<text x="([-0-9.]+)" y="([-0-9.]+)" class="([^"]*)" ([^>]*)>([^<]*)</text>)rx");
  std::vector<Text> all;
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
    static const std::regex entity("&[a-z#0-9]+;");
    Text text{std::stod(it->str(1)),
              std::stod(it->str(2)),
              0,
              0,
              it->str(3),
              std::regex_replace(it->str(5), entity, "?")};
    const double size = text.style == "gs-label" ? 12 : 13;
    const double width = 0.58 * size * static_cast<double>(text.words.size());
    const bool middle = it->str(4).find("middle") != std::string::npos;
    const bool at_end = it->str(4).find("\"end\"") != std::string::npos;
    text.left = text.x - (middle ? width / 2 : at_end ? width : 0);
    text.right = text.left + width;
    all.push_back(std::move(text));
  }
  return all;
}

template <typename Visit>
std::size_t for_each_drawing(Visit visit) {
  std::size_t count = 0;
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const PageFile& file : page_of(dialect)) {
      if (!file.name.ends_with(".svg")) continue;
      ++count;
      visit(file, dialect);
    }
  }
  return count;
}

TEST(Drawings, NoTextIsCutOff) {
  static const std::regex box(R"rx(viewBox="0 0 ([0-9.]+) ([0-9.]+)")rx");
  const std::size_t count = for_each_drawing([](const PageFile& file, const auto&) {
    std::smatch size;
    ASSERT_TRUE(std::regex_search(file.text, size, box)) << file.name;
    for (const Text& text : texts_of(file.text)) {
      EXPECT_GE(text.left, 0) << file.name << ": " << text.words;
      EXPECT_LE(text.right, std::stod(size.str(1))) << file.name << ": " << text.words;
      EXPECT_GE(text.y, 10) << file.name << ": " << text.words;
      EXPECT_LE(text.y, std::stod(size.str(2))) << file.name << ": " << text.words;
    }
  });
  EXPECT_GT(count, 80U);
}

TEST(Drawings, NoTextLiesOnAnother) {
  for_each_drawing([](const PageFile& file, const auto&) {
    const std::vector<Text> texts = texts_of(file.text);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      for (std::size_t k = i + 1; k < texts.size(); ++k) {
        const bool apart = texts[i].right <= texts[k].left || texts[k].right <= texts[i].left ||
                           std::fabs(texts[i].y - texts[k].y) >= 10;
        EXPECT_TRUE(apart) << file.name << ": \"" << texts[i].words << "\" and \"" << texts[k].words
                           << "\"";
      }
    }
  });
}

TEST(Drawings, SayTheirUnitsAxesAndKindsOfLines) {
  constexpr std::string_view kKinds[] = {"feed", "rapid", "thread"};
  for_each_drawing([&](const PageFile& file, const reference::Dialect& dialect) {
    bool unit = false;
    bool axes = false;
    bool kinds = false;
    for (const Text& text : texts_of(file.text)) {
      unit = unit || text.words == (dialect.lathe ? "mm, X as a radius" : "mm");
      axes = axes || (text.style == "gs-name" && text.words.size() == 1);
      kinds = kinds || std::ranges::any_of(kKinds, [&](std::string_view kind) {
                return text.words.ends_with(kind);
              });
    }
    EXPECT_TRUE(unit && axes && kinds) << file.name;
  });
}

}  // namespace
}  // namespace gonogo::oracle::manual
