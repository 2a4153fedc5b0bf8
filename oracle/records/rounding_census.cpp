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

constexpr int kFinest = RoundedCoordinates::kFinestDecimals;
constexpr int kNoGrid = kFinest + 1;
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

// The decimals of the coarsest grid that the number is on.
int decimals_of(const Number& number) {
  Number steps = number;
  for (int decimals = 0; decimals < kNoGrid; ++decimals, steps = steps * 10) {
    if (is_whole(steps)) return decimals;
  }
  return kNoGrid;
}

// In units of the finest grid, rounded up.
std::int64_t finest_units(const Number& length) {
  const Number units = (length * power_of_ten(kFinest)).ceil();
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
    if (decimals > kFinest) return false;
    finest[static_cast<std::size_t>(place - names.begin())] = static_cast<std::int8_t>(decimals);
  }
  return true;
}

// False where it is no count; one that is not there is left as it is.
bool read_count(const Json& source, const char* key, std::size_t& count) {
  const auto found = source.find(key);
  if (found == source.end()) return true;
  if (!found->is_number_unsigned()) return false;
  count = found->get<std::size_t>();
  return true;
}

bool read_part(const Json& source, const char* key, RoundedCoordinates& part) {
  const auto found = source.find(key);
  if (found == source.end()) return true;
  const auto read = RoundedCoordinates::from_json(*found);
  if (read) part = *read;
  return read.has_value();
}

}  // namespace

std::string_view name(RoundingMode mode) {
  return kModeNames[static_cast<std::size_t>(mode)];
}

std::string_view name(HalvesRule rule) {
  return kRuleNames[static_cast<std::size_t>(rule)];
}

RoundedCoordinates::RoundedCoordinates() {
  modes_.fill(kFinest);
  halves_.fill(kFinest);
}

RoundedCoordinates::RoundedCoordinates(const Number& exact, const Number& got)
    : count_(1), decimals_(static_cast<std::int8_t>(decimals_of(got))) {
  const Number difference = got - exact;
  const Number off = abs(difference);
  most_off_ = finest_units(off);
  modes_.fill(-1);
  halves_.fill(-1);
  Rounded rounded = {};
  rounded.up = difference.sign() > 0;
  rounded.toward_zero = rounded.up == (exact.sign() < 0);
  Number steps = power_of_ten(decimals_);
  for (std::int8_t grid = decimals_; grid <= kFinest; ++grid, steps = steps * 10) {
    const Number increments = off * steps;
    if (increments >= 1) break;
    const int side = Number::compare(increments * 2, 1);
    rounded.is_half = side == 0;
    rounded.is_even = rounded.is_half && is_whole(got * steps / 2);
    for (std::size_t i = 0; i < kRoundingModes; ++i) {
      if (fits(static_cast<RoundingMode>(i), rounded, side <= 0)) modes_[i] = grid;
    }
    for (std::size_t i = 0; i < kHalvesRules && side <= 0; ++i) {
      if (fits(static_cast<HalvesRule>(i), rounded)) halves_[i] = grid;
    }
  }
}

void RoundedCoordinates::add(const RoundedCoordinates& other) {
  count_ += other.count_;
  decimals_ = std::max(decimals_, other.decimals_);
  most_off_ = std::max(most_off_, other.most_off_);
  take_least(modes_, other.modes_);
  take_least(halves_, other.halves_);
}

Number RoundedCoordinates::increment() const {
  return has_grid() ? Number(1) / power_of_ten(decimals_) : Number(0);
}

std::int64_t RoundedCoordinates::increments_off() const {
  if (!has_grid()) return 0;
  std::int64_t increment = 1;
  for (std::int8_t i = decimals_; i < kFinest; ++i) increment *= 10;
  return most_off_ / increment + (most_off_ % increment == 0 ? 0 : 1);
}

std::vector<RoundingMode> RoundedCoordinates::modes() const {
  std::vector<RoundingMode> modes;
  for (std::size_t i = 0; has_grid() && i < kRoundingModes; ++i) {
    if (modes_[i] >= decimals_) modes.push_back(static_cast<RoundingMode>(i));
  }
  return modes;
}

std::vector<HalvesRule> RoundedCoordinates::halves() const {
  std::vector<HalvesRule> rules;
  const auto nearest = static_cast<std::size_t>(RoundingMode::nearest);
  for (std::size_t i = 0; has_grid() && modes_[nearest] >= decimals_ && i < kHalvesRules; ++i) {
    if (halves_[i] >= decimals_) rules.push_back(static_cast<HalvesRule>(i));
  }
  return rules;
}

