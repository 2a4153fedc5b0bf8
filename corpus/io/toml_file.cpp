// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/toml_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "corpus/io/corpus.hpp"
#include "oracle/records/input_file.hpp"
#include "reference/toml_text.hpp"

namespace gonogo::oracle {

toml::table read_toml_file(const std::string& path) {
  std::ifstream file = open_regular(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw CorpusError(fmt::format("{} cannot be read.", path));
  try {
    return reference::parse_toml(text);
  } catch (const toml::parse_error& error) {
    throw CorpusError(fmt::format("{}: {}", path, reference::toml_fault(text, error)));
  }
}

}  // namespace gonogo::oracle
