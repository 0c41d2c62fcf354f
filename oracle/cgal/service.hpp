// SPDX-License-Identifier: GPL-3.0-or-later
// The service of an executable behind the protocol: implemented once by each kind of executable.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "oracle/cgal/request.hpp"

namespace minkref::cgal_oracle {

/// Methods and versions, for --version.
nlohmann::json description();

/// Whether `method` is one of this executable's (self-tests apart).
bool has_method(const std::string& method);

/// The work of the child: reads the operands, asks CGAL, and returns {"status":..., ...}; status is
/// result, skipped or errored. May throw anything.
nlohmann::json answer_of(const Request& request);

}  // namespace minkref::cgal_oracle
