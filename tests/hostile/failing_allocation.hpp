// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory that comes to its end: operator new of the whole program, which throws std::bad_alloc at a
// chosen allocation. GMP and MPFR take theirs from malloc and end the process where there is none,
// so their numbers are not tried.
#pragma once

#include <cstdint>

namespace gonogo::hostile {

enum class Failing : std::uint8_t {
  once,       // the allocation of that number, and no other
  from_then,  // that one and all behind it
};

// While it stands, allocations of this thread are counted from 1, and that one fails.
class FailingAllocation {
 public:
  FailingAllocation(std::uint64_t number, Failing how);
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;
  ~FailingAllocation();
  bool has_failed() const;
};

// Blocks that are allocated now.
std::int64_t blocks_in_use();

}  // namespace gonogo::hostile
