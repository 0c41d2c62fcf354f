// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/self_test.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace minkref::cgal_oracle {
namespace {

constexpr std::string_view kPrefix = "self-test:";

std::string eat_memory() {
  constexpr std::size_t kPiece = 1 << 20;
  std::vector<std::unique_ptr<char[]>> eaten;
  for (;;) {
    eaten.push_back(std::make_unique<char[]>(kPiece));
    std::memset(eaten.back().get(), 1, kPiece);
  }
}

std::string hang() {
  volatile bool forever = true;
  while (forever) {
  }
  return "";
}

}  // namespace

bool is_self_test(const std::string& method) { return method.starts_with(kPrefix); }

std::string self_test(const std::string& method) {
  const auto name = method.substr(kPrefix.size());
  if (name == "crash") raise(SIGSEGV);
  if (name == "abort") std::abort();
  if (name == "hang") return hang();
  if (name == "sleep") {
    for (;;) pause();
  }
  if (name == "memory") return eat_memory();
  if (name == "garbage") return "\x01\x02 no JSON\n{";
  if (name == "flood") return std::string(std::size_t{300} << 20, ' ');
  if (name == "exit") std::exit(3);
  if (name == "silence") return "";
  return R"({"status":"errored","reason":"no such self-test"})";
}

}  // namespace minkref::cgal_oracle
