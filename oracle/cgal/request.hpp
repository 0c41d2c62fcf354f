// SPDX-License-Identifier: GPL-3.0-or-later
// One request of the protocol (README.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "oracle/cgal/child.hpp"

namespace minkref::cgal_oracle {

struct Request {
  nlohmann::json id;
  std::string method;
  Limits limits;
  nlohmann::json value;  ///< all of it
};

/// Throws BadOperand or nlohmann::json::exception where it is not one. `id` is kept as far as it
/// was read, so that the refusal can name it.
void read_request(const std::string& line, Request& request);

/// A member of the request, null where it has none. Never copied: hostile input nests deeply.
const nlohmann::json& member(const Request& request, const char* name);

/// The child's answer as text: of a self-test or of the service; status errored where it throws
/// (only std::bad_alloc is thrown).
std::string answer(const Request& request);

/// {"status": status, "reason": reason}.
nlohmann::json refusal(const char* status, const std::string& reason);

}  // namespace minkref::cgal_oracle
