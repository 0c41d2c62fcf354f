// Reads operands from files and texts: where to start.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "formats/limits.hpp"
#include "formats/reading.hpp"

namespace minkref {

/// Reads a polygon set (docs/formats.md). Coordinates are the exact numbers of the text. Rings of
/// WKT, GeoJSON, `.poly` and plain JSON are turned as their role demands; a case keeps its rings as
/// written. Nothing else is checked: see read_valid_text. Format::json takes plain sets, GeoJSON
/// and cases, told apart by their members. A case holds two operands: a source ending with "#P" or
/// "#Q" chooses; otherwise P is taken, with a warning. Throws BadInput and LimitExceeded, which
/// name source, line, ring and vertex; nothing else, save for std::bad_alloc. The limits bound time
/// and memory.
Reading read_text(std::string_view text, Format format, const std::string& source,
                  const ReadLimits& limits = {});

/// Reads a whole file first, then its text; the extension tells the format. "case.json#Q" means the
/// operand Q of case.json.
Reading read_file(const std::string& path, const ReadLimits& limits = {});

/// `open`: of each ring, whether it is not closed where the format repeats the first vertex.
struct FaultyReading {
  Reading reading;
  std::vector<bool> open;
};

/// Reads a set whose faults `minkref repair` mends (set_builder.hpp: Faults::kept), rings as
/// written, none turned. Refuses everything else as read_text does.
FaultyReading read_faulty_text(std::string_view text, Format format, const std::string& source,
                               const ReadLimits& limits = {});
FaultyReading read_faulty_file(const std::string& path, const ReadLimits& limits = {});

/// Read, then validated (`validate`); a refusal names the file, and the line, the ring and the
/// vertices as the file numbers them.
Reading read_valid_text(std::string_view text, Format format, const std::string& source,
                        const ReadLimits& limits = {});
Reading read_valid_file(const std::string& path, const ReadLimits& limits = {});

}  // namespace minkref
