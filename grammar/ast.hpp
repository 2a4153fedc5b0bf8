// SPDX-License-Identifier: GPL-3.0-or-later
//
// The syntax tree of one block of NC text. Standard library only: nothing here knows a machine, a
// motion or Spirit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gonogo::grammar {

// The dialects that the grammar reads.
enum class Dialect { gsk988ta, hnc21t, rs274, sinumerik };
inline constexpr Dialect kDialects[] = {Dialect::gsk988ta, Dialect::hnc21t, Dialect::rs274,
                                        Dialect::sinumerik};

// Bytes [begin, end) of the line, counted from 0. A column for people is begin + 1.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

// A decimal number exactly as written: (-1)^negative * magnitude / 10^scale. The sign of zero and
// the number of decimals written are kept, because ranges and readings ask for them.
struct Decimal {
  bool negative = false;
  std::uint32_t scale = 0;      // decimals written after the point
  std::uint64_t magnitude = 0;  // the digits, when there are at most 18; else 0
  std::string long_digits;      // the digits without leading zeros, when there are more than 18
  friend bool operator==(const Decimal&, const Decimal&) = default;
};

// Terms of Block::terms, one after the other: a value.
struct TermRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;  // 0: none
  friend bool operator==(const TermRange&, const TermRange&) = default;
};

// An address, a capital letter however it is written, and its number: X-12.5; or, in RS274/NGC, an
// expression: X[#1+2].
struct Word {
  char address = 0;
  Decimal value;
  Span where;
  TermRange terms = {};  // in place of `value`
  friend bool operator==(const Word& a, const Word& b) {
    return a.address == b.address && a.value == b.value && a.terms == b.terms;
  }
};

// One step of an expression in postfix order: 1 2 add is 1+2. The first ones are SINUMERIK's and
// RS274/NGC's, the last those of the latter alone.
enum class TermKind : std::uint8_t {
  number,     // pushes `number`
  parameter,  // pushes the value of R`number`
  negate,
  sin,  // of degrees
  cos,
  tan,
  sqrt,
  abs,
  add,
  subtract,
  multiply,
  divide,
  plus,      // a sign that changes nothing
  numbered,  // the value of the parameter of that number
  named,     // pushes the value of the parameter Block::names[`number`]
  exists,    // pushes whether it has one
  acos,      // degrees
  asin,
  atan,  // of two values
  exp,
  fix,
  fup,
  ln,
  round,
  power,
  modulo,
  equal,
  not_equal,
  greater,
  not_less,
  less,
  not_greater,
  logic_and,
  logic_or,
  logic_xor,
};

struct Term {
  TermKind kind = TermKind::number;
  Decimal number;
  Span where;
  // RS274/NGC: a + or - that follows AND, OR or XOR without brackets between (NGC-EXP-09).
  bool is_joined = false;
  friend bool operator==(const Term& a, const Term& b) {
    return a.kind == b.kind && a.number == b.number;
  }
};

// RS274/NGC: #1=2, #<name>=2.
struct Assignment {
  std::string name;      // in small letters; empty: a numbered parameter
  TermRange index = {};  // the number of that
  TermRange value = {};
  Span where;
  friend bool operator==(const Assignment& a, const Assignment& b) {
    return a.name == b.name && a.index == b.index && a.value == b.value;
  }
};

// What an O word of RS274/NGC does.
enum class ControlKind : std::uint8_t {
  sub,
  endsub,
  return_,
  call,
  if_,
  elseif,
  else_,
  endif,
  while_,
  endwhile,
  do_,
  repeat,
  endrepeat,
  break_,
  continue_,
};

// o100 while [#1 LT 10].
struct Control {
  ControlKind kind = ControlKind::sub;
  std::string label;      // digits, or <name> in small letters; empty: it is calculated
  TermRange number = {};  // then
  std::vector<TermRange> values;
  Span where;
  friend bool operator==(const Control& a, const Control& b) {
    return a.kind == b.kind && a.label == b.label && a.number == b.number && a.values == b.values;
  }
};

