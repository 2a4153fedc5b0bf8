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
// is 0.93 above and 0.24 below its foot, of which figures take 0.73 and nothing.
Box box_of(const std::smatch& text) {
  const bool is_label = text[3] == "gs-label";
  const double size = is_label ? 10 : 11;
  const std::string words = std::regex_replace(text[5].str(), std::regex("&[a-z#0-9]+;"), "x");
  const auto letters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  const double width = size * (is_label ? 0.636 : 0.75) * static_cast<double>(letters);
  const double x = std::stod(text[1]);
  const double y = std::stod(text[2]);
  const std::string anchor = text[4];
  const double left = anchor.find("middle") != std::string::npos ? x - width / 2
                      : anchor.find("end") != std::string::npos  ? x - width
                                                                 : x;
  return {left, y - 0.73 * size, left + width, y, text[5]};
}

std::vector<Box> labels_of(const std::string& svg) {
  static const std::regex kText(
      "<text x=\"([^\"]*)\" y=\"([^\"]*)\" class=\"(gs-label|gs-name)\" ([^>]*)>([^<]*)</text>");
  std::vector<Box> boxes;
  for (std::sregex_iterator at(svg.begin(), svg.end(), kText), end; at != end; ++at) {
    if (!(*at)[5].str().empty()) boxes.push_back(box_of(*at));
  }
  return boxes;
}

std::string sheet_of(const oracle::Case& test, const report::Path& path) {
  report::Sheet sheet;
  sheet.title = test.id;
  sheet.dialect = test.dialect;
  sheet.lathe = report::is_lathe(test.dialect);
  sheet.reference = &path;
  sheet.limits = report::limits_of_program(test.profile, test.program);
  return report::svg_sheet(sheet);
}

bool cuts_a_thread(const report::Path& path) {
  return std::ranges::any_of(path.motions,
                             [](const report::Motion& one) { return one.kind == "thread"; });
}

TEST(Labels, of_no_drawing_of_a_thread_lie_over_each_other) {
  std::size_t drawn = 0;
  for (const auto& [id, test] : checked_in_cases()) {
    const report::DrawnPath path = report::reference_path(test.profile, test.program);
    if (!cuts_a_thread(path.path)) continue;
    ++drawn;
    const std::vector<Box> boxes = labels_of(sheet_of(test, path.path));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        EXPECT_FALSE(boxes[i].meets(boxes[j]))
            << id << ": \"" << boxes[i].text << "\" and \"" << boxes[j].text << '"';
      }
    }
  }
  EXPECT_GT(drawn, 70U);
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
