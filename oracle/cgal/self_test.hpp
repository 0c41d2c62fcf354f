// SPDX-License-Identifier: GPL-3.0-or-later
// Misbehaviour on request, for the tests of the server: "self-test:" crash, abort, hang, sleep,
// memory, garbage, flood, exit, silence.
#pragma once

#include <string>

namespace minkref::cgal_oracle {

bool is_self_test(const std::string& method);

/// Misbehaves as the name says, and returns the child's output if it returns at all.
std::string self_test(const std::string& method);

}  // namespace minkref::cgal_oracle
