#include "reference/plane/index/signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t samples_along = 384;  // of the longer side
constexpr std::size_t block_side = 16;      // samples along a side of a block
constexpr double infinite_distance = std::numeric_limits<double>::infinity();

}  // namespace

SignedDistance::SignedDistance(const PolygonSet& region) {
  const std::vector<Edge> edges = edges_of(region);
  lay_grid(edges);
  measure(edges);
  mark_outside(edges);
}

std::vector<SignedDistance::Edge> SignedDistance::edges_of(const PolygonSet& region) {
  std::vector<Edge> edges;
  const auto add = [&](const Ring& ring) {
    std::vector<std::pair<double, double>> points;
    for (const Point& p : ring) points.emplace_back(to_double(p.x), to_double(p.y));
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& [x0, y0] = points[k];
      const auto& [x1, y1] = points[(k + 1) % points.size()];
      edges.push_back({x0, y0, x1, y1});
    }
  };
  for (const Polygon& polygon : region.polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return edges;
}

void SignedDistance::lay_grid(const std::vector<Edge>& edges) {
  double right = -infinite_distance, top = -infinite_distance, largest = 0;
  left_ = bottom_ = infinite_distance;
  for (const Edge& e : edges) {
    left_ = std::min(left_, e.x0);
    right = std::max(right, e.x0);
    bottom_ = std::min(bottom_, e.y0);
    top = std::max(top, e.y0);
    largest = std::max({largest, std::fabs(e.x0), std::fabs(e.y0)});
  }
  const double width = right - left_, height = top - bottom_;
  spacing_ = std::max(width, height) / (samples_along - 1);
  const auto count = [&](double length) {
    return static_cast<std::size_t>(std::ceil(length / spacing_)) + 1;
  };
  // Coordinates have a relative error of 2^-53, distances and differences a few times more.
  error_ = 0x1p-40 * (largest + width + height);
  if (!(spacing_ > 0 && largest > 1e-120 && largest < 1e120)) {  // squares would not be doubles
    columns_ = rows_ = 1;
    samples_ = {-infinite_distance};
    spacing_ = 1;
    return;
  }
  over_spacing_ = 1 / spacing_;
  columns_ = count(width);
  rows_ = count(height);
  samples_.resize(columns_ * rows_);
}

/// Works block by block: only edges about as near as the nearest to the block's middle can be
/// nearest to a sample of the block.
void SignedDistance::measure(const std::vector<Edge>& edges) {
  if (columns_ * rows_ == 1) return;
  std::vector<double> dx, dy, over, distance(edges.size());
  for (const Edge& e : edges) {
    dx.push_back(e.x1 - e.x0);
    dy.push_back(e.y1 - e.y0);
    // An edge of length zero in doubles counts as a point: its true length is below the error.
    const double squared_length = dx.back() * dx.back() + dy.back() * dy.back();
    over.push_back(squared_length > 0 ? 1 / squared_length : 0);
  }
  const auto squared = [&](std::size_t k, double x, double y) {
    const double ux = x - edges[k].x0, uy = y - edges[k].y0;
    const double t = std::clamp((ux * dx[k] + uy * dy[k]) * over[k], 0.0, 1.0);
    const double vx = ux - t * dx[k], vy = uy - t * dy[k];
    return vx * vx + vy * vy;
  };
  const double reach = spacing_ * block_side * 1.5;  // more than the diagonal of a block_side
  std::vector<std::size_t> near;
  for (std::size_t first_row = 0; first_row < rows_; first_row += block_side) {
    for (std::size_t first = 0; first < columns_; first += block_side) {
      look_for_interrupt_now();
      const double x = left_ + (static_cast<double>(first) + block_side / 2.0) * spacing_,
                   y = bottom_ + (static_cast<double>(first_row) + block_side / 2.0) * spacing_;
      double least = infinite_distance;
      for (std::size_t k = 0; k < edges.size(); ++k) {
        distance[k] = squared(k, x, y);
        least = std::min(least, distance[k]);
      }
      const double most = std::sqrt(least) + reach;
      near.clear();
      for (std::size_t k = 0; k < edges.size(); ++k) {
        if (distance[k] <= most * most) near.push_back(k);
      }
      for (std::size_t r = first_row; r < std::min(first_row + block_side, rows_); ++r) {
        for (std::size_t c = first; c < std::min(first + block_side, columns_); ++c) {
          double nearest = infinite_distance;
          for (const std::size_t k : near) {
            nearest = std::min(nearest, squared(k, left_ + static_cast<double>(c) * spacing_,
                                                bottom_ + static_cast<double>(r) * spacing_));
          }
          sample(c, r) = std::sqrt(nearest);
        }
      }
    }
  }
}

