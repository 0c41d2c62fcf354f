// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/child.hpp"

#include <fcntl.h>
#include <gmp.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <new>
#include <system_error>

namespace minkref::cgal_oracle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kNoMemory = 111;  // the child's exit code where GMP gets no memory: GMP cannot throw

void* gmp_allocate(std::size_t bytes) {
  void* memory = std::malloc(bytes);
  if (memory == nullptr) _exit(kNoMemory);
  return memory;
}

void* gmp_reallocate(void* old, std::size_t, std::size_t bytes) {
  void* memory = std::realloc(old, bytes);
  if (memory == nullptr) _exit(kNoMemory);
  return memory;
}

void gmp_free(void* memory, std::size_t) { std::free(memory); }

void limit(decltype(RLIMIT_CPU) resource, std::uint64_t soft, std::uint64_t hard) {
  const rlimit limits{soft, hard};
  setrlimit(resource, &limits);
}

bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const auto count = write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return true;
}

[[noreturn]] void be_the_child(int pipe, pid_t parent, const Limits& limits,
                               const std::function<std::string()>& work) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // the parent went before the line above
  signal(SIGPIPE, SIG_DFL);
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(null, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  limit(RLIMIT_CORE, 0, 0);
  const auto cpu = static_cast<std::uint64_t>(std::ceil(limits.seconds)) + 1;
  limit(RLIMIT_CPU, cpu, cpu + 5);  // for a child that outlives its parent
#ifndef __SANITIZE_ADDRESS__        // its shadow takes terabytes of address space
  limit(RLIMIT_AS, limits.bytes, limits.bytes);
#endif
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  try {
    _exit(write_all(pipe, work()) ? 0 : 1);
  } catch (const std::bad_alloc&) {
    _exit(kNoMemory);
  }
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Reads until the child closes the pipe or a limit is passed; in the second case sets
/// `outcome.end` and returns false.
bool read_answer(int pipe, const Limits& limits, Clock::time_point start, Outcome& outcome) {
  static char buffer[1 << 16];
  for (;;) {
    const double left = limits.seconds - seconds_since(start);
    pollfd ready{pipe, POLLIN, 0};
    const int found =
        left <= 0 ? 0 : poll(&ready, 1, static_cast<int>(std::min(left, 1e6) * 1e3) + 1);
    if (found < 0 && errno == EINTR) continue;
    if (found == 0) {
      if (left > 0) continue;
      outcome.end = End::timed_out;
      return false;
    }
    const auto count = read(pipe, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    outcome.text.append(buffer, static_cast<std::size_t>(count));
    if (outcome.text.size() > limits.answer_bytes) {
      outcome.end = End::answer_too_large;
      return false;
    }
  }
}

/// Waits for the child's end. A child that has closed the pipe must leave before the time limit.
int reap(pid_t child, const Limits& limits, Clock::time_point start, Outcome& outcome) {
  int status = 0;
  rusage usage{};
  bool ours = outcome.end != End::answered;
  if (ours) kill(child, SIGKILL);
  for (useconds_t pause = 20;; pause = std::min<useconds_t>(2 * pause, 10000)) {
    const pid_t found = wait4(child, &status, ours ? 0 : WNOHANG, &usage);
    if (found == child) break;
    if (found < 0 && errno != EINTR)
      throw std::system_error(errno, std::system_category(), "wait4");
    if (!ours && seconds_since(start) > limits.seconds) {
      ours = true;
      outcome.end = End::timed_out;
      kill(child, SIGKILL);
    }
    if (!ours) usleep(pause);
  }
  outcome.peak_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return status;
}

void judge(int status, Outcome& outcome) {
  if (outcome.end != End::answered) return;
  if (WIFSIGNALED(status)) {
    outcome.signal = WTERMSIG(status);
    outcome.end = outcome.signal == SIGXCPU   ? End::timed_out
                  : outcome.signal == SIGKILL ? End::out_of_memory  // not by us: the system's doing
                                              : End::crashed;
  } else if (WEXITSTATUS(status) == kNoMemory) {
    outcome.end = End::out_of_memory;
  } else if (WEXITSTATUS(status) != 0) {
    outcome.exit_code = WEXITSTATUS(status);
    outcome.end = End::exited;
  }
}

}  // namespace

Outcome run_in_child(const Limits& limits, const std::function<std::string()>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::system_category(), "pipe");
  const auto start = Clock::now();
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(error, std::system_category(), "fork");
  }
  if (child == 0) {
    close(ends[0]);
    be_the_child(ends[1], parent, limits, work);
  }
  close(ends[1]);
  Outcome outcome;
  try {
    read_answer(ends[0], limits, start, outcome);
  } catch (const std::bad_alloc&) {  // of the server itself
    outcome.text.clear();
    outcome.end = End::answer_too_large;
  }
  close(ends[0]);
  judge(reap(child, limits, start, outcome), outcome);
  outcome.seconds = seconds_since(start);
  return outcome;
}

}  // namespace minkref::cgal_oracle
