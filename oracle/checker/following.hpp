// The parts of a certificate, one after the other.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "oracle/checker/reading.hpp"

namespace minkref::checker {

/// Follows an inner part; what is wrong there is said with its place.
template <class Use>
void within(const std::string& place, Use&& use) {
  try {
    use();
  } catch (const NotVerified& error) {
    throw NotVerified(error.code, place + ": " + error.what());
  }
}

/// Throws NotVerified where a claim is made twice.
inline void require_different(const Value& claims) {
  std::set<std::string> different;
  for (const Value& claim : items(claims)) {
    require(different.insert(written_out(claim)).second, "a claim is made twice");
  }
}

/// Steps, then claims: a line for each of these. `proof` has add_step, add_claim and end, which
/// throw NotVerified.
template <class Proof>
std::vector<std::string> followed(Proof& proof, const Value& steps, const Value& claims) {
  std::size_t n = 0;
  for (const Value& step : items(steps)) {
    within("step " + std::to_string(n++), [&] { proof.add_step(step); });
  }
  require_different(claims);
  std::vector<std::string> said;
  for (const Value& claim : items(claims)) {
    within("claim " + std::to_string(said.size()), [&] { said.push_back(proof.add_claim(claim)); });
  }
  proof.end();
  return said;
}

}  // namespace minkref::checker
