#include "certify/plane/cell_complex.hpp"

#include <stdexcept>

#include "reference/interrupt.hpp"

namespace minkref::certify {

CellComplex::CellComplex(const PieceTree& P, const PieceTree& Q, NormalTable& normals,
                         Rational scale, const std::array<Rational, 4>& box)
    : P_(P),
      Q_(Q),
      normals_(normals),
      scale_(std::move(scale)),
      approximate_scale_(to_double(scale_)),
      box_(box) {
  for (std::uint32_t wall = 0; wall < 4; ++wall) {
    const bool vertical = wall % 2 == 0;
    add_line({LineSource::Kind::wall, wall}, vertical, !vertical, box_[wall], 0);
  }
}

std::uint32_t CellComplex::add_line(const LineSource& source, const Rational& nx,
                                    const Rational& ny, const Rational& constant,
                                    const Rational& slope) {
  const int turned = nx < 0 || (nx == 0 && ny < 0) ? -1 : 1;
  const std::uint32_t normal = normals_.add(turned * nx, turned * ny);
  // Constant and slope belong to (nx, ny); the normal may be a multiple of it.
  const Normal& n = normals_[normal];
  const Rational factor = nx != 0 ? Rational(Rational(n.x) / nx) : Rational(Rational(n.y) / ny);
  MovingLine line{source, normal, constant * factor, slope * factor, {}};
  line.here = Value(line.constant + line.slope * scale_);
  const auto [place, fresh] =
      line_at_.try_emplace({normal, line.here.exact}, static_cast<std::uint32_t>(lines_.size()));
  if (fresh) lines_.push_back(std::move(line));
  return place->second;
}

std::uint32_t CellComplex::line(const LineSource& source) {
  const bool of_P = source.kind == LineSource::Kind::P;
  const auto& ours = (of_P ? P_ : Q_).vertices();
  const Point &a = ours[source.a].point, &b = ours[source.b].point;
  const Point& c = (of_P ? Q_ : P_).vertices()[source.c].point;
  const Rational nx = a.y - b.y, ny = b.x - a.x;
  const Rational own = nx * a.x + ny * a.y, other = nx * c.x + ny * c.y;
  return of_P ? add_line(source, nx, ny, other, own) : add_line(source, nx, ny, own, other);
}

std::uint32_t CellComplex::vertical_through(std::uint32_t corner) {
  const MovingPoint moving = this->moving(corner);
  return add_line({LineSource::Kind::up, corner}, 1, 0, moving.constant.x, moving.slope.x);
}

bool CellComplex::parallel(std::uint32_t first, std::uint32_t second) const {
  return lines_[first].normal == lines_[second].normal;
}

namespace {

Point solved(const Normal& n, const Normal& m, const Rational& c, const Rational& d) {
  const Rational w = Rational(n.x * m.y - n.y * m.x);
  return {(c * Rational(m.y) - Rational(n.y) * d) / w, (Rational(n.x) * d - c * Rational(m.x)) / w};
}

}  // namespace

std::uint32_t CellComplex::meet(std::uint32_t first, std::uint32_t second) {
  look_for_interrupt();
  const MovingLine &a = lines_[first], &b = lines_[second];
  const Point point = solved(normals_[a.normal], normals_[b.normal], a.here.exact, b.here.exact);
  const auto [place, fresh] =
      corner_at_.try_emplace(point, static_cast<std::uint32_t>(corners_.size()));
  if (fresh) corners_.push_back({Place(point), first, second});
  return place->second;
}

std::optional<std::uint32_t> CellComplex::corner_at(const Point& point) const {
  const auto found = corner_at_.find(point);
  return found == corner_at_.end() ? std::nullopt : std::optional(found->second);
}

MovingPoint CellComplex::moving(std::uint32_t corner) const {
  const MovingLine &a = lines_[corners_[corner].first], &b = lines_[corners_[corner].second];
  const Normal &n = normals_[a.normal], &m = normals_[b.normal];
  return {solved(n, m, a.constant, b.constant), solved(n, m, a.slope, b.slope)};
}

int CellComplex::side_of(std::uint32_t line, std::uint32_t corner) const {
  const MovingLine& l = lines_[line];
  return side(normals_[l.normal], corners_[corner].place, l.here);
}

Rational CellComplex::most(std::uint32_t A, std::uint32_t B, std::uint32_t normal) const {
  return scale_ * P_.most(A, normal).exact + Q_.most(B, normal).exact;
}

CellComplex::Estimate CellComplex::estimate(std::uint32_t A, std::uint32_t B,
                                            std::uint32_t normal) const {
  const double p = approximate_scale_ * P_.most(A, normal).approximate;
  const double q = Q_.most(B, normal).approximate;
  return {p + q, (std::abs(p) + std::abs(q)) * 0x1p-49 + 1e-290};
}

int CellComplex::side_of_pair(std::uint32_t A, std::uint32_t B, std::uint32_t normal,
                              std::uint32_t corner) const {
  const Normal& n = normals_[normal];
  const Place& place = corners_[corner].place;
  const Estimate most = estimate(A, B, normal);
  const double left = n.dx * place.x, right = n.dy * place.y;
  const double value = left + right - most.value;
  const double bound = (std::abs(left) + std::abs(right)) * 0x1p-49 + most.error;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sign(Rational(dot(n, place.point) - this->most(A, B, normal)));
}

CellComplex::Parts CellComplex::cut(const Cell& cell, std::uint32_t line) {
  look_for_interrupt();
  const std::size_t n = cell.corners.size();
  std::vector<int> sides(n);
  bool any_below = false, any_above = false;
  for (std::size_t i = 0; i < n; ++i) {
    sides[i] = side_of(line, cell.corners[i]);
    any_below = any_below || sides[i] < 0;
    any_above = any_above || sides[i] > 0;
  }
  if (!any_above) return {cell, {}};
  if (!any_below) return {{}, cell};
  Cell below, above;
  const auto add = [](Cell& part, std::uint32_t corner, std::uint32_t along) {
    part.corners.push_back(corner);
    part.lines.push_back(along);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const int here = sides[i], there = sides[(i + 1) % n];
    const std::uint32_t corner = cell.corners[i], along = cell.lines[i];
    if (here < 0) add(below, corner, along);
    if (here > 0) add(above, corner, along);
    if (here == 0) {
      add(below, corner, there < 0 ? along : line);
      add(above, corner, there > 0 ? along : line);
    }
    if (here * there < 0) {
      const std::uint32_t between = meet(along, line);
      add(below, between, here < 0 ? line : along);
      add(above, between, here > 0 ? line : along);
    }
  }
  return {below, above};
}

}  // namespace minkref::certify
