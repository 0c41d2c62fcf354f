// The paper's way to events of two facets (Sec. 5.1, 5.2), over rational numbers.
#include "reference/paper/space/facet_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string_view>
#include <vector>

#include "reference/space/critical/parallel_facets.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_facet_contacts {
namespace {

using Contacts = FacetContacts<Rational>;

Contacts::Facet facet_of(const MovingConvolution& convolution, const MovingFacet& facet) {
  const auto vector = [](const IntegerVector& v) {
    return Contacts::Vector(Rational(v[0]), Rational(v[1]), Rational(v[2]));
  };
  Contacts::Facet corners;
  for (std::size_t k = 0; k < facet.size; ++k) {
    const auto& [of_P, of_Q] = facet.names[k];
    corners.push_back({vector(convolution.P.points[of_P].exact),
                       vector(convolution.Q.points[of_Q].exact), of_P, of_Q});
  }
  return corners;
}

std::set<Rational> scales_of(const std::vector<PaperContact<Rational>>& contacts) {
  std::set<Rational> scales;
  for (const auto& contact : contacts) {
    if (contact.scale) scales.insert(*contact.scale);
  }
  return scales;
}

std::set<Rational> exact_scales(const MovingConvolution& convolution, const MovingFacet& a,
                                const MovingFacet& b) {
  space::SignCounts signs;
  const bool parallel = is_zero(cross(a.normal.exact, b.normal.exact));
  const auto events = parallel ? parallel_events(convolution, a, b, signs)
                               : ContactRegion(convolution, a, b, signs).events();
  std::set<Rational> scales;
  for (const FacetEvent& event : events) scales.insert(event.s.exact());
  return scales;
}

bool has_a_side_along(const MovingFacet& a, const MovingFacet& b) {
  const auto along = [](const MovingFacet& own, const MovingFacet& other) {
    for (std::size_t k = 0; k < own.size; ++k) {
      if (dot(other.normal.exact, own.along[k].exact).is_zero()) return true;
    }
    return false;
  };
  return along(a, b) || along(b, a);
}

/// Two facets of a convolution, and which of the three cases of Sec. 5 they are.
struct Case {
  enum Kind { crossing, parallel, coplanar } kind;
  Contacts::Facet first, second;
  std::set<Rational> truth;
  bool has_a_side_along;
};

/// Each third pair of parallel facets of two bodies, and each twelfth of the others: exact systems
/// are slow.
template <class Use>
void for_each_case(Use&& use) {
  bodies::for_each_seed(1, [&](std::mt19937& dice) {
    const auto u_shape = [&](const auto& map) {
      return polycubes::solid(polycubes::without(polycubes::block({0, 0, 0}, {3, 2, 1}),
                                                 polycubes::block({1, 1, 0}, {2, 2, 1})),
                              map);
    };
    const auto map = polycubes::random_matrix(dice, 4);
    const Polyhedron P = u_shape(map),
                     Q = u_shape(dice() % 2 == 0 ? map : polycubes::random_matrix(dice, 4));
    const SpaceOperands operands = space_operands(P, Q, {1, 1, 1});
    const MovingConvolution convolution(operands.P, operands.Q);
    for (std::size_t i = 0; i < convolution.facets.size(); ++i) {
      for (std::size_t j = i + 1; j < convolution.facets.size(); ++j) {
        const MovingFacet &a = convolution.facets[i], &b = convolution.facets[j];
        const bool parallel = is_zero(cross(a.normal.exact, b.normal.exact));
        if ((i + j) % (parallel ? 3 : 12) != 0) continue;
        const Case::Kind kind = !parallel                         ? Case::crossing
                                : are_coplanar(convolution, a, b) ? Case::coplanar
                                                                  : Case::parallel;
        use(Case{kind, facet_of(convolution, a), facet_of(convolution, b),
                 exact_scales(convolution, a, b), has_a_side_along(a, b)});
      }
    }
  });
}

std::set<Rational> scales(const Case& pair, const FacetReadings& readings) {
  const Rational zero = 0;
  return scales_of(Contacts(pair.first, pair.second, readings, zero).all());
}

bool includes(const std::set<Rational>& all, const std::set<Rational>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

FacetReadings corrected_but(std::string_view name, std::string_view value) {
  FacetReadings readings = corrected_facet_readings();
  set_reading(readings, name, value);
  return readings;
}

/// With exact numbers the three equations agree. The printed form finds nothing if a side is
/// parallel to the other plane, at the scale that puts the side into the plane; so nothing for
/// parallel faces.
TEST(FacetContacts, HaveTheScalesOfTheExactEvents) {
  std::array<std::size_t, 3> events{}, missed{};
  for_each_case([&](const Case& pair) {
    ASSERT_EQ(scales(pair, corrected_facet_readings()), pair.truth) << pair.kind;
    const auto printed = scales(pair, FacetReadings{});
    events[pair.kind] += pair.truth.size();
    if (pair.kind == Case::coplanar) return;  // the printed formulas of the plane decide
    ASSERT_TRUE(includes(pair.truth, printed));
    ASSERT_TRUE(printed == pair.truth || pair.has_a_side_along);
    missed[pair.kind] += pair.truth.size() - printed.size();
  });
  for (const std::size_t count : events) EXPECT_GT(count, 5U);
  EXPECT_GT(missed[Case::crossing], 0U);
  EXPECT_EQ(missed[Case::parallel], events[Case::parallel]);
}

/// Each sentence by itself, the others corrected: what it loses or invents, and of which facets.
TEST(FacetContacts, BlameOneSentenceAtATime) {
  struct Blame {
    std::string_view name, value;
    std::array<bool, 3> misses, invents;  ///< of crossing, parallel, coplanar facets
  };
  const std::vector<Blame> blames{
      {"corner", "lines", {false, true, false}, {false, false, false}},
      {"crossing", "points", {true, false, false}, {false, false, false}},
      {"solve", "printed", {false, false, false}, {false, false, false}},
      {"solve", "least-squares", {false, false, false}, {false, false, false}},
      {"ends", "lines", {false, false, false}, {true, false, false}},
      {"parallel", "left-out", {false, true, false}, {false, false, false}},
      {"coplanar", "turned", {false, false, false}, {false, false, false}},
      {"coplanar", "left-out", {false, false, true}, {false, false, false}},
      {"plane-interval", "printed", {false, false, true}, {false, false, true}},
      {"plane-solve", "printed", {false, false, false}, {false, false, false}},
      {"plane-adjacent", "taken", {false, false, false}, {false, false, false}},
  };
  std::vector<std::array<bool, 3>> misses(blames.size()), invents(blames.size());
  for_each_case([&](const Case& pair) {
    for (std::size_t i = 0; i < blames.size(); ++i) {
      const bool in_plane = blames[i].name.starts_with("plane") || blames[i].name == "coplanar";
      if (in_plane != (pair.kind == Case::coplanar)) continue;  // it reads nothing else
      const auto found = scales(pair, corrected_but(blames[i].name, blames[i].value));
      misses[i][pair.kind] |= !includes(found, pair.truth);
      invents[i][pair.kind] |= !includes(pair.truth, found);
    }
  });
  for (std::size_t i = 0; i < blames.size(); ++i) {
    EXPECT_EQ(misses[i], blames[i].misses) << blames[i].name << "=" << blames[i].value;
    EXPECT_EQ(invents[i], blames[i].invents) << blames[i].name << "=" << blames[i].value;
  }
}

/// Fig. 4: two triangles that come to lie across each other in one plane, without a vertex of one
/// in the other. Only the sides meet.
TEST(FacetContacts, FindParallelFacesWithoutAVertexContact) {
  const auto triangle = [](std::array<int, 6> at, int rises, std::uint32_t first) {
    Contacts::Facet facet;
    for (std::size_t k = 0; k < 3; ++k) {
      facet.push_back({Contacts::Vector(0, 0, rises), Contacts::Vector(at[2 * k], at[2 * k + 1], 0),
                       0, first + static_cast<std::uint32_t>(k)});
    }
    return facet;
  };
  const Contacts::Facet still = triangle({0, 3, -3, -2, 3, -2}, 0, 0);
  Contacts::Facet rising = triangle({0, -3, 3, 2, -3, 2}, 1, 3);
  for (auto& corner : rising) corner.q.z() = -4;
  const Rational zero = 0;
  FacetReadings readings;
  EXPECT_TRUE(scales_of(Contacts(still, rising, readings, zero).all()).empty());
  set_reading(readings, "corner", "itself");
  const auto contacts = Contacts(still, rising, readings, zero).all();
  EXPECT_EQ(scales_of(contacts), std::set<Rational>{4});
  EXPECT_EQ(std::count_if(contacts.begin(), contacts.end(),
                          [](const auto& contact) {
                            return contact.scale && contact.kind == ContactKind::edge;
                          }),
            6);
}

}  // namespace
}  // namespace minkref::of_facet_contacts
