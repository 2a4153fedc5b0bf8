// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <limits>
#include <string_view>

#include "oracle/motion/plain_motion.hpp"

namespace gonogo::oracle {
namespace {

// What is left of a line. Each member takes what is expected off the front, or says false.
class Rest {
 public:
  explicit Rest(std::string_view line) : rest_(line) {}

  bool take(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  // The length is one that the compiler knows, for which nothing has to be called.
  template <std::size_t size>
  bool take(const char (&text)[size]) {
    if (rest_.size() < size - 1 || std::memcmp(rest_.data(), text, size - 1) != 0) return false;
    rest_.remove_prefix(size - 1);
    return true;
  }
  bool take(char byte) {
    if (rest_.empty() || rest_.front() != byte) return false;
    rest_.remove_prefix(1);
    return true;
  }
  // A number of JSON. None that is looked for is 0.
  bool take_integer(std::int64_t expected) {
    const bool negative = take('-');
    std::int64_t magnitude = 0;
    if (rest_.starts_with('0') || take_digits(magnitude) == 0) return false;
    return (negative ? -magnitude : magnitude) == expected;
  }
  // A decimal in quotation marks.
  bool take_millionths(std::int64_t expected) {
    constexpr std::array<std::int64_t, 7> kParts = {1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
    if (!take('"')) return false;
    const bool negative = take('-');
    std::int64_t magnitude = 0;
    if (take_digits(magnitude) == 0) return false;
    std::size_t places = 0;
    if (take('.')) {
      places = take_digits(magnitude);
      if (places == 0 || places >= kParts.size()) return false;
    }
    if (!take('"')) return false;
    magnitude *= kParts[places];
    return (negative ? -magnitude : magnitude) == expected;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  // Digits behind those that `magnitude` has; how many. So few altogether that they fit with six
  // zeros.
  std::size_t take_digits(std::int64_t& magnitude) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 100 / 1'000'000;
    std::size_t count = 0;
    while (count < rest_.size() && rest_[count] >= '0' && rest_[count] <= '9') {
      if (magnitude > kMost) return 0;
      magnitude = magnitude * 10 + (rest_[count] - '0');
      ++count;
    }
    rest_.remove_prefix(count);
    return count;
  }

  std::string_view rest_;
};

bool take_position(Rest& rest, AxisSet axes, const PlainMotion::Place& at) {
  bool first = true;
  for (const Axis axis : reference::kAllAxes) {
    if (!axes.has(axis)) continue;
    if ((!first && !rest.take(',')) || !rest.take('"') || !rest.take(letter(axis)) ||
        !rest.take("\":") || !rest.take_millionths(at[index(axis)])) {
      return false;
    }
    first = false;
  }
  return rest.take('}');
}

std::string_view plane_name(reference::Plane plane) {
  constexpr std::array<std::string_view, 3> kPlaneNames = {"G17", "G18", "G19"};
  return kPlaneNames[static_cast<std::size_t>(plane)];
}

bool take_arc(Rest& rest, const PlainMotion& motion) {
  const reference::PlaneAxes axes = axes_of(motion.plane);
  PlainMotion::Place centre = {};
  centre[index(axes.p)] = motion.centre[0];
  centre[index(axes.q)] = motion.centre[1];
  return rest.take(",\"plane\":\"") && rest.take(plane_name(motion.plane)) &&
         rest.take("\",\"c\":{") && take_position(rest, {axes.p, axes.q}, centre) &&
         rest.take(",\"rot\":") && rest.take_integer(motion.rot);
}

bool take_feed(Rest& rest, const PlainMotion& motion) {
  const bool per_revolution = motion.feed_mode == reference::FeedMode::per_revolution;
  return rest.take(",\"f\":") && rest.take_millionths(motion.feed) &&
         (!per_revolution || rest.take(",\"fm\":\"rev\""));
}

}  // namespace

bool is_line_of(const PlainMotion& motion, std::string_view line) {
  Rest rest(line);
  if (!rest.take("{\"k\":\"") || !rest.take(name(motion.kind)) || !rest.take("\",\"b\":") ||
      !rest.take_integer(static_cast<std::int64_t>(motion.block))) {
    return false;
  }
  if (motion.kind == RecordKind::arc && !take_arc(rest, motion)) return false;
  if (!rest.take(",\"to\":{") || !take_position(rest, motion.axes, motion.to)) return false;
  if (motion.kind != RecordKind::rapid && !take_feed(rest, motion)) return false;
  if (rest.take(",\"clause\":\"")) {
    if (!rest.take(reference::clause_name(motion.clause)) || !rest.take('"')) return false;
  }
  return rest.take('}') && rest.at_end();
}

}  // namespace gonogo::oracle
