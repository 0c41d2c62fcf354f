#include "reference/plane/routes/face_points.hpp"

#include "reference/error.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/paper_route.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {
namespace {

template <class Grid>
Point inner_point_of_face(const GridFrame<Grid>& frame,
                          const Arrangement<GridKernel<Grid>>& arrangement, std::uint32_t face) {
  const Rational unit_of_grid(Integer(1), frame.denominator);
  if (const auto x = interior_point_in_doubles(frame.kernel, arrangement, face)) {
    return {from_double(x->x) * unit_of_grid, from_double(x->y) * unit_of_grid};
  }
  const Point x = exact_interior_point(frame.kernel, arrangement, face);
  return {x.x * unit_of_grid, x.y * unit_of_grid};
}
Point inner_point_of_face(const ScalarFrame<Rational>& frame,
                          const Arrangement<PlainKernel<Rational>>& arrangement,
                          std::uint32_t face) {
  const auto x = interior_point(frame.kernel, arrangement, face);
  return {x.x(), x.y()};
}

}  // namespace

std::vector<FacePoint> face_points(const PolygonSet& P, const PolygonSet& Q,
                                   const Rational& scale) {
  refuse_bad_operands(P, Q, scale);
  if (P.empty() || Q.empty()) return {};
  return on_exact_frame(scaled(P, scale), Q, [&](const auto& frame) {
    Statistics statistics;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    const auto inside =
        faces_of_sum(built.arrangement, P, Q, face_collision(frame), statistics.orientable_faces);
    std::vector<FacePoint> points;
    for (std::uint32_t face = 1; face < built.arrangement.face_count(); ++face) {
      points.push_back({inner_point_of_face(frame, built.arrangement, face), inside[face]});
    }
    return points;
  });
}

}  // namespace minkref::inline plane
