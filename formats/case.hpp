// A case (`case-v1`): two operands, scales, and expected results. Schema: degeneracies/schema/.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/limits.hpp"
#include "formats/reading.hpp"
#include "reference/plane/scaling.hpp"

namespace minkref {

/// A closed interval of scales; an absent end means 0 or infinity.
struct CaseInterval {
  std::optional<Rational> from, to;
  friend bool operator==(const CaseInterval&, const CaseInterval&) = default;
};

/// The expected `sP + Q` at one scale. Absent members claim nothing.
struct Expected {
  Rational scale = 1;
  std::optional<PlaneScaling> axes;   ///< or this, a factor for each axis
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
  std::vector<Rational> scales;          ///< either these, and these with a factor for each axis
  std::vector<PlaneScaling> axes;        ///< (in a file both stand in one list)
  std::optional<CaseInterval> interval;  ///< or this
  std::vector<std::string> tags;         ///< families
  std::vector<std::string> flags;
  std::vector<Expected> expected;
  std::string source, licence;  ///< licence: an SPDX expression
  std::string certificate;      ///< path relative to the case; "" if none
  friend bool operator==(const Case&, const Case&) = default;
};

/// A case with its operands' places within the text.
struct CaseReading {
  Case value;
  std::vector<RingOrigin> P_origins, Q_origins;
};

/// Reads a 2-dimensional case. No ring is turned: `validate` refuses wrong orientation. Refuses
/// unknown members. Throws BadInput, LimitExceeded. A refusal of an operand names it:
/// "file.json#P".
CaseReading read_case_text(std::string_view text, const std::string& source,
                           const ReadLimits& limits = {});

/// Reads a case file; the operands are validated.
Case read_case(const std::string& path, const ReadLimits& limits = {});

/// Writes a case exactly, one line a ring. Reading the text gives the same case.
std::string write_case(const Case& value);

}  // namespace minkref
