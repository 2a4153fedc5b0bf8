// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/rounding_census.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "oracle/records/run_scope.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kNoGrid = RoundingCensus::kFinestDecimals + 1;
constexpr std::array<std::string_view, kRoundingModes> kModeNames = {
    "nearest", "toward zero", "away from zero", "down", "up"};
constexpr std::array<std::string_view, kHalvesRules> kRuleNames = {"away from zero", "toward zero",
                                                                   "to even", "up", "down"};

bool is_whole(const Number& number) {
  return number.is_rational() && number.floor() == number;
}

Number power_of_ten(int exponent) {
  Number power = 1;
  for (int i = 0; i < exponent; ++i) power = power * 10;
  return power;
}

// Of the coarsest grid that the number is on.
int decimals_of(const Number& number) {
  Number steps = number;
  for (int decimals = 0; decimals < kNoGrid; ++decimals, steps = steps * 10) {
    if (is_whole(steps)) return decimals;
  }
  return kNoGrid;
}

// In units of the finest grid, rounded up.
std::int64_t finest_units(const Number& length) {
  const Number units = (length * power_of_ten(RoundingCensus::kFinestDecimals)).ceil();
  return units.to_int64().value_or(std::numeric_limits<std::int64_t>::max());
}

// A value between two of a grid, and the one of them that was taken for it.
struct Rounded {
  bool toward_zero;
  bool up;
  bool is_half;
  bool is_even;  // the one taken
};

bool fits(RoundingMode mode, const Rounded& rounded, bool is_nearest) {
  switch (mode) {
    case RoundingMode::nearest:
      return is_nearest;
    case RoundingMode::toward_zero:
      return rounded.toward_zero;
    case RoundingMode::away_from_zero:
      return !rounded.toward_zero;
    case RoundingMode::down:
      return !rounded.up;
    case RoundingMode::up:
      return rounded.up;
  }
  return false;
}

bool fits(HalvesRule rule, const Rounded& rounded) {
  if (!rounded.is_half) return true;
  switch (rule) {
    case HalvesRule::away_from_zero:
      return !rounded.toward_zero;
    case HalvesRule::toward_zero:
      return rounded.toward_zero;
    case HalvesRule::to_even:
      return rounded.is_even;
    case HalvesRule::up:
      return rounded.up;
    case HalvesRule::down:
      return !rounded.up;
  }
  return false;
}

template <std::size_t N>
void take_least(std::array<std::int8_t, N>& least, const std::array<std::int8_t, N>& other) {
  for (std::size_t i = 0; i < N; ++i) least[i] = std::min(least[i], other[i]);
}

template <std::size_t N>
Json finest_json(const std::array<std::int8_t, N>& finest,
                 const std::array<std::string_view, N>& names, int coarsest) {
  Json object = Json::object();
  for (std::size_t i = 0; i < N; ++i) {
    if (finest[i] < coarsest) continue;
    object[std::string(names[i])] = static_cast<unsigned>(finest[i]);
  }
  return object;
}

// What is not named fits no grid.
template <std::size_t N>
bool read_finest(const Json& object, const std::array<std::string_view, N>& names,
                 std::array<std::int8_t, N>& finest) {
  if (!object.is_object()) return false;
  finest.fill(-1);
  for (const auto& [key, value] : object.items()) {
    const auto* place = std::ranges::find(names, key);
    if (place == names.end() || !value.is_number_unsigned()) return false;
    const auto decimals = value.template get<std::uint64_t>();
    if (decimals > RoundingCensus::kFinestDecimals) return false;
    finest[static_cast<std::size_t>(place - names.begin())] = static_cast<std::int8_t>(decimals);
  }
  return true;
}

bool read_count(const Json& source, const char* key, std::size_t& count) {
  const auto found = source.find(key);
  if (found == source.end()) return true;
  if (!found->is_number_unsigned()) return false;
  count = found->get<std::size_t>();
  return true;
}

}  // namespace

