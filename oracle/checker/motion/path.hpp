// Certificates for parts that move along paths. docs/certificates-paths.md
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Whether a certificate claims to have this form.
bool is_path_certificate(const Value& certificate);

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check_paths(const Value& certificate,
                                     const std::function<Value(const std::string&)>& read_case,
                                     Budget& budget);

}  // namespace minkref::checker
