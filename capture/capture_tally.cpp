// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "capture/export_manifest.hpp"
#include "oracle/records/gap_reason.hpp"

namespace gonogo::oracle {
namespace {

using reference::Number;
constexpr std::size_t kNamed = 10;

std::string text_in(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Number number_in(const nlohmann::json& object, const char* key) {
  return Number::parse(text_in(object, key)).value_or(Number(0));
}

std::string listed(const std::set<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (count == kNamed) return text + fmt::format(" and {} more", names.size() - kNamed);
    text += fmt::format("{}{}", count++ == 0 ? "" : ", ", name);
  }
  return text;
}

// 1, 2, 5, 10, ... by 1e-4 mm, up to 1 mm.
std::vector<Number> round_tolerances() {
  std::vector<Number> steps;
  for (std::int64_t decade = 100; decade < 1'000'000; decade *= 10) {
    for (const int digit : {1, 2, 5}) steps.push_back(Number::millionths(decade * digit));
  }
  steps.emplace_back(1);
  return steps;
}

}  // namespace

void CaptureTally::take(const std::string& line) {
  const nlohmann::json entry = nlohmann::json::parse(line);
  const std::string id = text_in(entry, "id");
  const std::string verdict = text_in(entry, "verdict");
  if (verdict == "skip" && text_in(entry, "feature") == "capture") {
    missing_.insert(id);
    return;
  }
  if (verdict != "skip") judged_.insert(id);
  const auto found = entry.find("sampled");
  if (found == entry.end()) return;
  noise_ = max(noise_, number_in(*found, "noise"));
  following_ = max(following_, number_in(*found, "following"));
  const bool of_the_path = verdict == "fail.geometry" || verdict == "fail.order" ||
                           verdict == "fail.overrun" || verdict == "oracle-gap";
  longest_ = max(longest_, number_in(*found, "longest"));
  unseen_ = max(unseen_, number_in(*found, "unseen"));
  if (text_in(entry, "gap") == name(GapReason::samples_hole)) ++with_holes_;
  if (found->contains("worst")) {
    const Number worst = number_in(*found, "worst");
    go_from_.push_back(worst);
    if (worst > worst_ || worst_where_.empty()) {
      worst_ = worst;
      const std::string place =
          found->contains("b") ? fmt::format("line {} of ", found->value("b", 0)) : "";
      worst_where_ = found->contains("at") ? place + id : "no sample is off the path";
    }
  } else if (found->contains("go_from")) {
    go_from_.push_back(number_in(*found, "go_from"));
    if (verdict == "oracle-gap") ++too_fine_;
  } else if (of_the_path && verdict != "oracle-gap") {
    ++never_;
  }
}

std::size_t CaptureTally::go_at(const Number& tolerance) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(go_from_, [&](const Number& from) { return from <= tolerance; }));
}

std::optional<Number> CaptureTally::suggested_tolerance() const {
  const std::size_t all = go_from_.size() + never_;
  for (const Number& step : round_tolerances()) {
    if (step * 2 >= noise_ * 3 && go_at(step) * 10 >= all * 9) return step;
  }
  return std::nullopt;
}

std::string CaptureTally::text() const {
  const std::size_t all = go_from_.size() + never_;
  const std::string holes =
      with_holes_ == 0
          ? ""
          : fmt::format("  {} cases are undecided: their samples have holes\n", with_holes_);
  if (all == 0) return holes;
  std::string text = holes;
  text += fmt::format(
      "  samples: they scatter by up to {} mm and stay up to {} mm off the path at constant speed "
      "(estimates)\n",
      noise_.text(), following_.text());
  text += fmt::format(
      "  up to {} s pass between two: {} mm away from the path and back would not be seen\n",
      longest_.text(), unseen_.text());
  if (!worst_where_.empty()) {
    text += fmt::format("  worst deviation of a GO: {} mm, {}\n", worst_.text(), worst_where_);
  }
  std::size_t before = all + 1;
  for (const Number& step : round_tolerances()) {
    const std::size_t count = go_at(step);
    if (count == before || count == 0) continue;
    text += fmt::format("  with a tolerance of {} mm: the path of {} of {} cases is GO\n",
                        step.text(), count, all);
    before = count;
  }
  if (too_fine_ > 0) {
    text += fmt::format("  {} cases are undecided: the tolerance is finer than their samples are\n",
                        too_fine_);
  }
  if (const auto suggested = suggested_tolerance()) {
    text += fmt::format("  suggested: --tolerance {}\n", suggested->text());
  }
  return text;
}

std::string CaptureTally::files_text(
    const std::string& folder, const std::string& manifest,
    const std::function<std::set<std::string>()>& all_cases) const {
  namespace fs = std::filesystem;
  std::set<std::string> stems;
  std::set<std::string> missing = missing_;
  const fs::path own = fs::path(folder) / "manifest.json";
  if (!manifest.empty() || fs::exists(own)) {
    const auto programs = read_export_manifest(manifest.empty() ? own.string() : manifest);
    for (const auto& [id, program] : programs) stems.insert(program.stem);
    // What was not exported could not come back.
    std::erase_if(missing, [&](const std::string& id) { return !programs.contains(id); });
  }
  std::set<std::string> strangers;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    const std::string stem = entry.path().stem().string();
    const bool is_log = ending == ".csv" || ending == ".jsonl";
    if (is_log && !judged_.contains(stem) && !stems.contains(stem)) {
      strangers.insert(entry.path().filename().string());
    }
  }
  if (!strangers.empty()) {
    const std::set<std::string> cases = all_cases();
    std::erase_if(strangers, [&](const std::string& name) {
      return cases.contains(fs::path(name).stem().string());
    });
  }
  std::string text;
  if (!strangers.empty()) {
    text += fmt::format("  files that belong to no case: {}\n", listed(strangers));
  }
  if (!missing.empty()) {
    text += fmt::format("  cases without a file: {}: {}\n", missing.size(), listed(missing));
  }
  return text;
}

}  // namespace gonogo::oracle
