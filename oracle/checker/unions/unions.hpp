// Certificates for unions of sets in the plane. docs/certificates-unions.md
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"

namespace minkref::checker {

/// Whether a certificate claims to have this form.
bool is_union_certificate(const Value& certificate);

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check_unions(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget);

}  // namespace minkref::checker
