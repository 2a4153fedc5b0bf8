// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/sheet.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "publish/report/views.hpp"
#include "tests/publish/report/report_testing.hpp"

namespace gonogo::oracle::report {
namespace {

// Whether every element is closed in order and no '<' or '&' stands loose: enough XML for texts
// that we write ourselves.
bool well_formed(const std::string& text) {
  static const std::regex tag(R"rx(<(/?)([a-z]+)((?: [a-zA-Z:-]+="[^"<]*")*) ?(/?)>)rx");
  std::vector<std::string> open;
  std::size_t at = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const auto place = static_cast<std::size_t>(it->position());
    if (text.substr(at, place - at).find('<') != std::string::npos) return false;
    at = place + static_cast<std::size_t>(it->length());
    if (it->str(4) == "/") continue;
    if (it->str(1).empty()) {
      open.push_back(it->str(2));
    } else if (open.empty() || open.back() != it->str(2)) {
      return false;
    } else {
      open.pop_back();
    }
  }
  static const std::regex loose("&(?!amp;|lt;|gt;|quot;|#39;)");
  return at > 0 && open.empty() && text.find('<', at) == std::string::npos &&
         !std::regex_search(text, loose);
}

Path box_path() {
  return {{line({0, 0, 0}, {40, 0, 0}, true), line({40, 0, 0}, {40, 30, 0}),
           line({40, 30, 0}, {40, 30, -20})}};
}

Sheet sheet_of(const Path& path) {
  Sheet sheet;
  sheet.title = "O0001";
  sheet.dialect = "gsk988ta";
  sheet.reference = &path;
  return sheet;
}

const SheetBox kArea{0, 0, 1000, 700};

TEST(LayOut, third_angle_sets_top_above_and_right_side_beside_the_front_view) {
  const Layout layout = lay_out({{0, 0, 0}, {40, 30, 20}}, false, kArea);
  ASSERT_EQ(layout.views.size(), 4U);
  const View& front = layout.views[0];
  const View& top = layout.views[1];
  const View& side = layout.views[2];
  EXPECT_LT(top.frame.y, front.frame.y);
  EXPECT_GT(side.frame.x, front.frame.x);
  const Point3 corner{40, 30, 20};
  EXPECT_NEAR(front.place(corner).x, top.place(corner).x, 1e-9);   // aligned on the first axis
  EXPECT_NEAR(front.place(corner).y, side.place(corner).y, 1e-9);  // aligned on the height
}

// From the right, with Z up, Y goes to the right; from above Y goes up.
TEST(LayOut, machine_axes_point_as_in_a_drawing) {
  const Layout layout = lay_out({{0, 0, 0}, {40, 30, 20}}, false, kArea);
  const Point3 origin{0, 0, 0};
  const Point3 y{0, 30, 0};
  EXPECT_LT(layout.views[1].place(y).y, layout.views[1].place(origin).y);
  EXPECT_GT(layout.views[2].place(y).x, layout.views[2].place(origin).x);
}

// A lathe's front view looks from +Y (Z right, X up), so that its G02 turns clockwise on paper; Y
// then comes towards the viewer: down in the top view, left in the view from +Z.
TEST(LayOut, a_lathe_shows_z_to_the_right_and_x_up) {
  const Layout layout = lay_out({{0, 0, 0}, {40, 30, 20}}, true, kArea);
  const Point3 origin{0, 0, 0};
  EXPECT_GT(layout.views[0].place({0, 0, 20}).x, layout.views[0].place(origin).x);
  EXPECT_LT(layout.views[0].place({40, 0, 0}).y, layout.views[0].place(origin).y);
  EXPECT_GT(layout.views[1].place({0, 30, 0}).y, layout.views[1].place(origin).y);
  EXPECT_LT(layout.views[2].place({0, 30, 0}).x, layout.views[2].place(origin).x);
}

