// SPDX-License-Identifier: GPL-3.0-or-later
//
// A coroutine that yields values one at a time, so that a cycle of a million pecks is written as
// a plain loop and takes the memory of one record. (std::generator is C++23.)
#pragma once

#include <coroutine>
#include <exception>
#include <utility>

namespace gonogo::reference {

template <typename T>
class Generator {
 public:
  struct promise_type {
    const T* value = nullptr;
    std::exception_ptr failure;

    Generator get_return_object() {
      return Generator(std::coroutine_handle<promise_type>::from_promise(*this));
    }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    // The yielded object lives in the coroutine until it is resumed.
    std::suspend_always yield_value(const T& yielded) noexcept {
      value = &yielded;
      return {};
    }
    void return_void() noexcept {}
    void unhandled_exception() { failure = std::current_exception(); }
  };

  Generator() = default;
  Generator(Generator&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Generator& operator=(Generator&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Generator(const Generator&) = delete;
  ~Generator() {
    if (handle_) handle_.destroy();
  }

  // The next value, valid until the next call; null when there are no more.
  const T* next() {
    if (!handle_ || handle_.done()) return nullptr;
    handle_.resume();
    if (handle_.promise().failure) std::rethrow_exception(handle_.promise().failure);
    return handle_.done() ? nullptr : handle_.promise().value;
  }
  explicit operator bool() const { return handle_ && !handle_.done(); }

 private:
  explicit Generator(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
  std::coroutine_handle<promise_type> handle_;
};

}  // namespace gonogo::reference