std::string_view name(RoundingMode mode) {
  return kModeNames[static_cast<std::size_t>(mode)];
}

std::string_view name(HalvesRule rule) {
  return kRuleNames[static_cast<std::size_t>(rule)];
}

RoundingCensus::RoundingCensus() {
  modes_.fill(kFinestDecimals);
  halves_.fill(kFinestDecimals);
}

void RoundingCensus::take(const Number& exact, const Number& got, bool correct) {
  try {
    const Number difference = got - exact;
    if (difference.form() == Number::Form::enclosure) {
      // Closer than that nothing tells them apart but bits without end.
      constexpr int kBits = 64;
      const auto [low, high] = difference.bounds(kBits);
      if (low.sign() <= 0 && high.sign() >= 0) {
        ++open_;
        return;
      }
    } else if (difference.sign() == 0) {
      ++exact_;
      return;
    }
    take_rounded(exact, got, difference, correct);
  } catch (const exact::Undecided&) {
    ++open_;
  }
}

void RoundingCensus::take_rounded(const Number& exact, const Number& got, const Number& difference,
                                  bool correct) {
  RoundingCensus one;
  const int decimals = decimals_of(got);
  const Number off = abs(difference);
  one.decimals_ = static_cast<std::int8_t>(decimals);
  one.most_off_ = finest_units(off);
  one.modes_.fill(-1);
  one.halves_.fill(-1);
  Rounded rounded = {};
  rounded.up = difference.sign() > 0;
  rounded.toward_zero = rounded.up == (exact.sign() < 0);
  Number steps = power_of_ten(decimals);
  for (int grid = decimals; grid <= kFinestDecimals; ++grid, steps = steps * 10) {
    const Number increments = off * steps;
    if (increments >= 1) break;
    const int side = Number::compare(increments * 2, 1);
    rounded.is_half = side == 0;
    rounded.is_even = rounded.is_half && is_whole(got * steps / 2);
    for (std::size_t i = 0; i < kRoundingModes; ++i) {
      if (fits(static_cast<RoundingMode>(i), rounded, side <= 0)) {
        one.modes_[i] = static_cast<std::int8_t>(grid);
      }
    }
    for (std::size_t i = 0; i < kHalvesRules && side <= 0; ++i) {
      if (fits(static_cast<HalvesRule>(i), rounded)) {
        one.halves_[i] = static_cast<std::int8_t>(grid);
      }
    }
  }
  ++(correct ? one.correct_ : one.incorrect_);
  add(one);
}

void RoundingCensus::add(const RoundingCensus& other) {
  exact_ += other.exact_;
  correct_ += other.correct_;
  incorrect_ += other.incorrect_;
  open_ += other.open_;
  decimals_ = std::max(decimals_, other.decimals_);
  most_off_ = std::max(most_off_, other.most_off_);
  take_least(modes_, other.modes_);
  take_least(halves_, other.halves_);
}

Number RoundingCensus::increment() const {
  return has_grid() ? Number(1) / power_of_ten(decimals_) : Number(0);
}

std::int64_t RoundingCensus::increments_off() const {
  if (!has_grid()) return 0;
  std::int64_t increment = 1;
  for (int i = decimals_; i < kFinestDecimals; ++i) increment *= 10;
  return most_off_ / increment + (most_off_ % increment == 0 ? 0 : 1);
}

std::vector<RoundingMode> RoundingCensus::modes() const {
  std::vector<RoundingMode> modes;
  for (std::size_t i = 0; has_grid() && i < kRoundingModes; ++i) {
    if (modes_[i] >= decimals_) modes.push_back(static_cast<RoundingMode>(i));
  }
  return modes;
}

std::vector<HalvesRule> RoundingCensus::halves() const {
  std::vector<HalvesRule> rules;
  const auto nearest = static_cast<std::size_t>(RoundingMode::nearest);
  for (std::size_t i = 0; has_grid() && modes_[nearest] >= decimals_ && i < kHalvesRules; ++i) {
    if (halves_[i] >= decimals_) rules.push_back(static_cast<HalvesRule>(i));
  }
  return rules;
}

