// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory of GMP's and MPFR's numbers in the fuzz targets: lists of free blocks in place of the
// address sanitizer's heap, on which a generated program's thousands of short-lived numbers would
// spend a third of its time. Both libraries are compiled without the sanitizers, so nothing looks
// at their accesses either way; the nodes that hold the numbers stay on the sanitizer's heap.
// GONOGO_FUZZ_GMP_HEAP=1 leaves the numbers there, too. One thread only, as a fuzz target is.
#include <gmp.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

constexpr std::size_t kStep = 16;      // bytes: of one list's blocks more than of the one before
constexpr std::size_t kLargest = 512;  // bytes: larger blocks are the heap's
constexpr std::size_t kChunk = 1 << 16;

struct FreeBlock {
  FreeBlock* next;
};

std::array<FreeBlock*, kLargest / kStep + 1> free_blocks{};
std::byte* chunk_end = nullptr;
std::byte* chunk_next = nullptr;

std::size_t list_of(std::size_t size) {
  return (size + kStep - 1) / kStep;
}

void* from_heap(std::size_t size) {
  void* const block = std::malloc(size);
  if (block == nullptr) std::abort();
  return block;
}

void* allocate(std::size_t size) {
  if (size > kLargest) return from_heap(size);
  FreeBlock*& first = free_blocks[list_of(size)];
  if (first != nullptr) {
    FreeBlock* const block = first;
    first = block->next;
    return block;
  }
  const std::size_t bytes = (list_of(size) + (size == 0 ? 1 : 0)) * kStep;
  if (chunk_end - chunk_next < static_cast<std::ptrdiff_t>(bytes)) {
    // The last one is still reachable through its blocks, for the leak sanitizer.
    chunk_next = static_cast<std::byte*>(from_heap(kChunk));
    chunk_end = chunk_next + kChunk;
  }
  void* const block = chunk_next;
  chunk_next += bytes;
  return block;
}

void release(void* block, std::size_t size) {
  if (size > kLargest) return std::free(block);
  FreeBlock*& first = free_blocks[list_of(size)];
  first = ::new (block) FreeBlock{first};
}

void* resize(void* block, std::size_t before, std::size_t after) {
  if (before <= kLargest && after <= kLargest && list_of(before) == list_of(after)) return block;
  void* const other = allocate(after);
  std::memcpy(other, block, before < after ? before : after);
  release(block, before);
  return other;
}

// Before the first number is made.
[[gnu::constructor(101)]] void take_over() {
  if (std::getenv("GONOGO_FUZZ_GMP_HEAP") == nullptr) {
    mp_set_memory_functions(allocate, resize, release);
  }
}

}  // namespace
