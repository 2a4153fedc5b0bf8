// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shell command in a session and with an environment of its own, with pipes on stdin, stdout and
// stderr. It and all its descendants are ended at the latest when the object is
// destroyed.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "subjects/line_buffer.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    other.close();
    return *this;
  }
  ~Descriptor() { close(); }
  void close();
  int get() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

// How a process ended.
struct Ending {
  bool by_itself = false;  // false: it was killed here
  int code = 0;
  int signal = 0;
  // Whether a signal ended it, or the exit code with which a shell or a sandbox reports one.
  bool broke_down() const { return by_itself && (signal != 0 || code > 128); }
  std::string text() const;  // "exited with 7", "exited with 134, signal 6 (Aborted)"
};

// Drops what has come.
inline bool drop(LineBuffer& output) {
  output.clear();
  return true;
}

class Process {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Event {
    output,  // bytes went into the buffer
    closed,  // stdout was closed
    exited,  // and all that had been written has been read
    deadline,
    excess,  // it holds more memory, or has more processes, than allowed: see `excess`
  };

  // Throws std::system_error when the system cannot start a process.
  Process(const std::string& command, const Limits& limits);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  // From now on `pump` waits no longer than this in all, plus what `extend` adds.
  void arm(std::chrono::milliseconds time);
  void extend(Clock::duration time) { deadline_ += time; }

  // Queues bytes for stdin; `pump` writes them as they are taken.
  void send(std::string bytes);
  // Closes stdin once all is written.
  void end_input();

  // Moves bytes until something happens.
  Event pump(LineBuffer& output);
  // Moves bytes until it has exited or has to be killed, or until `take`, which gets what has come,
  // wants no more.
  Event pump_to_end(LineBuffer& output, const std::function<bool(LineBuffer&)>& take);

  // Kills all of it, reaps the process and returns how it ended. May be called again.
  const Ending& kill();

  // What it had too much of, after Event::excess: "held more than 2048 MiB".
  const std::string& excess() const { return excess_; }

  // What came on stderr since the last call: readable, cut.
  std::string take_notes();

 private:
  bool has_exited() const;
  bool has_too_much();
  int wait_ms(Clock::time_point now);
  void write_input();
  void read_notes();

  pid_t pid_ = -1;
  Descriptor input_;
  Descriptor output_;
  Descriptor errors_;
  std::string pending_;
  std::size_t written_ = 0;
  bool input_ends_ = false;
  bool exited_ = false;    // seen, not yet reaped
  bool overtime_ = false;  // the last look after the deadline has been taken
  int poll_ms_ = 1;
  Clock::time_point deadline_;
  Clock::time_point next_look_;  // at its size
  std::size_t memory_bytes_;
  std::size_t processes_;
  std::string excess_;
  std::string notes_;
  std::size_t notes_cut_ = 0;
  Ending ending_;
};

}  // namespace gonogo::oracle
