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
      count_(std::size_t{first.size} + second.size) {}

std::array<ContactRow, most_sides>& ContactRegion::rows() {
  if (!line_) {
    line_.emplace(convolution_, first_, second_, signs_);
    for (std::uint8_t k = 0; k < first_.size; ++k) rows_[k] = {*line_, first_, k};
    for (std::uint8_t k = 0; k < second_.size; ++k) {
      rows_[first_.size + k] = {*line_, second_, k};
    }
    for (auto& row : turns_) row.fill(unknown);
  }
  return rows_;
}

/// The sign that `evaluate` gives for the constraints.
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
  const int certain = evaluate(Rounded{rows()}).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++signs_.by_float;
    return certain;
  }
  ++signs_.by_integer;
  return sign(evaluate(Exact{rows()}));
}

/// The sign of alpha_i beta_j - alpha_j beta_i.
int ContactRegion::turn(std::size_t i, std::size_t j) {
  rows();
  if (turns_[i][j] == unknown) {
    const auto turn = [&](const auto& rows) { return turn_of(rows[i], rows[j]); };
    const int certain = turn_of(rows_[i].rounded(), rows_[j].rounded()).certain_sign();
    const bool level = certain == BoundedDouble::undecided && is_level(i, j);
    turns_[i][j] = level ? 0 : sign_of(turn);
    turns_[j][i] = -turns_[i][j];
  }
  return turns_[i][j];
}

/// Whether touching parts share a vertex: the corner between two sides of one facet and any corner
/// of the other facet, or ends of sides of both.
template <class Vertex>
bool ContactRegion::have_common(std::size_t i, std::size_t j, Vertex&& vertex) const {
  const bool is_one = j < first_.size || i >= first_.size;
  if (is_one) {
    const MovingFacet &own = i < first_.size ? first_ : second_,
                      &other = i < first_.size ? second_ : first_;
    const std::size_t corner = corner_between(i, j);
    for (std::size_t l = 0; l < other.size; ++l) {
      if (vertex(own.names[corner]) == vertex(other.names[l])) return true;
    }
    return false;
  }
  const std::size_t l = j - first_.size;
  for (const std::size_t a : {i, (i + 1) % first_.size}) {
    for (const std::size_t b : {l, (l + 1) % second_.size}) {
      if (vertex(first_.names[a]) == vertex(second_.names[b])) return true;
    }
  }
  return false;
}

/// Whether names tell that i and j vanish together at no single scale s > 0. With a common vertex p
/// of P everything moves with s p: i and j vanish together at all scales or never. With a common
/// vertex of Q everything scales about this vertex: i and j vanish together at s = 0, or always.
/// Opposite sides vanish together at s = 0 or never.
bool ContactRegion::have_no_scale(std::size_t i, std::size_t j) const {
  using Name = ConvolutionFacet::Corner;
  if (are_opposite(i, j)) return true;
  return have_common(i, j, [](const Name& corner) { return corner.of_P; }) ||
         have_common(i, j, [](const Name& corner) { return corner.of_Q; });
}

/// The corner between two sides of one facet and the other facet's plane, or two sides: slope s +
/// height vanishes where they touch, unless parallel.
template <class T>
MovingHeight<T> ContactRegion::contact(std::size_t i, std::size_t j) const {
  const ExactCorners<T> exact(convolution_);
  const std::size_t size = first_.size;
  if (i < size && j >= size) {
    return exact.height(cross(exact.along(first_, i), exact.along(second_, j - size)),
                        first_.names[i], second_.names[j - size]);
  }
  const MovingFacet &own = i < size ? first_ : second_, &other = i < size ? second_ : first_;
  return exact.height(exact.normal(other), own.names[corner_between(i, j)], other.names[0]);
}

bool ContactRegion::are_opposite(std::size_t i, std::size_t j) const {
  if (i > j) std::swap(i, j);
  const bool is_one = j < first_.size || i >= first_.size;
  return is_one && j - i == 2 && (i < first_.size ? first_ : second_).size == 4;
}

/// Whether i and j are zero together at no single scale.
bool ContactRegion::is_level(std::size_t i, std::size_t j) const {
  if (i > j) std::swap(i, j);
  if (are_opposite(i, j)) return false;  // perhaps at 0
  return convolution_.words ? contact<Int128>(i, j).slope == 0
                            : contact<Integer>(i, j).slope.is_zero();
}

/// The common corner between a facet's two sides.
std::size_t ContactRegion::corner_between(std::size_t i, std::size_t j) const {
  const std::size_t start = i < first_.size ? 0 : first_.size,
                    size = i < first_.size ? first_.size : second_.size;
  return i + 1 == j ? j - start : (j + 1 - start) % size;
}

