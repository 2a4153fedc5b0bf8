// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/sheet_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "publish/report/escape.hpp"

namespace gonogo::oracle::report {
namespace {

using std::string_view_literals::operator""sv;

// Blue and vermilion keep apart for every kind of colour vision; width and dashes differ as well.
// Traverses have colours of their own, since only their ends are specified; threads a dash.
constexpr std::string_view kStyle = R"css(<style>
.gs-sheet{font-family:"DejaVu Sans","Noto Sans","Segoe UI",Arial,sans-serif;font-size:11px}
.gs-sheet text{fill:var(--gs-ink,#1c2733)}
.gs-sheet path,.gs-sheet rect,.gs-sheet circle{fill:none;vector-effect:non-scaling-stroke}
.gs-sheet .gs-paper{fill:var(--gs-paper,#fff)}
.gs-sheet .gs-border{stroke:var(--gs-ink,#1c2733);stroke-width:1.6}
.gs-sheet .gs-rule{stroke:var(--gs-ink,#1c2733);stroke-width:.8}
.gs-sheet .gs-grid{stroke:var(--gs-grid,#e3e8ee);stroke-width:1}
.gs-sheet .gs-zero{stroke:var(--gs-zero,#aab6c3);stroke-width:1;stroke-dasharray:14 3 3 3}
.gs-sheet .gs-label{fill:var(--gs-faint,#5c6b7a);font-size:10px}
.gs-sheet .gs-name{font-weight:600;letter-spacing:.08em}
.gs-sheet .gs-big{font-size:15px;font-weight:600}
.gs-sheet .gs-axis{stroke:var(--gs-faint,#5c6b7a);stroke-width:1.2}
.gs-sheet .gs-tip{fill:var(--gs-faint,#5c6b7a)}
.gs-sheet .gs-r{stroke:var(--gs-reference,#0072b2);stroke-width:4;stroke-linecap:round;stroke-linejoin:round}
.gs-sheet .gs-s{stroke:var(--gs-subject,#d55e00);stroke-width:1.6;stroke-linecap:round;stroke-linejoin:round}
.gs-sheet .gs-r.gs-feed{opacity:.75}
.gs-sheet .gs-r.gs-rapid{stroke:var(--gs-rapid-reference,#6b4fb0);stroke-dasharray:9 7;stroke-width:2.6}
.gs-sheet .gs-s.gs-rapid{stroke:var(--gs-rapid-subject,#8c5a00);stroke-dasharray:3 5}
.gs-sheet .gs-thread{stroke-linecap:butt}
.gs-sheet .gs-r.gs-thread{opacity:.75;stroke-dasharray:18 3 4 3}
.gs-sheet .gs-s.gs-thread{stroke-dasharray:18 3 4 3}
.gs-sheet .gs-r.gs-head{fill:var(--gs-reference,#0072b2);stroke-width:1}
.gs-sheet .gs-s.gs-head{fill:var(--gs-subject,#d55e00);stroke-width:1}
.gs-sheet .gs-start{stroke:var(--gs-ink,#1c2733);stroke-width:1.6;fill:var(--gs-paper,#fff)}
.gs-sheet .gs-end{stroke:var(--gs-paper,#fff);stroke-width:1}
.gs-sheet .gs-end.gs-r{fill:var(--gs-reference,#0072b2)}
.gs-sheet .gs-end.gs-s{fill:var(--gs-subject,#d55e00)}
.gs-sheet .gs-witness circle,.gs-sheet .gs-witness path{stroke:var(--gs-witness,#a3195b);stroke-width:2}
.gs-sheet .gs-border-line{stroke:var(--gs-limit,#3f7f3f);stroke-width:2}
.gs-sheet .gs-reach{stroke:var(--gs-limit,#3f7f3f);stroke-width:1.1;stroke-dasharray:10 3 2 3}
.gs-sheet path.gs-swept{vector-effect:none;stroke-linecap:round;stroke-linejoin:round}
.gs-sheet .gs-gouged{stroke:var(--gs-gouged,#d64545);opacity:.75}
.gs-sheet path.gs-uncut,.gs-sheet rect.gs-patch-uncut{fill:var(--gs-uncut,#f2c14e)}
.gs-sheet .gs-cut{stroke:var(--gs-cut,#e8edf2)}
.gs-sheet rect.gs-patch-cut{fill:var(--gs-cut,#e8edf2);stroke:var(--gs-zero,#aab6c3)}
.gs-sheet rect.gs-patch-gouged{fill:var(--gs-gouged,#d64545);opacity:.75}
.gs-sheet circle.gs-disc{stroke:var(--gs-witness,#a3195b);stroke-width:1.4;stroke-dasharray:5 4}
.gs-sheet .gs-plane{stroke:var(--gs-limit,#3f7f3f);stroke-width:1;stroke-dasharray:2 4}
.gs-sheet .gs-point{font-weight:700;font-size:12px;fill:var(--gs-limit,#2f6f2f);paint-order:stroke;stroke:var(--gs-paper,#fff);stroke-width:3px;stroke-linejoin:round}
</style>
)css";

double sign_of(const Direction& direction) {
  return direction.x + direction.y + direction.z < 0 ? -1 : 1;
}

// Grid lines across one direction of a view: where they stand on the sheet and what they say.
struct GridLine {
  double at;
  std::string label;
  bool zero;
};

constexpr double kLetterOfLabel = 6.6;  // pixels, the widest
constexpr double kBetweenLabels = 8;

// The width of what labels say, at most.
double room_of_label(std::string_view label) {
  const auto letters = std::ranges::count_if(
      label, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return kLetterOfLabel * static_cast<double>(letters) + kBetweenLabels;
}

std::vector<GridLine> grid_lines_at_least(const View& view, bool vertical, double least_gap) {
  constexpr int kMost = 60;
  const Direction& direction = vertical ? view.up : view.right;
  // The scale of X of a lathe is that of the program: diameters.
  const double times = view.diameters && axis_of(direction) == 'X' ? 2 : 1;
  const double step = svg::nice_step(times * least_gap / view.scale) / times;
  const double middle = vertical ? view.middle_up : view.middle_right;
  const double half = (vertical ? view.field.height : view.field.width) / 2 / view.scale;
  const double first = std::ceil((middle - half) / step);
  std::vector<GridLine> lines;
  for (int i = 0; i < kMost; ++i) {
    const double value = (first + i) * step;
    if (value > middle + half) break;
    const double offset = (value - middle) * view.scale;
    const double at = vertical ? view.field.y + view.field.height / 2 - offset
                               : view.field.x + view.field.width / 2 + offset;
    lines.push_back(
        {at, svg::step_label(sign_of(direction) * value * times, step * times), first + i == 0});
  }
  return lines;
}

// So far apart that no two labels meet.
std::vector<GridLine> grid_lines(const View& view, bool vertical) {
  double gap = 58;  // pixels between two lines
  std::vector<GridLine> lines = grid_lines_at_least(view, vertical, gap);
  double widest = 0;
  for (const GridLine& line : lines) widest = std::max(widest, room_of_label(line.label));
  if (!vertical && widest > gap) lines = grid_lines_at_least(view, vertical, widest);
  return lines;
}

void append_grid(std::string& out, const View& view) {
  const SheetBox& field = view.field;
  const double bottom = field.y + field.height;
  std::string lines;
  std::string zeros;
  std::string labels;
  const bool across = axis_of(view.right) == view.spread_axis;
  const bool upwards = axis_of(view.up) == view.spread_axis;
  for (const GridLine& line : across ? std::vector<GridLine>() : grid_lines(view, false)) {
    svg::append_line(line.zero ? zeros : lines, {line.at, field.y}, {line.at, bottom});
    svg::append_text(labels, {line.at, bottom + 17}, "gs-label", line.label,
                     "text-anchor=\"middle\"");
  }
  for (const GridLine& line : upwards ? std::vector<GridLine>() : grid_lines(view, true)) {
    svg::append_line(line.zero ? zeros : lines, {field.x, line.at},
                     {field.x + field.width, line.at});
    svg::append_text(labels, {field.x - 6, line.at + 3.5}, "gs-label", line.label,
                     "text-anchor=\"end\"");
  }
  out += fmt::format("<path class=\"gs-grid\" d=\"{}\"/>\n<path class=\"gs-zero\" d=\"{}\"/>\n{}",
                     lines, zeros, labels);
}

// An arrow with its axis letter; `dx`, `dy` is a direction on the sheet.
void append_axis(std::string& out, SheetPoint from, double dx, double dy, char letter) {
  const double length = std::hypot(dx, dy);
  if (length < 0.05) return;  // points at the viewer
  constexpr double kLength = 15;
  const SheetPoint tip{from.x + dx * kLength, from.y + dy * kLength};
  const double ux = dx / length;
  const double uy = dy / length;
  out += fmt::format(
      "<path class=\"gs-axis\" d=\"M{} {}L{} {}\"/><path class=\"gs-tip\" d=\"M{} "
      "{}L{} {}L{} {}Z\"/>\n",
      svg::number(from.x), svg::number(from.y), svg::number(tip.x), svg::number(tip.y),
      svg::number(tip.x + ux * 5), svg::number(tip.y + uy * 5),
      svg::number(tip.x - ux * 3 - uy * 3), svg::number(tip.y - uy * 3 + ux * 3),
      svg::number(tip.x - ux * 3 + uy * 3), svg::number(tip.y - uy * 3 - ux * 3));
  svg::append_text(out, {tip.x + ux * 12, tip.y + uy * 12 + 3.5}, "gs-name",
                   std::string_view(&letter, 1), "text-anchor=\"middle\"");
}

// The three axes as this view shows them, beside its title.
void append_axes(std::string& out, const View& view) {
  if (view.shown_axis != 0) return;
  const SheetPoint corner = corner_of_axes(view);
  const std::array<Direction, 3> axes = {Direction{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Direction& axis : axes) {
    if (axis_of(axis) == view.spread_axis) continue;
    const Point3 unit{axis.x, axis.y, axis.z};
    append_axis(out, corner, view.right.of(unit), -view.up.of(unit), axis_of(axis));
  }
}

bool has_threads(const Path* path) {
  return path != nullptr && std::ranges::any_of(path->motions, &Motion::is_thread);
}

// Returns where the next line stands.
double append_legend_lines(std::string& out, const Sheet& sheet, double x, double y) {
  const bool two = sheet.departing != nullptr;
  const bool threads = has_threads(sheet.reference) || has_threads(sheet.departing);
  const double pitch = threads && two ? 13 : 18;
  const auto line = [&](std::string_view style, std::string_view of_two, std::string_view alone) {
    out +=
        fmt::format("<path class=\"{}\" d=\"M{} {}h44\"/>", style, svg::number(x), svg::number(y));
    svg::append_text(out, {x + 54, y + 4}, "gs-text", two ? of_two : alone);
    y += pitch;
  };
  line("gs-r gs-feed", "reference, feed", "feed");
  line("gs-r gs-rapid", "reference, rapid", "rapid");
  if (threads) line("gs-r gs-thread", "reference, thread", "thread");
  if (!two) return y;
  line("gs-s gs-feed", "subject, feed", {});
  line("gs-s gs-rapid", "subject, rapid", {});
  if (threads) line("gs-s gs-thread", "subject, thread", {});
  return y;
}

void append_legend(std::string& out, const Sheet& sheet, double x, double y) {
  const double marks = append_legend_lines(out, sheet, x, y + 16);
  out += fmt::format(
      "<circle class=\"gs-start\" cx=\"{}\" cy=\"{}\" r=\"5\"/>"
      "<rect class=\"gs-end gs-r\" x=\"{}\" y=\"{}\" width=\"7\" height=\"7\"/>",
      svg::number(x + 6), svg::number(marks), svg::number(x + 54), svg::number(marks - 3.5));
  svg::append_text(out, {x + 16, marks + 4}, "gs-text", "start");
  svg::append_text(out, {x + 66, marks + 4}, "gs-text", "end");
  if (!sheet.witness) return;
  out += fmt::format(
      "<g class=\"gs-witness\"><circle cx=\"{0}\" cy=\"{1}\" r=\"5\"/>"
      "<path d=\"M{0} {1}m-9 0h6m6 0h6M{0} {1}m0 -9v6m0 6v6\"/></g>",
      svg::number(x + 108), svg::number(marks));
  svg::append_text(out, {x + 122, marks + 4}, "gs-text", "departure");
}

void append_scale_bar(std::string& out, const Layout& layout, double x, double y) {
  const double step = svg::nice_step(70 / layout.scale) / 2;
  const double width = 2 * step * layout.scale;
  const std::string left = svg::number(x);
  out += fmt::format("<path class=\"gs-rule\" d=\"M{0} {1}v8h{2}v-8m{3} 0v8\"/>", left,
                     svg::number(y), svg::number(width), svg::number(-width / 2));
  svg::append_text(out, {x, y - 5}, "gs-label", "0", "text-anchor=\"middle\"");
  svg::append_text(out, {x + width, y - 5}, "gs-label", svg::step_label(2 * step, step) + " mm",
                   "text-anchor=\"middle\"");
}

// A cone from the side and from its small end, the sign of third-angle projection.
void append_projection_symbol(std::string& out, double x, double y) {
  out += fmt::format(
      "<g transform=\"translate({} {})\"><circle class=\"gs-rule\" cx=\"10\" cy=\"10\""
      " r=\"9\"/><circle class=\"gs-rule\" cx=\"10\" cy=\"10\" r=\"4.5\"/>"
      "<path class=\"gs-rule\" d=\"M28 5.5L50 1V19L28 14.5Z\"/></g>",
      svg::number(x), svg::number(y));
  svg::append_text(out, {x + 60, y + 14}, "gs-text", "third angle");
}

std::string cut_note(const Sheet& sheet) {
  const bool reference = sheet.reference->cut;
  const bool subject = sheet.departing != nullptr && sheet.departing->cut;
  if (!reference && !subject) return {};
  return fmt::format("The {} longer than {} records or segments; the rest is not drawn.",
                     reference && subject ? "paths are"
                     : reference ? (sheet.departing != nullptr ? "reference path is" : "path is")
                                 : "subject path is",
                     kMaxSegments);
}

std::size_t moving(const Path& path) {
  return static_cast<std::size_t>(std::ranges::count_if(path.motions, &Motion::moves));
}

void append_names(std::string& out, const Sheet& sheet, double x, double y) {
  svg::append_text(out, {x, y + 22}, "gs-big", shortened(sheet.title, 46));
  std::string line = "Dialect " + shortened(sheet.dialect, 24);
  if (!sheet.subject.empty()) line += "  \xC2\xB7  Subject " + shortened(sheet.subject, 34);
  svg::append_text(out, {x, y + 42}, "gs-text", line);
  std::string motions = fmt::format("{} motions", moving(*sheet.reference));
  if (sheet.departing != nullptr) {
    motions = fmt::format("Reference {} motions, subject {}{}", moving(*sheet.reference),
                          moving(*sheet.departing),
                          sheet.departing->is_ended() ? ""
                          : sheet.ends_at_departure() ? " up to its departure"
                                                      : " as far as recorded");
  }
  if (!sheet.verdict.empty()) {
    svg::append_text(out, {x, y + 60}, "gs-name", "Verdict " + shortened(sheet.verdict, 40));
  }
  svg::append_text(out, {x, y + 78}, "gs-text", motions);
  svg::append_text(out, {x, y + 95}, "gs-label", cut_note(sheet));
}

}  // namespace

std::string view_title(const View& view) {
  if (view.isometric) return std::string(view.title) + ", own scale";
  if (view.spread_axis != 0) {
    const char shown =
        view.shown_axis != 0
            ? view.shown_axis
            : axis_of(axis_of(view.right) == view.spread_axis ? view.up : view.right);
    if (view.shown_axis != 0) return fmt::format("{}  {}", view.title, shown);
    return fmt::format("{}  {}, motions side by side", view.title, shown);
  }
  std::string names;
  for (const auto& [name, axis] : view.axis_names) {
    if (axis != axis_of(view.right) && axis != axis_of(view.up)) continue;
    names += fmt::format("{}{} = {}", names.empty() ? "  " : ", ", name, axis);
  }
  const auto scale = [&](const Direction& direction) {
    const char axis = axis_of(direction);
    return view.diameters && axis == 'X' ? std::string("\xE2\x8C\x80X") : std::string(1, axis);
  };
  return fmt::format("{}  {}\xE2\x80\x93{}{}", view.title, scale(view.right), scale(view.up),
                     names);
}

std::string_view sheet_style() {
  return kStyle;
}

void append_drawing_head(std::string& out, std::string_view css_class, SheetPoint size,
                         std::string_view title, std::string_view style) {
  out += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{3}\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">\n{4}{5}"
      "<rect class=\"gs-paper\" x=\"0\" y=\"0\" width=\"{0}\" height=\"{1}\"/>\n",
      svg::number(size.x), svg::number(size.y), markup_text("Drawing of " + shortened(title, 80)),
      css_class, kStyle, style);
}

std::string_view style_of(Limit::Kind kind) {
  return kind == Limit::Kind::border ? "gs-border-line" : "gs-reach";
}

void append_limit(std::string& out, const View& view, const Limit& limit) {
  std::string d;
  svg::append_subpath(d, view, limit.points);
  out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style_of(limit.kind), d);
}

void append_view_frame(std::string& out, const View& view) {
  svg::append_text(out, {view.frame.x + 12, view.frame.y + 18}, "gs-name", view_title(view));
  if (!view.isometric) append_grid(out, view);
  append_axes(out, view);
}

void append_blank_note(std::string& out) {
  svg::append_text(out, {kSheetWidth / 2, kDrawingArea.y + kDrawingArea.height / 2}, "gs-big",
                   "Nothing moves.", "text-anchor=\"middle\"");
}

void append_title_block(std::string& out, const Sheet& sheet, const Layout& layout) {
  constexpr double kTop = kSheetHeight - kMargin - kTitleBlock;
  constexpr double kNames = 290;
  constexpr double kScale = 760;
  out += fmt::format("<path class=\"gs-rule\" d=\"M{0} {1}H{2}M{3} {1}V{4}M{5} {1}V{4}\"/>\n",
                     svg::number(kMargin), svg::number(kTop), svg::number(kSheetWidth - kMargin),
                     svg::number(kNames - 16), svg::number(kSheetHeight - kMargin),
                     svg::number(kScale - 16));
  append_legend(out, sheet, kMargin + 14, kTop);
  append_names(out, sheet, kNames, kTop);
  append_scale_bar(out, layout, kScale + 6, kTop + 24);
  append_projection_symbol(out, kScale + 230, kTop + 16);
  svg::append_text(out, {kScale, kTop + 62}, "gs-text",
                   sheet.lathe ? "Millimetres; the scale of X is a diameter."sv
                               : "Millimetres. Base coordinate system."sv);
  svg::append_text(out, {kScale, kTop + 79}, "gs-text", layout.note);
  svg::append_text(out, {kScale, kTop + 95}, "gs-label", "Rapids: only their ends are specified.");
}

}  // namespace gonogo::oracle::report
