// Winding numbers beside the edges of the full convolution, through the scales.
#pragma once

#include <cstdint>
#include <vector>

namespace minkref::inline plane {

/// A change of two winding numbers.
struct SideStep {
  std::int8_t left = 0, right = 0;
};

/// Winding numbers of the faces on both sides of an edge's piece.
struct SideNumbers {
  std::int32_t left = 0, right = 0;

  friend SideNumbers operator+(SideNumbers a, SideNumbers b) {
    return {a.left + b.left, a.right + b.right};
  }
  friend SideNumbers operator-(SideNumbers a, SideNumbers b) {
    return {a.left - b.left, a.right - b.right};
  }
  friend SideNumbers operator+(SideNumbers a, SideStep b) {
    return {a.left + b.left, a.right + b.right};
  }
  friend bool operator==(SideNumbers, SideNumbers) = default;
};

/// Along an edge the numbers change at its nodes only, and each node always changes them in the
/// same way: one pair of numbers for each edge and interval of scales gives all numbers beside the
/// edge. Interval i lies between groups i - 1 and i.
struct WindingHistory {
  /// The numbers before an edge's first node, from an interval on.
  struct Base {
    std::uint32_t interval = 0;
    SideNumbers numbers;
  };
  std::vector<SideStep> steps;          ///< of each node of the table
  std::vector<Base> bases;              ///< edge by edge, ascending
  std::vector<std::size_t> first_base;  ///< of each edge

  /// Whether the numbers are kept: for the full convolution.
  bool kept() const { return !first_base.empty(); }
  /// O(log changes).
  SideNumbers base(std::uint32_t edge, std::uint32_t interval) const;
};

}  // namespace minkref::inline plane
