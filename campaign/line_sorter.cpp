// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/line_sorter.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <queue>
#include <utility>

#include "campaign/results.hpp"
#include "corpus/io/sha256.hpp"

namespace gonogo::oracle {
namespace {

// So many runs of a level become one of the next: each line is written once a level.
constexpr std::size_t kRunsOfALevel = 32;

// A sorted run that is read back line by line, and is what was written.
class RunReader {
 public:
  RunReader(std::FILE* file, std::string sha256, const std::string& folder)
      : lines_(file, "What is sorted in " + folder), folder_(folder), sha256_(std::move(sha256)) {}

  bool next() {
    if (!lines_.next(line)) {
      if (hash_.hex() == sha256_) return false;
      throw ResultsUnwritable(
          fmt::format("Somebody else has written to what is sorted in {}", folder_));
    }
    hash_.update_line(line);
    id = id_of_line(line);
    return true;
  }

  std::string line;
  std::string id;

 private:
  StoredLines lines_;
  std::string folder_;
  std::string sha256_;
  Sha256 hash_;
};

[[noreturn]] void fail_to_sort(const std::string& folder) {
  throw ResultsUnwritable(
      fmt::format("The results cannot be sorted in {}: {}", folder, std::strerror(errno)));
}

[[noreturn]] void fail_to_read(const std::string& name) {
  throw ResultsUnwritable(fmt::format("{} cannot be read back: {}", name, std::strerror(errno)));
}

}  // namespace

FileHandle open_stream(int descriptor, const char* mode) {
  return FileHandle(descriptor < 0 ? nullptr : ::fdopen(descriptor, mode));
}

bool write_line(std::FILE* file, std::string_view line) {
  return std::fwrite(line.data(), 1, line.size(), file) == line.size() &&
         std::fputc('\n', file) != EOF;
}

void fail_to_write(const std::string& path, int error) {
  throw ResultsUnwritable(fmt::format("{} cannot be written: {}", path, std::strerror(error)));
}

StoredLines::StoredLines(std::FILE* file, std::string name) : file_(file), name_(std::move(name)) {
  if (std::fseek(file_, 0, SEEK_SET) != 0) fail_to_read(name_);
}

StoredLines::StoredLines(StoredLines&& other) noexcept
    : file_(other.file_),
      name_(std::move(other.name_)),
      buffer_(std::exchange(other.buffer_, nullptr)),
      size_(other.size_) {}

StoredLines::~StoredLines() {
  std::free(buffer_);
}

bool StoredLines::next(std::string& line) {
  const ssize_t count = ::getline(&buffer_, &size_, file_);
  if (count <= 0) {
    if (std::feof(file_) == 0) fail_to_read(name_);
    return false;
  }
  line.assign(buffer_, static_cast<std::size_t>(count) - 1);
  return true;
}

class LineSorter::RunWriter {
 public:
  RunWriter(FileHandle file, const std::string& folder) : file_(std::move(file)), folder_(folder) {}
  void put(const std::string& line) {
    if (!write_line(file_.get(), line)) fail_to_sort(folder_);
    hash_.update_line(line);
  }
  Run finish(int level) {
    if (std::fflush(file_.get()) != 0) fail_to_sort(folder_);
    return {std::move(file_), level, hash_.hex()};
  }

 private:
  FileHandle file_;
  const std::string& folder_;
  Sha256 hash_;
};

FileHandle LineSorter::temporary() const {
  std::string path = folder_ + "/.sorting-XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(path.c_str());
  FileHandle file = open_stream(descriptor, "w+");
  if (file == nullptr) fail_to_sort(folder_);
  return file;
}

void LineSorter::add(std::string line) {
  std::string id = id_of_line(line);
  ++size_;
  held_bytes_ += line.size() + id.size() + sizeof(Entry);
  held_.push_back({std::move(id), std::move(line)});
  if (held_bytes_ > run_bytes_) write_run();
}

void LineSorter::sort_held() {
  std::ranges::sort(held_, {}, &Entry::id);
}

void LineSorter::write_run() {
  sort_held();
  RunWriter run(temporary(), folder_);
  for (const Entry& entry : held_) run.put(entry.line);
  held_ = {};
  held_bytes_ = 0;
  runs_.push_back(run.finish(0));
  const auto is_full = [&] {
    return runs_.size() >= kRunsOfALevel &&
           runs_[runs_.size() - kRunsOfALevel].level == runs_.back().level;
  };
  while (is_full()) merge_last(kRunsOfALevel);
}

void LineSorter::merge_last(std::size_t count) {
  RunWriter one(temporary(), folder_);
  merge(std::span(runs_).last(count),
        [&](const std::string&, const std::string& line) { one.put(line); });
  Run run = one.finish(runs_.back().level + 1);
  runs_.resize(runs_.size() - count);
  runs_.push_back(std::move(run));
}

void LineSorter::merge(std::span<const Run> runs, const Visit& visit) const {
  std::vector<RunReader> readers;
  for (const Run& run : runs) readers.emplace_back(run.file.get(), run.sha256, folder_);
  // The first of equal ids is that of the first run.
  auto later = [&](std::size_t a, std::size_t b) {
    const int order = readers[a].id.compare(readers[b].id);
    return order != 0 ? order > 0 : a > b;
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> waiting(later);
  for (std::size_t i = 0; i < readers.size(); ++i) {
    if (readers[i].next()) waiting.push(i);
  }
  while (!waiting.empty()) {
    const std::size_t first = waiting.top();
    waiting.pop();
    visit(readers[first].id, readers[first].line);
    if (readers[first].next()) waiting.push(first);
  }
}

void LineSorter::for_each(const Visit& visit) {
  if (runs_.empty()) {
    sort_held();
    for (const Entry& entry : held_) visit(entry.id, entry.line);
    held_ = {};
    return;
  }
  if (!held_.empty()) write_run();
  merge(runs_, visit);
  runs_.clear();
}

}  // namespace gonogo::oracle
