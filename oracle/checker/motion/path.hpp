// Certificates of parts that move along paths. docs/certificates-paths.md
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

/// Whether this says of itself that it is a certificate of this form.
bool is_path_certificate(const Value& certificate);

/// The proven claims of a certificate, a line each. `read_case` gives the case by the path that the
/// certificate names. Throws NotVerified.
std::vector<std::string> check_paths(const Value& certificate,
                                     const std::function<Value(const std::string&)>& read_case,
                                     Budget& budget);

}  // namespace minkref::checker