TEST(LayOut, everything_lies_in_its_field) {
  for (const Point3& size : {Point3{400, 3, 20}, {1, 500, 2}, {1e-3, 7, 9e5}, {5, 5, 5}}) {
    for (const View& view : lay_out({{0, 0, 0}, size}, false, kArea).views) {
      for (const Point3& point : {Point3{0, 0, 0}, size, {size.x, 0, 0}, {0, size.y, size.z}}) {
        const SheetPoint at = view.place(point);
        EXPECT_GE(at.x, view.field.x - 1e-6) << view.title;
        EXPECT_LE(at.x, view.field.x + view.field.width + 1e-6) << view.title;
        EXPECT_GE(at.y, view.field.y - 1e-6) << view.title;
        EXPECT_LE(at.y, view.field.y + view.field.height + 1e-6) << view.title;
      }
    }
  }
}

TEST(LayOut, two_axes_need_one_view) {
  const Layout layout = lay_out({{0, 0, 0}, {20, 0, 50}}, true, kArea);
  ASSERT_EQ(layout.views.size(), 1U);
  EXPECT_EQ(layout.note, "Y does not move: one view shows everything.");
}

TEST(SvgSheet, is_well_formed_with_one_path) {
  const Path path = box_path();
  EXPECT_TRUE(well_formed(svg_sheet(sheet_of(path))));
}

TEST(SvgSheet, is_well_formed_with_two_paths_and_a_witness) {
  const Path path = box_path();
  Sheet sheet = sheet_of(path);
  sheet.departing = &path;
  sheet.verdict = "fail.geometry";
  sheet.witness = Point3{40, 30, -25};
  const std::string svg = svg_sheet(sheet);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(occurrences(svg, "<g class=\"gs-witness\">"), 5U);  // four views and the legend
}

TEST(SvgSheet, is_well_formed_without_motion) {
  const Path path;
  const std::string svg = svg_sheet(sheet_of(path));
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(occurrences(svg, "Nothing moves."), 1U);
}

TEST(SvgSheet, texts_cannot_become_markup) {
  const Path path = box_path();
  Sheet sheet = sheet_of(path);
  sheet.title = "</text><script>alert(1)</script>";
  sheet.subject = "\" onload=\"x";
  const std::string svg = svg_sheet(sheet);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(SvgSheet, rapids_and_feeds_are_drawn_in_each_view_with_their_records) {
  const Path path = box_path();
  const std::string svg = svg_sheet(sheet_of(path));
  EXPECT_EQ(occurrences(svg, "class=\"gs-r gs-rapid\" data-p=\"r\" data-m=\"0\""), 4U);
  EXPECT_EQ(occurrences(svg, "class=\"gs-r gs-feed\" data-p=\"r\" data-m=\"1-2\""), 4U);
}

// 300 feeds in chunks of 128, in each of the one view's elements: 128, 128 and 44.
TEST(SvgSheet, long_paths_are_split_into_elements_that_browsers_draw_quickly) {
  Path path;
  for (int i = 0; i < 300; ++i) {
    path.motions.push_back(line({0, 0, 1.0 * i}, {1.0 * (i % 2), 0, 1.0 * i + 1}));
  }
  const std::string svg = svg_sheet(sheet_of(path));
  EXPECT_EQ(occurrences(svg, "data-m=\"0-127\""), 1U);
  EXPECT_EQ(occurrences(svg, "data-m=\"128-255\""), 1U);
  EXPECT_EQ(occurrences(svg, "data-m=\"256-299\""), 1U);
}

TEST(SvgSheet, says_when_the_path_is_cut) {
  Path path = box_path();
  EXPECT_EQ(occurrences(svg_sheet(sheet_of(path)), "is not drawn"), 0U);
  path.cut = true;
  EXPECT_EQ(occurrences(svg_sheet(sheet_of(path)), "20000 records or segments"), 1U);
}

}  // namespace
}  // namespace gonogo::oracle::report
