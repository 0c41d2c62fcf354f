#include "tests/fuzzing/reference/pair_input.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "reference/error.hpp"
#include "reference/plane/sum.hpp"
#include "tests/fuzzing/reference/input_tally.hpp"

namespace minkref::fuzzing {
namespace {

bool is_short(const Rational& value) { return to_string(value).size() <= most_digits; }

bool is_small(const PolygonSet& set) {
  if (set.vertices() > bounds.vertices) return false;
  for (const Polygon& polygon : set.polygons) {
    const auto short_ring = [](const Ring& ring) {
      for (const Point& p : ring) {
        if (!is_short(p.x) || !is_short(p.y)) return false;
      }
      return true;
    };
    if (!short_ring(polygon.outer)) return false;
    for (const Ring& hole : polygon.holes) {
      if (!short_ring(hole)) return false;
    }
  }
  return true;
}

/// The text up to the brace that closes the first brace. Strings never contain braces: a text cut
/// inside a string is no case.
std::string_view first_object(std::string_view text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && depth > 0 && --depth == 0) return text.substr(0, i + 1);
  }
  return text;
}

}  // namespace

std::optional<Case> read_pair(std::string_view text) {
  ReadLimits limits;
  limits.number = {.digits = 300, .exponent = 300};
  limits.depth = 16;
  try {
    return read_case_text(first_object(text), "input", limits).value;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

bool is_small(const Case& pair) {
  if (!is_small(pair.P) || !is_small(pair.Q) || pair.scales.size() > most_scales) return false;
  if (pair.P.vertices() * pair.Q.vertices() > bounds.product) return false;
  for (const Rational& s : pair.scales) {
    if (!is_short(s)) return false;
  }
  const auto short_end = [](const std::optional<Rational>& end) { return !end || is_short(*end); };
  return !pair.interval || (short_end(pair.interval->from) && short_end(pair.interval->to));
}

void refuse_bad_pair(const Case& pair) {
  validate(pair.P);
  validate(pair.Q);
  refuse_bad_operands(pair.P, pair.Q, scale_of(pair));
}

Rational scale_of(const Case& pair) {
  if (!pair.scales.empty()) return pair.scales.front();
  if (pair.interval && pair.interval->from) return *pair.interval->from;
  if (pair.interval && pair.interval->to) return *pair.interval->to;
  return 1;
}

void broken(const std::string& law, const Case& pair, const std::string& what) {
  std::fprintf(stderr, "broken law: %s\n%s\n%s", law.c_str(), what.c_str(),
               write_case(pair).c_str());
  std::fprintf(stderr,
               "keep it as FINDING.json: minkref sum FINDING.json#P FINDING.json#Q"
               " --scale %s\n",
               to_string(scale_of(pair)).c_str());
  tally().print();
  std::abort();
}

int check_pair(const std::uint8_t* data, std::size_t size,
               const std::function<void(const Case&, Dice&)>& check) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ++tally().inputs;
  const std::optional<Case> pair = read_pair(text);
  if (!pair) return ++tally().no_case, 0;
  if (!is_small(*pair)) return ++tally().too_large, 0;
  try {
    refuse_bad_pair(*pair);
  } catch (const BadInput&) {
    return ++tally().refused, 0;
  } catch (const std::exception& e) {
    broken("an invalid pair is refused by BadInput", *pair, e.what());
  }
  ++tally().valid;
  Dice dice(text);
  try {
    check(*pair, dice);
  } catch (const std::exception& e) {
    broken("nothing is thrown on a valid pair", *pair, e.what());
  }
  return 0;
}

}  // namespace minkref::fuzzing
