// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subjects that follow readings which they were not given, or have faults.
#pragma once

#include <memory>

#include "expanders/registry.hpp"
#include "fuzz/identify/outcome.hpp"
#include "subjects/make_subject.hpp"
#include "tests/fuzz/wrapped_subject.hpp"

namespace gonogo::identify::testing {

// Passes everything on, but the readings of the profile: those it has of its own.
class SecretSubject : public WrappedSubject {
 public:
  SecretSubject(std::unique_ptr<oracle::Subject> inner, reference::ReadingChoice readings)
      : WrappedSubject(std::move(inner)), readings_(std::move(readings)) {}

  void configure(const Profile& profile) override {
    told_a_reading_ = told_a_reading_ || !(profile.readings == reference::ReadingChoice());
    Profile own = profile;
    own.readings = readings_;
    WrappedSubject::configure(own);
  }

  bool told_a_reading() const { return told_a_reading_; }

 private:
  reference::ReadingChoice readings_;
  bool told_a_reading_ = false;
};

// The reference itself as a subject: it follows every reading that there is.
class ReferenceSubject : public oracle::Subject {
 public:
  ReferenceSubject() {
    info_.name = "reference";
    info_.everything = true;
    info_.features = {"blocks"};
  }
  const oracle::SubjectInfo& info() const override { return info_; }
  void configure(const Profile& profile) override { profile_ = profile; }
  oracle::RunEnd run(std::string_view, std::string_view program,
                     const oracle::RecordSink& sink) override {
    const auto outcome = run_reference(profile_, program);
    for (const Record& record : outcome->records) {
      if (!sink(record)) break;
    }
    return outcome->end;
  }
  void renew() override {}

 private:
  oracle::SubjectInfo info_;
  Profile profile_;
};

inline std::unique_ptr<oracle::Subject> builtin(std::string_view name,
                                                std::string_view fault = {}) {
  return oracle::make_interface_subject(*expanders::find(name, fault));
}

// Two faults that have nothing to do with each other: centres of arcs are taken as absolute, and
// dwells are a thousand times too long.
inline constexpr const char* kDwellCause = "dwells come out milliseconds";
class TwoFaults : public WrappedSubject {
 public:
  TwoFaults() : WrappedSubject(builtin("ngc", "offsets-absolute")) {}
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    return WrappedSubject::run(id, program, [&](const Record& record) {
      Record own = record;
      own.seconds = own.seconds * reference::Number::millionths(1'000'000'000);
      return sink(own);
    });
  }
};

inline Profile default_machine(std::string_view dialect) {
  return std::get<Profile>(reference::default_profile(dialect));
}

}  // namespace gonogo::identify::testing
