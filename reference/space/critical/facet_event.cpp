#include "reference/space/critical/facet_event.hpp"

#include <algorithm>
#include <type_traits>

namespace minkref::inline space {
namespace {

constexpr int unknown = 7;

}  // namespace

ContactRegion::ContactRegion(const MovingConvolution& convolution, const MovingFacet& first,
                             const MovingFacet& second, SignCounts& signs)
    : convolution_(convolution),
      first_(first),
      second_(second),
      signs_(signs),
      count_(std::size_t{first.size} + second.size),
      line_(convolution, first, second, signs) {
  for (std::uint8_t k = 0; k < first.size; ++k) rows_[k] = {line_, first, k};
  for (std::uint8_t k = 0; k < second.size; ++k) rows_[first.size + k] = {line_, second, k};
  for (auto& row : turns_) row.fill(unknown);
}

/// Of what `evaluate` makes of the constraints.
template <class Evaluate>
int ContactRegion::sign_of(Evaluate&& evaluate) {
  struct Rounded {
    std::array<ContactRow, most_sides>& rows;
    const LineForm<BoundedDouble>& operator[](std::size_t k) const { return rows[k].rounded(); }
  };
  struct Exact {
    std::array<ContactRow, most_sides>& rows;
    const LineForm<Integer>& operator[](std::size_t k) const { return rows[k].exact(); }
  };
  const int certain = evaluate(Rounded{rows_}).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++signs_.by_float;
    return certain;
  }
  ++signs_.by_integer;
  return sign(evaluate(Exact{rows_}));
}

/// The sign of alpha_i beta_j - alpha_j beta_i.
int ContactRegion::turn(std::size_t i, std::size_t j) {
  if (turns_[i][j] == unknown) {
    turns_[i][j] = sign_of([&](const auto& rows) {
      return rows[i].alpha * rows[j].beta - rows[j].alpha * rows[i].beta;
    });
    turns_[j][i] = -turns_[i][j];
  }
  return turns_[i][j];
}

/// The sign of constraint k where i and j are zero.
int ContactRegion::side(std::size_t i, std::size_t j, std::size_t k) {
  return turn(i, j) * sign_of([&](const auto& rows) {
           const auto &a = rows[i], &b = rows[j], &c = rows[k];
           return c.alpha * (a.beta * b.gamma - b.beta * a.gamma) +
                  c.beta * (a.gamma * b.alpha - b.gamma * a.alpha) +
                  c.gamma * (a.alpha * b.beta - b.alpha * a.beta);
         });
}

