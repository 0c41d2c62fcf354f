// Tight passages against the definition, which decides every crossing of two convolution edges, and
// points between crossings.
#include <algorithm>
#include <array>

#include "reference/plane/location.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "tests/fuzzing/reference/pair_change.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {

const Bounds bounds{.vertices = 14, .product = 64};

namespace {

constexpr std::size_t most_points = 48;

Rational cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }

bool is_less(const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

bool on_segment(const Point& a, const Point& b, const Point& x) {
  return sign(cross(b - a, x - a)) == 0 && std::min(a.x, b.x) <= x.x && x.x <= larger(a.x, b.x) &&
         std::min(a.y, b.y) <= x.y && x.y <= larger(a.y, b.y);
}

bool is_on(const std::vector<TightPassage>& passages, const Point& x) {
  for (const TightPassage& passage : passages) {
    if (passage.points.size() == 1 && passage.points[0] == x) return true;
    for (std::size_t i = 0; i + 1 < passage.points.size(); ++i) {
      if (on_segment(passage.points[i], passage.points[i + 1], x)) return true;
    }
  }
  return false;
}

/// Ends and common points of reduced convolution edges, and points halfway between two such points
/// on an edge.
std::vector<Point> candidates(const Case& pair, const Rational& s, Dice& dice) {
  std::vector<Segment> edges;
  for (const ConvolutionEdge& e : reduced_convolution(pair.P, pair.Q)) {
    edges.push_back(at_scale(e, pair.P, pair.Q, s));
  }
  std::vector<Point> found;
  for (std::size_t round = 0; round < most_points && !edges.empty(); ++round) {
    const Segment &a = dice.of(edges), &b = dice.of(edges);
    const Point u = a.end - a.start, v = b.end - b.start;
    const Rational turn = cross(u, v);
    if (sign(turn) == 0) {
      found.push_back(Rational(1, 2) * (a.end + b.start));
      found.push_back(Rational(1, 2) * (a.start + a.end));
      continue;
    }
    const Rational t = cross(b.start - a.start, v) / turn;
    const Point x = a.start + t * u;
    if (sign(t) < 0 || t > 1 || !on_segment(b.start, b.end, x)) continue;
    found.push_back(x);
    found.push_back(Rational(1, 2) * (x + a.end));
  }
  return found;
}

/// All points of the passages are in contact only, inside the sum or on its boundary; candidates
/// inside the sum that are in contact only lie on a passage.
void check_points(const Case& pair, const Rational& s, const Sum& sum, Dice& dice) {
  const auto& passages = *sum.tight_passages;
  const Membership membership(pair.P, pair.Q, s);
  const auto name = [](const Point& x) {
    return "(" + to_string(x.x) + ", " + to_string(x.y) + ")";
  };
  const auto touches = [&](const Point& x) {
    if (membership.contact(x) != Contact::touching) {
      broken("at a tight passage the operands only touch", pair, name(x));
    }
    if (locate(sum.region, x) == Location::outside) {
      broken("a tight passage lies in the sum", pair, name(x));
    }
  };
  for (const TightPassage& passage : passages) {
    for (std::size_t i = 0; i < passage.points.size(); ++i) {
      const Point& x = passage.points[i];
      touches(x);
      if (i + 1 == passage.points.size()) break;
      const Rational along(1, dice.between(2, 5));
      touches(x + along * (passage.points[i + 1] - x));
    }
  }
  for (const Point& x : candidates(pair, s, dice)) {
    if (locate(sum.region, x) != Location::inside) continue;
    if ((membership.contact(x) == Contact::touching) != is_on(passages, x)) {
      broken("inside the sum the operands only touch on tight passages", pair, name(x));
    }
  }
}

/// The points of all pieces, each in canonical direction, without contacts.
std::vector<std::vector<Point>> pieces(const std::vector<TightPassage>& passages) {
  std::vector<std::vector<Point>> all;
  for (const TightPassage& passage : passages) all.push_back(passage.points);
  return all;
}

bool sequence_less(const std::vector<Point>& p, const std::vector<Point>& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), is_less);
}

/// Pieces are sorted, run the smaller way, and name a contact for each part.
void check_order(const Case& pair, const std::vector<TightPassage>& passages) {
  const auto all = pieces(passages);
  if (!std::is_sorted(all.begin(), all.end(), sequence_less)) {
    broken("tight passages are sorted", pair);
  }
  for (const TightPassage& passage : passages) {
    std::vector<Point> back(passage.points.rbegin(), passage.points.rend());
    if (sequence_less(back, passage.points)) broken("a passage runs the smaller way", pair);
    const std::size_t parts = std::max<std::size_t>(1, passage.points.size() - 1);
    if (passage.points.empty() || passage.contacts.size() != parts) {
      broken("each part of a passage has its contacts", pair);
    }
    for (const auto& contacts : passage.contacts) {
      if (contacts.empty()) broken("a contact is named", pair);
    }
  }
}

/// Checks maps that keep the order of points, and the exchange of operands.
void check_laws(const Case& pair, const Rational& s, const Sum& sum, Dice& dice) {
  const auto mapped = [&](const auto& map) {
    auto all = pieces(*sum.tight_passages);
    for (auto& piece : all) std::transform(piece.begin(), piece.end(), piece.begin(), map);
    return all;
  };
  const auto found = [](const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
    return pieces(tight_passages(P, Q, scale));
  };
  switch (dice.below(3)) {
    case 0: {
      const Rational k(dice.between(1, 9), 7);
      const auto map = [&](const Point& p) { return k * p; };
      if (mapped(map) != found(scaled(pair.P, k), scaled(pair.Q, k), s)) {
        broken("tight passages scale with both operands", pair);
      }
      return;
    }
    case 1: {
      const Point t{power_of_two(dice.between(0, 70)), Rational(dice.between(-9, 9), 7)};
      const auto map = [&](const Point& p) { return p + t; };
      if (mapped(map) != found(pair.P, translated(pair.Q, t), s)) {
        broken("tight passages move with Q", pair);
      }
      return;
    }
    default: {
      const auto map = [&](const Point& p) { return Rational(1 / s) * p; };
      if (mapped(map) != found(pair.Q, pair.P, 1 / s)) {
        broken("tight passages do not hang on the order of the operands", pair);
      }
    }
  }
}

void check(const Case& pair, Dice& dice) {
  const Rational s = scale_of(pair);
  const Sum sum = minkowski_sum(pair.P, pair.Q, s, Route::paper, "rational", Passages::find);
  if (pair.P.empty() || pair.Q.empty()) return;
  if (*sum.tight_passages != tight_passages(pair.P, pair.Q, s)) {
    broken("tight passages of the sum are those found alone", pair);
  }
  check_order(pair, *sum.tight_passages);
  check_points(pair, s, sum, dice);
  check_laws(pair, s, sum, dice);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_pair(data, size, minkref::fuzzing::check);
}
