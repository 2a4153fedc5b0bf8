// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of the gauge's own.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace gonogo::oracle {

// Makes a new file for writing in place of one of the same name, which is neither written to nor
// followed when it is a link; -1 and errno when that cannot be.
int create_anew(const std::filesystem::path& path);

// The same as a stream, failed when that cannot be.
void open_anew(const std::filesystem::path& path, std::ofstream& out);

// A file that is written beside its place and put there when it is whole; until then nothing that
// lies there is touched. What is no regular file, as /dev/stdout, is written to as it is. Throws
// std::system_error when it cannot be written.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::filesystem::path part_;
  std::FILE* out_;
  bool done_ = false;
};

// A whole file at once.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace gonogo::oracle
