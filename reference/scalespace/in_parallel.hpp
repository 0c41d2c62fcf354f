// A loop over numbers by several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace minkref {

/// Calls worker(k) once for each k from 0 to count - 1, in no order; thread t of 0, 1, ... has a
/// worker of its own, from make_worker(t), which is called by that thread. An exception ends all,
/// and is thrown here.
template <class MakeWorker>
void in_parallel(std::size_t count, unsigned threads, MakeWorker&& make_worker) {
  constexpr std::size_t chunk = 16;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto run = [&](unsigned thread) {
    try {
      auto worker = make_worker(thread);
      for (;;) {
        const std::size_t first = next.fetch_add(chunk);
        if (first >= count) return;
        for (std::size_t k = first; k < std::min(first + chunk, count); ++k) worker(k);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!fault) fault = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  for (unsigned k = 1; k < threads; ++k) others.emplace_back(run, k);
  run(0);
  for (std::thread& other : others) other.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace minkref
