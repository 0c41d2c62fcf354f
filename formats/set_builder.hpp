// Collects a reader's rings into one operand.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "formats/input.hpp"
#include "formats/reading.hpp"

namespace minkref {

/// A ring as written.
struct TextRing {
  Ring points;
  std::size_t number = 0;            ///< 0-based, in the order of the text
  std::size_t line = 0;              ///< where it begins
  std::vector<std::uint32_t> lines;  ///< of each vertex

  Place place() const;                       ///< of the ring
  Place place_of(std::size_t vertex) const;  ///< of a vertex, with its coordinates
};

/// Rings are numbered as they come. A point and a segment stand alone: beside anything else they
/// are refused ("mixed-operand").
class SetBuilder {
 public:
  explicit SetBuilder(Input& input) : input_(input) {}

  TextRing ring(std::size_t line);
  /// Parses and appends a vertex; refusals name ring, vertex and line.
  void vertex(TextRing& ring, std::string_view x, std::string_view y, std::size_t line);
  /// For formats that repeat the first vertex at the end: drops the repetition. Refuses
  /// "ring-not-closed" and "too-few-vertices" (fewer than three are left).
  void close(TextRing& ring) const;

  void point(TextRing vertex);
  /// Refuses other vertex counts than two ("not-a-segment"); the other arguments are the format's
  /// words for its lines, their vertices, and its polygons.
  void segment(TextRing ends, std::string_view line, std::string_view points,
               std::string_view polygon);
  /// Adds a polygon; a lone outer ring of one or two vertices means a point or a segment.
  void polygon(TextRing outer, std::vector<TextRing> holes);

  /// The operand as read, nothing turned. Refuses rings of fewer than three vertices, save for a
  /// lone point or segment.
  Reading finish_as_read();
  /// The same with every ring turned as its role demands.
  Reading finish();

  Input& input() const { return input_; }

 private:
  Input& input_;
  std::size_t rings_ = 0;
  std::vector<std::vector<TextRing>> polygons_;  ///< outer first
};

}  // namespace minkref
