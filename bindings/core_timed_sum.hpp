// A sum's result for Python.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "reference/error.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::python {

/// A sum's tight passages, found once, at the first question.
class LaterPassages {
 public:
  using Find = std::function<std::vector<TightPassage>()>;

  /// For an answer without passages.
  LaterPassages() : state_(std::make_shared<State>()) {}
  explicit LaterPassages(Find find, std::optional<std::vector<TightPassage>> found = {})
      : LaterPassages() {
    state_->find = std::move(find);
    state_->found = std::move(found);
  }

  /// Threads may ask together: the first thread computes. Throws BadInput ("no-passages") for an
  /// answer without passages of its own, and errors of the computation.
  const std::vector<TightPassage>& get() const {
    const std::lock_guard hold(state_->lock);
    if (!state_->found) {
      if (!state_->find) {
        throw BadInput("no-passages", "this answer has no tight passages of its own",
                       "ask tight_passages(P, Q, scale) for those of the exact sum");
      }
      state_->found = state_->find();
    }
    return *state_->found;
  }

 private:
  struct State {
    std::mutex lock;
    Find find;
    std::optional<std::vector<TightPassage>> found;
  };
  std::shared_ptr<State> state_;  // a value of Python is copied by reference
};

struct TimedSum {
  Set region;
  std::size_t components = 0, holes = 0;
  double seconds = 0;
  Statistics statistics;
  LaterPassages tight_passages;
};

}  // namespace minkref::python
