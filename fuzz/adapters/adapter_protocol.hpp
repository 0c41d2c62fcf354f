// The loop of an adapter in C++: requests from standard input, answers to standard output.
// docs/adapter-protocol.md defines the protocol; this file implements its part in the plane, with
// numbers as doubles.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace minkref::adapter {

using nlohmann::json;

struct Point {
  double x, y;
};
using Ring = std::vector<Point>;
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};
using Polygons = std::vector<Polygon>;

/// The implementation does not take this case; the text is the reason.
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The members of a result, from sP and Q; may throw anything.
using Sum = std::function<json(const Polygons& sP, const Polygons& Q)>;
/// The members of a result, from sets to unite; may throw anything.
using Unite = std::function<json(const std::vector<Polygons>& sets)>;
/// The members of a result, from a set and the radius of the disc that it grows by; may throw
/// anything.
using Grow = std::function<json(const Polygons& P, double radius)>;
/// An offset's request: a set or open lines, the radius, and how corners and ends are to be.
struct Growth {
  Polygons polygons;
  std::vector<Ring> lines;
  double radius = 0;
  std::string join = "round", cap = "round";
  double limit = 2;  ///< of a mitre
};
/// The same for an implementation that takes open lines, or other joins and caps.
using GrowAs = std::function<json(const Growth& asked)>;
/// What an adapter does; an absent function's verb is skipped.
struct Work {
  Sum sum = nullptr;
  Unite unite = nullptr;
  Grow grow = nullptr;
  GrowAs grow_as = nullptr;
};

inline Ring read_ring(const json& value) {
  Ring ring;
  for (const json& p : value) ring.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  return ring;
}

inline Polygons read_polygons(const json& value) {
  Polygons polygons;
  for (const json& item : value.at("polygons")) {
    Polygon& polygon = polygons.emplace_back();
    polygon.outer = read_ring(item.at("outer"));
    for (const json& hole : item.at("holes")) polygon.holes.push_back(read_ring(hole));
  }
  return polygons;
}

inline Growth read_growth(const json& request) {
  const json& P = request.at("P");
  Growth asked;
  if (P.contains("lines")) {
    for (const json& line : P.at("lines")) asked.lines.push_back(read_ring(line));
  } else {
    asked.polygons = read_polygons(P);
  }
  asked.radius = request.at("radius").get<double>();
  asked.join = request.value("join", asked.join);
  asked.cap = request.value("cap", asked.cap);
  asked.limit = request.value("limit", asked.limit);
  return asked;
}

/// All the polygons' rings.
inline std::vector<Ring> rings_of(const Polygons& polygons) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : polygons) {
    rings.push_back(polygon.outer);
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return rings;
}

/// The answer to one request, without `seq`. `Q` comes from the last `load`.
inline json answer(const json& request, const json& hello, const Work& work, Polygons& Q,
                   bool& loaded) {
  try {
    const auto verb = request.at("verb").get<std::string>();
    json result = {{"status", "result"}};
    if (verb == "hello") {
      result["protocol"] = "adapter-v1";
      result.update(hello);
    } else if (verb == "load") {
      loaded = false;
      if (request.at("dimension") != 2) throw Skipped("in the plane only");
      Q = read_polygons(request.at("Q"));
      loaded = true;
    } else if (verb == "union" && work.unite) {
      std::vector<Polygons> sets;
      for (const json& set : request.at("sets")) sets.push_back(read_polygons(set));
      result.update(work.unite(sets));
    } else if (verb == "offset" && work.grow_as) {
      result.update(work.grow_as(read_growth(request)));
    } else if (verb == "offset" && work.grow) {
      result.update(work.grow(read_polygons(request.at("P")), request.at("radius").get<double>()));
    } else if (verb == "at" && work.sum) {
      if (!loaded) throw std::runtime_error("`at` before any `load`");
      result.update(work.sum(read_polygons(request.at("sP")), Q));
    } else if (verb != "stop") {
      throw Skipped("no verb " + verb + " here");
    }
    return result;
  } catch (const Skipped& reason) {
    return {{"status", "skipped"}, {"reason", reason.what()}};
  } catch (const std::exception& error) {
    return {{"status", "errored"}, {"reason", error.what()}};
  } catch (...) {  // any type other than std::exception
    return {{"status", "errored"}, {"reason", "an exception that says nothing"}};
  }
}

/// Answers until `stop` or the input's end; returns the program's exit code. The implementation's
/// own output goes to the log.
inline int serve(const json& hello, const Work& work) {
  std::FILE* answers = fdopen(dup(STDOUT_FILENO), "w");
  if (answers == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  Polygons Q;
  bool loaded = false, stop = false;
  for (std::string line; !stop && std::getline(std::cin, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const json request = json::parse(line, nullptr, false);
    json value;
    if (request.is_object()) {
      value = answer(request, hello, work, Q, loaded);
      value["seq"] = request.value("seq", json());
      stop = request.value("verb", json()) == "stop";
    } else {
      value = {{"seq", nullptr}, {"status", "errored"}, {"reason", "a line that is no request"}};
    }
    const auto text = value.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
    std::fwrite(text.data(), 1, text.size(), answers);
    if (std::fflush(answers) != 0) return 1;
  }
  return 0;
}

}  // namespace minkref::adapter
