// SPDX-License-Identifier: GPL-3.0-or-later
//
// Replaces operator new of the process that it is linked into. Apart from the tests, where g++
// would inline one half of it and warn of a mismatch.
#include "tests/grammar/counting_new.hpp"

#include <cstdlib>
#include <new>

namespace {
std::size_t allocations = 0;
}  // namespace

std::size_t allocation_count() {
  return allocations;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
