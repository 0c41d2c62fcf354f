// Follows a certificate to its claims.
#pragma once

#include "oracle/checker/plane/region.hpp"

namespace minkref::checker {

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check(const Value& certificate,
                               const std::function<Value(const std::string&)>& read_case,
                               Budget& budget);

}  // namespace minkref::checker
