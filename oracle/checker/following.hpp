// Follows a certificate's parts, one after another.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "oracle/checker/reading.hpp"

namespace minkref::checker {

/// Follows an inner part, and puts its place before the messages of errors.
template <class Use>
void within(const std::string& place, Use&& use) {
  try {
    use();
  } catch (const NotVerified& error) {
    throw NotVerified(error.code, place + ": " + error.what());
  }
}

/// Throws NotVerified if a claim occurs twice.
inline void require_different(const Value& claims) {
  std::set<std::string> different;
  for (const Value& claim : items(claims)) {
    require(different.insert(written_out(claim)).second, "a claim is made twice");
  }
}

/// Follows steps, then claims, and returns a line for each claim. The functions add_step, add_claim
/// and end of `proof` throw NotVerified.
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
