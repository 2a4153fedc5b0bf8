// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a clause turns on: a comparison with three outcomes, of which two are often one decision
// (below and at a limit). They are told to whoever asks which of them programs have met; the
// reference does not hang on it.
#pragma once

#include <string_view>

#include "reference/axis.hpp"
#include "reference/clause.hpp"

namespace gonogo::reference {

// Takes the signs of the reference's decisions in its own thread, while it lives; the one that was
// made last where several live. Those live as on a stack.
class SignWatch {
 public:
  SignWatch();
  SignWatch(const SignWatch&) = delete;
  SignWatch& operator=(const SignWatch&) = delete;
  virtual ~SignWatch();
  // `what` is an expression whose sign it is, with the letters of the words: "L - 2 D". It holds
  // until this returns. `sign` is -1, 0 or 1.
  virtual void note(ClauseId clause, std::string_view what, int sign) = 0;

 private:
  SignWatch* before_;
};

// The sign of `value`, or of a - b, as the clause has it decided. Throws exact::Undecided as the
// comparison does.
int decided(ClauseId clause, std::string_view what, const Number& value);
int decided(ClauseId clause, std::string_view what, const Number& a, const Number& b);

}  // namespace gonogo::reference
