// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/output_file.hpp"

#include <cerrno>
#include <system_error>

namespace gonogo::oracle {

namespace fs = std::filesystem;

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
  std::error_code ignored;
  if (!fs::exists(path_, ignored) || fs::is_regular_file(path_, ignored)) part_ += ".part";
  out_.open(part_, std::ios::binary | std::ios::trunc);
  if (!out_) fail();
}

OutputFile::~OutputFile() {
  if (done_ || part_ == path_) return;
  out_.close();
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void OutputFile::fail() const {
  throw std::system_error(errno, std::generic_category(), path_.string() + " cannot be written");
}

void OutputFile::write(std::string_view text) {
  if (!out_.write(text.data(), static_cast<std::streamsize>(text.size()))) fail();
}

void OutputFile::commit() {
  out_.close();
  if (!out_) fail();
  if (part_ != path_) fs::rename(part_, path_);
  done_ = true;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace gonogo::oracle
