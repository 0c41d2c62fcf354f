#include "reference/space/convex/compatibility.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace minkref::inline space {
namespace {

/// The edges at a vertex above a plane that is parallel to a facet.
struct Fan {
  std::uint32_t witness = UINT32_MAX;  ///< the half-edge that rises most; UINT32_MAX: none rises
  double slack = 0;                    ///< of the signs, where none rises
};

/// Where doubles do not settle all signs.
Fan look_at_fan_exactly(const FacetContact& contact, const FacetContact::Weighted& normal,
                        std::uint32_t vertex) {
  const ConvexPolyhedron& body = contact.edges();
  Fan fan;
  FacetContact::Slack slack(contact);
  double most = -std::numeric_limits<double>::infinity();
  for (std::uint32_t h = body.first(vertex); h < body.first(vertex + 1); ++h) {
    const FacetContact::Product product = contact.approximate(normal, h);
    slack.include(product);
    if (contact.rises(normal, h, product) && product.value > most) {
      most = product.value;
      fan.witness = h;
    }
  }
  if (fan.witness == UINT32_MAX) fan.slack = slack.drift();
  return fan;
}

/// Without branches on signs, which nothing predicts.
Fan look_at_fan(const FacetContact& contact, const FacetContact::Weighted& normal,
                std::uint32_t vertex) {
  const ConvexPolyhedron& body = contact.edges();
  const std::uint32_t first = body.first(vertex), end = body.first(vertex + 1);
  double most = -std::numeric_limits<double>::infinity();
  std::uint32_t witness = first;
  bool certain = true;
  FacetContact::Slack slack(contact);
  for (std::uint32_t h = first; h < end; ++h) {
    const FacetContact::Product product = contact.approximate(normal, h);
    certain &= product.certain();
    witness = product.value > most ? h : witness;
    most = std::max(most, product.value);
    slack.include(product);
  }
  if (!certain) return look_at_fan_exactly(contact, normal, vertex);
  if (most > 0) return {witness, 0};
  return {UINT32_MAX, slack.drift()};
}

double estimated_height(const FacetContact& contact, const FacetContact::Weighted& normal,
                        std::uint32_t vertex) {
  const DoubleVector& p = contact.edges().rounded_point(vertex);
  return normal.normal[0] * p[0] + normal.normal[1] * p[1] + normal.normal[2] * p[2];
}

}  // namespace

Climb climb(const FacetContact& contact, std::uint32_t facet, std::uint32_t vertex) {
  const FacetContact::Weighted normal = contact.weighted(facet);
  Fan fan = look_at_fan(contact, normal, vertex);
  std::uint32_t steps = 0;
  for (; fan.witness != UINT32_MAX; ++steps) {
    vertex = contact.edges().target(fan.witness);
    fan = look_at_fan(contact, normal, vertex);
  }
  return {vertex, steps, fan.slack};
}

Climb climb(const FacetContact& contact, std::uint32_t facet, std::uint32_t vertex,
            std::uint32_t other, std::vector<std::uint32_t>& walked) {
  walked.clear();
  const FacetContact::Weighted normal = contact.weighted(facet);
  Fan fan = look_at_fan(contact, normal, vertex);
  if (fan.witness != UINT32_MAX && other != vertex &&
      estimated_height(contact, normal, other) > estimated_height(contact, normal, vertex)) {
    vertex = other;
    fan = look_at_fan(contact, normal, vertex);
  }
  while (fan.witness != UINT32_MAX) {
    walked.push_back(fan.witness);
    vertex = contact.edges().target(fan.witness);
    fan = look_at_fan(contact, normal, vertex);
  }
  return {vertex, static_cast<std::uint32_t>(walked.size()), fan.slack};
}

void walk_chain(const FacetContact& across_Q, std::uint32_t edge, std::uint32_t from,
                std::uint32_t to, std::vector<std::uint32_t>& chain, std::vector<double>& slacks) {
  chain.clear();
  slacks.clear();
  if (from == to) return;
  const ConvexPolyhedron& Q = across_Q.normals();
  const std::uint32_t e = across_Q.edges().half_edge(edge);
  struct Side {
    FacetContact::Product product;
    bool rises;
  };
  const auto look_left_of = [&](std::uint32_t half_edge) {
    const FacetContact::Weighted normal = across_Q.weighted(Q.left(half_edge));
    const FacetContact::Product product = across_Q.approximate(normal, e);
    return Side{product, across_Q.rises(normal, e, product)};
  };
  const auto fail = [] {
    throw std::logic_error("a chain of edges is not that of an arc: its ends are wrong");
  };
  // The region's facets, counter-clockwise, lie on the great circle's positive side in one run: the
  // great circle leaves by the arc just before the run. Left and right of the arc:
  std::uint32_t h = Q.first(from);
  Side left = look_left_of(h), right{};
  if (left.rises) {
    for (;;) {
      const std::uint32_t before = Q.backward(h);
      right = look_left_of(before);
      if (!right.rises) break;
      h = before;
      left = right;
      if (h == Q.first(from)) fail();
    }
  } else {
    do {
      right = left;
      h = Q.onward(h);
      left = look_left_of(h);
      if (h == Q.first(from)) fail();
    } while (!left.rises);
  }
  for (;;) {
    chain.push_back(h);
    FacetContact::Slack slack(across_Q);
    slack.include(left.product);
    slack.include(right.product);
    slacks.push_back(slack.drift());
    if (Q.target(h) == to) return;
    if (chain.size() > Q.vertices()) fail();
    h = Q.onward(Q.twin(h));
    for (left = look_left_of(h); !left.rises; left = look_left_of(h)) {
      right = left;
      h = Q.onward(h);
    }
  }
}

LinkState examine_link(const FacetContact& across_Q, std::uint32_t edge, std::uint32_t half_edge) {
  const ConvexPolyhedron& Q = across_Q.normals();
  const std::uint32_t e = across_Q.edges().half_edge(edge);
  const FacetContact::Weighted left = across_Q.weighted(Q.left(half_edge)),
                               right = across_Q.weighted(Q.right(half_edge));
  const FacetContact::Product rising = across_Q.approximate(left, e),
                              falling = across_Q.approximate(right, e);
  if (!across_Q.rises(left, e, rising) || across_Q.rises(right, e, falling)) return {false, 0};
  FacetContact::Slack slack(across_Q);
  slack.include(rising);
  slack.include(falling);
  return {true, slack.drift()};
}

}  // namespace minkref::inline space
