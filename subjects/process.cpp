// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "oracle/records/text.hpp"
#include "subjects/family_keeper.hpp"
#include "subjects/process_family.hpp"
#include "subjects/spawn_shell.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kMostNotes = 16384;
constexpr int kLongestWaitMs = 25;  // between two looks at the process itself
// Between two looks at its size. Many processes take long to count, and begin no others meanwhile:
// the rest is at least so many times as long as the look was.
constexpr auto kSizeEvery = std::chrono::milliseconds(20);
constexpr int kRestPerLook = 4;

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

// Above the three standard ones, so that giving these to the child never overwrites a pipe.
Descriptor above_standard(Descriptor fd) {
  if (fd.get() > STDERR_FILENO) return fd;
  Descriptor moved(fcntl(fd.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!moved.is_open()) fail(errno, "fcntl");
  return moved;
}

struct Pipe {
  Descriptor read;
  Descriptor write;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "pipe2");
  Descriptor read(ends[0]);
  Descriptor write(ends[1]);
  return {above_standard(std::move(read)), above_standard(std::move(write))};
}

void make_nonblocking(const Descriptor& fd) {
  if (fcntl(fd.get(), F_SETFL, O_NONBLOCK) != 0) fail(errno, "fcntl");
}

// write() that a closed pipe answers with EPIPE and never with a signal, in spite of the
// program's own handling of SIGPIPE.
ssize_t write_quietly(int fd, const char* data, std::size_t size) {
  sigset_t broken_pipe;
  sigemptyset(&broken_pipe);
  sigaddset(&broken_pipe, SIGPIPE);
  sigset_t pending;
  sigpending(&pending);
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &broken_pipe, &before);
  const ssize_t count = write(fd, data, size);
  const int error = errno;
  if (count < 0 && error == EPIPE && sigismember(&pending, SIGPIPE) == 0) {
    const timespec now{};
    while (sigtimedwait(&broken_pipe, nullptr, &now) < 0 && errno == EINTR) {
    }
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return count;
}

std::string signal_text(int signal) {
  const char* description = sigdescr_np(signal);
  return fmt::format("signal {} ({})", signal, description ? description : "unknown");
}

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

void Descriptor::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

std::string Ending::text() const {
  if (!by_itself) return "was stopped";
  if (signal != 0) return "was ended by " + signal_text(signal);
  // A shell passes the signal of its command on as 128 + n.
  if (code > 128 && sigdescr_np(code - 128) != nullptr) {
    return fmt::format("exited with {}, {}", code, signal_text(code - 128));
  }
  return fmt::format("exited with {}", code);
}

Process::Process(const std::string& command, const Limits& limits)
    : memory_bytes_(limits.memory_bytes), processes_(limits.processes) {
  Pipe in = make_pipe();
  Pipe out = make_pipe();
  Pipe err = make_pipe();
  make_nonblocking(in.write);
  make_nonblocking(out.read);
  make_nonblocking(err.read);
  // In a sandbox the processes end with this program.
  if (!limits.sandbox.is_on()) start_family_keeper();
  pid_ = begin_family(
      [&](const ControlGroup& group) {
        return spawn_shell(command, limits, group, in.read.get(), out.write.get(), err.write.get());
      },
      ControlGroup::make(limits.memory_bytes, limits.processes));
  input_ = std::move(in.write);
  output_ = std::move(out.read);
  errors_ = std::move(err.read);
  deadline_ = Clock::now();
  next_look_ = deadline_ + kSizeEvery;
}

Process::~Process() {
  kill();
}

void Process::arm(std::chrono::milliseconds time) {
  deadline_ = Clock::now() + time;
  overtime_ = false;
  poll_ms_ = 1;
}

void Process::send(std::string bytes) {
  pending_.erase(0, written_);
  written_ = 0;
  if (pending_.empty()) {
    pending_ = std::move(bytes);
  } else {
    pending_ += bytes;
  }
  write_input();
}

void Process::end_input() {
  input_ends_ = true;
  write_input();
}

void Process::write_input() {
  while (input_.is_open() && written_ < pending_.size()) {
    const ssize_t count =
        write_quietly(input_.get(), pending_.data() + written_, pending_.size() - written_);
    if (count < 0) {
      if (!would_block()) input_.close();  // it reads no more
      return;
    }
    written_ += static_cast<std::size_t>(count);
  }
  if (input_ends_) input_.close();
}

