// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/shells.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace minkref::cgal_oracle {
namespace {

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

mpq_class determinant(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
         a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace

mpq_class six_volumes(const Solid& shell) {
  mpq_class sum;
  for (const Face& face : shell.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      sum += determinant(shell.vertices[face[0]], shell.vertices[face[i - 1]],
                         shell.vertices[face[i]]);
    }
  }
  return sum;
}

std::vector<Solid> shells_by_size(const Solid& solid) {
  std::vector<std::size_t> parent(solid.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const Face& face : solid.faces) {
    for (const std::size_t i : face) parent[root(parent, i)] = root(parent, face[0]);
  }
  std::map<std::size_t, Solid> shells;
  std::vector<std::size_t> number(solid.vertices.size());
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    auto& vertices = shells[root(parent, i)].vertices;
    number[i] = vertices.size();
    vertices.push_back(solid.vertices[i]);
  }
  for (const Face& face : solid.faces) {
    if (face.empty()) continue;
    Face& renamed = shells[root(parent, face[0])].faces.emplace_back();
    for (const std::size_t i : face) renamed.push_back(number[i]);
  }
  std::vector<std::pair<mpq_class, Solid>> sized;
  for (auto& [_, shell] : shells) {
    if (!shell.faces.empty()) sized.emplace_back(abs(six_volumes(shell)), std::move(shell));
  }
  std::stable_sort(sized.begin(), sized.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Solid> result;
  for (auto& [_, shell] : sized) result.push_back(std::move(shell));
  return result;
}

}  // namespace minkref::cgal_oracle
