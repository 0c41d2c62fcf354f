// A loop over numbers by several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "reference/number/float_environment.hpp"

namespace minkref {

/// Calls worker(k) once for each k from 0 to count - 1, in no order; thread t of 0, 1, ... has a
/// worker of its own, from make_worker(t), which is called by that thread. Thread 0 is the calling
/// thread. `control` has `threads()`, how many threads; `before(t, first)`, called by each thread
/// before it takes `chunk` numbers from `first` on; `stop()`, called when an exception ends the
/// loop, which throws that exception. If the system starts no more threads, the running ones do all
/// the work.
template <class Control, class MakeWorker>
void in_parallel(std::size_t count, std::size_t chunk, Control& control, MakeWorker&& make_worker) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto run = [&](unsigned thread) {
    const FloatEnvironment standard;  // a new thread need not have that of the one that starts it
    try {
      auto worker = make_worker(thread);
      while (true) {
        const std::size_t first = next.fetch_add(chunk);
        if (first >= count) return;
        control.before(thread, first);
        for (std::size_t k = first; k < std::min(first + chunk, count); ++k) worker(k);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!fault) fault = std::current_exception();
      next = count;
      control.stop();
    }
  };
  std::vector<std::thread> others;
  const std::size_t useful = std::min<std::size_t>(control.threads(), (count + chunk - 1) / chunk);
  others.reserve(useful);
  for (unsigned k = 1; k < useful; ++k) {
    try {
      others.emplace_back(run, k);
    } catch (const std::exception&) {  // no thread, or no memory for one
      break;
    }
  }
  run(0);
  for (std::thread& other : others) other.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace minkref
