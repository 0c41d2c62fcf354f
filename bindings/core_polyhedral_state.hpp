// A set's state for pickle, for sets from space.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_space.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::python {

/// Normal, offset, and the rings of each polygon.
using PlaneRow =
    std::tuple<ExactSpacePoint, std::string, std::vector<std::vector<std::vector<ExactPoint>>>>;

std::vector<PlaneRow> state_of(const PolyhedralSet& set);
/// Refuses (BadInput "damaged-set") a state without canonical form. Does not test whether the
/// planes together bound a set.
PolyhedralSet set_of_state(const std::vector<PlaneRow>& state);

}  // namespace minkref::python
