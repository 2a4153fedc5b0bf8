// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/programs.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "oracle/records/input_file.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"
#include "publish/evidence/text.hpp"

namespace gonogo::oracle::evidence {
namespace {

constexpr const char* kList = ".written";

// Only plain names: the list may have come from elsewhere.
void remove_listed(const std::filesystem::path& folder) {
  std::ifstream list = open_regular(folder / kList);
  std::string name;
  while (std::getline(list, name)) {
    const bool is_ours = name.ends_with(".nc") || name.ends_with(".txt");
    if (!is_ours || file_stem(name) != name) continue;
    std::error_code ignored;
    std::filesystem::remove(folder / name, ignored);
  }
}

}  // namespace

ProgramFolder::ProgramFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (std::filesystem::is_directory(folder_)) remove_listed(folder_);
  std::filesystem::create_directories(folder_);
  open_anew(folder_ / kList, list_);
}

void ProgramFolder::add(const CaseRow& facts) {
  if (facts.decision() == Decision::go || !facts.program) return;
  const std::string name = file_stem(facts.id);
  list_ << name << ".nc\n" << name << ".txt\n";
  write_file(folder_ / (name + ".nc"), *facts.program);
  write_file(folder_ / (name + ".txt"),
             visible(fmt::format("{} {}\n{}", facts.id, facts.verdict(), finding_text(facts, "  ")),
                     Lines::kept));
}

void ProgramFolder::finish() {
  list_.close();
  if (!list_) {
    throw std::system_error(errno, std::generic_category(),
                            (folder_ / kList).string() + " cannot be written");
  }
}

}  // namespace gonogo::oracle::evidence
