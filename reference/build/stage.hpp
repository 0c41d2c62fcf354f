// A stage of the build by several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reference/build/build_control.hpp"
#include "reference/build/in_parallel.hpp"

namespace minkref {

/// Calls worker(k) once for each k from 0 to count - 1, as minkref::in_parallel does. Reports
/// progress, and looks at interrupts and the memory limit.
template <class MakeWorker>
void in_parallel(std::size_t count, const BuildControl& control, BuildProgress::Stage stage,
                 MakeWorker&& make_worker) {
  struct StageControl {
    const BuildControl& control;
    BuildProgress::Stage stage;
    std::size_t count, step, reported;

    unsigned threads() const { return control.threads(); }
    void before(unsigned thread, std::size_t first) {
      control.look_now();
      if (thread != 0 || first < reported) return;
      control.report(stage, first, count);
      reported = first + step;
    }
    void stop() const { control.stop(); }
  };
  const std::size_t step = std::max<std::size_t>(count / 100, 1);
  StageControl look{control, stage, count, step, step};
  control.report(stage, 0, count);
  // Few and long pieces of work are shared out one by one.
  const std::size_t chunk = std::clamp<std::size_t>(count / (8 * control.threads()), 1, 16);
  minkref::in_parallel(count, chunk, look, std::forward<MakeWorker>(make_worker));
  control.look_now();
  control.report(stage, count, count);
}

}  // namespace minkref
