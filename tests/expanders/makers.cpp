// SPDX-License-Identifier: GPL-3.0-or-later
#include "makers.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "expanders/registry.hpp"
#include "reference/dialect.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::expanders::testing {
namespace {

using reference::Axis;
using reference::kLinearAxes;
using reference::testing::any_between;

oracle::Subject& subject() {
  static const auto made = oracle::make_interface_subject(*find("sinumerik"));
  return *made;
}

// The letters of X Y Z along the plane's axes, the third last.
std::array<std::size_t, 3> order(reference::Plane plane) {
  const reference::PlaneAxes axes = reference::axes_of(plane);
  return {index(axes.p), index(axes.q), index(axes.d)};
}

}  // namespace

Steps Made::steps(const reference::Profile& profile) const {
  Steps steps;
  std::array<Number, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = profile.initial.at[kLinearAxes[i]];
  for (const reference::Record& record : records) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (record.axes.has(kLinearAxes[i])) at[i] = record.to[kLinearAxes[i]];
    }
    steps.push_back({record, at});
  }
  return steps;
}

Made reference_makes(const std::string& program, const reference::Profile& profile) {
  Made made;
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) {
    if (const auto* record = std::get_if<reference::Record>(item)) made.records.push_back(*record);
    if (const auto* report = std::get_if<reference::AlarmReport>(item)) {
      made.alarm = name(report->alarms.front().alarm);
    }
  }
  return made;
}

Made expander_makes(const std::string& program, const reference::Profile& profile) {
  Made made;
  subject().configure(profile);
  const oracle::RunEnd end =
      subject().run("relation", program, [&](const reference::Record& record) {
        made.records.push_back(record);
        return true;
      });
  made.alarm = end.alarm.alarm_class;
  return made;
}

std::span<const Maker> makers() {
  static constexpr Maker kMakers[] = {&reference_makes, &expander_makes};
  return kMakers;
}

oracle::Verdict judged(const std::string& program, const reference::Profile& profile,
                       std::span<const reference::Record> records) {
  const oracle::Tolerances terms = make_tolerances(subject().info(), profile);
  return judge_outcome(profile, program, terms, records, {}).verdict;
}

reference::Profile machine_at(const Vector& place) {
  auto profile = std::get<reference::Profile>(reference::default_profile("sinumerik802s"));
  profile.tools = {{"1", {5, 0}}, {"2", {2, 0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    profile.initial.at[kLinearAxes[i]] = Number::millionths(place[i] * 1'000);
  }
  return profile;
}

Vector Turn::turned(const Vector& v) const {
  return {(cosine * v[0] - sine * v[1]) / over, (sine * v[0] + cosine * v[1]) / over, v[2]};
}

Vector Turn::xyz(const Vector& v) const {
  const auto axes = order(plane);
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) result[axes[i]] = v[i];
  return result;
}

std::array<Number, 2> Turn::centre(const std::array<Number, 2>& pq) const {
  return {(pq[0] * cosine - pq[1] * sine) / over + Number(shift[0]) / 1'000,
          (pq[0] * sine + pq[1] * cosine) / over + Number(shift[1]) / 1'000};
}

std::array<Number, 3> Turn::place(const std::array<Number, 3>& xyz) const {
  const auto [p, q, d] = order(plane);
  const std::array<Number, 2> in_plane = centre({xyz[p], xyz[q]});
  std::array<Number, 3> result;
  result[p] = in_plane[0];
  result[q] = in_plane[1];
  result[d] = xyz[d] + Number(shift[2]) / 1'000;
  return result;
}

std::string Turn::frame() const {
  return "G158" + words(*this, shift) + "\nG259 RPL=" + degrees + "\n";
}

Turn some_turn(bool quarters_only) {
  struct Angle {
    std::int64_t cosine, sine, over;
    int whole;
    const char* fraction;
  };
  static constexpr Angle kAngles[] = {
      {1, 0, 1, 0, "0"}, {4, 3, 5, 36, "869897645844021297"}, {3, 4, 5, 53, "130102354155978703"}};
  const Angle& angle = kAngles[quarters_only ? 0 : any_between(0, 2)];
  Turn turn;
  turn.plane = static_cast<reference::Plane>(any_between(0, 2));
  turn.cosine = angle.cosine;
  turn.sine = angle.sine;
  turn.over = angle.over;
  const auto quarters = static_cast<int>(any_between(0, 3));
  for (int i = 0; i < quarters; ++i) {
    const std::int64_t cosine = turn.cosine;
    turn.cosine = -turn.sine;
    turn.sine = cosine;
  }
  turn.degrees = fmt::format("{}.{}", angle.whole + 90 * quarters, angle.fraction);
  turn.shift = reference::testing::any_shift();
  return turn;
}

std::string decimal(std::int64_t thousandths) {
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", std::abs(thousandths) / 1'000,
                     std::abs(thousandths) % 1'000);
}

std::string words(const Turn& turn, const Vector& v, const char* letters, const char* sign) {
  const auto axes = order(turn.plane);
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += fmt::format(" {}{}{}", letters[axes[i]], sign, decimal(v[i]));
  }
  return text;
}

void expect_near(const Steps& got, const Steps& want, const Number& tolerance, int lines) {
  RC_ASSERT(got.size() == want.size());
  const auto near = [&](const Number& a, const Number& b) { return abs(a - b) <= tolerance; };
  for (std::size_t i = 0; i < want.size(); ++i) {
    const reference::Record& a = got[i].record;
    const reference::Record& b = want[i].record;
    RC_ASSERT(a.kind == b.kind);
    RC_ASSERT(a.plane == b.plane);
    RC_ASSERT(a.rot == b.rot);
    RC_ASSERT(a.feed == b.feed);
    RC_ASSERT(a.seconds == b.seconds);
    // The end of a trace has no block in the reference.
    const bool has_block = b.block != 0;
    RC_ASSERT(a.block == (has_block ? b.block + static_cast<std::uint64_t>(lines) : 0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      RC_ASSERT(near(got[i].to[axis], want[i].to[axis]));
      const Axis letter = kLinearAxes[axis];
      if (b.kind == reference::RecordKind::arc3) RC_ASSERT(near(a.via[letter], b.via[letter]));
    }
    if (b.kind != reference::RecordKind::arc) continue;
    RC_ASSERT(near(a.centre[0], b.centre[0]));
    RC_ASSERT(near(a.centre[1], b.centre[1]));
  }
}

}  // namespace gonogo::expanders::testing
