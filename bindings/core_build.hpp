// How a long build is run for Python.
#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <functional>
#include <optional>

#include "bindings/core.hpp"
#include "reference/build/build_options.hpp"

namespace minkref::python {

/// Receives the number of steps done, and of all steps.
using Progress = std::function<void(std::size_t, std::size_t)>;

/// `progress` must outlive it.
inline BuildOptions build_on(unsigned threads,
                             const std::optional<Progress>& progress = std::nullopt) {
  BuildOptions options;
  options.threads = threads;
  options.memory_limit = memory_limit();
  if (progress) {
    options.progress = [&progress](const BuildProgress& now) {
      const nanobind::gil_scoped_acquire held;
      (*progress)(now.done, now.total);
    };
  }
  return options;
}

}  // namespace minkref::python
