#include "reference/space/canonical_polyhedron.hpp"

#include "reference/interrupt.hpp"

namespace minkref::inline space {

std::string canonical_json(const Polyhedron& canonical) {
  std::string text = R"({"faces":[)";
  for (const Face& face : canonical.faces) {
    look_for_interrupt();
    text += text.back() == ']' ? ",[" : "[";
    for (const std::uint32_t v : face) {
      if (text.back() != '[') text += ',';
      text += std::to_string(v);
    }
    text += ']';
  }
  text += R"(],"vertices":[)";
  for (const SpacePoint& p : canonical.vertices) {
    look_for_interrupt();
    text += text.back() == ']' ? R"(,[")" : R"([")";
    text += to_string(p.x) + R"(",")" + to_string(p.y) + R"(",")" + to_string(p.z) + R"("])";
  }
  return text + "]}";
}

}  // namespace minkref::inline space
