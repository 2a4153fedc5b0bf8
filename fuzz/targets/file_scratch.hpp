// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the fuzz target of files puts them: a folder that is made once, and goes with the process.
// An engine that ends the process at once leaves it behind.
#pragma once

#include <string>
#include <string_view>

#include "subjects/private_folder.hpp"

namespace gonogo::fuzz {

class Scratch {
 public:
  // With a corpus of two cases, and all of a certificate but its results.
  Scratch();
  std::string path(std::string_view name) const { return folder_.path() + "/" + std::string(name); }
  // Writes the file; its path.
  std::string put(std::string_view name, std::string_view text) const {
    return folder_.write(name, text);
  }
  const std::string& corpus_sha256() const { return corpus_sha256_; }

 private:
  oracle::PrivateFolder folder_;
  std::string corpus_sha256_;
};

const Scratch& scratch();

// Which gonogo is said to have written mended results.
inline constexpr const char* kMendedVersion = "0.0.0";

// A results file with the hash that its lines have, of that gonogo and of the corpus of the scratch
// folder: else hardly a change of a line would come further than to the hash.
std::string mended_results(std::string_view file);

}  // namespace gonogo::fuzz
