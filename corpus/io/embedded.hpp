// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus inside the program, for a copy of the program that has no folder beside it
// (packaging/README.md).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gonogo::oracle {

struct EmbeddedFile {
  std::string_view name;  // below the folder: "vectors/rs274/basic.json"
  std::string_view gzip;  // the bytes as a gzip file
};

// Stands for the folder of the embedded corpus wherever the name of a corpus folder is asked for.
inline constexpr std::string_view kEmbeddedFolder = "carried:";

// Empty in a program that has none. packaging/embed-corpus writes the definition of one that
// does, which the linker then takes instead.
std::span<const EmbeddedFile> embedded_corpus();

// The bytes of an embedded file. Throws CorpusError where they are no whole gzip file.
std::string embedded_text(const EmbeddedFile& file);

}  // namespace gonogo::oracle
