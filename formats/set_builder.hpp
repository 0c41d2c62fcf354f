// Collects a reader's rings into one operand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
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
  bool is_open = false;              ///< not closed, where the format repeats the first vertex

  Place place() const;                       ///< of the ring
  Place place_of(std::size_t vertex) const;  ///< of a vertex, with its coordinates
};

/// Whether faults that `minkref repair` mends are refused or kept: open rings, rings of fewer than
/// three vertices, points and segments beside other parts, holes of `.poly` in no outer ring.
enum class Faults : std::uint8_t { refused, kept };

/// Rings are numbered as they come. Points and segments stand without polygons: beside one they are
/// refused ("mixed-operand").
class SetBuilder {
 public:
  explicit SetBuilder(Input& input, Faults faults = Faults::refused)
      : input_(input), faults_(faults) {}

  TextRing ring(std::size_t line);
  /// Parses and appends a vertex; refusals name ring, vertex and line.
  void vertex(TextRing& ring, std::string_view x, std::string_view y, std::size_t line);
  /// Notes what the set does not keep: one warning for each `what`, at the first line.
  void drop(const std::string& what, std::size_t line);
  /// The same for a vertex's coordinate beyond x and y; NaN counts as none. Refuses other words
  /// ("not-a-number").
  void drop_coordinate(std::string_view token, const Place& place);
  /// For formats that repeat the first vertex at the end: drops the repetition. Refuses
  /// "ring-not-closed" and "too-few-vertices" (fewer than three are left).
  void close(TextRing& ring) const;

  void point(TextRing vertex);
  /// Adds each edge as a segment, closed lines included. Refuses a single vertex ("not-a-segment")
  /// and equal neighbours ("zero-length-edge"); the other arguments are the format's words for its
  /// lines and their vertices.
  void line(const TextRing& vertices, std::string_view line, std::string_view points);
  /// Adds a polygon; an outer ring of one or two vertices alone means a point or a segment.
  void polygon(TextRing outer, std::vector<TextRing> holes);

  /// The operand as read, nothing turned. Refuses rings of fewer than three vertices, save for
  /// points and segments without polygons.
  Reading finish_as_read();
  /// The same with every ring turned as its role demands.
  Reading finish();

  /// Whether each ring of the finished set is open.
  std::vector<bool> take_open() { return std::move(open_); }

  Input& input() const { return input_; }
  bool keeps_faults() const { return faults_ == Faults::kept; }

 private:
  void tell_dropped();

  Input& input_;
  Faults faults_;
  std::vector<bool> open_;
  std::vector<std::pair<std::string, std::size_t>> dropped_;  ///< with its first line
  std::size_t coordinates_dropped_ = 0, coordinates_line_ = 0;
  std::size_t rings_ = 0;
  std::vector<std::vector<TextRing>> polygons_;  ///< outer first
};

}  // namespace minkref
