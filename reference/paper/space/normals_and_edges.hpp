// One body's facets and the other's edges with one arithmetic: the degree of incompatibility and
// its witness, as read.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/number/scalar.hpp"
#include "reference/paper/space/repair_readings.hpp"
#include "reference/space/convex/convex_polyhedron.hpp"

namespace minkref::inline space {

template <class T>
using Vector3 = std::array<T, 3>;

/// A vertex seen from a facet.
template <class T>
struct Fan {
  bool compatible = false;
  std::uint32_t witness = 0;  ///< the half-edge of the greatest degree, the first of equals
  T degree{};                 ///< times the length of the normal
};

template <class T>
class NormalsAndEdges {
 public:
  /// `of_P`: the normals belong to P, the scaled body, and the edges to Q; else the other way
  /// round.
  NormalsAndEdges(const ConvexPolyhedron& normals, const ConvexPolyhedron& edges, bool of_P,
                  const Arithmetic<T>& arithmetic, const RepairReadings& readings)
      : normals_body_(normals), body_(edges), of_P_(of_P), readings_(readings) {
    for (std::uint32_t f = 0; f < normals.facets(); ++f) {
      normals_.push_back(rounded(normals.normal(f), 1, arithmetic));
    }
    for (std::uint32_t h = 0; h < edges.half_edges(); ++h) {
      edges_.push_back(rounded(edges.vector(h), edges.denominator(), arithmetic));
    }
    scaled_normals_ = normals_;
    scaled_edges_ = edges_;
  }

  bool of_P() const { return of_P_; }
  const ConvexPolyhedron& body() const { return body_; }  ///< the edges' body

  /// The normal of a scaled facet is n_i / s_i, a scaled edge s_i d_i.
  void rescale(const Vector3<T>& factors) {
    if (of_P_) {
      for (std::size_t f = 0; f < normals_.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) scaled_normals_[f][i] = normals_[f][i] / factors[i];
      }
    } else {
      for (std::size_t h = 0; h < edges_.size(); ++h) {
        for (std::size_t i = 0; i < 3; ++i) scaled_edges_[h][i] = edges_[h][i] * factors[i];
      }
    }
  }

  /// The sign of n . d; never 0 with Ties::perturbed.
  int side(std::uint32_t facet, std::uint32_t half_edge) const {
    return side(facet, half_edge, product(facet, half_edge));
  }

  Fan<T> look(std::uint32_t facet, std::uint32_t vertex) const {
    Fan<T> fan;
    bool rises = false, any = false;
    for (std::uint32_t h = body_.first(vertex); h < body_.first(vertex + 1); ++h) {
      T rise = product(facet, h);
      const int above = side(facet, h, rise);
      rises = rises || above > 0;
      if (readings_.degree == Form::corrected) {
        if (above <= 0) continue;
      } else if (sign(rise) < 0) {
        rise = -rise;
      }
      if (any && sign(T(rise - fan.degree)) <= 0) continue;
      any = true;
      fan.degree = rise;
      fan.witness = h;
    }
    fan.compatible = readings_.test == RepairReadings::Test::sides ? !rises
                     : readings_.degree == Form::corrected         ? !any
                                                                   : sign(fan.degree) == 0;
    return fan;
  }

  /// Over the squared length of the normal.
  T squared_degree(std::uint32_t facet, const T& degree) const {
    const Vector3<T>& n = scaled_normals_[facet];
    const T square = degree * degree;
    const T length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return T(square / length);
  }

 private:
  static Vector3<T> rounded(const IntegerVector& vector, const Integer& denominator,
                            const Arithmetic<T>& arithmetic) {
    return {arithmetic(Rational(vector[0], denominator)),
            arithmetic(Rational(vector[1], denominator)),
            arithmetic(Rational(vector[2], denominator))};
  }

  T product(std::uint32_t facet, std::uint32_t half_edge) const {
    const Vector3<T>& n = scaled_normals_[facet];
    const Vector3<T>& d = scaled_edges_[half_edge];
    return T(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
  }

  int side(std::uint32_t facet, std::uint32_t half_edge, const T& product) const {
    const int above = sign(product);
    if (above != 0 || readings_.ties != RepairReadings::Ties::perturbed) return above;
    // P moved by the infinitesimal map of facet_contact.hpp: the first nonzero n_i d_j decides.
    const IntegerVector edge = body_.vector(half_edge);
    for (const Integer& n : normals_body_.normal(facet)) {
      for (const Integer& d : edge) {
        const int first = sign(n) * sign(d);
        if (first != 0) return of_P_ ? -first : first;
      }
    }
    return 0;  // neither vector is zero
  }

  const ConvexPolyhedron& normals_body_;
  const ConvexPolyhedron& body_;
  bool of_P_;
  RepairReadings readings_;
  std::vector<Vector3<T>> normals_, edges_, scaled_normals_, scaled_edges_;
};

}  // namespace minkref::inline space
