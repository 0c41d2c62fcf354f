// A case (`case-v1`): two operands, scales, and what is expected. Schema: degeneracies/schema/.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/limits.hpp"
#include "formats/reading.hpp"

namespace minkref {

/// A closed interval of scales; an end that is absent is 0 or infinity.
struct CaseInterval {
  std::optional<Rational> from, to;
  friend bool operator==(const CaseInterval&, const CaseInterval&) = default;
};

/// What is expected of `sP + Q` at one scale. Only what is given is claimed.
struct Expected {
  Rational scale;
  std::optional<std::string> digest;  ///< SHA-256 of the canonical JSON, 64 hexadecimal digits
  std::optional<std::uint64_t> components, holes, vertices;
  std::optional<Rational> area;
  std::optional<PolygonSet> result;  ///< in full
  friend bool operator==(const Expected&, const Expected&) = default;
};

struct Case {
  std::string id;
  std::string title, comment;  ///< carry no truth
  PolygonSet P, Q;
  std::vector<Rational> scales;          ///< either these
  std::optional<CaseInterval> interval;  ///< or this
  std::vector<std::string> tags;         ///< families
  std::vector<std::string> flags;
  std::vector<Expected> expected;
  std::string source, licence;  ///< licence: an SPDX expression
  std::string certificate;      ///< path relative to the case; "" where there is none
  friend bool operator==(const Case&, const Case&) = default;
};

/// A case with the places of its operands in the text.
struct CaseReading {
  Case value;
  std::vector<RingOrigin> P_origins, Q_origins;
};

/// Reads a case of dimension 2. Nothing is turned: `validate` refuses wrong orientation. Unknown
/// members are refused. Throws BadInput, LimitExceeded. Refusals in an operand name it:
/// "file.json#P".
CaseReading read_case_text(std::string_view text, const std::string& source,
                           const ReadLimits& limits = {});

/// Reads a case file; the operands are validated.
Case read_case(const std::string& path, const ReadLimits& limits = {});

/// The text of a case: exact, one line a ring. Reading it gives the same case.
std::string write_case(const Case& value);

}  // namespace minkref
