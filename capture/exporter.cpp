// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/exporter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "capture/expected_paths.hpp"
#include "capture/number_json.hpp"
#include "oracle/records/output_file.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using reference::Axis;

constexpr auto kReasons = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"other-set-up", "The case needs the machine set up otherwise; --all-profiles exports it."},
    {"outside-envelope", "The path leaves the envelope."},
    {"feed-above-max", "A feed is above --feed-max."},
    {"feed-per-revolution",
     "A feed is per revolution: without a spindle speed it has no bound in mm/min, and --feed-max "
     "was given."},
    {"thread",
     "A thread is cut at the spindle's speed, which has no bound in mm/min, and "
     "--feed-max was given."},
    {"not-covered", "The gauge does not read all of the program, so that its path is not known."},
    {"header-changes-meaning",
     "No header was found that leads to the initial position and leaves the program's meaning as "
     "it is."},
    {"start-on-spindle-axis",
     "The program starts at X0 or beyond it, and the header would traverse to the spindle's axis. "
     "Set a work offset that puts X0 at a safe radius, and say which with --x-zero-at."},
    {"undecided", "Whether the path lies inside the envelope could not be decided."},
    {"too-many-readings", "The program leaves too many readings open to bound its path."},
});

Json box_json(const Extents& extents) {
  Json box = Json::object();
  for (Axis axis : reference::kAllAxes) {
    box[std::string(1, letter(axis))] = {json_of(extents.low[axis]), json_of(extents.high[axis])};
  }
  return box;
}

// The keys of a profile that say how the machine is set up: not where a program starts, which its
// header sees to, and not how the manual is read.
Json set_up_of(const reference::Profile& profile) {
  Json keys = Json::parse(reference::profile_json(profile));
  keys.erase("readings");
  keys.erase("alarm_timing");
  if (keys.contains("initial")) {
    for (const char* key : {"x", "y", "z", "a", "c", "f", "plane", "motion"}) {
      keys["initial"].erase(key);
    }
    if (keys["initial"].empty()) keys.erase("initial");
  }
  return keys;
}

}  // namespace

std::string_view Exporter::obstacle(const Case& test, const Extents& extents) const {
  if (extents.not_covered) return "not-covered";
  if (reference::find_dialect(test.dialect)->lathe &&
      test.profile.initial.at[Axis::x] + options_.x_zero_at.value_or(Number(0)) <= 0) {
    return "start-on-spindle-axis";
  }
  if (options_.envelope) {
    for (Axis axis : reference::kLinearAxes) {
      const auto& [low, high] = (*options_.envelope)[reference::index(axis)];
      if (extents.low[axis] < low || extents.high[axis] > high) return "outside-envelope";
    }
  }
  if (options_.feed_max) {
    if (extents.largest_feed > *options_.feed_max) return "feed-above-max";
    if (extents.per_revolution) return "feed-per-revolution";
    if (extents.threads) return "thread";
  }
  return {};
}

void Exporter::write(const Case& test, const Extents& extents, const ExportHeader& header,
                     const Json& set_up) {
  const std::string file = fmt::format("{:04}.nc", programs_.size() + 1);
  write_file(folder_ / file, options_.header + header.text + test.program);
  Json entry;
  entry["file"] = file;
  entry["id"] = test.id;
  entry["comes_back_as"] = {test.id + ".jsonl", test.id + ".csv"};
  entry["dialect"] = test.dialect;
  entry["profile"] = Json::parse(reference::profile_json(test.profile));
  entry["set_up"] = set_up;
  entry["header_lines"] = header_lines_ + header.lines;
  entry["start"] = Json::object();
  for (Axis axis : reference::kAllAxes) {
    if (!header.axes.has(axis)) continue;
    entry["start"][std::string(1, letter(axis))] = test.profile.initial.at[axis].text();
  }
  entry["extents"] = box_json(extents);
  entry["largest_feed"] = json_of(extents.largest_feed);
  entry["feed_per_revolution"] = extents.per_revolution;
  entry["thread"] = extents.threads;
  entry["alarms"] = extents.alarms;
  if (options_.expected) {
    Json line = {{"id", test.id}, {"file", file}, {"header_lines", entry["header_lines"]}};
    expected_ += line.dump();
    expected_.back() = ',';
    expected_ += fmt::format("\"expected\":{}}}\n", expected_paths(test.profile, test.program));
  }
  programs_.push_back(std::move(entry));
  if (extents.alarms) ++alarms_;
  ++set_ups_[fmt::format("{} {}", test.dialect, set_up.dump())];
}

