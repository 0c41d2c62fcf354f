#include "reference/space/surface/faces_about_edges.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

/// A half-plane about an edge with the direction d. If the half-edge runs along d (`forward`) and
/// its face has the normal n, the half-plane is on the side of n x d: seen against d, the outside
/// comes counter-clockwise after the half-plane, and the interior before. A half-edge against d
/// exchanges both. A quarter of a turn further each half-plane is n or -n.
struct HalfPlane {
  std::uint32_t half_edge;
  bool forward;
  std::array<Integer, 2> turned;  ///< n or -n, seen along an axis that d does not cross
};

int cross_sign(const HalfPlane& a, const HalfPlane& b) {
  return Integer(a.turned[0] * b.turned[1] - a.turned[1] * b.turned[0]).sign();
}

bool is_before(const HalfPlane& a, const HalfPlane& b) {
  const auto lower = [](const HalfPlane& ray) {
    const int y = ray.turned[1].sign();
    return y < 0 || (y == 0 && ray.turned[0].sign() < 0);
  };
  const bool a_lower = lower(a), b_lower = lower(b);
  return a_lower != b_lower ? b_lower : cross_sign(a, b) > 0;
}

class EdgePairing {
 public:
  explicit EdgePairing(SurfaceEdges& surface) : surface_(surface) {}

  void run() {
    const std::vector<HalfEdge>& half_edges = surface_.half_edges;
    const auto ends = [&](std::uint32_t h) {
      return std::minmax(half_edges[h].from, half_edges[h].to);
    };
    std::vector<std::uint32_t> order(half_edges.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t g, std::uint32_t h) {
      return std::pair(PointPair(ends(g)), g) < std::pair(PointPair(ends(h)), h);
    });
    for (std::size_t k = 0, end = 0; k < order.size(); k = end) {
      look_for_interrupt();
      about_.clear();
      for (end = k; end < order.size() && ends(order[end]) == ends(order[k]); ++end) {
        const HalfEdge& half_edge = half_edges[order[end]];
        about_.push_back({order[end], half_edge.from < half_edge.to, {}});
      }
      if (about_.size() > 2) sort_about();
      pair();
    }
  }

 private:
  void sort_about() {
    const HalfEdge& any = surface_.half_edges[about_[0].half_edge];
    const auto [from, to] = std::minmax(any.from, any.to);
    const RationalVector d = surface_.points[to].exact - surface_.points[from].exact;
    std::size_t axis = 0;
    while (d[axis].is_zero()) ++axis;
    const int towards = sign(d[axis]);
    for (HalfPlane& ray : about_) {
      const std::uint32_t face = surface_.half_edges[ray.half_edge].face;
      const IntegerVector& n = surface_.planes[surface_.faces[face].plane].normal;
      const int side = ray.forward ? 1 : -1;
      ray.turned = {n[(axis + 1) % 3] * side, n[(axis + 2) % 3] * (side * towards)};
    }
    std::sort(about_.begin(), about_.end(), is_before);
    for (std::size_t k = 1; k < about_.size(); ++k) {
      if (!is_before(about_[k - 1], about_[k])) {
        throw std::logic_error("two faces lie on each other along an edge");
      }
    }
  }

  /// Counter-clockwise, the outside follows forward half-planes.
  void pair() {
    for (std::size_t k = 0; k < about_.size(); ++k) {
      const HalfPlane &a = about_[k], &b = about_[(k + 1) % about_.size()];
      if (a.forward == b.forward) {
        throw std::logic_error("the faces about an edge do not bound interior and outside in turn");
      }
      const auto sector =
          static_cast<std::size_t>(a.forward ? Pairing::outside : Pairing::interior);
      surface_.half_edges[a.half_edge].mates[sector] = b.half_edge;
      surface_.half_edges[b.half_edge].mates[sector] = a.half_edge;
    }
  }

  SurfaceEdges& surface_;
  std::vector<HalfPlane> about_;
};

}  // namespace

void pair_faces_about_edges(SurfaceEdges& surface) { EdgePairing(surface).run(); }

}  // namespace minkref::inline space
