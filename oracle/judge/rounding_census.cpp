// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/rounding_census.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gonogo::oracle {
namespace {

constexpr int kFinestDecimals = 9;

bool is_whole(const Number& number) {
  return number.is_rational() && number.floor() == number;
}

// Whether `got` is what the mode makes of `exact`, both in increments. Of halves nearest is either.
bool fits(RoundingMode mode, const Number& exact, const Number& got) {
  switch (mode) {
    case RoundingMode::nearest:
      return abs(got - exact) * 2 <= 1;
    case RoundingMode::toward_zero:
      return got == (exact.sign() < 0 ? exact.ceil() : exact.floor());
    case RoundingMode::away_from_zero:
      return got == (exact.sign() < 0 ? exact.floor() : exact.ceil());
    case RoundingMode::down:
      return got == exact.floor();
    case RoundingMode::up:
      return got == exact.ceil();
  }
  return false;
}

}  // namespace

std::string_view name(RoundingMode mode) {
  constexpr std::array<std::string_view, kRoundingModes> kNames = {"nearest", "toward zero",
                                                                   "away from zero", "down", "up"};
  return kNames[static_cast<std::size_t>(mode)];
}

RoundingCensus::RoundingCensus() {
  Number increment = 1;
  for (int i = 0; i <= kFinestDecimals; ++i) {
    Grid grid;
    grid.increment = increment;
    grid.modes.fill(true);
    grids_.push_back(grid);
    increment = increment / 10;
  }
}

void RoundingCensus::take(const Number& exact, const Number& got) {
  try {
    if (exact == got) {
      ++exact_;
      return;
    }
    ++rounded_;
    for (Grid& grid : grids_) {
      const Number steps = got / grid.increment;
      grid.fits = grid.fits && is_whole(steps);
      if (!grid.fits) continue;
      const Number due = exact / grid.increment;
      grid.most_off = max(grid.most_off, abs(steps - due));
      for (std::size_t i = 0; i < kRoundingModes; ++i) {
        grid.modes[i] = grid.modes[i] && fits(static_cast<RoundingMode>(i), due, steps);
      }
    }
  } catch (const exact::Undecided&) {
    ++open_;
  }
}

const RoundingCensus::Grid* RoundingCensus::grid() const {
  const auto found = std::ranges::find(grids_, true, &Grid::fits);
  return rounded_ == 0 || found == grids_.end() ? nullptr : &*found;
}

Number RoundingCensus::increment() const {
  return grid() == nullptr ? Number(0) : grid()->increment;
}

Number RoundingCensus::increments_off() const {
  return grid() == nullptr ? Number(0) : grid()->most_off.ceil();
}

std::vector<RoundingMode> RoundingCensus::modes() const {
  std::vector<RoundingMode> modes;
  for (std::size_t i = 0; grid() != nullptr && i < kRoundingModes; ++i) {
    if (grid()->modes[i]) modes.push_back(static_cast<RoundingMode>(i));
  }
  return modes;
}

std::string RoundingCensus::text() const {
  std::string text = fmt::format("coordinates: {} exact", exact_);
  if (open_ != 0) text += fmt::format(", {} of which it cannot be told", open_);
  if (rounded_ == 0) return text;
  if (grid() == nullptr) return text + fmt::format(", {} off and on no decimal grid", rounded_);
  std::vector<std::string_view> names;
  for (const RoundingMode mode : modes()) names.push_back(name(mode));
  return text + fmt::format(
                    ", {} on a grid of {} mm, within {} of it; {}", rounded_, increment().text(),
                    increments_off().text(),
                    names.empty() ? "by no one mode" : fmt::format("{}", fmt::join(names, " or ")));
}

}  // namespace gonogo::oracle
