// Long work can be broken off: its loops ask now and then whether to go on.
#pragma once

#include <functional>

namespace minkref {

/// While an Interruptible lives, the long loops of this thread call `look`, some hundred times a
/// second or more. An exception from `look` ends the work: its unfinished result is lost, its
/// arguments keep their values. An inner Interruptible replaces the outer one.
class Interruptible {
 public:
  explicit Interruptible(std::function<void()> look);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  std::function<void()> look_;
  const std::function<void()>* before_;
};

/// For each turn of a loop whose turns take a millisecond.
void look_for_interrupt_now();

/// For each turn of a possibly long loop; looks now and then. A turn costs next to nothing.
inline void look_for_interrupt() {
  constexpr unsigned turns_between_looks = 64;
  static thread_local unsigned turns = 0;
  if (++turns % turns_between_looks == 0) look_for_interrupt_now();
}

}  // namespace minkref
