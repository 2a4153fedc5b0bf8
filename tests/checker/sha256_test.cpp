// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples of FIPS 180-2, appendix B.
#include "checker/sha256.hpp"

#include <gtest/gtest.h>

namespace gonogo::checker {
namespace {

std::string hash_of(std::string_view text) {
  Sha256 hash;
  hash.update(text);
  return hash.hex();
}

TEST(CheckerSha256, OneBlock) {
  EXPECT_EQ(hash_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(CheckerSha256, TwoBlocks) {
  EXPECT_EQ(hash_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(CheckerSha256, AMillionLetters) {
  EXPECT_EQ(hash_of(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(CheckerSha256, PiecesMakeTheWhole) {
  Sha256 hash;
  hash.update("a");
  hash.update("bc");
  EXPECT_EQ(hash.hex(), hash_of("abc"));
}

}  // namespace
}  // namespace gonogo::checker
