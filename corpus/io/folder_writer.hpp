// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus folder written whole: vector files, and the manifest that names them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

struct CorpusFolder {
  std::string version;
  std::set<std::string> retired;
  std::map<std::string, std::vector<Case>> files;  // "vectors/gsk988ta/g94.json" -> its cases
  std::string license = "CC0-1.0";                 // an identifier of SPDX
};

std::string manifest_text(const CorpusFolder& corpus);

// Writes into a folder that is empty or not there yet. Every case is read again from what was
// written and its expectations are computed anew: one that differs is a CorpusError. Throws
// std::system_error where something cannot be written.
void write_corpus(const std::string& folder, const CorpusFolder& corpus);

}  // namespace gonogo::oracle
