#include "reference/scene/scene.hpp"

#include <algorithm>
#include <tuple>

namespace minkref::inline scene {
namespace {

auto key(const Owner& owner) {
  const ConvolutionEdge& e = owner.edge;
  return std::tuple(owner.copy, e.kind, e.edge.ring, e.edge.index, e.vertex.ring, e.vertex.index);
}

}  // namespace

bool less(const Owner& a, const Owner& b) { return key(a) < key(b); }

void sort_unique(std::vector<Owner>& owners) {
  std::sort(owners.begin(), owners.end(), less);
  owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
}

}  // namespace minkref::inline scene
