// SPDX-License-Identifier: GPL-3.0-or-later
//
// A control group (Linux, version 2) of one subject, where this program may make one: the kernel
// bounds the memory and the processes in it, and ends all of them at once. Where there is none, the
// walk over the descendants (process_family.hpp) is all that there is.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace gonogo::oracle {

class ControlGroup {
 public:
  ControlGroup() = default;  // none
  // Beside the group of this program, or below it where that is the first one; none where that is
  // not allowed. The measured limits of a subject end it before the kernel does: its bounds are
  // wider.
  static ControlGroup make(std::size_t memory_bytes, std::size_t processes);
  // In the folder of a group that is there.
  explicit ControlGroup(std::string folder) : folder_(std::move(folder)) {}
  ControlGroup(ControlGroup&& other) noexcept { folder_.swap(other.folder_); }
  ControlGroup& operator=(ControlGroup&& other) noexcept {
    folder_.swap(other.folder_);
    return *this;
  }
  ~ControlGroup();  // ends what is in it and removes it

  bool exists() const { return !folder_.empty(); }
  // Only the controllers that the system gives to groups at this place know their limit.
  void limit(std::size_t memory_bytes, std::size_t processes) const;
  // The words of a command that goes into the group before anything else; the same without a group.
  std::vector<std::string> entering(std::vector<std::string> words) const;
  std::vector<pid_t> processes() const;
  void kill() const;

 private:
  bool write(const char* file, const std::string& text) const;

  std::string folder_;
};

}  // namespace gonogo::oracle
