// A loop over numbers by several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "reference/plane/index/build_control.hpp"

namespace minkref::inline plane {

/// Calls worker(k) once for each k from 0 to count - 1, in no order; thread t of 0, 1, ... has a
/// worker of its own, from make_worker(t), which is called by that thread. An exception ends all,
/// and is thrown here. Where the system starts no more threads, those that there are do all the
/// work. Reports progress, and looks at interrupts and the memory limit.
template <class MakeWorker>
void in_parallel(std::size_t count, const BuildControl& control, BuildProgress::Stage stage,
                 MakeWorker&& make_worker) {
  constexpr std::size_t chunk = 16;
  const std::size_t step = std::max<std::size_t>(count / 100, 1);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto run = [&](unsigned thread) {
    try {
      auto worker = make_worker(thread);
      for (std::size_t reported = step;;) {
        const std::size_t first = next.fetch_add(chunk);
        if (first >= count) return;
        control.look_now();
        if (first >= reported) {
          if (thread == 0) control.report(stage, first, count);
          reported = first + step;
        }
        for (std::size_t k = first; k < std::min(first + chunk, count); ++k) worker(k);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!fault) fault = std::current_exception();
      next = count;
      control.stop();
    }
  };
  control.report(stage, 0, count);
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
  control.look_now();
  control.report(stage, count, count);
}

}  // namespace minkref::inline plane
