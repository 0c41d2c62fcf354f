// SPDX-License-Identifier: GPL-3.0-or-later
// The service behind the protocol; each kind of executable implements it once.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "oracle/cgal/request.hpp"

namespace minkref::cgal_oracle {

/// Lists methods and versions, for --version.
nlohmann::json description();

/// Whether this executable has `method` (self-tests apart).
bool has_method(const std::string& method);

/// Does the child's work: reads the operands, asks CGAL, and returns {"status":..., ...} with
/// status result, skipped or errored. May throw anything.
nlohmann::json answer_of(const Request& request);

}  // namespace minkref::cgal_oracle
