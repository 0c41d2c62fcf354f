// Progress, interrupts and the memory limit of a build, as its loops see them.
#pragma once

#include <atomic>
#include <string>

#include "reference/build/build_options.hpp"

namespace minkref {

/// `options` must outlive it. `subject` is what is built, as a refusal names it.
class BuildControl {
 public:
  /// Throws BadInput ("too-many-threads").
  BuildControl(const BuildOptions& options, const char* subject);

  unsigned threads() const { return options_.threads == 0 ? 1 : options_.threads; }

  /// From any thread, in each turn of a loop that may be long: looks now and then. A turn costs
  /// next to nothing.
  void look() const {
    thread_local unsigned turns = 0;
    if (++turns % turns_between_looks == 0) look_now();
  }
  /// Throws LimitExceeded ("memory-limit"), what an interrupt throws, and in other threads
  /// Stopped. Some 10 us.
  void look_now() const;
  /// Throws Stopped if the build has failed.
  void end_if_stopped() const {
    if (stopped_) throw Stopped{};
  }
  /// From the calling thread.
  void report(BuildProgress::Stage stage, std::uint64_t done, std::uint64_t total) const;

  /// The build has failed: threads that are still at work end at their next look.
  void stop() const { stopped_ = true; }
  struct Stopped {};

  static constexpr unsigned turns_between_looks = 256, most_threads = 1024;

 private:
  const BuildOptions& options_;
  const char* subject_;
  mutable std::atomic<bool> stopped_{false};
};

}  // namespace minkref
