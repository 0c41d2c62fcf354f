// The result of a reader of polyhedra.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref {

struct MeshReading {
  Polyhedron polyhedron;
  std::vector<std::string> warnings;
  std::vector<std::uint32_t> vertex_lines;  ///< 1-based line of each vertex; none for binary files
  std::vector<std::uint32_t> face_lines;    ///< the same of each face
};

/// Runs a check of the polyhedron; its refusals (BadInput) also name `source`, and the line of the
/// face, or else of the first vertex.
void refuse_as_read(const MeshReading& reading, const std::string& source,
                    const std::function<void()>& check);

/// `validate(reading.polyhedron)`; a refusal names `source`, and the line of the face, or else that
/// of the first vertex.
void validate_as_read(const MeshReading& reading, const std::string& source);
/// The same with `validate_summand`, which takes a plane polygon.
void validate_summand_as_read(const MeshReading& reading, const std::string& source);

}  // namespace minkref
