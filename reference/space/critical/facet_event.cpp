#include "reference/space/critical/facet_event.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace minkref::inline space {
namespace {

constexpr int unknown = 7;

std::size_t crossing_axis(const FilteredVector& n, const FilteredVector& m) {
  const BoundedVector along = cross(n.rounded, m.rounded);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(along[k].value) - along[k].error >
        std::abs(along[axis].value) - along[axis].error) {
      axis = k;
    }
  }
  const int sign = along[axis].certain_sign();
  if (sign == 1 || sign == -1) return axis;
  return longest_axis(cross(n.exact, m.exact));
}

/// Without a common factor that may be beyond doubles.
void bring_near_one(SideConstraint<BoundedDouble>& row) {
  const double most =
      std::max({std::abs(row.alpha.value), std::abs(row.beta.value), std::abs(row.gamma.value)});
  if (!(most > 0) || !std::isfinite(most)) return;
  const int exponent = std::ilogb(most);
  for (BoundedDouble* number : {&row.alpha, &row.beta, &row.gamma}) {
    if (number->error == 0 && number->value == 0) continue;
    number->value = std::ldexp(number->value, -exponent);
    number->error = std::ldexp(number->error, -exponent) + 1e-300;
  }
}

}  // namespace

ContactRegion::ContactRegion(const MovingConvolution& convolution, const MovingFacet& first,
                             const MovingFacet& second, SignCounts& signs)
    : convolution_(convolution),
      first_(first),
      second_(second),
      signs_(signs),
      count_(std::size_t{first.size} + second.size),
      axis_(crossing_axis(first.normal, second.normal)) {
  const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  is_negative_ = filtered_sign(signs_, [&]<class T>(std::type_identity<T>) {
                   const std::array<T, 3>&n = first.normal.as<T>(), &m = second.normal.as<T>();
                   return T(n[i] * m[j] - n[j] * m[i]);
                 }) < 0;
  const auto shared = line<BoundedDouble>();
  for (std::size_t k = 0; k < count_; ++k) {
    rounded_[k] = constraint(shared, k);
    bring_near_one(rounded_[k]);
  }
  for (auto& row : turns_) row.fill(unknown);
}

/// Coordinates are those from the first corner of the first facet.
template <class T>
ContactRegion::Line<T> ContactRegion::line() const {
  const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
  const auto &from = first_.names[0], &to = second_.names[0];
  const std::array<T, 3>&n = first_.normal.as<T>(), &m = second_.normal.as<T>();
  Line<T> line;
  line.A = dot(m, P.points[to.of_P].as<T>() - P.points[from.of_P].as<T>());
  line.B = dot(m, Q.points[to.of_Q].as<T>() - Q.points[from.of_Q].as<T>());
  line.along = cross(n, m);
  line.foot[axis_] = T(0);
  line.foot[(axis_ + 1) % 3] = -n[(axis_ + 2) % 3];
  line.foot[(axis_ + 2) % 3] = n[(axis_ + 1) % 3];
  line.weight = line.along[axis_];
  if (is_negative_) {
    line.weight = -line.weight;
    for (std::size_t k = 0; k < 3; ++k) {
      line.along[k] = -line.along[k];
      line.foot[k] = -line.foot[k];
    }
  }
  return line;
}

/// Of a side of the first facet, or after these of the second.
template <class T>
SideConstraint<T> ContactRegion::constraint(const Line<T>& line, std::size_t side) const {
  const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
  const bool is_first = side < first_.size;
  const MovingFacet& facet = is_first ? first_ : second_;
  const std::size_t k = is_first ? side : side - first_.size;
  const auto &base = first_.names[0], &corner = facet.names[k];
  const std::array<T, 3> inwards = cross(facet.normal.as<T>(), facet.along[k].as<T>());
  const T lean = dot(inwards, line.foot);
  const T of_P = dot(inwards, P.points[corner.of_P].as<T>() - P.points[base.of_P].as<T>()),
          of_Q = dot(inwards, Q.points[corner.of_Q].as<T>() - Q.points[base.of_Q].as<T>());
  return {T(line.A * lean - line.weight * of_P), T(dot(inwards, line.along)),
          T(line.B * lean - line.weight * of_Q)};
}

const SideConstraint<Integer>& ContactRegion::exact(std::size_t side) {
  if (!exact_[side]) {
    if (!exact_line_) exact_line_ = line<Integer>();
    exact_[side] = constraint(*exact_line_, side);
  }
  return *exact_[side];
}

/// Of what `evaluate` makes of the constraints.
template <class Evaluate>
int ContactRegion::sign_of(Evaluate&& evaluate) {
  const int certain = evaluate(rounded_).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++signs_.by_float;
    return certain;
  }
  ++signs_.by_integer;
  struct Rows {
    ContactRegion& region;
    const SideConstraint<Integer>& operator[](std::size_t side) const { return region.exact(side); }
  };
  return sign(evaluate(Rows{*this}));
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
  const SideConstraint<Integer>&f = exact(corner.i), &g = exact(corner.j);
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