/// The sign at s of one corner's distance beyond another along a direction, which `direction` gives
/// as numbers of the requested type.
template <class Direction>
int ContactRegion::height_at(const EventScale& s, const ConvolutionFacet::Corner& from,
                             const ConvolutionFacet::Corner& to, Direction&& direction) {
  const auto &P = convolution_.P.points, &Q = convolution_.Q.points;
  return filtered_sign(signs_, [&]<class T>(std::type_identity<T> type) {
    const std::array<T, 3> n = direction(type);
    const T moved = dot(n, P[to.of_P].template as<T>() - P[from.of_P].template as<T>()),
            fixed = dot(n, Q[to.of_Q].template as<T>() - Q[from.of_Q].template as<T>());
    if constexpr (std::is_same_v<T, Integer>) {
      return Integer(moved * s.numerator() + fixed * s.denominator());
    } else {
      return moved * BoundedDouble(s.rounded(), s.rounded() * 0x1p-49) + fixed;
    }
  });
}

/// Whether the corner between sides i and j, which lies in the other facet's plane at s, lies
/// inside this facet; adds the sides through the corner.
bool ContactRegion::corner_is_inside(std::size_t i, std::size_t j, const EventScale& s,
                                     unsigned& zeros) {
  const bool of_first = i < first_.size;
  const MovingFacet &own = of_first ? first_ : second_, &other = of_first ? second_ : first_;
  const auto& corner = own.names[corner_between(i, j)];
  for (std::size_t k = 0; k < other.size; ++k) {
    const int at = height_at(s, other.names[k], corner, [&]<class T>(std::type_identity<T>) {
      return cross(other.normal.as<T>(), other.along[k].as<T>());
    });
    if (at < 0) return false;
    if (at == 0) zeros |= 1U << (of_first ? first_.size + k : k);
  }
  return true;
}

/// Whether the first facet's side i and the second's side j, coplanar at s and not parallel, cross
/// there; adds the neighbouring sides that share an end lying on the other side.
bool ContactRegion::sides_cross(std::size_t i, std::size_t j, const EventScale& s,
                                unsigned& zeros) {
  const std::size_t l = j - first_.size;
  const auto ends_part = [&](const MovingFacet& own, std::size_t k, std::size_t start,
                             const MovingFacet& other, std::size_t of_other) {
    const auto across = [&]<class T>(std::type_identity<T>) {
      const std::array<T, 3>&u = own.along[k].as<T>(), &v = other.along[of_other].as<T>();
      return cross(cross(u, v), v);
    };
    const std::size_t next = (k + 1) % own.size;
    const int before = height_at(s, other.names[of_other], own.names[k], across),
              after = height_at(s, other.names[of_other], own.names[next], across);
    if (before == 0) zeros |= 1U << (start + (k + own.size - 1) % own.size);
    if (after == 0) zeros |= 1U << (start + next);
    return before * after <= 0;
  };
  return ends_part(first_, i, 0, second_, l) && ends_part(second_, l, first_.size, first_, i);
}

/// The corner where i and j vanish, if this corner lies within the region at a scale above 0, and
/// no earlier two constraints single the corner out.
std::optional<ContactRegion::Corner> ContactRegion::corner_of(std::size_t i, std::size_t j) {
  if (have_no_scale(i, j)) return std::nullopt;
  EventScale s;
  const auto finds = [&](const auto& touch) {
    if (touch.slope == 0) return false;
    s = EventScale(-touch.height, touch.slope);
    return s.sign() > 0 && (window_ == nullptr || window_->has(s));
  };
  if (!(convolution_.words ? finds(contact<Int128>(i, j)) : finds(contact<Integer>(i, j)))) {
    return std::nullopt;
  }
  unsigned zeros = 1U << i | 1U << j;
  const bool is_edge = i < first_.size && j >= first_.size;
  if (!(is_edge ? sides_cross(i, j, s, zeros) : corner_is_inside(i, j, s, zeros))) {
    return std::nullopt;
  }
  for (std::size_t a = 0; a <= i; ++a) {
    for (std::size_t b = a + 1; b < count_; ++b) {
      if (a == i && b == j) {
        return Corner{i, j, static_cast<std::uint8_t>(zeros), std::move(s)};
      }
      if ((zeros >> a & 1U) != 0 && (zeros >> b & 1U) != 0 && turn(a, b) != 0) return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Whether the region has scales above a corner's (direction 1), or below (-1), next to the corner:
/// constraints with beta > 0 bound t from below, constraints with beta < 0 from above.
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
  contact.s = corner.s;
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

std::vector<FacetEvent> ContactRegion::events(const ScaleWindow* window) {
  window_ = window;
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
