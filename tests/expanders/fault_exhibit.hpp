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

struct Exhibit {
  const char* fault;
  std::string program;
  const char* want;  ///< what the faulty expander does, without its `end`
};

/// The same under a profile of its own; what the faulty expander does is left to other tests.
struct ProfiledExhibit {
  const char* fault;
  const char* program;
  const char* profile = "{}";
};

inline void PrintTo(const Exhibit& exhibit, std::ostream* out) {
  *out << exhibit.fault;
}
inline void PrintTo(const ProfiledExhibit& exhibit, std::ostream* out) {
  *out << exhibit.fault;
}

/// Names a test after its fault.
struct FaultName {
  template <typename AnyExhibit>
  std::string operator()(const ::testing::TestParamInfo<AnyExhibit>& exhibit) const {
    std::string name = exhibit.param.fault;
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
inline void expect_shown(const Exhibit& exhibit, const char* expander, const char* after_reset) {
  Session sound("{}", {}, expander);
  Session faulty("{}", exhibit.fault, expander);
  const std::uint64_t before = times_reached(expander, exhibit.fault);
  std::string want = sound.run(exhibit.program).all();
  EXPECT_EQ(times_reached(expander, exhibit.fault), before);
  std::string got = faulty.run(exhibit.program).all();
  sound.reset();
  faulty.reset();
  want += sound.run(after_reset).all();
  got += faulty.run(after_reset).all();
  EXPECT_NE(got, want);
  EXPECT_GT(times_reached(expander, exhibit.fault), before);
}

/// The same; the faulty expander is stopped after 10,000 records of the program.
inline void expect_shown(const ProfiledExhibit& exhibit, const char* expander,
                         const char* after_reset) {
  Session sound(exhibit.profile, {}, expander);
  Session faulty(exhibit.profile, exhibit.fault, expander);
  const std::uint64_t before = times_reached(expander, exhibit.fault);
  std::string want = sound.run(exhibit.program).all();
  EXPECT_EQ(times_reached(expander, exhibit.fault), before);
  std::string got = faulty.run(exhibit.program, 10'000).all();
  sound.reset();
  faulty.reset();
  want += sound.run(after_reset).all();
  got += faulty.run(after_reset).all();
  EXPECT_NE(got, want);
  EXPECT_GT(times_reached(expander, exhibit.fault), before);
}

}  // namespace gonogo::expanders::testing
