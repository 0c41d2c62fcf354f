#include "reference/build/build_control.hpp"

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/memory.hpp"

namespace minkref {

BuildControl::BuildControl(const BuildOptions& options, const char* subject)
    : options_(options), subject_(subject) {
  if (options.threads <= most_threads) return;
  throw BadInput("too-many-threads",
                 std::to_string(options.threads) +
                     " threads are asked for, and there are at most " +
                     std::to_string(most_threads),
                 "ask for as many as the machine has cores");
}

void BuildControl::look_now() const {
  end_if_stopped();
  if (options_.memory_limit != 0) check_memory(options_.memory_limit, subject_);
  look_for_interrupt_now();
}

void BuildControl::report(BuildProgress::Stage stage, std::uint64_t done,
                          std::uint64_t total) const {
  if (options_.progress) options_.progress({stage, done, total});
}

}  // namespace minkref
