// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/first_subject.hpp"

#include <mutex>
#include <utility>

namespace gonogo::cli {

oracle::SubjectMaker beginning_with(std::unique_ptr<oracle::Subject> first,
                                    oracle::SubjectMaker maker) {
  struct Kept {
    std::mutex mutex;
    std::unique_ptr<oracle::Subject> subject;
  };
  auto kept = std::make_shared<Kept>();
  kept->subject = std::move(first);
  return [kept, make = std::move(maker)] {
    {
      const std::lock_guard lock(kept->mutex);
      if (kept->subject) return std::move(kept->subject);
    }
    return make();
  };
}

}  // namespace gonogo::cli
