// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "corpus/io/corpus.hpp"
#include "corpus/io/sha256.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle {
namespace {

std::vector<std::string> ids_of(const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  ids.reserve(cases.size());
  for (const Case& test : cases) ids.push_back(test.id);
  return ids;
}

// The dialect in whose folder a file lies; empty: in that of none.
std::string dialect_of_folder(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  const bool is_one = folder.parent_path() == "vectors" &&
                      reference::find_dialect(folder.filename().string()) != nullptr;
  return is_one ? folder.filename().string() : std::string();
}

// Where a name stands in the order of a seed.
std::uint64_t place_of(std::uint64_t seed, const std::string& name) {
  return leading_bytes(fmt::format("{} {}", seed, name));
}

}  // namespace

CaseReader::CaseReader(const Corpus& corpus, Detail detail, std::vector<std::string> dialects,
                       std::uint64_t seed)
    : corpus_(corpus),
      detail_(detail),
      dialects_(std::move(dialects)),
      seed_(seed),
      ids_([this](std::size_t file) {
        return ids_of(read_vector_file(path(file), Detail::to_run));
      }) {
  for (std::size_t file = 0; file < corpus.files().size(); ++file) {
    const std::string dialect = dialect_of_folder(corpus.files()[file]);
    if (!dialect.empty() && !is_wanted(dialect)) continue;
    order_.push_back(file);
    bytes_ += corpus.file_bytes()[file];
  }
  if (seed_ == 0) return;
  std::ranges::sort(order_, {}, [&](std::size_t file) {
    return std::pair(place_of(seed_, corpus_.files()[file]), file);
  });
}

// By the number of its turn.
std::string CaseReader::path(std::size_t file) const {
  return corpus_.folder() + "/" + corpus_.files()[order_[file]];
}

bool CaseReader::is_wanted(const std::string& dialect) const {
  return dialects_.empty() || std::ranges::find(dialects_, dialect) != dialects_.end();
}

// A group stays together: its cases share a profile, which a subject gets once.
void CaseReader::shuffle() {
  if (seed_ == 0) return;
  using Place = std::tuple<std::uint64_t, std::string, std::uint64_t, std::string>;
  std::map<Place, Case> placed;
  for (Case& test : cases_) {
    Place place(place_of(seed_, test.group), test.group, place_of(seed_, test.id), test.id);
    placed.emplace(std::move(place), std::move(test));
  }
  cases_.clear();
  for (auto& [place, test] : placed) cases_.push_back(std::move(test));
}

// Only now that an id is met again is it worth the time to look where it stood first.
void CaseReader::refuse_again(const std::string& id) const {
  const std::string here = path(files_read_ - 1);
  for (std::size_t file = 0; file + 1 < files_read_; ++file) {
    const std::vector<Case> others = read_vector_file(path(file), Detail::to_run);
    if (std::ranges::find(others, id, &Case::id) == others.end()) continue;
    throw CorpusError(
        fmt::format("{}: The id {} stands in {} too.", here, id, corpus_.files()[order_[file]]));
  }
}

void CaseReader::read_file() {
  const std::size_t file = order_[files_read_];
  present_bytes_ = corpus_.file_bytes()[file];
  cases_ = read_vector_file(path(files_read_++), detail_);
  if (const auto again = ids_.add(ids_of(cases_))) refuse_again(*again);
  if (cases_.empty()) return;
  const std::string& dialect = cases_.front().dialect;
  const std::string of_folder = dialect_of_folder(corpus_.files()[file]);
  if (!of_folder.empty() && of_folder != dialect) {
    throw CorpusError(fmt::format("{}: The dialect is {}, and the folder is that of {}.",
                                  path(files_read_ - 1), dialect, of_folder));
  }
  if (!is_wanted(dialect)) cases_.clear();
  shuffle();
}

std::optional<Case> CaseReader::next() {
  while (next_ == cases_.size()) {
    bytes_before_ += std::exchange(present_bytes_, 0);
    cases_.clear();
    next_ = 0;
    if (files_read_ == order_.size()) return std::nullopt;
    read_file();
  }
  Case& test = cases_[next_++];
  if (corpus_.retired().contains(test.id)) {
    throw CorpusError(fmt::format("{}: The id {} is retired and cannot be used again.",
                                  path(files_read_ - 1), test.id));
  }
  return std::move(test);
}

double CaseReader::part() const {
  if (bytes_ == 0) return 1;
  auto done = static_cast<double>(bytes_before_);
  if (!cases_.empty()) {
    const double within = static_cast<double>(next_) / static_cast<double>(cases_.size());
    done += within * static_cast<double>(present_bytes_);
  }
  return done / static_cast<double>(bytes_);
}

}  // namespace gonogo::oracle
