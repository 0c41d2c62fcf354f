// A scale bracket's events where free places may change.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

struct CriticalEvents;

/// Events of two, three and four facets of the sum of obstacles and -sR, for s from one scale to
/// another, both included. Between two of their scales no component of the free places is born,
/// dies, splits or merges. Exact and complete. Throws and costs as `critical_events_in_space`.
class FreeEvents {
 public:
  FreeEvents(const Polyhedron& turned, const Polyhedron& obstacles, const Rational& from,
             const Rational& to);

  const std::vector<Rational>& scales() const { return scales_; }  ///< ascending, distinct
  /// The places of the events of a scale, ascending, distinct.
  std::vector<SpacePoint> places_at(const Rational& scale) const;

  static constexpr std::uint64_t most = 1'000'000;  ///< events; more throw LimitExceeded

 private:
  std::shared_ptr<const CriticalEvents> events_;
  std::vector<Rational> scales_;
};

}  // namespace minkref::inline space
