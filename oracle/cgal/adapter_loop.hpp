// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the adapter protocol (docs/adapter-protocol.md) for space, with exact numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

using SolidSum = std::function<Solid(const Solid& sP, const Solid& Q)>;

/// Answers requests until `stop` or the end of the input, in this process, so the adapter's caller
/// sets limits. `hello` is the declaration. CGAL's output goes to the log. Returns the exit code.
int serve_adapter(const nlohmann::json& hello, const SolidSum& sum);

}  // namespace minkref::cgal_oracle
