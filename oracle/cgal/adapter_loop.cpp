// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/adapter_loop.hpp"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <optional>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {
namespace {

using nlohmann::json;

struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

mpq_class read_coordinate(const json& value) {
  return value.is_number_integer() ? mpq_class(value.dump(), 10) : read_number(value, "vertices");
}

Solid read_solid(const json& value) {
  Solid solid;
  for (const json& v : value.at("vertices")) {
    if (v.size() != 3) throw BadOperand("a vertex is not [x, y, z]");
    solid.vertices.push_back(
        {read_coordinate(v.at(0)), read_coordinate(v.at(1)), read_coordinate(v.at(2))});
  }
  for (const json& f : value.at("faces")) {
    Face& face = solid.faces.emplace_back(f.get<Face>());
    for (const std::size_t i : face) {
      if (i >= solid.vertices.size()) throw BadOperand("a face names a vertex that is not there");
    }
  }
  return solid;
}

json write_solid(const Solid& solid) {
  json vertices = json::array(), faces = json::array();
  for (const SpacePoint& v : solid.vertices) {
    vertices.push_back({v.x.get_str(), v.y.get_str(), v.z.get_str()});
  }
  for (const Face& face : solid.faces) faces.push_back(face);
  return {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
}

json answer(const json& request, const json& hello, const SolidSum& sum, std::optional<Solid>& Q) {
  try {
    const auto verb = request.at("verb").get<std::string>();
    json result = {{"status", "result"}};
    if (verb == "hello") {
      result["protocol"] = "adapter-v1";
      result.update(hello);
    } else if (verb == "load") {
      Q.reset();
      if (request.at("dimension") != 3) throw Skipped("in space only");
      Q = read_solid(request.at("Q"));
    } else if (verb == "at") {
      if (!Q) throw BadOperand("`at` before any `load`");
      const Solid found = sum(read_solid(request.at("sP")), *Q);
      result.update(write_solid(found));
      if (request.value("timed", false)) result["cgal_seconds"] = found.seconds;
    } else if (verb != "stop") {
      throw Skipped("no verb " + verb + " here");
    }
    return result;
  } catch (const Skipped& reason) {
    return {{"status", "skipped"}, {"reason", reason.what()}};
  } catch (const std::exception& error) {  // CGAL's failures are exceptions too
    return {{"status", "errored"}, {"reason", error.what()}};
  }
}

}  // namespace

int serve_adapter(const json& hello, const SolidSum& sum) {
  std::FILE* answers = fdopen(dup(STDOUT_FILENO), "w");
  if (answers == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  std::optional<Solid> Q;
  bool stop = false;
  for (std::string line; !stop && std::getline(std::cin, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const json request = json::parse(line, nullptr, false);
    json value = {{"seq", nullptr}, {"status", "errored"}, {"reason", "a line that is no request"}};
    if (request.is_object()) {
      value = answer(request, hello, sum, Q);
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