std::string RoundingCensus::modes_text() const {
  std::vector<std::string> names;
  for (const RoundingMode mode : modes()) {
    names.emplace_back(name(mode));
    const std::vector<HalvesRule> rules = halves();
    if (mode != RoundingMode::nearest || rules.size() == kHalvesRules) continue;
    std::vector<std::string_view> texts;
    for (const HalvesRule rule : rules) texts.push_back(name(rule));
    names.back() += rules.empty() ? " with halves by no one rule"
                                  : fmt::format(" with halves {}", fmt::join(texts, " or "));
  }
  return names.empty() ? "by no one mode" : fmt::format("{}", fmt::join(names, " or "));
}

std::string RoundingCensus::grid_text() const {
  if (has_grid()) {
    return fmt::format("on a grid of {} mm, within {} of it, {}", increment().text(),
                       increments_off(), modes_text());
  }
  const Number most = Number(most_off_) / power_of_ten(kFinestDecimals);
  return fmt::format("on no decimal grid, within {} mm", most.text());
}

std::string RoundingCensus::text() const {
  std::string text = grouped(exact_) + " exact";
  if (open_ != 0) text += fmt::format(", {} of which it cannot be told", grouped(open_));
  if (correct_ != 0) text += fmt::format(", {} correctly rounded", grouped(correct_));
  if (incorrect_ != 0) text += fmt::format(", {} off", grouped(incorrect_));
  return rounded() == 0 ? text : fmt::format("{}; {}", text, grid_text());
}

Json RoundingCensus::json() const {
  Json object = {{"exact", exact_}};
  if (open_ != 0) object["open"] = open_;
  if (rounded() == 0) return object;
  object["correct"] = correct_;
  object["off"] = incorrect_;
  object["most"] = (Number(most_off_) / power_of_ten(kFinestDecimals)).text();
  if (!has_grid()) return object;
  object["decimals"] = static_cast<unsigned>(decimals_);
  object["modes"] = finest_json(modes_, kModeNames, decimals_);
  const std::int8_t nearest = modes_[static_cast<std::size_t>(RoundingMode::nearest)];
  const bool has_halves =
      std::ranges::any_of(halves_, [&](std::int8_t each) { return each != nearest; });
  if (has_halves && nearest >= decimals_) {
    object["halves"] = finest_json(halves_, kRuleNames, decimals_);
  }
  return object;
}

std::optional<RoundingCensus> RoundingCensus::from_json(const Json& source) {
  RoundingCensus census;
  if (!source.is_object() || !read_count(source, "exact", census.exact_) ||
      !read_count(source, "open", census.open_) || !read_count(source, "correct", census.correct_) ||
      !read_count(source, "off", census.incorrect_)) {
    return std::nullopt;
  }
  if (census.rounded() == 0) return census;
  const auto most = source.find("most");
  const auto length = most != source.end() && most->is_string()
                          ? Number::parse(most->get<std::string>())
                          : std::nullopt;
  if (!length || length->sign() < 0) return std::nullopt;
  census.most_off_ = finest_units(*length);
  std::size_t decimals = kNoGrid;
  if (!read_count(source, "decimals", decimals) || decimals > kNoGrid) return std::nullopt;
  census.decimals_ = static_cast<std::int8_t>(decimals);
  census.modes_.fill(-1);
  census.halves_.fill(-1);
  if (!census.has_grid()) return census;
  if (!source.contains("modes") || !read_finest(source["modes"], kModeNames, census.modes_)) {
    return std::nullopt;
  }
  census.halves_.fill(census.modes_[static_cast<std::size_t>(RoundingMode::nearest)]);
  if (source.contains("halves") && !read_finest(source["halves"], kRuleNames, census.halves_)) {
    return std::nullopt;
  }
  return census;
}

}  // namespace gonogo::oracle
