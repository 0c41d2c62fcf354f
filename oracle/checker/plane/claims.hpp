// A certificate, followed to its claims.
#pragma once

#include "oracle/checker/plane/region.hpp"

namespace minkref::checker {

/// The proven claims of a certificate, a line each. `read_case` gives the case by the path that the
/// certificate names. Throws NotVerified.
std::vector<std::string> check(const Value& certificate,
                               const std::function<Value(const std::string&)>& read_case,
                               Budget& budget);

}  // namespace minkref::checker
