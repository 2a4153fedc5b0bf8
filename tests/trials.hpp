// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test that tries something at random, so that what fails is shrunk.
#pragma once

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdio>
#include <sstream>

#include "tests/chance.hpp"
#include "tests/fuzz/generate/drawn_decisions.hpp"

namespace gonogo {

// Tries the body so often, with what RapidCheck draws: what fails is tried again with fewer and
// earlier choices, and the least that still fails is told. Assertions are those of any test, and
// `return` goes on to the next trial.
template <typename Body>
void each_trial(long usual, Body&& body) {
  rc::detail::TestParams params;
  params.seed = trial_seed();
  params.maxSuccess = static_cast<int>(trial_count(usual));
  rc::detail::TestMetadata metadata;
  metadata.id = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::printf("%d trials, GONOGO_SEED=%llu\n", params.maxSuccess,
              static_cast<unsigned long long>(params.seed));
  const auto result = rc::detail::checkTestable(
      [&] {
        const generate::Decisions bytes = *generate::decisions();
        Chance chance(bytes);
        ::testing::TestPartResultArray said;
        {
          const ::testing::ScopedFakeTestPartResultReporter reporter(
              ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &said);
          body(chance);
        }
        for (int i = 0; i < said.size(); ++i) {
          if (said.GetTestPartResult(i).failed()) RC_FAIL(said.GetTestPartResult(i).message());
        }
      },
      metadata, params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  printResultMessage(result, text);
  FAIL() << text.str();
}

}  // namespace gonogo
