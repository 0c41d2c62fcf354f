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
  nlohmann::json value;  ///< the whole request
};

/// Throws BadOperand or nlohmann::json::exception where the line is no request. Keeps `id` once it
/// has been read, so that the refusal can name the request.
void read_request(const std::string& line, Request& request);

/// Finds a request's member, null if absent. Never copied: hostile input nests deeply.
const nlohmann::json& member(const Request& request, const char* name);

/// Returns the child's answer as text, from a self-test or from the service; errored where either
/// throws. Only std::bad_alloc leaves this function.
std::string answer(const Request& request);

/// {"status": status, "reason": reason}.
nlohmann::json refusal(const char* status, const std::string& reason);

}  // namespace minkref::cgal_oracle
