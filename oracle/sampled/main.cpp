// minkref-sampled-events: a judge for boundary events. Reads a question per line, writes an answer
// per line (README.md).
#include <sys/resource.h>

#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "oracle/sampled/events.hpp"

namespace {

using namespace minkref::sampled;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_digits = 10'000;

mpq_class rational(const Json& value) {
  const std::string text =
      value.is_number_integer() ? std::to_string(value.get<long>()) : value.get<std::string>();
  if (text.size() > most_digits) throw BadOperand("a number has too many digits");
  mpq_class number;
  if (number.set_str(text, 10) != 0 || number.get_den() == 0)
    throw BadOperand("no number: " + text);
  number.canonicalize();
  return number;
}

struct RationalPoint {
  mpq_class x, y;
};

std::vector<std::vector<RationalPoint>> rings_of(const Json& operand) {
  std::vector<std::vector<RationalPoint>> rings;
  const auto add = [&](const Json& ring) {
    auto& points = rings.emplace_back();
    for (const Json& v : ring) points.push_back({rational(v.at(0)), rational(v.at(1))});
    if (points.empty()) throw BadOperand("a ring has no points");
  };
  for (const Json& polygon : operand.at("polygons")) {
    add(polygon.at("outer"));
    if (polygon.contains("holes")) {
      for (const Json& hole : polygon.at("holes")) add(hole);
    }
  }
  return rings;
}

Rings in_units(const std::vector<std::vector<RationalPoint>>& rings, const mpz_class& unit) {
  Rings result;
  for (const auto& ring : rings) {
    auto& points = result.emplace_back();
    for (const auto& v : ring) points.push_back({mpz_class(v.x * unit), mpz_class(v.y * unit)});
  }
  return result;
}

bool is_thin(const Rings& rings) { return rings.size() == 1 && rings[0].size() < 3; }

Json text(const Counts& c) { return {c.rings, c.vertices, c.components, c.holes}; }

/// Limits the address space; without memory GMP ends the process.
void limit_memory(rlim_t bytes) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
}

Json answer_to(const Json& asked) {
  const auto began = Clock::now();
  const double seconds = asked.value("seconds", 600.0);
  if (asked.contains("bytes")) limit_memory(asked["bytes"].get<rlim_t>());
  const auto P = rings_of(asked.at("P")), Q = rings_of(asked.at("Q"));
  mpz_class unit = 1;  // sP + Q grows with both operands by this factor
  for (const auto* rings : {&P, &Q}) {
    for (const auto& ring : *rings) {
      for (const auto& v : ring) unit = lcm(lcm(unit, v.x.get_den()), v.y.get_den());
    }
  }
  Question question{in_units(P, unit), in_units(Q, unit), {}, {}, asked.value("all", false), {}};
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  question.is_in_time = [&] { return elapsed() < seconds; };
  if (asked.contains("from") && !asked["from"].is_null()) question.from = rational(asked["from"]);
  if (asked.contains("to") && !asked["to"].is_null()) question.to = rational(asked["to"]);
  if (is_thin(question.P) && is_thin(question.Q)) {
    return {{"status", "skipped"}, {"reason", "both operands are points or segments"}};
  }
  const Answer found = events(question);
  Json rows = Json::array();
  for (const Event& e : found.events) {
    rows.push_back({{"s", e.s.get_str()},
                    {"below", text(e.below)},
                    {"at", text(e.at)},
                    {"above", text(e.above)},
                    {"same", e.same}});
  }
  return {{"status", "result"},           {"events", rows},
          {"before", text(found.before)}, {"candidates", found.candidates},
          {"sums", found.sums},           {"bits", found.bits},
          {"seconds", elapsed()}};
}

Json answer_or_failure(const Json& asked) {
  const auto failed = [](const char* status, const std::string& why) {
    return Json{{"status", status}, {"reason", why}};
  };
  try {
    return answer_to(asked);
  } catch (const OutOfTime&) {
    return failed("timed-out", "the limit of time");
  } catch (const std::bad_alloc&) {
    return failed("out-of-memory", "the limit of memory");
  } catch (const std::exception& error) {
    return failed("errored", error.what());
  }
}

}  // namespace

int main() {
  std::ios::sync_with_stdio(false);
  std::string line;
  while (std::getline(std::cin, line)) {
    Json asked = Json::parse(line, nullptr, false);
    Json answer = asked.is_object() ? answer_or_failure(asked)
                                    : Json{{"status", "errored"}, {"reason", "no JSON object"}};
    if (asked.is_object() && asked.contains("id")) answer["id"] = asked["id"];
    std::cout << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
  }
  return 0;
}
