// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace gonogo::oracle {

namespace fs = std::filesystem;

int create_anew(const std::filesystem::path& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return -1;
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

void open_anew(const std::filesystem::path& path, std::ofstream& out) {
  const int descriptor = create_anew(path);
  if (descriptor < 0) {
    out.setstate(std::ios::failbit);
    return;
  }
  out.open(path, std::ios::binary | std::ios::trunc);
  ::close(descriptor);
}

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
  std::error_code ignored;
  if (!fs::exists(path_, ignored) || fs::is_regular_file(path_, ignored)) part_ += ".part";
  const int descriptor =
      part_ == path_ ? ::open(path_.c_str(), O_WRONLY | O_CLOEXEC) : create_anew(part_);
  out_ = descriptor < 0 ? nullptr : ::fdopen(descriptor, "w");
  if (out_ == nullptr) fail();
}

OutputFile::~OutputFile() {
  if (out_ != nullptr) std::fclose(out_);
  if (done_ || part_ == path_) return;
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void OutputFile::fail() const {
  throw std::system_error(errno, std::generic_category(), path_.string() + " cannot be written");
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), out_) != text.size()) fail();
}

void OutputFile::commit() {
  if (std::fclose(std::exchange(out_, nullptr)) != 0) fail();
  if (part_ != path_) fs::rename(part_, path_);
  done_ = true;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace gonogo::oracle
