// The only list of route names.
#pragma once

#include <string_view>
#include <vector>

#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

struct RouteName {
  Route route;
  std::string_view name;
  std::string_view what;  ///< how it works, in a few words
};

/// All routes, the paper's first.
const std::vector<RouteName>& route_names();

/// Throws BadInput ("unknown-route") with a list of all routes.
Route route_named(std::string_view name);

}  // namespace minkref::inline plane
