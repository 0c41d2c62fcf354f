#include "reference/memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>

#include "reference/error.hpp"

namespace minkref {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  if (!(file >> value)) return std::nullopt;  // also for the word "max"
  return value;
}

std::uint64_t available_on_machine() {
  std::ifstream file("/proc/meminfo");
  std::string name, rest;
  std::uint64_t kibibytes = 0;
  while (file >> name >> kibibytes && std::getline(file, rest)) {
    if (name == "MemAvailable:") return kibibytes << 10;
  }
  return unlimited;
}

/// The memory left by a control group and the groups above.
std::uint64_t available_below(const std::string& root, std::string group, const char* limit,
                              const char* usage) {
  std::uint64_t least = unlimited;
  for (;;) {
    const std::string folder = root + group + "/";
    const auto most = number_in(folder + limit), used = number_in(folder + usage);
    if (most && used) least = std::min(least, *most - std::min(*most, *used));
    const auto slash = group.rfind('/');
    if (slash == std::string::npos) return least;
    group.resize(slash);
  }
}

std::uint64_t available_in_groups() {
  std::uint64_t least = unlimited;
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      group = line.substr(second + 1);
    if (controllers.empty()) {
      least =
          std::min(least, available_below("/sys/fs/cgroup", group, "memory.max", "memory.current"));
    } else if (controllers == "memory") {
      least = std::min(least, available_below("/sys/fs/cgroup/memory", group,
                                              "memory.limit_in_bytes", "memory.usage_in_bytes"));
    }
  }
  return least;
}

}  // namespace

std::uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t available_bytes() { return std::min(available_on_machine(), available_in_groups()); }

void check_memory(std::uint64_t limit, const std::string& work) {
  const std::uint64_t now = resident_bytes();
  if (now <= limit) return;
  throw LimitExceeded("memory-limit",
                      work + " needs more memory than it may have: " + std::to_string(now >> 20) +
                          " MiB of " + std::to_string(limit >> 20) + " MiB",
                      "raise the limit, or take simpler operands or a smaller window of scales");
}

}  // namespace minkref
