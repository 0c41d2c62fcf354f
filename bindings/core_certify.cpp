// Proofs of sums for Python: steps of certificates.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "certify/plane/step_text.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Numbers = std::array<std::string, 4>;
using Steps = std::pair<std::size_t, std::size_t>;
/// A passage's points, and the elements along the passage.
using Passage = std::pair<std::vector<ExactPoint>, std::vector<std::uint32_t>>;
/// A step; the sum, components and holes; its passages; points that its rings pass more than once.
using Proof = std::tuple<std::string, Set, std::size_t, std::size_t, std::vector<Passage>,
                         std::vector<ExactPoint>>;
/// x0, x1, y0, y1: the point (x0 + s x1, y0 + s y1).
using Vertex = std::array<std::string, 4>;
/// A step; from, to; the vertices by polygon and ring; components and holes; points that the rings
/// pass more than once.
using MovingProof =
    std::tuple<std::string, std::string, std::string, std::vector<std::vector<std::vector<Vertex>>>,
               std::size_t, std::size_t, std::vector<Vertex>>;

Vertex vertex(const certify::MovingPoint& p) {
  return {to_string(p.constant.x), to_string(p.slope.x), to_string(p.constant.y),
          to_string(p.slope.y)};
}

std::array<Rational, 4> box_of(const Numbers& numbers) {
  std::array<Rational, 4> box;
  for (std::size_t i = 0; i < 4; ++i) box[i] = parse_rational(numbers[i]);
  return box;
}

Numbers box(const certify::Prover& prover, const std::string& largest) {
  Numbers numbers;
  const auto box = prover.box(parse_rational(largest));
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = to_string(box[i]);
  return numbers;
}

Proof prove(certify::Prover& prover, const std::string& scale, const Numbers& box, const Steps& by,
            bool passages) {
  const Rational s = parse_rational(scale);
  Sum sum = minkowski_sum(prover.P(), prover.Q(), s, Route::paper, "rational",
                          passages ? Passages::find : Passages::leave);
  const certify::SumProof proof = prover.prove(sum, s, box_of(box));
  std::vector<Passage> found;
  for (std::size_t i = 0; i < proof.passages.size(); ++i) {
    auto& [points, path] = found.emplace_back();
    path = proof.passages[i];
    for (const Point& p : proof.passage_points[i]) points.push_back(to_strings(p));
  }
  std::vector<ExactPoint> touching;
  for (const certify::MovingPoint& p : proof.touching) touching.push_back(to_strings(p.constant));
  return {certify::sum_text(proof, by.first, by.second),
          Set{std::move(sum.region), true},
          sum.components,
          sum.holes,
          std::move(found),
          std::move(touching)};
}

std::optional<MovingProof> prove_around(certify::Prover& prover, const std::string& scale,
                                        const Numbers& box, const Steps& by,
                                        const std::string& from, const std::string& to) {
  const Rational s = parse_rational(scale);
  const Sum sum = minkowski_sum(prover.P(), prover.Q(), s);
  const auto proof =
      prover.prove_around(sum, s, box_of(box), parse_rational(from), parse_rational(to));
  if (!proof) return std::nullopt;
  std::vector<std::vector<std::vector<Vertex>>> polygons;
  for (const auto& rings : proof->vertices) {
    auto& polygon = polygons.emplace_back();
    for (const auto& ring : rings) {
      auto& vertices = polygon.emplace_back();
      for (const certify::MovingPoint& p : ring) vertices.push_back(vertex(p));
    }
  }
  std::vector<Vertex> touching;
  for (const certify::MovingPoint& p : proof->touching) touching.push_back(vertex(p));
  return MovingProof{certify::sum_text(*proof, by.first, by.second),
                     to_string(proof->scales[0]),
                     to_string(proof->scales[1]),
                     std::move(polygons),
                     sum.components,
                     sum.holes,
                     std::move(touching)};
}

}  // namespace

void bind_certify(nb::module_& module) {
  nb::class_<certify::Prover>(module, "Prover",
                              "Proofs of sums, as steps of certificates (docs/certificates.md).")
      .def(
          "__init__",
          [](certify::Prover* self, const Set& P, const Set& Q) {
            new (self) certify::Prover(P.value, Q.value);
          },
          "P"_a, "Q"_a, Released())
      .def(
          "pieces",
          [](const certify::Prover& self, const std::string& operand) {
            const bool first = operand == "P";
            return certify::pieces_text(first ? self.pieces_of_P() : self.pieces_of_Q(), operand);
          },
          "operand"_a, Released(), "The step `pieces` of operand P or Q.")
      .def("box", &box, "largest"_a, Released(),
           "A box that holds the sums at all scales up to the largest: left, bottom, right, top.")
      .def("prove", &prove, "scale"_a, "box"_a, "by"_a, "passages"_a = false, Released(),
           "The step `eq` at a scale; the sum, its components and holes; its tight passages, as "
           "points and elements of the step; points that its rings pass more than once. Exact.")
      .def("prove_around", &prove_around, "scale"_a, "box"_a, "by"_a, "from_scale"_a, "to_scale"_a,
           Released(),
           "The step `move` around a scale, as far as it goes within two; those scales; the "
           "vertices (x0, x1, y0, y1) by polygon and ring; components and holes; points that the "
           "rings pass more than once. None if the proof at this scale goes nowhere. Exact.");
}

}  // namespace minkref::python
