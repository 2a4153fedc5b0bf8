// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace gonogo::oracle {

// A new folder that only this user can enter; it goes with the object, and all in it.
class PrivateFolder {
 public:
  // Throws std::system_error.
  PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  // Writes a file that only this user can read, in place of one of the same name.
  std::string write(std::string_view name, std::string_view text) const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace gonogo::oracle
