// SPDX-License-Identifier: GPL-3.0-or-later
//
// Case lines put into the order of their ids in memory that does not grow with their number: they
// go out to temporary files as sorted runs, which are merged.
#pragma once

#include <cerrno>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

// A file of the results cannot be written or read back: a sentence. The run is undecided.
class ResultsUnwritable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, FileCloser>;

// The stream of a descriptor, which it owns; null where that is -1, or cannot have one.
FileHandle open_stream(int descriptor, const char* mode);
// False, and errno, when line and line end cannot be written.
bool write_line(std::FILE* file, std::string_view line);
// Throws ResultsUnwritable with the file and the text of the error.
[[noreturn]] void fail_to_write(const std::string& path, int error = errno);

// The lines of a file from its beginning, without their ends.
class StoredLines {
 public:
  // `name` for people. Throws ResultsUnwritable, as next() does.
  StoredLines(std::FILE* file, std::string name);
  StoredLines(StoredLines&& other) noexcept;
  StoredLines& operator=(StoredLines&&) = delete;
  ~StoredLines();

  // False behind the last line; a file that cannot be read has none.
  bool next(std::string& line);

 private:
  std::FILE* file_;
  std::string name_;
  char* buffer_ = nullptr;
  std::size_t size_ = 0;
};

class LineSorter {
 public:
  // `folder`: where the temporary files go; they have no name there. A run is written when its
  // lines have more than `run_bytes`.
  explicit LineSorter(std::string folder, std::size_t run_bytes = std::size_t{4} << 20)
      : folder_(std::move(folder)), run_bytes_(run_bytes) {}

  // Throws ResultsUnwritable.
  void add(std::string line);
  std::size_t size() const { return size_; }
  // Visits every line once, in order; to be called once. Two lines of one id come one after the
  // other. Throws ResultsUnwritable, also when what is read back is not what was written.
  using Visit = std::function<void(const std::string& id, const std::string& line)>;
  void for_each(const Visit& visit);

 private:
  struct Entry {
    std::string id;
    std::string line;
  };
  // A sorted run; of a higher level, many of the level below.
  struct Run {
    FileHandle file;
    int level = 0;
    std::string sha256;  // of its lines
  };
  void sort_held();
  void write_run();
  void merge_last(std::size_t count);
  class RunWriter;
  FileHandle temporary() const;
  void merge(std::span<const Run> runs, const Visit& visit) const;

  std::string folder_;
  std::size_t run_bytes_;
  std::vector<Entry> held_;
  std::size_t held_bytes_ = 0;
  std::size_t size_ = 0;
  std::vector<Run> runs_;  // levels never rise
};

}  // namespace gonogo::oracle