std::string RoundedCoordinates::modes_text() const {
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
  return names.empty() ? "by no one way of rounding" : fmt::format("{}", fmt::join(names, " or "));
}

std::string RoundedCoordinates::text() const {
  if (has_grid()) {
    return fmt::format("on a grid of {} mm, at most {} of its steps away, {}", increment().text(),
                       grouped(static_cast<std::size_t>(increments_off())), modes_text());
  }
  const Number most = Number(most_off_) / power_of_ten(kFinest);
  return fmt::format("on no decimal grid, within {} mm", most.text());
}

Json RoundedCoordinates::json() const {
  Json object = {{"count", count_}, {"most", (Number(most_off_) / power_of_ten(kFinest)).text()}};
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

std::optional<RoundedCoordinates> RoundedCoordinates::from_json(const Json& source) {
  if (!source.is_object()) return std::nullopt;
  RoundedCoordinates part;
  const auto most = source.find("most");
  const auto length = most != source.end() && most->is_string()
                          ? Number::parse(most->get<std::string>())
                          : std::nullopt;
  std::size_t decimals = kNoGrid;
  if (!read_count(source, "count", part.count_) || part.count_ == 0 || !length ||
      length->sign() < 0 || !read_count(source, "decimals", decimals) || decimals > kNoGrid) {
    return std::nullopt;
  }
  part.most_off_ = finest_units(*length);
  part.decimals_ = static_cast<std::int8_t>(decimals);
  part.modes_.fill(-1);
  part.halves_.fill(-1);
  if (!part.has_grid()) return part;
  if (!source.contains("modes") || !read_finest(source["modes"], kModeNames, part.modes_)) {
    return std::nullopt;
  }
  part.halves_.fill(part.modes_[static_cast<std::size_t>(RoundingMode::nearest)]);
  if (source.contains("halves") && !read_finest(source["halves"], kRuleNames, part.halves_)) {
    return std::nullopt;
  }
  return part;
}

void RoundingCensus::take(const Number& exact, const Number& got, bool is_correct) {
  try {
    const Number difference = got - exact;
    if (difference.form() == Number::Form::enclosure) {
      // Closer than that no number of bits distinguishes them.
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
    (is_correct ? correct_ : off_).add(RoundedCoordinates(exact, got));
  } catch (const exact::Undecided&) {
    ++open_;
  }
}

void RoundingCensus::add(const RoundingCensus& other) {
  exact_ += other.exact_;
  open_ += other.open_;
  correct_.add(other.correct_);
  off_.add(other.off_);
}

RoundedCoordinates RoundingCensus::rounded() const {
  RoundedCoordinates both = correct_;
  both.add(off_);
  return both;
}

std::string RoundingCensus::text() const {
  const RoundedCoordinates both = rounded();
  const bool is_one_kind = correct_.count() == 0 || off_.count() == 0;
  const bool is_one = is_one_kind || !both.modes().empty();
  std::string text = grouped(exact_) + " exact";
  const auto count = [&](std::string_view mark, std::size_t number, std::string_view what) {
    if (number != 0) text += fmt::format("{} {} {}", mark, grouped(number), what);
  };
  count(",", open_, "of which it cannot be told");
  count(is_one ? "," : ";", correct_.count(), "correctly rounded");
  if (!is_one) text += ", " + correct_.text();
  count(is_one ? "," : ";", off_.count(), "off");
  if (!is_one) text += ", " + off_.text();
  return is_one && both.count() != 0 ? text + "; " + both.text() : text;
}

Json RoundingCensus::json() const {
  Json object = {{"exact", exact_}};
  if (open_ != 0) object["open"] = open_;
  if (correct_.count() != 0) object["correct"] = correct_.json();
  if (off_.count() != 0) object["off"] = off_.json();
  return object;
}

std::optional<RoundingCensus> RoundingCensus::from_json(const Json& source) {
  RoundingCensus census;
  if (!source.is_object() || !read_count(source, "exact", census.exact_) ||
      !read_count(source, "open", census.open_) || !read_part(source, "correct", census.correct_) ||
      !read_part(source, "off", census.off_)) {
    return std::nullopt;
  }
  return census;
}

}  // namespace gonogo::oracle
