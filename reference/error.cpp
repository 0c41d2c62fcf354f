#include "reference/error.hpp"

namespace minkref {
namespace {

std::string list(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (i > 0) text += ", ";
    text += std::to_string(indices[i]);
  }
  return text;
}

std::string message(const std::string& code, const std::string& problem, const std::string& mend,
                    const Place& place) {
  std::string text;
  if (!place.source.empty()) text += place.source + ": ";
  if (place.line) text += "line " + std::to_string(*place.line) + ": ";
  if (place.ring) text += "ring " + std::to_string(*place.ring) + ": ";
  if (place.face) text += "face " + std::to_string(*place.face) + ": ";
  if (!place.vertices.empty()) {
    text += (place.vertices.size() > 1 ? "vertices " : "vertex ") + list(place.vertices) + ": ";
  }
  if (place.other_face) text += "with face " + std::to_string(*place.other_face) + ": ";
  if (place.other_ring) {
    text += "with ring " + std::to_string(*place.other_ring);
    if (!place.other_vertices.empty()) {
      text += place.other_vertices.size() > 1 ? " vertices " : " vertex ";
      text += list(place.other_vertices);
    }
    text += ": ";
  }
  for (const auto& coordinate : place.coordinates) text += coordinate + " ";
  text += problem + " [" + code + "]";
  if (!mend.empty()) text += ". To fix it: " + mend;
  return text;
}

}  // namespace

BadInput::BadInput(std::string code, std::string problem, std::string mend, Place place)
    : Error(message(code, problem, mend, place)),
      code_(std::move(code)),
      problem_(std::move(problem)),
      mend_(std::move(mend)),
      place_(std::move(place)) {}

BadInput BadInput::from(const std::string& source) const {
  Place place = place_;
  if (place.source.empty()) place.source = source;
  return {code_, problem_, mend_, std::move(place)};
}

}  // namespace minkref
