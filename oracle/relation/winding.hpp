// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8, sense and measure: the way round a middle, in any pieces.
#pragma once

#include <optional>
#include <vector>

#include "oracle/relation/event.hpp"

namespace gonogo::relation {

// A vector from a middle, along p and q. The kernel of reference/geometry/ has such operations too.
struct Offset {
  Number p;
  Number q;
  Number square() const;
};
Offset operator-(const Offset& a, const Offset& b);
Number along(const Offset& a, const Offset& b);   // their scalar product
Number across(const Offset& a, const Offset& b);  // > 0: b lies counterclockwise of a
// The square of the way from the middle to the nearest point of the line between the two.
Number nearest_square(const Offset& from, const Offset& to);

// In quarters of a turn, and how far it has gone back.
class Winding {
 public:
  // `sense` as the sign of rot; nearer to the middle than `blind` nothing goes round it.
  Winding(int sense, Number blind) : sense_(sense), blind_(std::move(blind)) {}
  void take(const Offset& to);
  // Another stretch begins: the way to it does not count.
  void leave() { last_.reset(); }
  bool goes_back() const { return most_ - quarters_ > 2; }  // by more than half a turn
  std::int64_t quarters() const { return quarters_; }

 private:
  static int quarter_of(const Offset& offset);
  int sense_;
  Number blind_;
  std::optional<Offset> last_;
  std::int64_t quarters_ = 0;
  std::int64_t most_ = 0;
};

// How often arcs go round each ring.
class Rings {
 public:
  // Rings no farther apart than `width` are one; for `blind` see above.
  Rings(Number width, Number blind) : width_(std::move(width)), blind_(std::move(blind)) {}
  // A piece of an arc about a middle, its ends seen from there: whether its ring has been gone
  // round more than ten times.
  bool turns_again(const Offset& middle, const Offset& from, const Offset& to, int sense);
  void clear() { rings_.clear(); }

 private:
  struct Ring {
    Offset middle;
    Number radius;
    int sense;
    Winding winding;
    Offset end;  // of the last piece
  };
  Number width_;
  Number blind_;
  std::vector<Ring> rings_;
};

}  // namespace gonogo::relation
