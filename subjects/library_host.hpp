// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipe protocol in front of the C interface: what runs in the process of a library.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "gonogo/subject.h"

namespace gonogo::oracle {

// How many runs the runner may send ahead.
inline constexpr int kHostWindow = 64;

// The `feature` of an outcome "error" when the library broke the C interface. The runner knows its
// own host, and takes such an outcome for `protocol`.
inline constexpr std::string_view kBrokenInterface = "c-interface";

class LibraryHost {
 public:
  // Reads and writes the two descriptors. Throws SubjectUnusable when the table or the description
  // cannot be used.
  LibraryHost(const gonogo_subject_v1& subject, int input, int output);
  LibraryHost(LibraryHost&&) noexcept;
  ~LibraryHost();

  // Answers until `stop`, until the input ends, or until nobody reads the output any more.
  void serve();

  // The reply to `start`: the library's description with the host's window.
  const std::string& start_reply() const;

 private:
  // The size of a parser of simdjson hangs on how a target is compiled: no other target sees it.
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gonogo::oracle
