// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hostile/failing_allocation.hpp"

#include <dlfcn.h>
#include <execinfo.h>

#include <array>
#include <cstdlib>
#include <new>
#include <string_view>

namespace gonogo::hostile {
namespace {

struct Plan {
  bool stands = false;
  Failing how = Failing::once;
  std::uint64_t number = 0;
  std::uint64_t count = 0;
  bool has_failed = false;
};

thread_local constinit Plan plan;
thread_local constinit std::int64_t in_use = 0;

// The destructor of nlohmann's JSON allocates a stack for the values that it holds. Where it
// cannot, the process ends, and no user of the library can do anything about it.
bool is_in_json_destructor() {
  constexpr int kFrames = 16;
  std::array<void*, kFrames> frames{};
  const int count = ::backtrace(frames.data(), kFrames);
  for (int i = 0; i < count; ++i) {
    Dl_info info{};
    if (::dladdr(frames[static_cast<std::size_t>(i)], &info) != 0 && info.dli_sname != nullptr &&
        std::string_view(info.dli_sname).find("json_value7destroy") != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

bool fails_now() {
  if (!plan.stands) return false;
  ++plan.count;
  const bool is_one =
      plan.how == Failing::once ? plan.count == plan.number : plan.count >= plan.number;
  if (!is_one) return false;
  if (!is_in_json_destructor()) return plan.has_failed = true;
  if (plan.how == Failing::once) ++plan.number;  // the next one then
  return false;
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (fails_now()) throw std::bad_alloc();
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* const block = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (block == nullptr) throw std::bad_alloc();
  ++in_use;
  return block;
}

void release(void* block) {
  if (block != nullptr) --in_use;
  std::free(block);
}

}  // namespace

FailingAllocation::FailingAllocation(std::uint64_t number, Failing how) {
  plan = {true, how, number, 0, false};
}

FailingAllocation::~FailingAllocation() {
  plan.stands = false;
}

bool FailingAllocation::has_failed() const {
  return plan.has_failed;
}

std::int64_t blocks_in_use() {
  return in_use;
}

}  // namespace gonogo::hostile

// The forms for arrays and those that do not throw call these.
void* operator new(std::size_t size) {
  return gonogo::hostile::allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return gonogo::hostile::allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept {
  gonogo::hostile::release(block);
}
void operator delete(void* block, std::size_t) noexcept {
  gonogo::hostile::release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  gonogo::hostile::release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  gonogo::hostile::release(block);
}
