// SPDX-License-Identifier: GPL-3.0-or-later
//
// The certificate of a run: a folder that states what was judged, with the results and everything
// that the statement rests on, so that it can be verified elsewhere.
#pragma once

#include <optional>
#include <string>

namespace gonogo::oracle::evidence {

struct CertificateSources {
  std::string results;         // a results file
  std::string known_failures;  // TOML files of the run; empty: the run had none
  std::string alarm_map;
  std::string profile;
  std::string traces;  // folder of `certify --traces`; empty: none are kept
};

// Writes STATEMENT.md, statement.json, results.jsonl, what there is of waivers.toml,
// alarm-map.toml, profile.toml or .json and traces/<id>.jsonl, and SHA256SUMS over all of them.
// Refuses a results file that is faulty or incomplete, one with cases that are known to fail
// without the file of the reasons, and a folder that holds other files. Returns why not, a
// sentence. Throws std::system_error where something cannot be written.
std::optional<std::string> write_certificate(const CertificateSources& sources,
                                             const std::string& folder);

}  // namespace gonogo::oracle::evidence
