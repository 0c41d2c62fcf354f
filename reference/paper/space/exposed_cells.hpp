// Cells on the boundary, by collision detection beside each cell (Sec. 3).
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/number/exact_value.hpp"
#include "reference/paper/space/body_contact.hpp"
#include "reference/paper/space/facet_cells.hpp"
#include "reference/paper/space/facet_shot.hpp"
#include "reference/paper/space/paper_space_update.hpp"
#include "reference/plane/routes/boundary_rings.hpp"

namespace minkref::inline space {

template <class T>
class ExposedCells {
 public:
  using Vector = typename PlacedFacets<T>::Vector;

  /// `coplanar_with`: for each facet all always coplanar facets, ascending. `denominator`: the
  /// coordinates' unit. All must outlive the object.
  ExposedCells(const PlacedFacets<T>& placed,
               const std::vector<std::vector<std::uint32_t>>& coplanar_with,
               const BodyContact<T>& contact, const Integer& denominator)
      : placed_(placed),
        coplanar_with_(coplanar_with),
        contact_(contact),
        unit_(Integer(1), denominator) {}

  /// Adds a facet's cells, and rings around exposed cells. A cell counts as exposed if the place
  /// above, halfway to the next facet, lies outside the sum; a cell that borders on a crossing
  /// facet from below never does, and needs no test. As exact as T.
  void add(std::uint32_t facet, PaperSpaceSum& sum) const {
    const FacetCells<T> cells(placed_, facet);
    sum.nodes += cells.node_count();
    std::vector<bool> exposed(cells.face_count(), false);
    bool any = false;
    for (std::uint32_t face = 1; face < cells.face_count(); ++face) {
      look_for_interrupt();
      const auto found = cells.inner_point(face);
      if (!found || !placed_.holds(facet, *found)) continue;
      const Vector& x = *found;
      if (!cells.is_below_another(face)) {
        ++sum.asked;
        exposed[face] = !contact_.meets(above(facet, x, cells.normal()));
      }
      any = any || exposed[face];
      sum.cells.push_back({facet, exact_point(x), exposed[face]});
    }
    if (!any) return;
    PaperSpaceSum::Exposed part{facet, {}};
    for (const auto& nodes : boundary_nodes(cells.arrangement(), exposed)) {
      auto& ring = part.rings.emplace_back();
      for (const std::uint32_t node : nodes) {
        ring.push_back(exact_point(cells.lifted(cells.arrangement().node(node))));
      }
    }
    sum.exposed.push_back(std::move(part));
  }

 private:
  SpacePoint exact_point(const Vector& x) const {
    return {exact_value(x[0]) * unit_, exact_value(x[1]) * unit_, exact_value(x[2]) * unit_};
  }

  Vector above(std::uint32_t facet, const Vector& x, const Vector& n) const {
    const auto& same = coplanar_with_[facet];
    const auto hit = first_hit(placed_, x, n, [&](std::uint32_t other) {
      return other != facet && !std::binary_search(same.begin(), same.end(), other);
    });
    return x + n * (hit ? T(*hit / T(2)) : T(1));
  }

  const PlacedFacets<T>& placed_;
  const std::vector<std::vector<std::uint32_t>>& coplanar_with_;
  const BodyContact<T>& contact_;
  const Rational unit_;
};

}  // namespace minkref::inline space
