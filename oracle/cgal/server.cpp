// SPDX-License-Identifier: GPL-3.0-or-later
// A server for JSON lines: a child process answers each request (README.md).
#include <signal.h>

#include <cstring>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

#include "oracle/cgal/child.hpp"
#include "oracle/cgal/request.hpp"
#include "oracle/cgal/service.hpp"

namespace minkref::cgal_oracle {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestLine = std::size_t{256} << 20;

json of_answer(const Outcome& outcome) {
  json value = json::parse(outcome.text, nullptr, false);
  if (value.is_object() && value.contains("status")) return value;
  return {{"status", "errored"}, {"reason", "the child's answer is not that of the protocol"}};
}

/// Judges a refused allocation. If the child used far less than its allowance, no limit of ours
/// stood in its way: the program asked for an absurd amount, as after reading stale memory.
json of_memory(const Outcome& outcome, const Limits& limits) {
  if (outcome.signal != 0) {
    return {{"status", "out-of-memory"},
            {"reason", "killed by the system, as it does where memory runs out"}};
  }
  const std::string use = std::to_string(outcome.peak_bytes) + " bytes in use and " +
                          std::to_string(limits.bytes) + " allowed";
  if (outcome.peak_bytes < limits.bytes / 8) {
    return {{"status", "crashed"}, {"reason", "std::bad_alloc with no more than " + use}};
  }
  return {{"status", "out-of-memory"}, {"reason", "an allocation was refused with " + use}};
}

json of_end(const Outcome& outcome, const Limits& limits) {
  switch (outcome.end) {
    case End::answered:
      return of_answer(outcome);
    case End::crashed:
      return {{"status", "crashed"},
              {"signal", outcome.signal},
              {"reason", std::string("signal ") + std::to_string(outcome.signal) + ": " +
                             strsignal(outcome.signal)}};
    case End::timed_out:
      return {{"status", "timed-out"},
              {"reason", "no answer in " + json(limits.seconds).dump() + " s"}};
    case End::out_of_memory:
      return of_memory(outcome, limits);
    case End::answer_too_large:
      return {{"status", "errored"},
              {"reason",
               "the answer is larger than " + std::to_string(limits.answer_bytes) + " bytes"}};
    case End::exited:
      return {{"status", "errored"},
              {"reason", "the child left with exit code " + std::to_string(outcome.exit_code)}};
  }
  return {{"status", "errored"}, {"reason", "unknown end"}};
}

json serve(const std::string& line) {
  Request request;
  json value;
  try {
    read_request(line, request);
    const Outcome outcome = run_in_child(request.limits, [&] { return answer(request); });
    value = of_end(outcome, request.limits);
    value["total_seconds"] = outcome.seconds;
    value["peak_bytes"] = outcome.peak_bytes;
    if (!value.contains("seconds")) value["seconds"] = outcome.seconds;
  } catch (const std::bad_alloc&) {
    value = {{"status", "errored"}, {"reason", "no memory left in the server"}};
  } catch (const std::exception& fault) {
    value = {{"status", "errored"}, {"reason", fault.what()}};
  }
  value["id"] = request.id;
  return value;
}

/// Reads a line without its end; false at the end of the input. Reads an overlong line to its end,
/// leaves it empty, and sets `too_long`.
bool read_line(std::string& line, bool& too_long) {
  line.clear();
  too_long = false;
  for (int c; (c = std::cin.rdbuf()->sbumpc()) != EOF;) {
    if (c == '\n') return true;
    if (!too_long) line.push_back(static_cast<char>(c));
    if (line.size() > kLongestLine) {
      too_long = true;
      line = std::string();
    }
  }
  return !line.empty() || too_long;
}

int run() {
  signal(SIGPIPE, SIG_IGN);  // seen as a failed write
  std::ios::sync_with_stdio(false);
  std::string line;
  bool too_long = false;
  while (read_line(line, too_long)) {
    if (line.find_first_not_of(" \t\r") == std::string::npos && !too_long) continue;
    const json value =
        too_long ? json{{"id", nullptr}, {"status", "errored"}, {"reason", "the line is too long"}}
                 : serve(line);
    std::cout << value.dump(-1, ' ', false, json::error_handler_t::replace) << '\n' << std::flush;
    if (!std::cout) return 1;
  }
  return 0;
}

}  // namespace
}  // namespace minkref::cgal_oracle

int main(int count, char** arguments) {
  using namespace minkref::cgal_oracle;
  if (count == 1) return run();
  if (count == 2 && std::string_view(arguments[1]) == "--version") {
    std::cout << description().dump() << '\n';
    return 0;
  }
  std::cerr << "usage: " << arguments[0]
            << " [--version]\nAnswers requests on standard input, one JSON object a line: see "
               "oracle/cgal/README.md.\n";
  return 2;
}