Json Exporter::manifest() const {
  Json json;
  json["format"] = 1;
  json["gonogo"] = title_.gonogo;
  json["corpus"] = {{"version", title_.corpus_version}, {"sha256", title_.corpus_sha256}};
  json["units"] = "mm as true lengths (X of a lathe as a radius), degrees, mm/min, seconds";
  if (options_.envelope) {
    for (Axis axis : reference::kLinearAxes) {
      const auto& [low, high] = (*options_.envelope)[reference::index(axis)];
      json["envelope"][std::string(1, letter(axis))] = {low.text(), high.text()};
    }
  }
  if (options_.feed_max) json["feed_max"] = options_.feed_max->text();
  if (options_.x_zero_at) json["x_zero_at"] = options_.x_zero_at->text();
  json["header_file_lines"] = header_lines_;
  json["warning"] =
      "Programs with \"alarms\": true break a rule on purpose. A controller that does not alarm "
      "goes on, and neither the extents nor the feed say where to.";
  json["set_ups"] = Json::array();
  for (const auto& [key, count] : set_ups_) {
    const std::size_t space = key.find(' ');
    json["set_ups"].push_back({{"dialect", key.substr(0, space)},
                               {"set", Json::parse(key.substr(space + 1))},
                               {"programs", count}});
  }
  json["left_out"] = Json::array();
  for (const auto& [reason, sentence] : kReasons) {
    const auto found = left_out_.find(std::string(reason));
    if (found == left_out_.end()) continue;
    json["left_out"].push_back({{"reason", reason},
                                {"sentence", sentence},
                                {"count", found->second.size()},
                                {"ids", found->second}});
  }
  json["programs"] = programs_;
  return json;
}

Exporter::Exporter(std::string folder, ExportOptions options, ExportTitle title)
    : folder_(std::move(folder)), options_(std::move(options)), title_(std::move(title)) {
  std::string& header = options_.header;
  if (!header.empty() && header.back() != '\n') header += '\n';
  header_lines_ = static_cast<std::uint64_t>(std::ranges::count(header, '\n'));
  fs::create_directories(folder_);
  if (!fs::is_empty(folder_)) {
    throw std::runtime_error(
        fmt::format("The folder {} is not empty. Name a new one.", folder_.string()));
  }
}

void Exporter::add(const Case& test) {
  ++cases_;
  auto leave_out = [&](std::string_view reason) {
    left_out_[std::string(reason)].push_back(test.id);
  };
  const Json set_up = set_up_of(test.profile);
  if (!set_up.empty() && !options_.all_profiles) return leave_out("other-set-up");
  try {
    const std::optional<Extents> extents = extents_of(test.profile, test.program);
    if (!extents) return leave_out("too-many-readings");
    const std::string_view reason = obstacle(test, *extents);
    if (!reason.empty()) return leave_out(reason);
    const auto header = export_header(test.profile, test.program, extents->moved);
    if (!header) return leave_out("header-changes-meaning");
    write(test, *extents, *header, set_up);
  } catch (const exact::Undecided&) {
    leave_out("undecided");
  }
}

std::string Exporter::finish() {
  write_file(folder_ / "manifest.json", manifest().dump(1) + "\n");
  if (options_.expected) {
    write_file(folder_ / "expected.jsonl", expected_);
    write_file(folder_ / "compare.py", std::string(kComparer));
  }
  std::string text =
      fmt::format("{} of {} cases exported to {}\n", programs_.size(), cases_, folder_.string());
  for (const auto& [reason, sentence] : kReasons) {
    const auto found = left_out_.find(std::string(reason));
    if (found == left_out_.end()) continue;
    text += fmt::format("left out: {:>6}  {}: {}\n", found->second.size(), reason, sentence);
  }
  for (const auto& [key, count] : set_ups_) {
    if (!key.ends_with("{}")) text += fmt::format("set-up:   {:>6}  {}\n", count, key);
  }
  if (alarms_ > 0) {
    text += fmt::format(
        "{} programs break a rule on purpose: a controller that does not alarm goes on, and where "
        "to is not bounded.\n",
        alarms_);
  }
  return text;
}

std::optional<std::array<std::array<Number, 2>, 3>> envelope_of(const std::string& text) {
  std::array<std::array<Number, 2>, 3> envelope;
  std::string_view rest = text;
  for (std::size_t i = 0; i < envelope.size(); ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == envelope.size())) return std::nullopt;
    const std::string_view range = rest.substr(0, comma);
    const std::size_t dots = range.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const auto low = Number::parse(range.substr(0, dots));
    const auto high = Number::parse(range.substr(dots + 2));
    if (!low || !high || *high < *low) return std::nullopt;
    envelope[i] = {*low, *high};
    if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
  }
  return envelope;
}

}  // namespace gonogo::oracle
