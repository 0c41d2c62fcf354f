#include "reference/plane/index/lazy_index.hpp"

#include <algorithm>
#include <utility>

#include "reference/error.hpp"
#include "reference/plane/index/rings_at_scale.hpp"

namespace minkref::inline plane {
namespace {

/// Signs of static sums that take about as long as a build: measured, by `minkref bench --only
/// index`.
std::uint64_t price_of_build(const Statistics& sum) {
  constexpr std::uint64_t signs_for_an_edge = 1300;
  return signs_for_an_edge * (sum.s_edges + sum.t_edges);
}

}  // namespace

LazyIndex::LazyIndex(PolygonSet P, PolygonSet Q, ScaleWindow window, BuildOptions options)
    : P_(std::move(P)), Q_(std::move(Q)), window_(std::move(window)), options_(std::move(options)) {
  refuse_bad_operands(P_, Q_, 1);
  refuse_bad_window(window_);
}

const ScaleIndex& LazyIndex::index() const {
  if (const ScaleIndex* found = built_.load(std::memory_order_acquire)) return *found;
  const std::lock_guard<std::mutex> lock(building_);
  if (!index_) index_.emplace(P_, Q_, window_, options_);
  built_.store(&*index_, std::memory_order_release);
  return *index_;
}

const ScaleIndex* LazyIndex::due(double more) const {
  if (const ScaleIndex* found = built_.load(std::memory_order_acquire)) return found;
  if (price_ == 0 || static_cast<double>(work_) + more < static_cast<double>(price_)) {
    return nullptr;
  }
  const std::unique_lock<std::mutex> lock(building_, std::try_to_lock);
  if (!lock) return nullptr;
  try {
    if (!index_) index_.emplace(P_, Q_, window_, options_);
  } catch (const LimitExceeded&) {
    price_ = 2 * std::max(work_.load(), price_.load());  // single sums go on until then
    return nullptr;
  }
  built_.store(&*index_, std::memory_order_release);
  return &*index_;
}

void LazyIndex::pay(const Statistics& sum) const {
  work_ += sum.by_float + sum.by_integer + sum.by_rational;
  ++answers_;
  std::uint64_t unknown = 0;
  price_.compare_exchange_strong(unknown, price_of_build(sum));
}

void LazyIndex::expect(std::uint64_t questions) const {
  if (is_built() || answers_ == 0) return;
  due(static_cast<double>(work_) / static_cast<double>(answers_) * static_cast<double>(questions));
}

template <class Rings>
void LazyIndex::answer(const Rational& scale, Rings& rings) const {
  refuse_outside(window_, scale);
  if (const ScaleIndex* found = due()) {
    found->rings(scale, rings);
    return;
  }
  Statistics statistics;
  write_rings(rings_at_scale(P_, Q_, scale, statistics), rings);
  pay(statistics);
}

void LazyIndex::rings(const Rational& scale, RoundedRings& rings) const { answer(scale, rings); }
void LazyIndex::rings(const Rational& scale, HomogeneousRings& rings) const {
  answer(scale, rings);
}
void LazyIndex::rings(const Rational& scale, RationalRings& rings) const { answer(scale, rings); }
void LazyIndex::rings(const Rational& scale, TrackRings& rings) const {
  refuse_outside(window_, scale);
  index().rings(scale, rings);
}

Sum LazyIndex::sum(const Rational& scale, Passages passages) const {
  refuse_outside(window_, scale);
  if (const ScaleIndex* found = due()) return found->sum(scale, passages);
  Sum sum = minkowski_sum(P_, Q_, scale, Route::paper, "rational", passages);
  pay(sum.statistics);
  return sum;
}

ScaleIndex::Features LazyIndex::features(const Rational& scale) const {
  refuse_outside(window_, scale);
  if (const ScaleIndex* index = due()) return index->features(scale);
  const Sum found = sum(scale);
  return {static_cast<std::uint32_t>(found.components), static_cast<std::uint32_t>(found.holes)};
}

}  // namespace minkref::inline plane
