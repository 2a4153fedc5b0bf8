// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/word_use.hpp"

#include <algorithm>
#include <array>

namespace gonogo::reference::hnc21t {
namespace {

// HNC-WRD-01. Beside every code stand the codes themselves, the feed, the tool and the spindle.
constexpr std::string_view kEverywhere = "GMFST";

struct CodeWords {
  int code;
  std::string_view used;
  std::string_view passed_over;  // by the rules below
};

constexpr auto kCodeWords = std::to_array<CodeWords>({
    {0, "XUZW", ""},
    {1, "XUZW", ""},
    {2, "XUZWRIK", ""},
    {3, "XUZWRIK", ""},
    {4, "P", ""},
    {32, "XUZWJREPCQKI", ""},  // run_thread reads no run-out and no starts but those of 0
    {74, "ZWRQ", "XUIKECAPJ"},
    {75, "XUZWRQIP", "KECAJ"},
    {80, "XUZWI", "KRECAPJQ"},
    {81, "XUZWK", "IRECAPJQ"},
    {82, "XUZWIRECPJQ", "KA"},
    {92, "XUZW", ""},
});

constexpr ClauseId kOfCycles = "HNC-COM-07"_clause;
constexpr std::string_view kOwnWord =
    "a word of the group of cycles that this cycle does not use is taken in without effect";

constexpr auto kPassedWords = std::to_array<PassedWords>({
    {"every block", "S T", "HNC-COM-01"_clause, "the spindle and the tool do not shape the path"},
    {"G02, G03 with R", "I K", "HNC-COM-01"_clause, "the radius goes before the centre"},
    {"G32", "R E P C Q K I of 0", "HNC-WRD-01"_clause,
     "a run-out, a start angle or a number of starts of zero asks for none"},
    {"G74, G75", "Q without R", "HNC-G74-01"_clause,
     "the depth of a peck is checked; without a withdrawal there are no pecks"},
    {"G74", "X U", "HNC-G74-04"_clause, "drilling goes along Z alone"},
    {"G74", "I K E C A P J", kOfCycles, kOwnWord},
    {"G75", "K E C A J, and the one of I and P that is not the count", kOfCycles, kOwnWord},
    {"G80", "K R E C A P J Q", kOfCycles, kOwnWord},
    {"G81", "I R E C A P J Q", kOfCycles, kOwnWord},
    {"G82", "K A", kOfCycles, kOwnWord},
    {"G82", "Q", "HNC-G82-05"_clause, "its sign is checked; it has no effect on the geometry"},
});

}  // namespace

bool reads_word(int code, char address) {
  if (kEverywhere.find(address) != std::string_view::npos) return true;
  const auto* const words = std::ranges::find(kCodeWords, code, &CodeWords::code);
  if (words == kCodeWords.end()) return false;
  return words->used.find(address) != std::string_view::npos ||
         words->passed_over.find(address) != std::string_view::npos;
}

std::span<const PassedWords> passed_words() {
  return kPassedWords;
}

}  // namespace gonogo::reference::hnc21t
