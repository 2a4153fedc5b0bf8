// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work where memory comes to its end: whichever allocation fails, a run ends in std::bad_alloc or
// in the reader's own error, never in a wrong answer and never in the end of the process; nothing
// of it stays allocated, and the same inputs give the right answer behind it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <string>

#include "tests/hostile/failing_allocation.hpp"

namespace gonogo::hostile {

// The answer, or what the reader declares of a file; anything else that is thrown ends the test.
struct Answer {
  std::string text;
  bool is_refused = false;
  bool has_failed = false;  // the allocation
};

template <typename Error, typename Work>
Answer answer_where(std::uint64_t number, Failing how, Work& work) {
  Answer answer;
  const FailingAllocation failing(number, how);
  try {
    answer.text = work();
  } catch (const std::bad_alloc&) {
    answer.is_refused = true;
  } catch (const Error&) {
    answer.is_refused = true;
  }
  answer.has_failed = failing.has_failed();
  return answer;
}

// Whether that allocation failed: then the answer is the right one or none.
template <typename Error, typename Work>
bool check_one(std::uint64_t number, Failing how, Work& work, const std::string& right) {
  const Answer answer = answer_where<Error>(number, how, work);
  if (!answer.is_refused || !answer.has_failed) {
    EXPECT_EQ(answer.text, right) << "allocation " << number;
  }
  return answer.has_failed;
}

// Each of the first allocations fails, and of the others some, until a run has none that fails.
template <typename Error, typename Work>
void try_every_failure(Work work) {
  constexpr std::uint64_t kStep = 60;
  const std::string right = work();
  ASSERT_EQ(work(), right);
  for (const Failing how : {Failing::once, Failing::from_then}) {
    bool has_failed = true;
    for (std::uint64_t number = 1; has_failed; number += 1 + number / kStep) {
      const std::int64_t before = blocks_in_use();
      has_failed = check_one<Error>(number, how, work, right);
      ASSERT_EQ(blocks_in_use(), before) << "allocation " << number;
      if (number % 7 == 1) {
        ASSERT_EQ(work(), right) << "behind allocation " << number;
      }
      if (testing::Test::HasFailure()) return;
    }
  }
}

// What a file reader may not throw.
struct NoError {};

}  // namespace gonogo::hostile
