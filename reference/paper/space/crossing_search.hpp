// Crossings for all pairs of facets at all scales, on several threads; and at one scale, without
// events: a measure for the paper's update (Behar & Lien 2012, Sec. 5, 7.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/build/stage.hpp"
#include "reference/interrupt.hpp"
#include "reference/paper/space/crossings.hpp"

namespace minkref::inline space {

template <class T>
struct CrossingLists {
  std::vector<Crossing<T>> crossings;  ///< by the first facet, then by the second
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar;  ///< at all scales; ascending
  std::uint64_t pairs = 0;                                        ///< that were looked at
  std::uint64_t undecided = 0;  ///< that were left out: a sign was NaN
};

/// All later facets: no filter, which might discard just the events that a wrong formula invents.
inline std::vector<std::uint32_t> all_later(std::uint32_t facet, std::size_t count) {
  std::vector<std::uint32_t> later;
  for (std::uint32_t b = facet + 1; b < count; ++b) later.push_back(b);
  return later;
}

/// The crossings of pairs of facets, as read; the same whatever the number of threads. `later(a)`
/// lists the greater facets that are paired with a, ascending; `directions(a, b)` gives their
/// PairDirections, for the reading of this name. `zero`: the tolerance below which
/// numbers count as zero. Reports progress by facets. Throws what `control` throws, UndecidedSign
/// if an interval cannot tell a sign. O(1) for each pair.
template <class T, class Later, class Directions>
CrossingLists<T> find_crossings(const std::vector<typename TwoFacets<T>::Facet>& facets,
                                Later&& later, Directions&& directions,
                                const SpaceUpdateReadings& readings, const T& zero,
                                const BuildControl& control) {
  const bool told = readings.singular == SpaceUpdateReadings::Singular::directions;
  const auto find = [&](std::uint32_t a) {
    CrossingLists<T> row;
    for (const std::uint32_t b : later(a)) {
      control.look();
      ++row.pairs;
      try {
        const PairDirections known = told ? directions(a, b) : PairDirections{};
        PairCrossings<T> pair(facets[a], facets[b], told ? &known : nullptr, readings, zero);
        const bool coplanar = pair.find([&](Crossing<T> found) {
          found.first = a;
          found.second = b;
          row.crossings.push_back(std::move(found));
        });
        if (coplanar) row.coplanar.emplace_back(a, b);
      } catch (const UndecidedSign&) {
        if constexpr (std::is_same_v<T, Interval>) throw;
        ++row.undecided;
      }
    }
    return row;
  };
  std::vector<CrossingLists<T>> rows(facets.size());
  in_parallel(facets.size(), control, BuildProgress::Stage::pairs, [&](unsigned) {
    return [&](std::size_t a) { rows[a] = find(static_cast<std::uint32_t>(a)); };
  });
  CrossingLists<T> all;
  std::size_t count = 0;
  for (const CrossingLists<T>& row : rows) count += row.crossings.size();
  all.crossings.reserve(count);
  for (CrossingLists<T>& row : rows) {
    control.look();
    all.pairs += row.pairs;
    all.undecided += row.undecided;
    for (Crossing<T>& found : row.crossings) all.crossings.push_back(std::move(found));
    all.coplanar.insert(all.coplanar.end(), row.coplanar.begin(), row.coplanar.end());
    row = {};
  }
  return all;
}

/// Counts sides that pierce facets at a scale, ends included: for each pair, solves the system from
/// Sec. 5.2 for each side's line and the second plane, and checks the point against side and facet.
/// `later(a)` lists the greater facets that are paired with a. As exact as T; omits pairs with a
/// sign that was NaN. Throws UndecidedSign where an interval cannot tell. O(1) for each pair.
template <class T, class Later>
std::size_t crossings_afresh(const std::vector<typename TwoFacets<T>::Facet>& facets, Later&& later,
                             const T& scale) {
  std::vector<typename TwoFacets<T>::Vector> points;
  const auto look_at = [&](const TwoFacets<T>& pair) {
    for (const std::size_t which : {0U, 1U}) {
      for (std::size_t k = 0; k < pair.size(which); ++k) {
        auto x = pair.crossing(which, k, scale);
        if (x && pair.is_between(which, k, *x, scale) && pair.is_inside(1 - which, *x, scale)) {
          points.push_back(std::move(*x));
        }
      }
    }
  };
  for (std::uint32_t a = 0; a < facets.size(); ++a) {
    for (const std::uint32_t b : later(a)) {
      look_for_interrupt();
      try {
        look_at(TwoFacets<T>(facets[a], facets[b]));
      } catch (const UndecidedSign&) {  // a system that only rounding keeps from being singular
        if constexpr (std::is_same_v<T, Interval>) throw;
      }
    }
  }
  return points.size();
}

}  // namespace minkref::inline space
