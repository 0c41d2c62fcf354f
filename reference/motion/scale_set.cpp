#include "reference/motion/scale_set.hpp"

#include <algorithm>

namespace minkref::inline motion {
namespace {

/// Whether a range ends before a cut, with something in between.
bool ends_before(const ScaleRange& range, const ScaleCut& cut) {
  return range.to && *range.to < cut;
}

}  // namespace

bool ScaleRange::holds(const Rational& scale) const {
  const bool is_behind_start = from.scale < scale || (from.scale == scale && !from.above);
  const bool is_before_end = !to || scale < to->scale || (scale == to->scale && to->above);
  return is_behind_start && is_before_end;
}

Rational ScaleRange::sample() const {
  if (!to) return from.scale == 0 ? Rational(1) : Rational(2 * from.scale);
  return (from.scale + to->scale) / 2;
}

void ScaleSet::add(const ScaleCut& from, const std::optional<ScaleCut>& to) {
  if (to && !(from < *to)) return;
  const auto first = std::partition_point(
      ranges_.begin(), ranges_.end(), [&](const ScaleRange& r) { return ends_before(r, from); });
  ScaleRange whole{from, to};
  auto last = first;
  while (last != ranges_.end() && (!whole.to || !(*whole.to < last->from))) {
    if (last->from < whole.from) whole.from = last->from;
    if (!last->to || (whole.to && *whole.to < *last->to)) whole.to = last->to;
    ++last;
  }
  ranges_.insert(ranges_.erase(first, last), std::move(whole));
}

bool ScaleSet::holds(const Rational& scale) const {
  return std::any_of(ranges_.begin(), ranges_.end(),
                     [&](const ScaleRange& r) { return r.holds(scale); });
}

ScaleRange range_of(const ScaleWindow& window) {
  ScaleRange all{{window.from.value_or(Rational(0)), !window.from}, {}};
  if (window.to) all.to = ScaleCut{*window.to, true};
  return all;
}

std::vector<ScaleRange> ScaleSet::left_of(const ScaleWindow& window) const {
  const ScaleRange all = range_of(window);
  std::vector<ScaleRange> left;
  std::optional<ScaleCut> from = all.from;  // begin of the remaining part; none: nothing remains
  for (const ScaleRange& range : ranges_) {
    if (!from || (all.to && !(range.from < *all.to))) break;
    if (*from < range.from) left.push_back({*from, range.from});
    if (!range.to) {
      from.reset();
    } else if (*from < *range.to) {
      from = range.to;
    }
  }
  if (from && (!all.to || *from < *all.to)) left.push_back({*from, all.to});
  return left;
}

}  // namespace minkref::inline motion
