// Certificates for points of sums of polyhedra. docs/certificates-solids.md, "Points"
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Whether a certificate claims to have this form.
bool is_solid_point_certificate(const Value& certificate);

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check_solid_points(
    const Value& certificate, const std::function<Value(const std::string&)>& read_case,
    Budget& budget);

}  // namespace minkref::checker
