// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/engine/shared_page.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include "reference/profile.hpp"

namespace gonogo::fuzz {

SharedPage& SharedPage::make() {
  void* const memory = ::mmap(nullptr, sizeof(SharedPage), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  return *new (memory) SharedPage;
}

void SharedPage::unmap(SharedPage& page) {
  ::munmap(&page, sizeof(SharedPage));
}

void SharedPage::note(const generate::GeneratedProgram& program) {
  const std::string profile = reference::profile_json(program.profile);
  // Empty while it is written.
  profile_size_ = text_size_ = 0;
  if (profile.size() > kMost || program.text.size() > kMost) return;
  std::ranges::copy(program.text, text_.begin());
  std::ranges::copy(profile, profile_.begin());
  text_size_ = program.text.size();
  profile_size_ = profile.size();
}

std::optional<generate::GeneratedProgram> SharedPage::noted(const std::string& dialect) const {
  if (profile_size_ == 0) return std::nullopt;
  auto profile = reference::profile_from_json({profile_.data(), profile_size_}, dialect);
  auto* const read = std::get_if<reference::Profile>(&profile);
  if (read == nullptr) return std::nullopt;
  return generate::GeneratedProgram{std::move(*read), std::string(text_.data(), text_size_)};
}

void SharedPage::count_program() {
  count.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  if (++count.programs == 1) count.first_after = count.seconds;
}

}  // namespace gonogo::fuzz
