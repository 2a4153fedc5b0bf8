// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>

namespace gonogo::expanders {

/// What a block will do. Preparing it checks every rule of the block and complains to the machine;
/// performing it cannot fail. So an alarming block moves nothing.
class Plan {
 public:
  Plan() = default;  ///< nothing
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  /// `motion()` is false when the sink has asked to stop. It must not outlive what it refers to.
  template <typename Motion>
  Plan& operator=(const Motion& motion) {
    static_assert(sizeof(Motion) <= sizeof room_ && std::is_trivially_destructible_v<Motion>);
    new (room_.data()) Motion(motion);
    perform_ = [](std::byte* room) {
      return (*std::launder(reinterpret_cast<const Motion*>(room)))();
    };
    return *this;
  }

  bool perform() { return perform_ == nullptr || perform_(room_.data()); }

 private:
  bool (*perform_)(std::byte* room) = nullptr;
  alignas(std::max_align_t) std::array<std::byte, 512> room_;
};

}  // namespace gonogo::expanders
