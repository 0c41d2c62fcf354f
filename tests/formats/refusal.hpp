// Checks for refusals.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "formats/read.hpp"
#include "reference/error.hpp"

namespace minkref {

/// The refusal that `act` throws; a test failure if it throws nothing or something else.
template <class Act>
BadInput refusal_of(Act act) {
  try {
    act();
  } catch (const BadInput& e) {
    // Every refusal shortly names the fault and the remedy.
    EXPECT_FALSE(e.problem().empty());
    EXPECT_FALSE(e.mend().empty());
    EXPECT_LT(std::string_view(e.what()).size(), 1000U);
    return e;
  } catch (const std::exception& e) {
    ADD_FAILURE() << "not a refusal: " << e.what();
    return {"none", "", ""};
  }
  ADD_FAILURE() << "nothing was refused";
  return {"none", "", ""};
}

inline BadInput refusal_of_text(std::string_view text, Format format,
                                const ReadLimits& limits = {}) {
  const BadInput refused = refusal_of([&] { read_valid_text(text, format, "input", limits); });
  EXPECT_TRUE(refused.place().source.starts_with("input")) << refused.what();
  return refused;
}

inline std::string code_of(std::string_view text, Format format, const ReadLimits& limits = {}) {
  return refusal_of_text(text, format, limits).code();
}

/// Expects every text to be refused with this code, which `code_of` gives.
template <class CodeOf>
void expect_code(CodeOf&& code_of, std::string_view code,
                 std::initializer_list<std::string> texts) {
  for (const std::string& text : texts) EXPECT_EQ(code_of(text), code) << text;
}

inline Point point(const char* x, const char* y) { return {parse_rational(x), parse_rational(y)}; }

}  // namespace minkref
