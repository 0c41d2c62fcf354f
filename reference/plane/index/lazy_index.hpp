// An index of all scales that is built when single sums have cost as much as a build.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>

#include "reference/plane/index/scale_index.hpp"

namespace minkref::inline plane {

/// Answers the first questions by static sums, and adds up their work. Once the work is worth a
/// build, the index is built, and answers all further questions. So all questions together take at
/// most about twice the time of the better of the two ways, however many come, if the price is
/// right (docs/scale-index.md, "Built when it pays"). Work is counted, not timed: the same
/// questions in the same order build at the same question on every machine.
///
/// Safe to ask from several threads at once: while one builds, others go on by static sums.
class LazyIndex {
 public:
  /// O(n), for the copies. Operands, window, errors: as ScaleIndex. `options` are for the build.
  LazyIndex(PolygonSet P, PolygonSet Q, ScaleWindow window, BuildOptions options = {});

  const PolygonSet& P() const { return P_; }
  const PolygonSet& Q() const { return Q_; }
  const ScaleWindow& window() const { return window_; }

  bool is_built() const { return built_.load(std::memory_order_acquire) != nullptr; }
  /// The index, built now if need be. Throws as ScaleIndex.
  const ScaleIndex& index() const;

  /// The boundary, as ScaleIndex::rings: the same rings and points, exact. Without the index holes
  /// and components are numbered afresh at each scale, and doubles are the nearest ones. Throws as
  /// ScaleIndex::rings; where memory does not suffice for a build, static sums go on.
  void rings(const Rational& scale, RoundedRings& rings) const;
  void rings(const Rational& scale, HomogeneousRings& rings) const;
  void rings(const Rational& scale, RationalRings& rings) const;
  void rings(const Rational& scale, TrackRings& rings) const;  ///< builds: tracks are an index's

  /// As ScaleIndex.
  Sum sum(const Rational& scale, Passages passages = Passages::leave) const;
  ScaleIndex::Features features(const Rational& scale) const;

  /// Builds at once if so many more questions, each as dear as the average one before, would cost
  /// more than the build. Asked before many questions at once, answers do not depend on the order
  /// that threads take them in.
  void expect(std::uint64_t questions) const;

  /// Signs decided by static sums so far, and signs that are worth a build; 0 before the first
  /// question.
  std::uint64_t work() const { return work_; }
  std::uint64_t price() const { return price_; }

 private:
  /// The index, if built, or due after `more` work; else null.
  const ScaleIndex* due(double more = 0) const;
  /// Adds the work of an answer.
  void pay(const Statistics& statistics) const;
  template <class Rings>
  void answer(const Rational& scale, Rings& rings) const;

  PolygonSet P_, Q_;
  ScaleWindow window_;
  BuildOptions options_;
  mutable std::mutex building_;
  mutable std::optional<ScaleIndex> index_;
  mutable std::atomic<const ScaleIndex*> built_{nullptr};
  mutable std::atomic<std::uint64_t> work_{0}, answers_{0}, price_{0};
};

}  // namespace minkref::inline plane