/// Uses each row's crossings. Where rounding could confuse the sides, the distance stays below the
/// error.
void SignedDistance::mark_outside(const std::vector<Edge>& edges) {
  if (columns_ * rows_ == 1) return;
  std::vector<double> crossings;
  for (std::size_t r = 0; r < rows_; ++r) {
    look_for_interrupt_now();
    const double y = bottom_ + static_cast<double>(r) * spacing_;
    crossings.clear();
    for (const Edge& e : edges) {
      if ((e.y0 <= y) == (e.y1 <= y)) continue;
      crossings.push_back(e.x0 + (y - e.y0) / (e.y1 - e.y0) * (e.x1 - e.x0));
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t passed = 0;
    for (std::size_t c = 0; c < columns_; ++c) {
      const double x = left_ + static_cast<double>(c) * spacing_;
      while (passed < crossings.size() && crossings[passed] < x) ++passed;
      if (passed % 2 == 0) sample(c, r) = -sample(c, r);
      sample(c, r) -= error_;
    }
  }
}

double SignedDistance::below(double x, double y) const {
  // Any sample will do; the nearest is the best.
  const double column = (x - left_) * over_spacing_, row = (y - bottom_) * over_spacing_;
  const auto nearest = [](double place, std::size_t count) {
    return static_cast<std::uint32_t>(
        std::min(std::max(0.0, place + 0.5), static_cast<double>(count) - 0.5));
  };
  const std::uint32_t c = nearest(column, columns_), r = nearest(row, rows_);
  const double across = column - c, up = row - r;
  const double away = spacing_ * std::sqrt(across * across + up * up);
  return samples_[std::size_t{r} * columns_ + c] - away * (1 + 0x1p-30) -
         0x1p-40 * (std::fabs(x) + std::fabs(y)) - error_;
}

std::vector<Disc> SignedDistance::inscribed_discs(std::size_t count) const {
  std::vector<std::size_t> order(samples_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t k) { return !(samples_[k] > spacing_); });
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return samples_[a] > samples_[b]; });
  std::vector<bool> covered(samples_.size());
  std::vector<Disc> result;
  for (const std::size_t k : order) {
    look_for_interrupt();
    if (result.size() == count) break;
    if (covered[k]) continue;
    const std::size_t column = k % columns_, row = k / columns_;
    const double radius = samples_[k];
    result.push_back({left_ + static_cast<double>(column) * spacing_,
                      bottom_ + static_cast<double>(row) * spacing_, radius - error_});
    // Discs may overlap slightly: each covers the centres within 0.9 of its radius.
    const auto reach = static_cast<std::size_t>(0.9 * radius / spacing_);
    for (std::size_t r = row - std::min(row, reach); r <= std::min(row + reach, rows_ - 1); ++r) {
      for (std::size_t c = column - std::min(column, reach);
           c <= std::min(column + reach, columns_ - 1); ++c) {
        const double x = static_cast<double>(c) - static_cast<double>(column),
                     y = static_cast<double>(r) - static_cast<double>(row);
        if ((x * x + y * y) * spacing_ * spacing_ <= 0.81 * radius * radius) {
          covered[r * columns_ + c] = true;
        }
      }
    }
  }
  return result;
}

}  // namespace minkref::inline plane
