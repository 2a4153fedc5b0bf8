// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the hunt share.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "expanders/registry.hpp"
#include "fuzz/hunt/hunt.hpp"
#include "subjects/make_subject.hpp"
#include "tests/fuzz/wrapped_subject.hpp"

namespace gonogo::hunt::testing {

inline constexpr const char* kTaper = "G00 X100 Z5\nG94 X50 Z-10 R-2 F100\n";

inline reference::Profile defaults(const std::string& dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

inline generate::GeneratedProgram gsk(std::string text) {
  return {defaults("gsk988ta"), std::move(text)};
}

// Makes the built-in expander, with a planted fault if one is named.
inline SubjectMaker builtin(const char* name, const char* fault = "") {
  const gonogo_subject_v1* subject = expanders::find(name, fault);
  return [subject] { return oracle::make_interface_subject(*subject); };
}

// Every 97th run puts its first motion 1 mm beside.
class Flickering : public WrappedSubject {
 public:
  // `runs` goes on where the subject is made again.
  Flickering(std::unique_ptr<oracle::Subject> inner, bool keeps_state, std::size_t& runs)
      : WrappedSubject(std::move(inner)), keeps_state_(keeps_state), runs_(runs) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    bool is_due = ++runs_ % 97 == 0;
    return WrappedSubject::run(id, program, [&](const reference::Record& record) {
      reference::Record shown = record;
      if (is_due && reference::is_motion(record.kind)) {
        shown.to[reference::Axis::x] += reference::Number(1);
        is_due = false;
      }
      return sink(shown);
    });
  }
  bool keeps_state() const override { return keeps_state_; }

 private:
  bool keeps_state_;
  std::size_t& runs_;
};

inline HuntOptions hunting(const std::string& dialect, std::uint64_t seed = 1) {
  HuntOptions options;
  options.dialect = dialect;
  options.seed = seed;
  return options;
}

}  // namespace gonogo::hunt::testing
