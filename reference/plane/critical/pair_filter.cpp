#include "reference/plane/critical/pair_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/plane/kernel/double_block.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t width = block_width;
using Mask = BlockMask;

struct EdgeRow {
  double px, py, qx, qy, dx, dy;
};

/// The scales that remain: (lower, upper).
struct Range {
  Block lower, upper;
};

MINKREF_INLINE void restrict_to(Range& range, Block slope, Block value, double error) {
  const Block zero = {}, infinity = zero + std::numeric_limits<double>::infinity();
  const Mask rises = slope > error, falls = slope < -error;
  const Block num = rises ? -value - error : value + error;
  const Block den = rises ? slope + error : -slope - error;
  const Block root = num / den;
  const Block lower = rises ? root : zero, upper = falls ? root : infinity;
  range.lower = lower > range.lower ? lower : range.lower;
  range.upper = upper < range.upper ? upper : range.upper;
}

template <bool AIsS, bool BIsS>
MINKREF_INLINE std::size_t survivors(const EdgeRow& a, const EdgeColumns& b, std::uint32_t first,
                                     std::uint32_t last, double error, std::uint32_t* out) {
  std::size_t count = 0;
  // The quotients' relative rounding stays below 2^-50.
  const double slack = 1 + 0x1p-48;
  for (std::size_t j = first; j < last; j += width) {
    const Block dx = load_block(&b.dx[j]), dy = load_block(&b.dy[j]);
    const Block px = load_block(&b.px[j]) - a.px, py = load_block(&b.py[j]) - a.py;
    const Block qx = load_block(&b.qx[j]) - a.qx, qy = load_block(&b.qy[j]) - a.qy;
    const Block turn = a.dx * dy - a.dy * dx;
    const Mask right = turn < 0;
    const auto turned = [&](Block value)
                            __attribute__((always_inline)) { return right ? -value : value; };
    const Block c = turned(turn);
    const Block a_slope = turned(px * dy - py * dx), a_value = turned(qx * dy - qy * dx);
    const Block b_slope = turned(px * a.dy - py * a.dx), b_value = turned(qx * a.dy - qy * a.dx);
    Range range{Block{}, Block{} + std::numeric_limits<double>::infinity()};
    restrict_to(range, a_slope, a_value, error);
    if constexpr (AIsS) {
      restrict_to(range, c - a_slope, -a_value, error);
    } else {
      restrict_to(range, -a_slope, c - a_value, error);
    }
    restrict_to(range, b_slope, b_value, error);
    if constexpr (BIsS) {
      restrict_to(range, c - b_slope, -b_value, error);
    } else {
      restrict_to(range, -b_slope, c - b_value, error);
    }
    const Mask never = (range.lower > range.upper * slack) & (c > error);
    for (std::size_t k = 0; k < width; ++k) {
      out[count] = static_cast<std::uint32_t>(j + k);
      count += static_cast<std::size_t>(never[k] == 0 && j + k < last);
    }
  }
  return count;
}

MINKREF_CLONES std::size_t survivors_ss(const EdgeRow& a, const EdgeColumns& b, std::uint32_t first,
                                        std::uint32_t last, double error, std::uint32_t* out) {
  return survivors<true, true>(a, b, first, last, error, out);
}
MINKREF_CLONES std::size_t survivors_st(const EdgeRow& a, const EdgeColumns& b, std::uint32_t first,
                                        std::uint32_t last, double error, std::uint32_t* out) {
  return survivors<true, false>(a, b, first, last, error, out);
}
MINKREF_CLONES std::size_t survivors_tt(const EdgeRow& a, const EdgeColumns& b, std::uint32_t first,
                                        std::uint32_t last, double error, std::uint32_t* out) {
  return survivors<false, false>(a, b, first, last, error, out);
}

double largest(const std::vector<double>& column, double at_least) {
  for (const double value : column) at_least = std::max(at_least, std::abs(value));
  return at_least;
}

}  // namespace

void EdgeColumns::add(double px_, double py_, double qx_, double qy_, double dx_, double dy_) {
  px.push_back(px_);
  py.push_back(py_);
  qx.push_back(qx_);
  qy.push_back(qy_);
  dx.push_back(dx_);
  dy.push_back(dy_);
  ++size;
}

void EdgeColumns::close() {
  for (auto* column : {&px, &py, &qx, &qy, &dx, &dy}) column->resize(size + width, 0.0);
}

PairFilter::PairFilter(EdgeColumns s_edges, EdgeColumns t_edges)
    : s_(std::move(s_edges)), t_(std::move(t_edges)) {
  double M = 0, D = 0;
  for (EdgeColumns* columns : {&s_, &t_}) {
    columns->close();
    for (const auto* c : {&columns->px, &columns->py, &columns->qx, &columns->qy}) {
      M = largest(*c, M);
    }
    for (const auto* c : {&columns->dx, &columns->dy}) D = largest(*c, D);
  }
  // With u = 2^-53: the error of a difference of coordinates is at most 4 M u, of a coefficient of
  // A or B 20 M D u, of c 8 D^2 u, and of their differences 24 M D u + 10 D^2 u. The other terms
  // cover subnormal coordinates, with errors up to 2^-1075, and underflow.
  error_ = 64 * 0x1p-53 * D * (M + D) + 32 * 0x1p-1074 * (M + D) + 1e-300;
}

std::size_t PairFilter::candidates(bool a_is_s, std::uint32_t a, bool b_is_s, std::uint32_t first,
                                   std::uint32_t last, std::uint32_t* out) const {
  const EdgeColumns& own = a_is_s ? s_ : t_;
  const EdgeRow row{own.px[a], own.py[a], own.qx[a], own.qy[a], own.dx[a], own.dy[a]};
  if (!a_is_s) return survivors_tt(row, t_, first, last, error_, out);
  return b_is_s ? survivors_ss(row, s_, first, last, error_, out)
                : survivors_st(row, t_, first, last, error_, out);
}

}  // namespace minkref::inline plane
