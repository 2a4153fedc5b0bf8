// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanding.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace gonogo::reference::testing {
namespace {

std::string axes_text(AxisSet axes, const Position& at) {
  std::string text;
  for (Axis axis : kAllAxes) {
    if (axes.has(axis)) text += fmt::format(" {}{}", letter(axis), at[axis].text());
  }
  return text;
}

std::string feed_text(const Number& feed, FeedMode mode) {
  return fmt::format(" f{}{}", feed.text(), mode == FeedMode::per_revolution ? "/rev" : "");
}

std::string centre_text(const std::array<Number, 2>& centre) {
  return fmt::format(" c{},{}", centre[0].text(), centre[1].text());
}

struct LineOf {
  std::string operator()(const Record& record) const {
    if (record.kind == RecordKind::m) return fmt::format("m{}", record.m);
    if (record.kind == RecordKind::dwell) return "dwell " + record.seconds.text();
    std::string text = std::string(name(record.kind)) + axes_text(record.axes, record.to);
    if (record.kind == RecordKind::thread) {
      return text + fmt::format(" lead{} start{}", record.lead.text(), record.start.text());
    }
    if (record.kind == RecordKind::arc) {
      text += centre_text(record.centre) + fmt::format(" rot{}", record.rot);
    }
    if (record.kind == RecordKind::arc3) text += " via" + axes_text(record.via_axes, record.via);
    if (record.kind == RecordKind::feed || record.kind == RecordKind::arc ||
        record.kind == RecordKind::arc3) {
      text += feed_text(record.feed, record.feed_mode);
    }
    return text;
  }
  std::string operator()(const PocketLevel& level) const {
    return fmt::format("level d{}{} R{} r{} L{} {:+}{}", level.depth.text(),
                       centre_text(level.centre), level.pocket_radius.text(),
                       level.tool_radius.text(), level.step.text(), level.sense,
                       feed_text(level.feed, level.feed_mode));
  }
  // helix d15..-5 c70,35 r4 turns5 -1 f200, `flat` where a flat turn follows.
  std::string operator()(const HelixPocket& pocket) const {
    return fmt::format("helix d{}..{}{} r{} turns{} {:+}{}{}", pocket.r_plane.text(),
                       pocket.bottom.text(), centre_text(pocket.centre), pocket.radius.text(),
                       pocket.turns, pocket.sense, pocket.flat ? " flat" : "",
                       feed_text(pocket.feed, pocket.feed_mode));
  }
  // threads external d15..-5 c0,0 lead5 from18 P1 Q0.5 J2 K30 -1 f900.
  std::string operator()(const ThreadMilling& thread) const {
    return fmt::format("threads {} d{}..{}{} lead{} from{} P{} Q{} J{} K{} {:+}{}",
                       thread.external ? "external" : "internal", thread.r_plane.text(),
                       thread.bottom.text(), centre_text(thread.centre), thread.lead.text(),
                       thread.start_radius.text(), thread.height.text(), thread.infeed.text(),
                       thread.runout_length.text(), thread.runout_angle.text(), thread.sense,
                       feed_text(thread.feed, thread.feed_mode));
  }
  // milling d2..-17 c60,40 60x40 R8 r4 Q4 +1 depth f150 plane f300: where it begins and ends along
  // the depth, the pocket that the tool may touch, R of its corners, r of the tool, the infeed.
  std::string operator()(const PocketMilling& pocket) const {
    return fmt::format("milling d{}..{}{} {}x{} R{} r{} Q{} {:+} depth{} plane{}",
                       pocket.clearance.text(), pocket.floor.text(), centre_text(pocket.centre),
                       pocket.length.text(), pocket.width.text(), pocket.corner_radius.text(),
                       pocket.tool_radius.text(), pocket.infeed.text(), pocket.sense,
                       feed_text(pocket.depth_feed, pocket.feed_mode),
                       feed_text(pocket.plane_feed, pocket.feed_mode));
  }
  std::string operator()(const Renaming& renaming) const {
    return "rename" + axes_text(kEveryAxis, renaming.shift);
  }
  std::string operator()(const AlarmReport& report) const {
    std::string text = fmt::format("alarm b{}", report.block);
    for (const Alarm& alarm : report.alarms) text += fmt::format(" {}", name(alarm.alarm));
    return text;
  }
  std::string operator()(const NotCovered& end) const {
    return fmt::format("not-covered b{} {}", end.block, end.code);
  }
};

struct ClauseOf {
  ClauseId operator()(const Record& record) const { return record.clause; }
  ClauseId operator()(const PocketLevel& level) const { return level.clause; }
  ClauseId operator()(const HelixPocket& pocket) const { return pocket.clause; }
  ClauseId operator()(const ThreadMilling& thread) const { return thread.clause; }
  ClauseId operator()(const PocketMilling& pocket) const { return pocket.clause; }
  ClauseId operator()(const Renaming&) const { return kNoClause; }
  ClauseId operator()(const AlarmReport& report) const { return report.alarms.front().clause; }
  ClauseId operator()(const NotCovered&) const { return kNoClause; }
};

bool is_end(const Item& item) {
  const Record* record = std::get_if<Record>(&item);
  return record != nullptr && record->kind == RecordKind::end;
}

}  // namespace

Number num(std::string_view text) {
  return Number::parse(text).value();
}

Profile profile_with(
    std::initializer_list<std::pair<std::string_view, std::string_view>> readings) {
  Profile profile;
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

std::vector<Item> expand(std::string_view program, const Profile& profile, OpenPaths open_paths) {
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  Expander expander(profile, source, open_paths);
  std::vector<Item> items;
  while (const Item* item = expander.next()) items.push_back(*item);
  return items;
}

std::string line_of(const Item& item) {
  return std::visit(LineOf{}, item);
}

Lines lines(std::string_view program, const Profile& profile, OpenPaths open_paths) {
  Lines text;
  for (const Item& item : expand(program, profile, open_paths)) {
    if (!is_end(item)) text.push_back(line_of(item));
  }
  return text;
}

Lines judged(std::string_view program, const Profile& profile) {
  return lines(program, profile, OpenPaths::judged);
}

Lines lines_after(const std::string& start, const std::string& blocks, const Profile& profile) {
  Lines all = lines(start + "\n" + blocks, profile);
  all.erase(all.begin());
  return all;
}

std::string ending(std::string_view program, const Profile& profile, OpenPaths open_paths) {
  return line_of(expand(program, profile, open_paths).back());
}

Lines clauses_of(std::string_view program, const Profile& profile, OpenPaths open_paths) {
  Lines text;
  for (const Item& item : expand(program, profile, open_paths)) {
    if (!is_end(item)) text.emplace_back(clause_name(std::visit(ClauseOf{}, item)));
  }
  return text;
}

Lines admitted_classes_of(std::string_view program, const Profile& profile) {
  Lines classes;
  for (const Item& item : expand(program, profile)) {
    const auto* report = std::get_if<AlarmReport>(&item);
    if (report == nullptr) continue;
    for (const AdmittedClass& one : admitted_classes(*report)) {
      classes.emplace_back(name(one.alarm));
    }
  }
  return classes;
}

Lines touched_readings(std::string_view program, const Profile& profile, OpenPaths open_paths) {
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  Expander expander(profile, source, open_paths);
  while (expander.next() != nullptr) {
  }
  Lines names;
  for (ReadingKey key : expander.readings().touched()) names.emplace_back(reading(key).name);
  return names;
}

}  // namespace gonogo::reference::testing
