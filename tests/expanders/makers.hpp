// SPDX-License-Identifier: GPL-3.0-or-later
// What the reference and the expander of sinumerik802s make of a program, as places of the base
// system, and programs in a frame with the same programs derived by hand.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "oracle/judge/judge_session.hpp"
#include "tests/reference/axes_change.hpp"

namespace gonogo::expanders::testing {

using reference::Number;
using reference::testing::Vector;
using reference::testing::operator+;
using reference::testing::operator-;

/// A record with the whole place where it ends.
struct Step {
  reference::Record record;
  std::array<Number, 3> to;
};
using Steps = std::vector<Step>;

/// Records as they are shown, and the class of the alarm that ends them.
struct Made {
  std::vector<reference::Record> records;
  std::string alarm;
  Steps steps(const reference::Profile& profile) const;
};

using Maker = Made (*)(const std::string& program, const reference::Profile& profile);
Made reference_makes(const std::string& program, const reference::Profile& profile);
Made expander_makes(const std::string& program, const reference::Profile& profile);
/// Both.
std::span<const Maker> makers();

/// The records of the expander, judged against another program.
oracle::Verdict judged(const std::string& program, const reference::Profile& profile,
                       std::span<const reference::Record> records);

/// The dialect's default machine with the tools 1 (radius 5) and 2 (radius 2), at a place.
reference::Profile machine_at(const Vector& place);

/// A rotation whose sine and cosine are fractions, in a plane, and a translation after it. A vector
/// is along the axes of the plane, the third last, in thousandths.
struct Turn {
  reference::Plane plane = reference::Plane::g17;
  std::int64_t cosine = 1;  // times `over`
  std::int64_t sine = 0;
  std::int64_t over = 1;
  std::string degrees = "0";
  Vector shift{};

  bool is_exact() const { return over == 1; }
  /// REQUIRES: multiples of `over`.
  Vector turned(const Vector& v) const;
  Vector point(const Vector& v) const { return turned(v) + shift; }
  /// From the axes of the plane to X Y Z.
  Vector xyz(const Vector& v) const;
  std::array<Number, 3> place(const std::array<Number, 3>& xyz) const;
  std::array<Number, 2> centre(const std::array<Number, 2>& pq) const;
  /// The blocks that set it; always as many.
  std::string frame() const;
};
inline constexpr int kFrameBlocks = 2;

/// By quarters, or also by the angles of the triangle 3-4-5.
Turn some_turn(bool quarters_only);

std::string decimal(std::int64_t thousandths);
/// "X1 Y2 Z3" of a vector along the axes of the plane; other letters for IJK.
std::string words(const Turn& turn, const Vector& v, const char* letters = "XYZ",
                  const char* sign = "");

/// That the steps agree within a tolerance in mm. The blocks are `lines` apart.
void expect_near(const Steps& got, const Steps& want, const Number& tolerance, int lines);

}  // namespace gonogo::expanders::testing
