// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/publish/evidence/results_files.hpp"

#include <stdlib.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "corpus/io/sha256.hpp"

namespace gonogo::oracle {

namespace fs = std::filesystem;

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "gonogo-evidence-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Scratch::write(const std::string& name, std::string_view text) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

std::string Scratch::read(const std::string& name) const {
  std::ifstream in(path_ / name, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string results_text(const std::vector<std::string>& cases, const std::string& decision) {
  using Json = nlohmann::ordered_json;
  std::string text = std::string(kHeaderLine) + "\n";
  Sha256 hash;
  std::map<std::string, int> totals;
  std::size_t judged = 0;
  for (const std::string& line : cases) {
    text += line + "\n";
    Json value = Json::parse(line);
    const auto verdict = value["verdict"].get<std::string>();
    ++totals[verdict];
    const bool is_neither = verdict == "skip" || verdict == "advice" || verdict == "xfail";
    if (!is_neither && !verdict.starts_with("oracle-")) ++judged;
    value.erase("us");
    value.erase("attempts");
    value.erase("notes");
    hash.update(value.dump() + "\n");
  }
  Json footer;
  footer["decision"] = decision;
  footer["totals"] = totals;
  footer["judged"] = judged;
  footer["cases"] = cases.size();
  footer["assignments"] = Json::array();
  footer["sha256"] = hash.hex();
  return text + footer.dump() + "\n";
}

}  // namespace gonogo::oracle
