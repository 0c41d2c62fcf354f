// Collects the vertices and faces that a reader finds into one polyhedron.
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

/// What a position in the file is: the line of a text, the first byte of a binary part. A refusal
/// names a line in its place, a byte in its problem.
enum class Positions { lines, bytes };

/// Vertices and faces may come in any order. Nothing is turned and nothing is made one.
class MeshBuilder {
 public:
  /// `first_number`: what the file calls its first vertex, 0 or 1; for messages.
  MeshBuilder(Input& input, Positions positions, std::size_t first_number = 0)
      : input_(input), positions_(positions), first_number_(first_number) {}

  Input& input() const { return input_; }
  std::size_t vertices() const { return mesh_.vertices.size(); }
  std::size_t faces() const { return mesh_.faces.size(); }

  /// The exact numbers of the text, or of the bits; charged to the limits.
  void vertex(const std::array<std::string_view, 3>& coordinates, std::size_t position);
  void vertex(const std::array<double, 3>& coordinates, std::size_t position);

  void begin_face(std::size_t position);
  /// A vertex of the open face, from 0. Refused at the end where there is no such vertex.
  void corner(std::uint64_t vertex);
  /// Refuses a vertex of the open face ("index-out-of-range"): `number` as the file has it, `why`
  /// as in "there are 8 vertices".
  [[noreturn]] void refuse_corner(const std::string& number, const std::string& why) const;
  /// Refuses a face of fewer than three vertices ("too-few-vertices").
  void end_face();

  /// Throws BadInput at the next vertex, at the face last begun, or at neither.
  [[noreturn]] void refuse_vertex(const std::string& code, const std::string& problem,
                                  const std::string& mend, std::size_t position) const;
  [[noreturn]] void refuse_face(const std::string& code, const std::string& problem,
                                const std::string& mend) const;

  /// The polyhedron as read. Refuses a face that names no vertex ("index-out-of-range").
  MeshReading finish();
  /// The same with one vertex for all that have the same coordinates.
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
