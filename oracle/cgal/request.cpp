// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/request.hpp"

#include <exception>
#include <new>

#include "oracle/cgal/polygon.hpp"
#include "oracle/cgal/self_test.hpp"
#include "oracle/cgal/service.hpp"

namespace minkref::cgal_oracle {

using nlohmann::json;

json refusal(const char* status, const std::string& reason) {
  return {{"status", status}, {"reason", reason}};
}

void read_request(const std::string& line, Request& request) {
  json value = json::parse(line);
  if (!value.is_object()) throw BadOperand("a request is a JSON object");
  request.id = value.value("id", json());
  request.method = value.value("method", std::string());
  request.limits.seconds = value.value("seconds", request.limits.seconds);
  request.limits.bytes = value.value("bytes", request.limits.bytes);
  if (!(request.limits.seconds > 0 && request.limits.seconds <= 1e6)) {
    throw BadOperand("\"seconds\" is not in (0, 1000000]");
  }
  if (!has_method(request.method) && !is_self_test(request.method)) {
    throw BadOperand("no method \"" + request.method + '"');
  }
  request.value = std::move(value);
}

const json& member(const Request& request, const char* name) {
  static const json null;
  const auto found = request.value.find(name);
  return found == request.value.end() ? null : *found;
}

std::string answer(const Request& request) {
  try {
    if (is_self_test(request.method)) return self_test(request.method);
    return answer_of(request).dump();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const BadOperand& fault) {
    return refusal("errored", fault.what()).dump();
  } catch (const std::exception& fault) {  // CGAL's failures are exceptions too
    return refusal("errored", std::string("exception: ") + fault.what())
        .dump(-1, ' ', false, json::error_handler_t::replace);
  }
}

}  // namespace minkref::cgal_oracle
