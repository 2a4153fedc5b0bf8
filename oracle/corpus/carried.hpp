// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus inside the program, for a copy of the program that has no folder beside it
// (packaging/README.md).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gonogo::oracle {

struct CarriedFile {
  std::string_view name;  // below the folder: "vectors/rs274/basic.json"
  std::string_view gzip;  // the bytes as a gzip file
};

// Stands for the folder of the carried corpus wherever the name of a corpus folder is asked for.
inline constexpr std::string_view kCarriedFolder = "carried:";

// Empty in a program that carries none. packaging/carry-corpus writes the definition of one that
// does, which the linker then takes instead.
std::span<const CarriedFile> carried_corpus();

// The bytes of a carried file. Throws CorpusError where they are no whole gzip file.
std::string carried_text(const CarriedFile& file);

}  // namespace gonogo::oracle
