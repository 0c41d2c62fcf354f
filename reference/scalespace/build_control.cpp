#include "reference/scalespace/build_control.hpp"

#include <unistd.h>

#include <fstream>

#include "reference/error.hpp"

namespace minkref {

std::uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void BuildControl::check_memory() const {
  if (options_.memory_limit == 0) return;
  const std::uint64_t now = resident_bytes();
  if (now <= options_.memory_limit) return;
  throw LimitExceeded(
      "memory-limit",
      "the build of the index needs more memory than it may have: " + std::to_string(now >> 20) +
          " MiB of " + std::to_string(options_.memory_limit >> 20) + " MiB",
      "raise the limit, or take a smaller window of scales or simpler operands");
}

void BuildControl::look_now() const {
  if (stopped_) throw Stopped{};
  check_memory();
  if (options_.interrupt && std::this_thread::get_id() == calling_thread_) options_.interrupt();
}

void BuildControl::report(BuildProgress::Stage stage, std::uint64_t done,
                          std::uint64_t total) const {
  if (options_.progress) options_.progress({stage, done, total});
}

}  // namespace minkref