void Process::read_notes() {
  std::array<char, 16384> bytes;
  const ssize_t count = read(errors_.get(), bytes.data(), bytes.size());
  if (count == 0 || (count < 0 && !would_block())) return errors_.close();
  if (count < 0) return;
  const auto size = static_cast<std::size_t>(count);
  const std::size_t kept = std::min(size, kMostNotes - std::min(notes_.size(), kMostNotes));
  notes_.append(bytes.data(), kept);
  notes_cut_ += size - kept;
}

// Looks without reaping: until then the process group cannot become another's.
bool Process::has_exited() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == pid_;
}

bool Process::has_too_much() {
  const auto now = Clock::now();
  if (now < next_look_) return false;
  const FamilySize size = size_of_family(pid_);
  const auto seen = Clock::now();
  next_look_ = seen + std::max<Clock::duration>(kSizeEvery, kRestPerLook * (seen - now));
  if (size.resident_bytes > memory_bytes_) {
    excess_ = fmt::format("held more than {} MiB", memory_bytes_ >> 20);
  } else if (size.processes > processes_) {
    excess_ = fmt::format("had more than {} processes at once", processes_);
  }
  return !excess_.empty();
}

int Process::wait_ms(Clock::time_point now) {
  if (exited_ || now >= deadline_) return 0;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - now).count();
  const auto wait = static_cast<int>(std::min<std::int64_t>(left, poll_ms_));
  poll_ms_ = std::clamp(2 * poll_ms_, 1, kLongestWaitMs);
  return wait;
}

Process::Event Process::pump(LineBuffer& output) {
  while (true) {
    const auto now = Clock::now();
    const bool expired = now >= deadline_;
    if (expired && overtime_) return Event::deadline;
    overtime_ = expired;  // what has come by now still counts, once
    if (!expired && has_too_much()) return Event::excess;
    std::array<pollfd, 3> fds = {
        pollfd{output_.get(), POLLIN, 0}, pollfd{errors_.get(), POLLIN, 0},
        pollfd{written_ < pending_.size() ? input_.get() : -1, POLLOUT, 0}};
    const int ready = poll(fds.data(), fds.size(), wait_ms(now));
    if (ready < 0) continue;  // a signal
    if (fds[1].revents != 0) read_notes();
    if (fds[2].revents != 0) write_input();
    if (fds[0].revents != 0) {
      const std::span<char> room = output.room();
      const ssize_t count = read(output_.get(), room.data(), room.size());
      if (count > 0) {
        output.commit(static_cast<std::size_t>(count));
        return Event::output;
      }
      if (count == 0 || !would_block()) {
        output_.close();
        poll_ms_ = 0;  // the exit follows at once
        return Event::closed;
      }
    } else if (exited_) {
      return Event::exited;
    } else if (ready == 0 || !output_.is_open()) {
      if (expired) return Event::deadline;
      exited_ = has_exited();
    }
  }
}

Process::Event Process::pump_to_end(LineBuffer& output,
                                    const std::function<bool(LineBuffer&)>& take) {
  for (;;) {
    const Event event = pump(output);
    const bool goes_on = event == Event::output || event == Event::closed;
    if (!take(output) || !goes_on) return event;
  }
}

const Ending& Process::kill() {
  if (pid_ < 0) return ending_;
  ending_.by_itself = has_exited();
  const int status = end_family(pid_);
  if (WIFEXITED(status)) ending_.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending_.signal = WTERMSIG(status);
  pid_ = -1;
  // What is left on stderr belongs to the report; a process that escaped may still hold the pipe.
  for (int i = 0; i < 16 && errors_.is_open(); ++i) read_notes();
  errors_.close();
  input_.close();
  output_.close();
  return ending_;
}

std::string Process::take_notes() {
  if (errors_.is_open()) read_notes();
  std::string text = visible(notes_, Lines::kept);
  if (notes_cut_ > 0) text += fmt::format("\n({} more bytes)", notes_cut_);
  notes_.clear();
  notes_cut_ = 0;
  return text;
}

}  // namespace gonogo::oracle
