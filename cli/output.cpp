// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/terminal.hpp"

namespace gonogo::cli {

void Output::flush() {
  std::string_view rest = text_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      text_.clear();
      throw OutputError(fmt::format("The output cannot be written: {}.", std::strerror(reason)),
                        reason == EPIPE);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  text_.clear();
}

void Output::tell() {
  if (::isatty(descriptor_) == 1) text_ = wrapped(text_, columns_of_terminal(descriptor_));
  flush();
}

}  // namespace gonogo::cli
