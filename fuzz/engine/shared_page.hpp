// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory that the engine's parent process still reads after the engine has died.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/engine/fuzz_run.hpp"

namespace gonogo::fuzz {

// Where the process is.
enum class FuzzStage : std::uint8_t { loading, running, departed };

class SharedPage {
 public:
  // Mapped before the process forks. Throws std::system_error.
  static SharedPage& make();
  static void unmap(SharedPage& page);

  // The program that is run next.
  void note(const generate::GeneratedProgram& program);
  // The program of the note. Nothing: there was none, or it is too long to be kept.
  std::optional<generate::GeneratedProgram> noted(const std::string& dialect) const;

  void count_program();

  FuzzStage stage = FuzzStage::loading;
  FuzzCount count;

 private:
  static constexpr std::size_t kMost = std::size_t{1} << 18;
  using Clock = std::chrono::steady_clock;

  Clock::time_point begin_ = Clock::now();
  std::size_t text_size_ = 0;
  std::size_t profile_size_ = 0;
  std::array<char, kMost> text_;
  std::array<char, kMost> profile_;
};

}  // namespace gonogo::fuzz