// How the value of an end point or a centre is meant: as the mode in force says, =AC(...),
// =IC(...).
enum class Dimension : std::uint8_t { as_in_force, absolute, incremental };

// One item of a block of SINUMERIK, whose addresses have names: X10, CR=5.23, I1=AC(2), R101=R1+2,
// G2, LCYC75, MSG("...").
struct NamedWord {
  std::string name;                    // in capitals: "X", "CR", "R", "LCYC75", "MSG"
  std::optional<std::uint64_t> index;  // of I1=, R101=, H5=: the number before '='
  bool has_equals = false;
  bool is_call = false;  // name(...): what stands between the brackets is not kept
  Dimension dimension = Dimension::as_in_force;
  std::uint32_t first_term = 0;  // its value, in Block::terms
  std::uint32_t terms = 0;       // 0: a name without a value
  Span where;
  friend bool operator==(const NamedWord& a, const NamedWord& b) {
    return a.name == b.name && a.index == b.index && a.has_equals == b.has_equals &&
           a.is_call == b.is_call && a.dimension == b.dimension && a.first_term == b.first_term &&
           a.terms == b.terms;
  }
};

// The bytes of a comment in any encoding, without its delimiters.
struct Comment {
  std::string text;
  bool to_end_of_line = false;  // began with ';' rather than '('
  Span where;
  friend bool operator==(const Comment& a, const Comment& b) {
    return a.text == b.text && a.to_end_of_line == b.to_end_of_line;
  }
};

// Something that the maker's language has and the gauge does not read: a variable, an expression, a
// jump. The block is well formed as far as it is read; its meaning is not covered.
struct OutsideConstruct {
  // Stable: "variable", "expression", "control-statement", "file-name", "o-word", "string",
  // "comma-word", "RL=", "RC=".
  std::string name;
  Span where;
  std::string word = {};  // what it begins with, as written: "MCALL", "#1"
  friend bool operator==(const OutsideConstruct& a, const OutsideConstruct& b) {
    return a.name == b.name;
  }
};

// A place of the line. Trees are the same wherever their parts stand.
struct Place {
  Span span;
  friend constexpr bool operator==(const Place&, const Place&) { return true; }
};

// One line of a program. Words stand in the order written; N and O are not among them.
struct Block {
  bool skip = false;                       // begins with '/'
  bool tape_mark = false;                  // the line is '%'
  std::optional<Decimal> sequence_number;  // N
  std::optional<Decimal> program_number;   // O, in HNC also %
  Place number_place;                      // of the number of either
  Place line_comment;                      // of ';' and all behind it, in letter addresses
  std::vector<Word> words;
  std::vector<NamedWord> named;  // SINUMERIK, in place of `words`, in the order written
  Place other_blank;             // SINUMERIK: the first '&' or unprinted character, a blank there
  std::vector<Term> terms;       // the values of `named` and of what RS274/NGC has
  // RS274/NGC.
  std::vector<std::string> names;       // of parameters, in `terms`; in small letters
  std::vector<Assignment> assignments;  // in the order written
  std::optional<Control> control;       // the line is an O word
  std::vector<Comment> comments;
  std::optional<OutsideConstruct> outside;

  // Makes the block empty and keeps its memory, so that a stream of blocks allocates nothing.
  void clear();
  friend bool operator==(const Block&, const Block&) = default;
};

// What is wrong with a line. Codes are for programs, `message()` is for people.
enum class SyntaxCode {
  unexpected_character,   // none of what may stand here
  number_expected,        // an address without a number
  unclosed_comment,       // '(' without ')'
  misplaced_number_word,  // N or O that is not at the head of the block
  line_too_long,          // above 1 MiB
  nested_too_deep,        // brackets or functions, above 64 in each other
};

struct SyntaxError {
  SyntaxCode code = SyntaxCode::unexpected_character;
  Span where;
  std::string expected;  // what could have stood here, a noun phrase: "a number after X"
  friend bool operator==(const SyntaxError&, const SyntaxError&) = default;
};

}  // namespace gonogo::grammar
