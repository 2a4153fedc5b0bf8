// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "publish/report/figure_parts.hpp"
#include "publish/report/sheet_parts.hpp"
#include "publish/report/sheet_paths.hpp"
#include "publish/report/svg.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {
namespace {

// Pixels.
constexpr double kWidth = 860;
constexpr double kEdge = 4;
constexpr double kLetterOfLegend = 7.6;  // of the legend, at most
constexpr double kRow = 24;
constexpr double kManyViews = 640;  // height of a figure of four views

constexpr std::string_view kFigureStyle = R"css(<style>
.gs-figure{font-size:13px}
.gs-figure .gs-label{font-size:12px}
.gs-figure .gs-number{font-size:13px;font-weight:700;paint-order:stroke;stroke:var(--gs-paper,#fff);stroke-width:4px;stroke-linejoin:round}
.gs-figure .gs-border-line{stroke:var(--gs-limit,#3f7f3f);stroke-width:2}
.gs-figure .gs-reach{stroke:var(--gs-limit,#3f7f3f);stroke-width:1.3;stroke-dasharray:10 3 2 3}
</style>
)css";

bool has(const Path* path, std::string_view style) {
  return path != nullptr && std::ranges::any_of(path->motions, [style](const Motion& motion) {
           return motion.moves() && style_of(motion) == style;
         });
}

// The lines of the legend, broken where a row is full.
class Legend {
 public:
  explicit Legend(double top) : top_(top) {}

  void line(std::string_view style, std::string_view text) {
    const SheetPoint at = take(50 + kLetterOfLegend * static_cast<double>(text.size()));
    out_ += fmt::format("<path class=\"{}\" d=\"M{} {}h36\"/>", style, svg::number(at.x),
                        svg::number(at.y));
    svg::append_text(out_, {at.x + 44, at.y + 4.5}, "gs-text", text);
  }
  void marks() {
    const SheetPoint at = take(140);
    out_ += fmt::format(
        "<circle class=\"gs-start\" cx=\"{}\" cy=\"{}\" r=\"5\"/>"
        "<rect class=\"gs-end gs-r\" x=\"{}\" y=\"{}\" width=\"7\" height=\"7\"/>",
        svg::number(at.x + 6), svg::number(at.y), svg::number(at.x + 62), svg::number(at.y - 3.5));
    svg::append_text(out_, {at.x + 17, at.y + 4.5}, "gs-text", "start");
    svg::append_text(out_, {at.x + 75, at.y + 4.5}, "gs-text", "end");
  }
  void text(std::string_view words) {
    const SheetPoint at = take(kLetterOfLegend * static_cast<double>(words.size()));
    svg::append_text(out_, {at.x, at.y + 4.5}, "gs-text", words);
  }
  const std::string& svg() const { return out_; }
  double bottom() const { return top_ + kRow * (row_ + 1) + 4; }

 private:
  SheetPoint take(double width) {
    if (x_ > kFirst && x_ + width > kWidth - kFirst) {
      x_ = kFirst;
      row_ += 1;
    }
    const SheetPoint at{x_, top_ + kRow * (row_ + 0.5)};
    x_ += width + 14;
    return at;
  }

  static constexpr double kFirst = 16;
  double top_;
  double x_ = kFirst;
  double row_ = 0;
  std::string out_;
};

void append_path_lines(Legend& legend, const Path* path, const std::string& owner,
                       const std::string& name) {
  const std::string before = name.empty() ? "" : name + ", ";
  bool moves = false;
  for (const std::string_view kind : {"feed", "rapid", "thread"}) {
    const std::string style = fmt::format("gs-{}", kind);
    if (!has(path, style)) continue;
    legend.line(owner + " " + style, before + std::string(kind));
    moves = true;
  }
  if (!moves) legend.text(name + ": nothing moves here");
}

Legend legend_of(const Figure& figure, double top) {
  Legend legend(top);
  append_path_lines(legend, figure.path, "gs-r", figure.path_name);
  if (figure.other != nullptr) append_path_lines(legend, figure.other, "gs-s", figure.other_name);
  for (auto limit = figure.limits.begin(); limit != figure.limits.end(); ++limit) {
    const auto earlier = std::find_if(figure.limits.begin(), limit, [&](const Limit& other) {
      return other.text == limit->text;
    });
    if (earlier == limit) legend.line(style_of(limit->kind), limit->text);
  }
  legend.marks();
  legend.text(figure.lathe ? "mm, X as a radius" : "mm");
  return legend;
}

Extent extent_of(const Figure& figure) {
  Extent extent = extent_of_paths({figure.path, figure.other});
  for (const Limit& limit : figure.limits) {
    for (const Point3& point : limit.points) extent.include(point);
  }
  return extent;
}

// As high as the drawing needs, within what a page can take.
double height_for(const Layout& layout, const Extent& extent) {
  if (layout.views.size() > 1) return kManyViews;
  const View& view = layout.views.front();
  const Point3 span = extent.span();
  const double right = std::fabs(view.right.of(span));
  const double up = std::fabs(view.up.of(span));
  const double wanted = right > 0 ? up / right * view.field.width : kManyViews;
  return std::clamp(wanted, 150.0, 420.0) + 70;
}

void append_view(std::string& out, const View& view, const Figure& figure) {
  out += fmt::format("<g data-view=\"{}\">\n", view.key);
  append_view_frame(out, view);
  for (const Limit& limit : figure.limits) append_limit(out, view, limit);
  append_path(out, view, *figure.path, 'r');
  if (figure.other != nullptr) append_path(out, view, *figure.other, 's');
  for (const Path* path : {figure.path, figure.other}) {
    if (path != nullptr) append_start(out, view, *path);
  }
  append_end(out, view, *figure.path, 'r');
  if (figure.other != nullptr) append_end(out, view, *figure.other, 's');
  out += "</g>\n";
}

bool still(const Extent& extent) {
  const Point3 span = extent.span();
  return extent.empty() || (span.x < kStill && span.y < kStill && span.z < kStill);
}

std::string draw(const Figure& figure, const Extent& extent, char spread_axis) {
  SheetBox area{kEdge + 4, kEdge + 4, kWidth - 2 * (kEdge + 4), kManyViews};
  area.height = height_for(lay_out(extent, figure.lathe, area), extent);
  Layout layout = lay_out(extent, figure.lathe, area);
  for (View& view : layout.views) view.spread_axis = spread_axis;
  const double rule = area.y + area.height + 6;
  const Legend legend = legend_of(figure, rule + 4);
  std::string out;
  append_drawing_head(out, "gs-sheet gs-figure", {kWidth, legend.bottom() + kEdge}, figure.title,
                      kFigureStyle);
  for (const View& view : layout.views) append_view(out, view, figure);
  if (figure.other == nullptr) append_numbers(out, layout.views.back(), *figure.path);
  out += fmt::format("<path class=\"gs-rule\" d=\"M{} {}H{}\"/>\n{}", svg::number(kEdge),
                     svg::number(rule), svg::number(kWidth - kEdge), legend.svg());
  out += fmt::format(
      "<rect class=\"gs-border\" x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\"/>\n</svg>\n",
      svg::number(kEdge - 0.5), svg::number(kWidth - 2 * kEdge + 1),
      svg::number(legend.bottom() - kEdge + 1));
  return out;
}

}  // namespace

std::vector<std::size_t> motion_numbers(const Path& path) {
  std::vector<std::size_t> numbers(path.motions.size(), 0);
  std::size_t last = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (path.motions[i].moves()) numbers[i] = ++last;
  }
  if (last > kMostNumbered) std::ranges::fill(numbers, 0);
  return numbers;
}

std::string svg_figure(const Figure& figure) {
  const Extent extent = extent_of(figure);
  if (still(extent)) return {};
  const std::optional<Spread> spread = spread_for(extent, figure.lathe);
  if (!spread) return draw(figure, extent, 0);
  Figure wide = figure;
  const Path path = spread_out(*figure.path, *spread);
  const Path other = figure.other != nullptr ? spread_out(*figure.other, *spread) : Path();
  wide.path = &path;
  if (figure.other != nullptr) wide.other = &other;
  return draw(wide, extent_of(wide), spread->axis);
}

}  // namespace gonogo::oracle::report
