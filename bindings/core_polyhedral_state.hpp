// A set in space as what a pickle holds.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_space.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::python {

/// Normal, offset, and of each polygon its rings.
using PlaneRow =
    std::tuple<ExactSpacePoint, std::string, std::vector<std::vector<std::vector<ExactPoint>>>>;

std::vector<PlaneRow> state_of(const PolyhedralSet& set);
/// Refuses (BadInput "damaged-set") a state that is not in canonical form. Does not test whether
/// the planes together bound a set.
PolyhedralSet set_of_state(const std::vector<PlaneRow>& state);

}  // namespace minkref::python
