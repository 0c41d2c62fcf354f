// Collects a reader's vertices and faces into one polyhedron.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// The meaning of positions: the line of a text, or the first byte of a binary part. A refusal's
/// place names the line; a refusal's problem names the byte.
enum class Positions { lines, bytes };

/// Vertices and faces may come any way round. The builder turns no face and joins no vertices.
class MeshBuilder {
 public:
  /// `first_number`: the file's number for its first vertex, 0 or 1; for messages.
  MeshBuilder(Input& input, Positions positions, std::size_t first_number = 0)
      : input_(input), positions_(positions), first_number_(first_number) {}

  Input& input() const { return input_; }
  std::size_t vertices() const { return mesh_.vertices.size(); }
  std::size_t faces() const { return mesh_.faces.size(); }

  /// The exact numbers of the text, or of the bits; charged to the limits.
  void vertex(const std::array<std::string_view, 3>& coordinates, std::size_t position);
  void vertex(const std::array<double, 3>& coordinates, std::size_t position);

  void begin_face(std::size_t position);
  /// Adds a vertex, counted from 0, to the open face. A vertex that never appears is refused at the
  /// end.
  void corner(std::uint64_t vertex);
  /// Refuses a vertex of the open face ("index-out-of-range"): `number` as written by the file,
  /// `why` like "there are 8 vertices".
  [[noreturn]] void refuse_corner(const std::string& number, const std::string& why) const;
  /// Refuses a face of fewer than three vertices ("too-few-vertices").
  void end_face();

  /// Throws BadInput at the next vertex, at the face last begun, or at neither.
  [[noreturn]] void refuse_vertex(const std::string& code, const std::string& problem,
                                  const std::string& mend, std::size_t position) const;
  [[noreturn]] void refuse_face(const std::string& code, const std::string& problem,
                                const std::string& mend) const;

  /// The polyhedron as read. Refuses a face without vertices ("index-out-of-range").
  MeshReading finish();
  /// The polyhedron with one vertex for all equal coordinates.
  MeshReading finish_shared();

 private:
  template <class Number>
  void add_vertex(const std::array<Number, 3>& coordinates, std::size_t position);
  Place vertex_place(std::size_t position) const;
  Place face_place(std::size_t face) const;
  std::string at_byte(std::size_t position) const;
  [[noreturn]] void refuse_index(std::size_t face, const std::string& number,
                                 const std::string& why) const;
  std::string known_numbers() const;

  Input& input_;
  Positions positions_;
  std::size_t first_number_;
  Polyhedron mesh_;
  std::vector<std::uint32_t> vertex_positions_, face_positions_;
};

}  // namespace minkref