/// Where i and j are zero, if that is in the region, at a scale above 0, and i and j are the first
/// two that single it out.
std::optional<ContactRegion::Corner> ContactRegion::corner_of(std::size_t i, std::size_t j) {
  if (turn(i, j) == 0) return std::nullopt;
  const int scale = turn(i, j) * sign_of([&](const auto& rows) {
                      return rows[i].beta * rows[j].gamma - rows[j].beta * rows[i].gamma;
                    });
  if (scale <= 0) return std::nullopt;
  unsigned zeros = 1U << i | 1U << j;
  for (std::size_t k = 0; k < count_; ++k) {
    if (k == i || k == j) continue;
    const int at = side(i, j, k);
    if (at < 0) return std::nullopt;
    if (at == 0) zeros |= 1U << k;
  }
  for (std::size_t a = 0; a <= i; ++a) {
    for (std::size_t b = a + 1; b < count_; ++b) {
      if (a == i && b == j) {
        return Corner{i, j, static_cast<std::uint8_t>(zeros)};
      }
      if ((zeros >> a & 1U) != 0 && (zeros >> b & 1U) != 0 && turn(a, b) != 0) return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Whether the region has scales above that of a corner (direction 1), or below it (-1), next to
/// it: constraints with beta > 0 bound t from below, those with beta < 0 from above.
bool ContactRegion::grows_from(const Corner& corner, int direction) {
  std::array<int, most_sides> slopes{};
  for (std::size_t k = 0; k < count_; ++k) {
    if ((corner.zeros >> k & 1U) == 0) continue;
    slopes[k] = sign_of([&](const auto& rows) { return rows[k].beta; });
    if (slopes[k] == 0 &&
        direction * sign_of([&](const auto& rows) { return rows[k].alpha; }) < 0) {
      return false;
    }
  }
  for (std::size_t k = 0; k < count_; ++k) {
    for (std::size_t l = 0; l < count_; ++l) {
      if (slopes[k] > 0 && slopes[l] < 0 && direction * turn(k, l) > 0) return false;
    }
  }
  return true;
}

/// From a plane and a corner, or from two sides: numbers are shorter than those of constraints.
Rational ContactRegion::scale_of(const Corner& corner, const FacetEvent& event) {
  IntegerVector normal;
  ConvolutionFacet::Corner from, to;
  if (event.kind == ContactKind::edge) {
    normal = cross(first_.along[event.of_first].exact, second_.along[event.of_second].exact);
    from = first_.names[event.of_first];
    to = second_.names[event.of_second];
  } else if (event.of_first != FacetEvent::no_corner) {
    normal = second_.normal.exact;
    from = first_.names[event.of_first];
    to = second_.names[0];
  } else {
    normal = first_.normal.exact;
    from = second_.names[event.of_second];
    to = first_.names[0];
  }
  const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
  const Integer slope = dot(normal, P.points[to.of_P].exact - P.points[from.of_P].exact);
  if (slope != 0) {
    return Rational(-dot(normal, Q.points[to.of_Q].exact - Q.points[from.of_Q].exact), slope);
  }
  // They touch at all scales, somewhere.
  const LineForm<Integer>&f = rows_[corner.i].exact(), &g = rows_[corner.j].exact();
  return Rational(f.beta * g.gamma - g.beta * f.gamma, f.alpha * g.beta - g.alpha * f.beta);
}

FacetEvent ContactRegion::event_at(const Corner& corner) {
  FacetEvent contact{
      ContactKind::edge, ContactChange::pass, FacetEvent::no_corner, FacetEvent::no_corner, {}};
  const auto zero = [&](std::size_t k) { return (corner.zeros >> k & 1U) != 0; };
  const auto find = [&](std::size_t from, std::size_t size, std::uint8_t& corner_number) {
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t next = (k + 1) % size;
      if (!zero(from + k) || !zero(from + next)) continue;
      corner_number = static_cast<std::uint8_t>(next);
      contact.kind = ContactKind::vertex;
    }
  };
  find(0, first_.size, contact.of_first);
  find(first_.size, second_.size, contact.of_second);
  if (contact.kind == ContactKind::edge) {
    contact.of_first = static_cast<std::uint8_t>(corner.i);
    contact.of_second = static_cast<std::uint8_t>(corner.j - first_.size);
  }
  contact.s = scale_of(corner, contact);
  return contact;
}

/// On the line at s each side leaves a half-line: the last start must not be after the first end.
bool ContactRegion::meet_at(const Rational& s) {
  const Integer numerator = boost::multiprecision::numerator(s),
                denominator = boost::multiprecision::denominator(s);
  const std::array<BoundedDouble, 2> rounded{BoundedDouble(numerator), BoundedDouble(denominator)};
  const auto height = [&](const auto& row) {
    if constexpr (std::is_same_v<std::decay_t<decltype(row)>, LineForm<Integer>>) {
      return Integer(row.alpha * numerator + row.gamma * denominator);
    } else {
      return row.alpha * rounded[0] + row.gamma * rounded[1];
    }
  };
  std::array<int, most_sides> slopes{};
  for (std::size_t k = 0; k < count_; ++k) {
    slopes[k] = sign_of([&](const auto& rows) { return rows[k].beta; });
    if (slopes[k] == 0 && sign_of([&](const auto& rows) { return height(rows[k]); }) < 0) {
      return false;
    }
  }
  for (std::size_t k = 0; k < count_; ++k) {
    for (std::size_t l = 0; l < count_; ++l) {
      if (slopes[k] <= 0 || slopes[l] >= 0) continue;
      const int between = sign_of([&](const auto& rows) {
        return height(rows[k]) * rows[l].beta - height(rows[l]) * rows[k].beta;
      });
      if (between > 0) return false;
    }
  }
  return true;
}

std::vector<FacetEvent> ContactRegion::events() {
  std::vector<FacetEvent> found;
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t j = i + 1; j < count_; ++j) {
      const auto corner = corner_of(i, j);
      if (!corner) continue;
      FacetEvent contact = event_at(*corner);
      const bool up = grows_from(*corner, 1), down = grows_from(*corner, -1);
      if (up && !down) contact.change = ContactChange::birth;
      if (!up && down) contact.change = ContactChange::death;
      if (!up && !down) contact.change = ContactChange::touch;
      found.push_back(std::move(contact));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const FacetEvent& a, const FacetEvent& b) { return a.s < b.s; });
  return found;
}

}  // namespace minkref::inline space
