// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault with a program on which it shows, as the parameter of a test.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {

struct FaultExample {
  const char* fault;
  std::string program;
  const char* want;  ///< what the faulty expander does, without its `end`
};

/// The same under a profile of its own; what the faulty expander does is left to other tests.
struct ProfiledFaultExample {
  const char* fault;
  const char* program;
  const char* profile = "{}";
};

inline void PrintTo(const FaultExample& example, std::ostream* out) {
  *out << example.fault;
}
inline void PrintTo(const ProfiledFaultExample& example, std::ostream* out) {
  *out << example.fault;
}

/// Names a test after its fault.
struct FaultName {
  template <typename AnyFaultExample>
  std::string operator()(const ::testing::TestParamInfo<AnyFaultExample>& example) const {
    std::string name = example.param.fault;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

inline std::uint64_t times_reached(const char* expander, const char* fault) {
  return count(expander, fault).value().reached;
}

/// That the expander with the fault does something else than without, in the program or in
/// `after_reset`, which is run once more after a reset; and that its line is reached there, by the
/// one that has it.
inline void expect_shown(const FaultExample& example, const char* expander,
                         const char* after_reset) {
  Session sound("{}", {}, expander);
  Session faulty("{}", example.fault, expander);
  const std::uint64_t before = times_reached(expander, example.fault);
  std::string want = sound.run(example.program).all();
  EXPECT_EQ(times_reached(expander, example.fault), before);
  std::string got = faulty.run(example.program).all();
  sound.reset();
  faulty.reset();
  want += sound.run(after_reset).all();
  got += faulty.run(after_reset).all();
  EXPECT_NE(got, want);
  EXPECT_GT(times_reached(expander, example.fault), before);
}

/// The same; the faulty expander is stopped after 10,000 records of the program.
inline void expect_shown(const ProfiledFaultExample& example, const char* expander,
                         const char* after_reset) {
  Session sound(example.profile, {}, expander);
  Session faulty(example.profile, example.fault, expander);
  const std::uint64_t before = times_reached(expander, example.fault);
  std::string want = sound.run(example.program).all();
  EXPECT_EQ(times_reached(expander, example.fault), before);
  std::string got = faulty.run(example.program, 10'000).all();
  sound.reset();
  faulty.reset();
  want += sound.run(after_reset).all();
  got += faulty.run(after_reset).all();
  EXPECT_NE(got, want);
  EXPECT_GT(times_reached(expander, example.fault), before);
}

}  // namespace gonogo::expanders::testing
