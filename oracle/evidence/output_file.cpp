// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/evidence/output_file.hpp"

#include <cerrno>
#include <system_error>

namespace gonogo::oracle::evidence {

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  out_.open(part_, std::ios::binary | std::ios::trunc);
  if (!out_) fail();
}

OutputFile::~OutputFile() {
  if (done_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
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
  std::filesystem::rename(part_, path_);
  done_ = true;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace gonogo::oracle::evidence
