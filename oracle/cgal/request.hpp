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
  bool raw = false;
  Limits limits;
  nlohmann::json p, q;
};

/// Throws BadOperand or nlohmann::json::exception where it is not one. `id` is kept as far as it
/// was read, so that the refusal can name it.
void read_request(const std::string& line, Request& request);

/// What the child does: reads the operands, asks CGAL, and returns {"status":..., ...} as text.
/// status is result, skipped or errored; only std::bad_alloc is thrown.
std::string answer(const Request& request);

/// Whether `method` is one of this executable's, or a self-test.
bool has_method(const std::string& method);

}  // namespace minkref::cgal_oracle
