// The scale of an event, an unreduced fraction: two words of 128 bits or, if these are too short,
// two integers. Scales number millions.
#pragma once

#include <cmath>
#include <utility>

#include "reference/number/int128.hpp"
#include "reference/number/rational.hpp"

namespace minkref::inline space {

class EventScale {
 public:
  /// The most bits for the magnitudes of numerator and denominator.
  static constexpr unsigned most_bits = 126;

  EventScale() = default;
  /// denominator != 0.
  EventScale(Int128 numerator, Int128 denominator)
      : numerator_(denominator < 0 ? -numerator : numerator),
        denominator_(denominator < 0 ? -denominator : denominator) {}
  EventScale(const Integer& numerator, const Integer& denominator);
  explicit EventScale(const Rational& value);
  EventScale(const EventScale& other);
  EventScale(EventScale&& other) noexcept { swap(other); }
  EventScale& operator=(EventScale other) noexcept {
    swap(other);
    return *this;
  }
  ~EventScale() {
    if (is_long()) delete long_;
  }

  /// Reduced.
  Rational exact() const;
  /// Perhaps not reduced; the denominator is above 0.
  Integer numerator() const;
  Integer denominator() const;
  /// Within three roundings.
  double rounded() const;
  int sign() const;
  /// Compares exactly; returns the difference's sign.
  int compare(const EventScale& other) const;

  friend bool operator==(const EventScale& a, const EventScale& b) { return a.compare(b) == 0; }
  friend auto operator<=>(const EventScale& a, const EventScale& b) { return a.compare(b) <=> 0; }
  /// Whether rounded numbers, each within three roundings, tell the order of the exact numbers.
  static bool tell_the_order(double a, double b) {
    const double most = std::abs(a) + std::abs(b);
    return most > 1e-290 && std::abs(a - b) > 0x1p-49 * most;
  }

 private:
  bool is_long() const { return denominator_ == 0; }
  void swap(EventScale& other) noexcept {
    std::swap(numerator_, other.numerator_);
    std::swap(denominator_, other.denominator_);
  }

  struct Long {
    Integer numerator, denominator;  ///< the denominator is above 0
    double rounded;
  };
  union {
    Int128 numerator_ = 0;
    const Long* long_;  ///< owned; where the denominator is 0
  };
  Int128 denominator_ = 1;
};

/// The scales from one to another, both included.
struct ScaleWindow {
  EventScale from, to;

  bool has(const EventScale& s) const { return s >= from && s <= to; }
};

}  // namespace minkref::inline space
