// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace gonogo::oracle::evidence {

// A file that is written beside its place and put there when it is whole; until then nothing that
// lies there is touched. Throws std::system_error when it cannot be written.
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
  std::ofstream out_;
  bool done_ = false;
};

// A whole file at once.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace gonogo::oracle::evidence
