#include "oracle/checker/space/solid_tiling.hpp"

#include <utility>

namespace minkref::checker {
namespace {

constexpr std::size_t most_pairs = 20'000;  // of pieces

}  // namespace

Tiling checked_tiling(std::array<Body, 2>& bodies, const Value& pieces_of_P,
                      const Value& pieces_of_Q, Budget& budget) {
  PieceList first = read_pieces(pieces_of_P, bodies[0]);
  Tiling tiling{1, {std::move(first), read_pieces(pieces_of_Q, bodies[1])}, {}};
  demand(tiling.lists[0].hulls.size() * tiling.lists[1].hulls.size() <= most_pairs,
         "there are too many pairs of pieces", Code::out_of_budget);
  for (const PieceList& list : tiling.lists) add_denominators(list.points, tiling.unit, budget);
  const mpq_class whole(tiling.unit);
  for (std::size_t k = 0; k < 2; ++k) {
    Body& body = bodies[k];
    for (const Triple& point : tiling.lists[k].points) {
      body.points.push_back(times({whole, whole, whole}, point));
    }
    within("the pieces of " + body.name, [&] {
      tiling.pieces[k] = hulls_of(tiling.lists[k], body.points, budget);
      check_tiling(body, tiling.pieces[k], budget);
    });
  }
  return tiling;
}

}  // namespace minkref::checker
