#include "reference/interrupt.hpp"

#include <utility>

namespace minkref {
namespace {

thread_local const std::function<void()>* current = nullptr;

}  // namespace

Interruptible::Interruptible(std::function<void()> look)
    : look_(std::move(look)), before_(current) {
  current = &look_;
}

Interruptible::~Interruptible() { current = before_; }

void look_for_interrupt_now() {
  if (current != nullptr) (*current)();
}

}  // namespace minkref
