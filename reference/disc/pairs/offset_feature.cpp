#include "reference/disc/pairs/offset_feature.hpp"

#include <map>

#include "reference/error.hpp"

namespace minkref::inline disc {

OffsetFeature OffsetFeature::edge(const Point& p, const Point& q) {
  const Direction along = from_to(p, q);
  if (along.x == 0 && along.y == 0) {
    throw BadInput("bad-feature", "the ends of an edge are one point", "give two points");
  }
  const Direction normal{along.y, -along.x};
  return {false, {p, q}, {normal, normal}, {}};
}

OffsetFeature OffsetFeature::arc(const Point& centre, const Direction& in, const Direction& out) {
  const Rational turn = cross(in, out);
  if (turn < 0 || (turn == 0 && dot(in, out) >= 0)) {
    throw BadInput("bad-feature", "there is no arc about a vertex that is not convex",
                   "give a vertex at which P, on the left, turns left");
  }
  return {true, {centre, centre}, {Direction{in.y, -in.x}, Direction{out.y, -out.x}}, {}};
}

std::vector<OffsetFeature> offset_features(const OffsetCurves& curves) {
  std::vector<OffsetFeature> features;
  for (const OffsetEdge& edge : curves.edges) {
    features.push_back(
        {false, {edge.start, edge.end}, {edge.normal, edge.normal}, edge.id, edge.feature});
  }
  std::map<std::uint32_t, std::size_t> arcs;  // about one place there is one at most
  for (const OffsetPatch& patch : curves.patches) {
    if (patch.edge != OffsetPatch::none || curves.edges.empty()) continue;
    const auto [found, is_new] = arcs.try_emplace(patch.feature, features.size());
    if (is_new) {
      features.push_back(
          {true, {patch.centre, patch.centre}, {patch.first, patch.last}, {}, patch.feature});
    } else {
      features[found->second].way[1] = patch.last;  // parts follow each other
    }
  }
  return features;
}

}  // namespace minkref::inline disc
