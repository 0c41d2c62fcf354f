// Certificates for sums of a region with a disc. docs/certificates-disc.md
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Whether a certificate claims to have this form.
bool is_disc_sum_certificate(const Value& certificate);

/// Returns a certificate's proven claims, a line each. `read_case` reads the case from the path
/// named by the certificate. Throws NotVerified.
std::vector<std::string> check_disc_sums(const Value& certificate,
                                         const std::function<Value(const std::string&)>& read_case,
                                         Budget& budget);

}  // namespace minkref::checker
