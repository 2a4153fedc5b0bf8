// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/sinumerik/expression.hpp"
#include "expanders/sinumerik/names.hpp"

namespace gonogo::expanders::sinumerik {

/// A value and how it is to be taken.
struct Value {
  enum class Mode { kPlain, kAbsolute, kIncremental };  // as G90 or G91 say, AC( ), IC( )
  Decimal number;
  Mode mode = Mode::kPlain;
  bool undefined = false;  ///< an expression without value
};

/// One item of a block.
struct Item {
  enum class Kind {
    kLetter,      // X10, X=R1
    kIndexed,     // I1=3, S2=500: a letter with a number of its own
    kAssignment,  // R5=1
    kName,        // CR=5, CIP, MSG("...")
    kEnd,
    kSyntax,
    kOutside
  };
  Kind kind = Kind::kEnd;
  char letter = 0;        // capital; also the first of a name
  std::size_t index = 0;  // of kIndexed and kAssignment
  Name name;
  Value value;
  Real real = 0;          // of kAssignment
  bool loose = false;     // its `=` is missing
  std::string_view text;  // of what is outside
};

/// What stands before the words of a line.
struct Head {
  enum class Kind { kBlock, kProgramName, kSyntax };
  Kind kind = Kind::kBlock;
  bool skip = false;  ///< `/`
};

/// Cuts a line into items and reckons their values. `;` ends the block; bytes beyond ASCII may
/// stand in comments and strings only.
class Tokenizer {
 public:
  struct Manner {
    bool capitals_only = false;
    bool left_to_right = false;
    bool ignores_absolute = false;
    bool ignores_incremental = false;
    Control control = Control::k840D;
    bool rotation_needs_equals = false;  ///< RPL45 is none
  };

  Tokenizer(std::string_view line, const Parameters& parameters, Manner manner)
      : cursor_(line.data()),
        end_(line.data() + line.size()),
        parameters_(parameters),
        manner_(manner) {}

  Head head();
  /// R parameters are looked up as the items are read.
  Item next();

 private:
  bool is_printed_name() const;
  bool skip_number();
  void skip_label();
  bool at(char c) const { return cursor_ != end_ && *cursor_ == c; }
  Item letter();
  Item assignment(Item item);
  Item name();
  Item loose_rotation(Item item, const char* from);
  bool skip_call();
  Item with_value(Item item);
  Item marked(Item item, Scan step, const char* from) const;
  Scan value(Item& item);
  Scan expression(Item& item);

  const char* cursor_;
  const char* end_;
  const Parameters& parameters_;
  Manner manner_;
};

}  // namespace gonogo::expanders::sinumerik
