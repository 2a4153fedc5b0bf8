// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject in a test that does one thing otherwise than another subject.
#pragma once

#include <memory>
#include <string_view>
#include <utility>

#include "oracle/differential/subject.hpp"

namespace gonogo {

// Passes everything on.
class WrappedSubject : public oracle::Subject {
 public:
  explicit WrappedSubject(std::unique_ptr<oracle::Subject> inner) : inner_(std::move(inner)) {}
  const oracle::SubjectInfo& info() const override { return inner_->info(); }
  void configure(const reference::Profile& profile) override { inner_->configure(profile); }
  oracle::RunEnd run(std::string_view id, std::string_view program,
                     const oracle::RecordSink& sink) override {
    return inner_->run(id, program, sink);
  }
  void renew() override { inner_->renew(); }

 private:
  std::unique_ptr<oracle::Subject> inner_;
};

}  // namespace gonogo
