// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a case that is not GO takes on both sides, as far as its records say.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "publish/report/case_paths.hpp"

namespace gonogo::oracle::report {

// Where the two sides part: places in what reference_path and subject_path draw.
struct Parting {
  std::optional<std::size_t> wanted;  // of the reference's
  std::optional<std::size_t> record;  // of the subject's
};

// {"rows": [[what, reference, reference to the departure, subject to it, hint], ...], "leftOut":
// motions without a known length}; rows of parts that either side has. A subject is read to its
// departure, so that both are compared up to there. Where the departure is not known, the
// reference's entry is "" and the whole trace of the subject counts.
// Null: not given, because the program renames positions, or there is too much of it.
Json case_times(const reference::Profile& profile, std::string_view program, const Json& trace,
                const Parting& parting);

}  // namespace gonogo::oracle::report
