// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/adapter_loop.hpp"

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace minkref::cgal_oracle {
namespace {

using nlohmann::json;

json answer(const json& request, const json& hello, const Answering& answering) {
  try {
    const auto verb = request.at("verb").get<std::string>();
    json result = {{"status", "result"}};
    if (verb == "hello") {
      result["protocol"] = "adapter-v1";
      result.update(hello);
    } else if (verb != "stop") {
      result.update(answering(verb, request));
    }
    return result;
  } catch (const Skipped& reason) {
    return {{"status", "skipped"}, {"reason", reason.what()}};
  } catch (const std::exception& error) {  // CGAL's failures are exceptions too
    return {{"status", "errored"}, {"reason", error.what()}};
  }
}

}  // namespace

int serve_adapter(const json& hello, const Answering& answering) {
  std::FILE* answers = fdopen(dup(STDOUT_FILENO), "w");
  if (answers == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  bool stop = false;
  for (std::string line; !stop && std::getline(std::cin, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const json request = json::parse(line, nullptr, false);
    json value = {{"seq", nullptr}, {"status", "errored"}, {"reason", "a line that is no request"}};
    if (request.is_object()) {
      value = answer(request, hello, answering);
      value["seq"] = request.value("seq", json());
      stop = request.value("verb", json()) == "stop";
    }
    const auto text = value.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
    std::fwrite(text.data(), 1, text.size(), answers);
    if (std::fflush(answers) != 0) return 1;
  }
  return 0;
}

}  // namespace minkref::cgal_oracle
