// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sets of bytes. The character classes of <cctype> and of Spirit depend on a locale or fail above
// 127, and programs carry comments in any encoding: so the grammar has classes of its own.
#pragma once

#include <array>
#include <string_view>

namespace gonogo::grammar {

class ByteSet {
 public:
  constexpr explicit ByteSet(std::string_view members) {
    for (const char member : members) insert(member);
  }
  // The bytes from `first` to `last`, both within.
  static constexpr ByteSet range(char first, char last) {
    ByteSet set("");
    for (char member = first; member < last; ++member) set.insert(member);
    set.insert(last);
    return set;
  }

  constexpr bool contains(char byte) const { return has_[static_cast<unsigned char>(byte)]; }

  friend constexpr ByteSet operator|(ByteSet a, const ByteSet& b) {
    for (std::size_t i = 0; i < a.has_.size(); ++i) a.has_[i] = a.has_[i] || b.has_[i];
    return a;
  }
  friend constexpr ByteSet operator-(ByteSet a, const ByteSet& b) {
    for (std::size_t i = 0; i < a.has_.size(); ++i) a.has_[i] = a.has_[i] && !b.has_[i];
    return a;
  }

 private:
  constexpr void insert(char member) { has_[static_cast<unsigned char>(member)] = true; }

  std::array<bool, 256> has_{};
};

inline constexpr ByteSet kBlank{" \t"};
inline constexpr ByteSet kDigit = ByteSet::range('0', '9');
inline constexpr ByteSet kCapital = ByteSet::range('A', 'Z');
inline constexpr ByteSet kLowerCase = ByteSet::range('a', 'z');
inline constexpr ByteSet kLetter = kCapital | kLowerCase;
inline constexpr ByteSet kSign{"+-"};

// N and O number a block or a program; every other capital letter is the address of a word.
inline constexpr ByteSet kAddress = kCapital - ByteSet{"NO"};

// How a dialect writes letters outside comments: in capitals, or in either case.
enum class Letters { capital, any_case };

// A letter as a capital; every other byte as it is.
constexpr char capital_of(char letter) {
  return kLowerCase.contains(letter) ? static_cast<char>(letter - 'a' + 'A') : letter;
}

// What may stand somewhere outside a comment in a block that is read.
template <Letters letters>
inline constexpr ByteSet kProgram = kBlank | kDigit | kSign | ByteSet{".()/;%#[]"} |
                                    (letters == Letters::capital ? kCapital : kLetter);

// What may stand in an outside construct, without the bytes that open or close something.
template <Letters letters>
inline constexpr ByteSet kMacro = (kBlank | ByteSet::range('!', '~')) -
                                  (letters == Letters::capital ? kLowerCase | ByteSet{"()[];"}
                                                               : ByteSet{"()[];"});

}  // namespace gonogo::grammar
