// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the bench itself says of a mutant, without the judge.
#pragma once

#include "specimen.hpp"

namespace gonogo::mutations {

enum class Answer {
  reject,  // it is wrong under each reading of the manual
  same,    // it is right by a named rule
  unsure,  // not counted
};

struct Statement {
  Answer answer = Answer::unsure;
  std::string why;  // what is wrong, or the kind of explanation
};

Statement state(const Specimen& specimen, const Trace& mutant);

}  // namespace gonogo::mutations
