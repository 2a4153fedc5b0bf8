// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program with other lines, for asking what the reference says of it then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/steps/program_input.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

class ChangedProgram : public grammar::ByteSource {
 public:
  // What a line becomes; nothing: the program ends before it.
  using Change = std::function<std::optional<std::string_view>(const grammar::Line& line)>;

  // What it is given must outlive it.
  ChangedProgram(const reference::Profile& profile, const ProgramText& program, Change change);
  std::size_t read(char* data, std::size_t capacity) override;

 private:
  ProgramInput input_;
  Change change_;
  std::string text_;
  std::size_t at_ = 0;
};

// The alarm with which it ends; nothing: it has none among so many items.
std::optional<reference::AlarmReport> alarm_of(const reference::Profile& profile,
                                               const ProgramText& program,
                                               ChangedProgram::Change change,
                                               std::size_t most_items);

}  // namespace gonogo::oracle
