// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/request.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>

#include "oracle/cgal/method.hpp"
#include "oracle/cgal/screen.hpp"
#include "oracle/cgal/self_test.hpp"
#include "oracle/cgal/vanishing_holes.hpp"

namespace minkref::cgal_oracle {
namespace {

using nlohmann::json;

const Method* find_method(const std::string& name) {
  const auto all = methods();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Method& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

json refusal(const char* status, const std::string& reason) {
  return {{"status", status}, {"reason", reason}};
}

json sum(const Method& method, const Request& request) {
  const auto p = read_polygons(request.p, "P");
  const auto q = read_polygons(request.q, "Q");
  if (const auto reason = outside_of_cgal(p, method.holes, "P")) return refusal("skipped", *reason);
  if (const auto reason = outside_of_cgal(q, method.holes, "Q")) return refusal("skipped", *reason);
  Polygon first = p.front();
  Polygon second = q.front();
  if (!request.raw) {
    first = without_vanishing_holes(first, second);
    second = without_vanishing_holes(second, first);
  }
  const std::size_t removed =
      p.front().holes.size() + q.front().holes.size() - first.holes.size() - second.holes.size();
  const Sum sum = method.sum(first, second);
  return {{"status", "result"},
          {"seconds", sum.seconds},
          {"removed_holes", removed},
          {"result", write_polygons({sum.region})}};
}

}  // namespace

void read_request(const std::string& line, Request& request) {
  json value = json::parse(line);
  if (!value.is_object()) throw BadOperand("a request is a JSON object");
  request.id = value.value("id", json());
  request.method = value.value("method", std::string());
  request.raw = value.value("raw", false);
  request.limits.seconds = value.value("seconds", request.limits.seconds);
  request.limits.bytes = value.value("bytes", request.limits.bytes);
  if (!(request.limits.seconds > 0 && request.limits.seconds <= 1e6)) {
    throw BadOperand("\"seconds\" is not in (0, 1000000]");
  }
  if (!has_method(request.method)) throw BadOperand("no method \"" + request.method + '"');
  if (value.contains("P")) request.p = std::move(value["P"]);
  if (value.contains("Q")) request.q = std::move(value["Q"]);
}

bool has_method(const std::string& method) {
  return find_method(method) != nullptr || is_self_test(method);
}

std::string answer(const Request& request) {
  try {
    if (is_self_test(request.method)) return self_test(request.method);
    return sum(*find_method(request.method), request).dump();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const BadOperand& fault) {
    return refusal("errored", fault.what()).dump();
  } catch (const std::exception& fault) {  // CGAL's failures come as exceptions of its own
    return refusal("errored", std::string("exception: ") + fault.what())
        .dump(-1, ' ', false, json::error_handler_t::replace);
  }
}

}  // namespace minkref::cgal_oracle
