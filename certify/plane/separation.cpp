#include "certify/plane/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

#include "reference/interrupt.hpp"

namespace minkref::certify {
namespace {

constexpr std::size_t most_recent = 8;

class Separation {
 public:
  Separation(const CellComplex& complex, const std::vector<std::uint32_t>& corners)
      : complex_(complex), corners_(corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point& a = at(corners[i]).point;
      const Point& b = at(corners[(i + 1) % corners.size()]).point;
      if (a != b) own_.push_back(complex.normals().add(a.y - b.y, b.x - a.x));
    }
  }

  std::vector<std::int64_t> run() {
    const PieceTree &P = complex_.P(), &Q = complex_.Q();
    if (P.nodes().empty() || Q.nodes().empty()) return {};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{{P.root(), Q.root()}};
    std::vector<std::int64_t> code;
    const double s = to_double(complex_.scale());
    while (!pairs.empty()) {
      look_for_interrupt();
      const auto [A, B] = pairs.back();
      pairs.pop_back();
      if (const auto normal = separating(A, B)) {
        code.push_back(*normal);
        const auto known = std::find(recent_.begin(), recent_.end(), *normal);
        if (known != recent_.end()) recent_.erase(known);
        recent_.insert(recent_.begin(), *normal);
        if (recent_.size() > most_recent) recent_.pop_back();
        continue;
      }
      const PieceTree::Node &a = P.nodes()[A], &b = Q.nodes()[B];
      if (a.is_piece && b.is_piece) throw std::logic_error("a cell outside meets the sum");
      if (!a.is_piece && (b.is_piece || s * a.extent >= b.extent)) {
        code.push_back(split_P);
        pairs.emplace_back(a.children[1], B);
        pairs.emplace_back(a.children[0], B);
      } else {
        code.push_back(split_Q);
        pairs.emplace_back(A, b.children[1]);
        pairs.emplace_back(A, b.children[0]);
      }
    }
    return code;
  }

 private:
  const Place& at(std::uint32_t corner) const { return complex_.corners()[corner].place; }

  std::optional<std::uint32_t> separating(std::uint32_t A, std::uint32_t B) {
    const PieceTree &P = complex_.P(), &Q = complex_.Q();
    for (const std::vector<std::uint32_t>* normals :
         {&std::as_const(recent_), &std::as_const(own_), &P.outward(A), &Q.outward(B)}) {
      for (const std::uint32_t normal : *normals) {
        if (separates(normal, A, B)) return normal;
      }
    }
    // Two parallel segments, or a segment and a point: beside them, or beyond an end.
    for (const std::uint32_t normal : P.outward(A)) {
      const Normal n = complex_.normals()[normal];
      for (const int way : {1, -1}) {
        const std::uint32_t along =
            complex_.normals().add(Rational(-way * n.y), Rational(way * n.x));
        if (P.nodes()[A].hull.size() == 2 && separates(along, A, B)) return along;
      }
    }
    return std::nullopt;
  }

  bool separates(std::uint32_t normal, std::uint32_t A, std::uint32_t B) {
    const Least& least = least_of(normal);
    const auto most = complex_.estimate(A, B, normal);
    const double value = least.value - most.value, bound = least.error + most.error;
    if (value > bound) return true;
    if (value < -bound) return false;
    return std::all_of(corners_.begin(), corners_.end(), [&](std::uint32_t corner) {
      return complex_.side_of_pair(A, B, normal, corner) >= 0;
    });
  }

  struct Least {
    double value, error;
  };
  const Least& least_of(std::uint32_t normal) {
    const auto [place, fresh] = least_.try_emplace(normal, Least{0, 0});
    if (!fresh) return place->second;
    const Normal& n = complex_.normals()[normal];
    double least = std::numeric_limits<double>::infinity(), error = 0;
    for (const std::uint32_t corner : corners_) {
      const double left = n.dx * at(corner).x, right = n.dy * at(corner).y;
      const double bound = (std::abs(left) + std::abs(right)) * 0x1p-49 + 1e-290;
      if (!std::isfinite(bound)) return place->second = {0, bound};  // decides nothing
      least = std::min(least, left + right);
      error = std::max(error, bound);
    }
    return place->second = {least, error};
  }

  const CellComplex& complex_;
  const std::vector<std::uint32_t>& corners_;
  std::vector<std::uint32_t> own_, recent_;
  std::unordered_map<std::uint32_t, Least> least_;
};

}  // namespace

std::vector<std::int64_t> separating_code(const CellComplex& complex,
                                          const std::vector<std::uint32_t>& corners) {
  return Separation(complex, corners).run();
}

}  // namespace minkref::certify
