// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subject capture:DIR: what came back from a controller. DIR holds a file for each case,
//   <id>.jsonl  records, as `gonogo judge --trace` takes them, or
//   <id>.csv    sampled axis positions (sample_reader.hpp),
// under the id of the case or the number under which `gonogo export` wrote its program;
//   manifest.json  of the export: how many lines stand before each program (optional);
//   subject.json   the reply to `start` (optional): name, version, numeric, features.
// A case without a file is skipped.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

// Throws SubjectUnusable when DIR or one of the files above cannot be used.
std::unique_ptr<Subject> make_capture_subject(const std::string& folder,
                                              const CaptureOptions& options);

}  // namespace gonogo::oracle
