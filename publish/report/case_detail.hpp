// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page shows of one case that is not GO: its evidence, both paths motion by motion and
// the drawing sheet.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "publish/report/case_paths.hpp"

namespace gonogo::oracle::report {

// The bytes of a case's program; nothing when the line has none.
std::optional<std::string> program_bytes(const Json& line);

// A case of the corpus, and the profile that it was judged under.
struct CorpusCase {
  std::string dialect;
  std::string comment;
  Json profile;  // the keys that differ from the defaults
  Json program;  // a text, or {"base64"}
};
// What the page shows of a case whose line holds no program: the subject is GO, so the path is the
// reference's.
Json pass_detail(const CorpusCase& test);

// `line` is a case line of a results file, with what its writer knows besides; `subject_name`
// stands on the sheet. `with_paths` false: without drawing and records, to keep a page of very many
// failures small.
Json case_detail(const Json& line, std::string_view subject_name, bool with_paths);

// Where the two sides part: places in what reference_path and subject_path draw.
struct Parting {
  std::optional<std::size_t> wanted;  // of the reference's
  std::optional<std::size_t> record;  // of the subject's
};

// How long the case takes on both sides, as far as its records say.
// {"rows": [[what, reference, reference to the departure, subject to it, hint], ...], "leftOut":
// motions without a known length}; rows of parts that either side has. A subject is read to its
// departure, so that both are compared up to there. Where the departure is not known, the
// reference's entry is "" and the whole trace of the subject counts.
// Null: not given, because the program renames positions, or there is too much of it.
Json case_times(const reference::Profile& profile, std::string_view program, const Json& trace,
                const Parting& parting);

}  // namespace gonogo::oracle::report
