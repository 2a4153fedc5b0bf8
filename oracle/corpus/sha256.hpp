// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nettle/sha2.h>

#include <string>
#include <string_view>

namespace gonogo::oracle {

// SHA-256 of bytes that come in parts.
class Sha256 {
 public:
  Sha256();
  void update(std::string_view bytes);
  // 64 lower-case hexadecimal digits; the object starts anew.
  std::string hex();

 private:
  sha256_ctx context_;
};

}  // namespace gonogo::oracle
