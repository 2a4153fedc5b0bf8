// SPDX-License-Identifier: GPL-3.0-or-later
//
// RS274/NGC: the words of operators and functions.
#pragma once

#include <array>
#include <string_view>

#include "grammar/ast.hpp"

namespace gonogo::grammar::rs274 {

struct WordOfTerm {
  std::string_view word;
  TermKind kind;
};

// NGC-EXP-01: operators from the highest group to the lowest.
inline constexpr auto kPowers = std::to_array<WordOfTerm>({{"**", TermKind::power}});
inline constexpr auto kProducts = std::to_array<WordOfTerm>(
    {{"*", TermKind::multiply}, {"/", TermKind::divide}, {"MOD", TermKind::modulo}});
inline constexpr auto kSums =
    std::to_array<WordOfTerm>({{"+", TermKind::add}, {"-", TermKind::subtract}});
inline constexpr auto kComparisons = std::to_array<WordOfTerm>({{"EQ", TermKind::equal},
                                                                {"NE", TermKind::not_equal},
                                                                {"GT", TermKind::greater},
                                                                {"GE", TermKind::not_less},
                                                                {"LT", TermKind::less},
                                                                {"LE", TermKind::not_greater}});
inline constexpr auto kLogic = std::to_array<WordOfTerm>(
    {{"AND", TermKind::logic_and}, {"OR", TermKind::logic_or}, {"XOR", TermKind::logic_xor}});

// NGC-EXP-03: functions of one value.
inline constexpr auto kFunctionsOfOne = std::to_array<WordOfTerm>({
    {"ABS", TermKind::abs},
    {"ACOS", TermKind::acos},
    {"ASIN", TermKind::asin},
    {"COS", TermKind::cos},
    {"EXP", TermKind::exp},
    {"FIX", TermKind::fix},
    {"FUP", TermKind::fup},
    {"LN", TermKind::ln},
    {"ROUND", TermKind::round},
    {"SIN", TermKind::sin},
    {"SQRT", TermKind::sqrt},
    {"TAN", TermKind::tan},
});

}  // namespace gonogo::grammar::rs274
