// Certificates of sums of polyhedra of any shape. docs/certificates-solids.md
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Whether this says of itself that it is a certificate of this form.
bool is_solid_certificate(const Value& certificate);

/// The proven claims of a certificate, a line each. `read_case` gives the case by the path that the
/// certificate names. Throws NotVerified.
std::vector<std::string> check_solids(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget);

}  // namespace minkref::checker
