// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of an adapter (docs/adapter-protocol.md) with exact numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace minkref::cgal_oracle {

/// The implementation does not take this case; the text is the reason.
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The members of a result, by verb; throws Skipped for a verb that it does not have.
using Answering =
    std::function<nlohmann::json(const std::string& verb, const nlohmann::json& request)>;

/// Answers requests until `stop` or the end of the input, in this process, so the adapter's caller
/// sets limits. `hello` is the declaration. CGAL's output goes to the log. Returns the exit code.
int serve_adapter(const nlohmann::json& hello, const Answering& answering);

}  // namespace minkref::cgal_oracle
