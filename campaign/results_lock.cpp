// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

std::string holder_text() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}", ::getpid(), host.data());
}

std::string read_holder(int descriptor) {
  std::array<char, 300> text;
  const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
  if (count <= 0) return "another process";
  return excerpt({text.data(), static_cast<std::size_t>(count)});
}

// A foreign file of that name stays.
bool is_of_a_lock(int descriptor, off_t size) {
  return size == 0 || read_holder(descriptor).starts_with("process ");
}

}  // namespace

// Every process removes the file at its end, so the open file may no longer be the one there.
bool ResultsLock::take() {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
  if (descriptor_ < 0) {
    throw std::system_error(errno, std::generic_category(), path_ + " cannot be written");
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    const std::string holder = read_holder(descriptor_);
    ::close(descriptor_);
    throw ResultsRefused(
        fmt::format("{} is held by {}, which writes there. Name another folder, or wait for it.",
                    path_, holder));
  }
  struct stat opened {};
  struct stat there {};
  const bool is_same = ::fstat(descriptor_, &opened) == 0 && ::lstat(path_.c_str(), &there) == 0 &&
                       opened.st_ino == there.st_ino;
  if (is_same && (!S_ISREG(opened.st_mode) || !is_of_a_lock(descriptor_, opened.st_size))) {
    ::close(descriptor_);
    throw ResultsRefused(fmt::format("{} is no lock of a run. Take it away.", path_));
  }
  if (!is_same) ::close(descriptor_);
  return is_same;
}

ResultsLock::ResultsLock(const std::string& results) : path_(results + ".lock") {
  while (!take()) {
  }
  const std::string holder = holder_text();
  // On a full disk the lock holds without a name.
  [[maybe_unused]] const bool is_named = ::ftruncate(descriptor_, 0) == 0 &&
                                         ::pwrite(descriptor_, holder.data(), holder.size(), 0) > 0;
}

ResultsLock::~ResultsLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace gonogo::oracle
