// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of each kind of record (docs/protocol.md), for those that read records from JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "reference/record.hpp"

namespace gonogo::oracle {

// Strings are no longer.
inline constexpr std::size_t kLongestString = 1000;

enum class Key : std::uint8_t {
  k,
  b,
  to,
  f,
  fm,
  plane,
  c,
  rot,
  via,
  lead,
  start,
  s,
  m,
  alarm_class,
  word,
  native,
  count
};
inline constexpr std::size_t kKeys = static_cast<std::size_t>(Key::count);
inline constexpr std::array<std::string_view, kKeys> kKeyNames = {
    "k",   "b",    "to",    "f", "fm", "plane", "c",    "rot",
    "via", "lead", "start", "s", "m",  "class", "word", "native"};
constexpr std::string_view name_of(Key key) {
  return kKeyNames[static_cast<std::size_t>(key)];
}
constexpr std::optional<Key> record_key(std::string_view name) {
  for (std::size_t i = 0; i < kKeys; ++i) {
    if (kKeyNames[i] == name) return static_cast<Key>(i);
  }
  return std::nullopt;
}

constexpr std::uint32_t bit(Key key) {
  return 1U << static_cast<unsigned>(key);
}
template <class... Keys>
constexpr std::uint32_t bits(Keys... keys) {
  return (0U | ... | bit(keys));
}

// The keys of one kind of record; `k` and `b` go with all.
struct Shape {
  std::string_view name;
  reference::RecordKind kind;
  std::uint32_t required;
  std::uint32_t allowed;
};
inline constexpr std::uint32_t kCommonKeys = bits(Key::k, Key::b);
constexpr Shape shape(std::string_view name, reference::RecordKind kind, std::uint32_t required,
                      std::uint32_t optional = 0) {
  return {name, kind, required, required | optional | kCommonKeys};
}
inline constexpr std::array<Shape, 8> kShapes = {
    shape("rapid", reference::RecordKind::rapid, bits(Key::to)),
    shape("feed", reference::RecordKind::feed, bits(Key::to, Key::f), bits(Key::fm)),
    shape("arc", reference::RecordKind::arc, bits(Key::plane, Key::c, Key::rot, Key::to, Key::f),
          bits(Key::fm)),
    shape("arc3", reference::RecordKind::arc3, bits(Key::via, Key::to, Key::f), bits(Key::fm)),
    shape("thread", reference::RecordKind::thread, bits(Key::to, Key::lead, Key::start)),
    shape("dwell", reference::RecordKind::dwell, bits(Key::s)),
    shape("m", reference::RecordKind::m, bits(Key::m)),
    shape("end", reference::RecordKind::end, bits(Key::to))};
inline constexpr std::uint32_t kAlarmKeys = bits(Key::b, Key::alarm_class, Key::word, Key::native);

}  // namespace gonogo::oracle
