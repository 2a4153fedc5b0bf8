// SPDX-License-Identifier: GPL-3.0-or-later
//
// The labels of drawings: none lies over another.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "corpus_testing.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/sheet.hpp"

namespace gonogo::testing {
namespace {

namespace report = oracle::report;

struct Box {
  double left, top, right, bottom;
  std::string text;
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// DejaVu Sans: a figure is 0.636 of the size wide, a capital of a title with its space 0.75; a line
// is 0.93 above and 0.24 below its foot, of which figures take 0.73 and nothing. Of bold letters
// the narrow ones are 0.35 of the size wide, the others 0.72.
Box box_of(const std::smatch& text) {
  const bool is_label = text[3] == "gs-label";
  const bool is_point = text[3] == "gs-point";
  const double size = is_label ? 10 : is_point ? 12 : 11;
  const std::string words = std::regex_replace(text[5].str(), std::regex("&[a-z#0-9]+;"), "x");
  const auto letters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  const auto narrow =
      is_point ? std::ranges::count_if(
                     words, [](char c) { return std::string("il ,").find(c) != std::string::npos; })
               : 0;
  const double width = size * ((is_label   ? 0.636
                                : is_point ? 0.72
                                           : 0.75) *
                                   static_cast<double>(letters - narrow) +
                               0.35 * static_cast<double>(narrow));
  const double x = std::stod(text[1]);
  const double y = std::stod(text[2]);
  const std::string anchor = text[4];
  const double before = anchor.find("middle") != std::string::npos ? width / 2
                        : anchor.find("end") != std::string::npos  ? width
                                                                   : 0;
  // Upright it is read from the right.
  if (anchor.find("rotate(-90") != std::string::npos) {
    return {x - 0.73 * size, y + before - width, x, y + before, text[5]};
  }
  return {x - before, y - 0.73 * size, x - before + width, y, text[5]};
}

std::vector<Box> labels_of(const std::string& svg) {
  static const std::regex kText(
      "<text x=\"([^\"]*)\" y=\"([^\"]*)\" class=\"(gs-label|gs-name|gs-point)\" "
      "([^>]*)>([^<]*)</text>");
  std::vector<Box> boxes;
  for (std::sregex_iterator at(svg.begin(), svg.end(), kText), end; at != end; ++at) {
    if (!(*at)[5].str().empty()) boxes.push_back(box_of(*at));
  }
  return boxes;
}

std::string sheet_of(const oracle::Case& test, const report::Path& path, std::uint64_t block = 0) {
  report::Sheet sheet;
  sheet.title = test.id;
  sheet.dialect = test.dialect;
  sheet.lathe = report::is_lathe(test.dialect);
  sheet.reference = &path;
  sheet.limits = report::limits_of_program(test.profile, test.program);
  sheet.block = block;
  return report::svg_sheet(sheet);
}

// With a tap, a chaser, or a mill that goes round.
bool cuts_a_thread(const oracle::Case& test, const report::Path& path) {
  const auto limits = report::limits_of_program(test.profile, test.program);
  return std::ranges::any_of(path.motions, &report::Motion::is_thread) ||
         std::ranges::any_of(
             limits, [](const report::Limit& limit) { return limit.text == "circle of a pass"; });
}

void expect_apart(const std::vector<Box>& boxes, const std::string& where) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      EXPECT_FALSE(boxes[i].meets(boxes[j]))
          << where << ": \"" << boxes[i].text << "\" and \"" << boxes[j].text << '"';
    }
  }
}

TEST(Labels, of_no_drawing_of_a_thread_lie_over_each_other) {
  std::size_t drawn = 0;
  std::size_t named = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    const report::DrawnPath path = report::reference_path(test.profile, test.program);
    if (!cuts_a_thread(test, path.path)) continue;
    ++drawn;
    expect_apart(labels_of(sheet_of(test, path.path)), id);
    for (const report::Names& names : path.path.names) {
      ++named;
      expect_apart(labels_of(sheet_of(test, path.path, names.block)),
                   id + ", block " + std::to_string(names.block));
    }
  }
  EXPECT_GT(drawn, 500U);
  EXPECT_GT(named, 500U);
}

// A traverse from X20 to X40 is one of 10 mm in a record: the scale says what the program does.
TEST(Labels, of_a_lathe_say_diameters) {
  oracle::Case test;
  test.id = "own";
  test.dialect = test.profile.dialect = "gsk988ta";
  test.program = "G00 X20 Z0\nG00 X40 Z-30\nM30\n";
  const report::DrawnPath path = report::reference_path(test.profile, test.program);
  std::vector<std::string> words;
  for (const Box& box : labels_of(sheet_of(test, path.path))) words.push_back(box.text);
  const auto has = [&](const std::string& word) {
    return std::ranges::find(words, word) != words.end();
  };
  EXPECT_TRUE(has("40"));
  EXPECT_TRUE(has("FRONT  Z\xE2\x80\x93\xE2\x8C\x80X")) << words.front();
}

}  // namespace
}  // namespace gonogo::testing
