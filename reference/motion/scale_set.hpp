// Sets of scales: finitely many intervals with open and closed ends, and single scales.
#pragma once

#include <optional>
#include <vector>

#include "reference/number/rational.hpp"
#include "reference/plane/critical/scale_window.hpp"

namespace minkref::inline motion {

/// A cut of the scales: just below a scale, or just above.
struct ScaleCut {
  Rational scale;
  bool above = false;

  friend bool operator==(const ScaleCut&, const ScaleCut&) = default;
  friend bool operator<(const ScaleCut& a, const ScaleCut& b) {
    return a.scale != b.scale ? a.scale < b.scale : !a.above && b.above;
  }
};

/// All scales between two cuts, one or more; without an end it goes on to infinity.
struct ScaleRange {
  ScaleCut from;
  std::optional<ScaleCut> to;

  bool from_in() const { return !from.above; }    ///< the least scale belongs to it
  bool to_in() const { return to && to->above; }  ///< so does the greatest
  bool is_one_scale() const { return to && from.scale == to->scale; }
  bool holds(const Rational& scale) const;
  /// A scale of the range: the only scale, or a scale strictly between the ends.
  Rational sample() const;
  friend bool operator==(const ScaleRange&, const ScaleRange&) = default;
};

/// A union of ranges, kept sorted and apart.
class ScaleSet {
 public:
  /// Adds the range between two cuts; nothing if the cuts are equal or out of order. Exact. O(log
  /// n) plus the merged ranges.
  void add(const ScaleCut& from, const std::optional<ScaleCut>& to);
  const std::vector<ScaleRange>& ranges() const { return ranges_; }
  bool holds(const Rational& scale) const;

  /// The rest of a closed window, open towards 0 and infinity where the window has no bound. Exact.
  std::vector<ScaleRange> left_of(const ScaleWindow& window) const;

 private:
  std::vector<ScaleRange> ranges_;
};

/// The cuts around a closed window.
ScaleRange range_of(const ScaleWindow& window);

}  // namespace minkref::inline motion
