#include "certify/plane/validity.hpp"

#include "certify/plane/separation.hpp"

namespace minkref::certify {

Validity::Validity(const CellComplex& complex, Rational from, Rational to)
    : complex_(complex),
      from_(std::move(from)),
      to_(std::move(to)),
      moving_(complex.corners().size()) {}

const MovingPoint& Validity::moving(std::uint32_t corner) {
  auto& known = moving_[corner];
  if (!known) known = complex_.moving(corner);
  return *known;
}

void Validity::keep(const Rational& constant, const Rational& slope) {
  const int rises = sign(slope);
  if (rises == 0) return;  // holds at the complex's scale
  const Rational root = -constant / slope;
  if (rises > 0 && root > from_) from_ = root;
  if (rises < 0 && root < to_) to_ = root;
}

void Validity::keep_cell(const std::vector<std::uint32_t>& corners) {
  const Rational& s = complex_.scale();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const MovingPoint &a = moving(corners[i]), &b = moving(corners[(i + 1) % corners.size()]);
    const Point d{b.constant.x - a.constant.x, b.constant.y - a.constant.y};
    const Point e{b.slope.x - a.slope.x, b.slope.y - a.slope.y};
    const Point here{d.x + s * e.x, d.y + s * e.y};
    if (here.x * e.y != here.y * e.x) anywhere_else_ = false;
    keep(d.x * here.x + d.y * here.y, e.x * here.x + e.y * here.y);
  }
}

void Validity::keep_cover(const std::vector<std::uint32_t>& corners, std::uint32_t A,
                          std::uint32_t B) {
  const PieceTree &P = complex_.P(), &Q = complex_.Q();
  for (const auto* normals : {&P.outward(A), &Q.outward(B)}) {
    for (const std::uint32_t normal : *normals) {
      const Normal& n = complex_.normals()[normal];
      const Rational &p = P.most(A, normal).exact, &q = Q.most(B, normal).exact;
      for (const std::uint32_t corner : corners) {
        const MovingPoint& c = moving(corner);
        keep(q - dot(n, c.constant), p - dot(n, c.slope));
      }
    }
  }
}

void Validity::keep_code(const std::vector<std::uint32_t>& corners,
                         const std::vector<std::int64_t>& code) {
  const PieceTree &P = complex_.P(), &Q = complex_.Q();
  if (code.empty()) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{{P.root(), Q.root()}};
  for (const std::int64_t entry : code) {
    const auto [A, B] = pairs.back();
    pairs.pop_back();
    if (entry == split_P) {
      const auto& children = P.nodes()[A].children;
      pairs.emplace_back(children[1], B);
      pairs.emplace_back(children[0], B);
    } else if (entry == split_Q) {
      const auto& children = Q.nodes()[B].children;
      pairs.emplace_back(A, children[1]);
      pairs.emplace_back(A, children[0]);
    } else {
      const auto normal = static_cast<std::uint32_t>(entry);
      const Normal& n = complex_.normals()[normal];
      const Rational &p = P.most(A, normal).exact, &q = Q.most(B, normal).exact;
      for (const std::uint32_t corner : corners) {
        const MovingPoint& c = moving(corner);
        keep(dot(n, c.constant) - q, dot(n, c.slope) - p);
      }
    }
  }
}

std::pair<Rational, Rational> Validity::interval() const {
  if (!anywhere_else_) return {complex_.scale(), complex_.scale()};
  return {from_, to_};
}

}  // namespace minkref::certify
