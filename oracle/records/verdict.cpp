// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/verdict.hpp"

#include <algorithm>
#include <array>

namespace gonogo::oracle {
namespace {

constexpr std::array<std::string_view, 28> kNames = {"pass-exact",
                                                     "pass-rounded",
                                                     "pass-tolerance",
                                                     "pass-properties",
                                                     "xfail",
                                                     "skip",
                                                     "advice",
                                                     "fail.geometry",
                                                     "fail.order",
                                                     "fail.feed",
                                                     "fail.region",
                                                     "fail.reading",
                                                     "fail.overrun",
                                                     "fail.alarm-missing",
                                                     "fail.alarm-spurious",
                                                     "fail.alarm-class",
                                                     "fail.alarm-late",
                                                     "fail.declaration",
                                                     "state-leak",
                                                     "crash",
                                                     "timeout",
                                                     "out-of-memory",
                                                     "protocol",
                                                     "unmapped-alarm",
                                                     "xpass",
                                                     "oracle-gap",
                                                     "oracle-error",
                                                     ""};

}  // namespace

std::string_view name(VerdictKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<VerdictKind> verdict_kind(std::string_view name) {
  for (std::size_t i = 0; !kNames[i].empty(); ++i) {
    if (kNames[i] == name) return static_cast<VerdictKind>(i);
  }
  return std::nullopt;
}

Decision decision(VerdictKind kind) {
  if (kind < VerdictKind::xfail) return Decision::go;
  if (kind <= VerdictKind::advice) return Decision::neither;
  return kind < VerdictKind::oracle_gap ? Decision::no_go : Decision::undecided;
}

std::span<const std::string_view> verdict_names() {
  return std::span(kNames).first(kNames.size() - 1);
}

}  // namespace gonogo::oracle
