// SPDX-License-Identifier: GPL-3.0-or-later
// An executable that answers lines of JSON with lines of JSON. The caller limits this process.
#pragma once

#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace minkref::cgal_oracle {

/// Answers lines until the input ends. Exceptions, including CGAL's failures, give {"error": what}.
template <class Answer>
void answer_lines(Answer&& answer) {
  for (std::string line; std::getline(std::cin, line);) {
    nlohmann::json found;
    try {
      found = answer(nlohmann::json::parse(line));
    } catch (const std::exception& error) {
      found = {{"error", error.what()}};
    }
    std::cout << found.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  }
}

}  // namespace minkref::cgal_oracle
