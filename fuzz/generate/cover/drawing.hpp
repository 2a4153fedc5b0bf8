// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program drawn from a row: the machine that it is for, its text, and the block under test.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/generate/cover/length.hpp"
#include "fuzz/generate/cover/parameters.hpp"
#include "reference/descriptor.hpp"
#include "reference/profile.hpp"

namespace gonogo::cover {

// A row by the names of its parameters.
class Pick {
 public:
  Pick(const Parameters& parameters, const Row& row) : parameters_(parameters), row_(row) {}
  bool has(std::string_view parameter) const;
  // The value of the class. Throws ModelError for an unknown parameter.
  const std::string& operator[](std::string_view parameter) const;
  bool is(std::string_view parameter, std::string_view class_name) const;
  Length length(std::string_view parameter) const { return Length::parse((*this)[parameter]); }

 private:
  const Class& class_of(std::string_view parameter) const;
  const Parameters& parameters_;
  const Row& row_;
};

// The axes by their role in the plane: first, second and depth axis.
enum class Role : std::uint8_t { p, q, d };

// Some parameters mean the same in every model and are taken up here: `plane` (G17, G18, G19; G18
// where there is none on a lathe, else G17), `units` (mm, inch), `increment` (ISB, ISC), `x`
// (diameter, radius), `distance` (absolute; letters: U V W; modal: G91; IC: IC(); AC: AC() under
// G91), `reading` (default, or name=value).
class Drawing {
 public:
  Drawing(const Pick& pick, std::string_view dialect);

  // Where the tool stands when the block under test begins: a traverse with plane and units before
  // it, G91 after it, and the spindle turning but where the model has it in its own hands: as a
  // parameter `spindle`, or by an M3 in `more`. True lengths.
  void stand(Length p, Length q, Length d, std::string_view more = {});
  // A block of the words that are not empty.
  void put(const std::vector<std::string>& words);
  // The same; what alarms of a row with a fault is this block.
  void test(const std::vector<std::string>& words);

  // "" for a class named none.
  std::string word(std::string_view address, std::string_view parameter) const;
  std::string word(std::string_view address, Length value) const;
  // The axis word that goes so far from where the tool stands, as `distance` says.
  std::string travel(Role role, Length way) const;
  // The same under an address of its own: I1 of a circle through a point.
  std::string target(std::string_view address, Role role, Length way) const;
  // The same, absolute or by a letter of increments; `distance` does not count.
  std::string absolute(Role role, Length way) const;
  std::string letters(Role role, Length way) const;
  // The word of the centre's offset along the axis: I, J or K.
  std::string offset(Role role, Length way) const;
  char letter(Role role) const { return "XYZ"[axis(role)]; }
  int decimals() const { return decimals_; }  // of the least increment
  int plane() const { return plane_; }
  // Later words are those of this plane. REQUIRES: 17 to 19.
  void plane(int code) { plane_ = code; }

  // The program, with the last line that the dialect asks for.
  std::string program() const;

  reference::Profile profile;
  std::string text;
  std::vector<std::string> features;  // beside those of the model
  std::size_t test_line = 0;

 private:
  std::size_t axis(Role role) const;
  Length scaled(Role role, Length way) const;
  std::string unit_code() const;
  void take_reading(const std::string& reading);

  const Pick& pick_;
  std::string_view dialect_;
  const reference::Descriptor& table_;
  bool lathe_;
  int plane_;
  int decimals_;
  std::size_t lines_ = 0;
  std::array<Length, 3> at_;  // by role
};

// What turns the spindle, behind the first block of a program, where cutting wants it (SIE-G1-04);
// empty: nothing does. It belongs to no model, as the last line.
std::string_view opening(std::string_view dialect);
// The line without which a text of the dialect is no whole program (NGC-COM-08); empty: none. It
// belongs to no model: ids do not depend on it.
std::string_view last_line(std::string_view dialect);
// A program without either.
std::string own_text(std::string program, std::string_view dialect);

}  // namespace gonogo::cover
