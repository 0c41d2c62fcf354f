#include "oracle/checker/motion/path_clear.hpp"

#include <algorithm>

namespace minkref::checker {

Vector read_normal(const Value& value) {
  const auto& pair = items(value, 2);
  const Vector normal{whole(pair[0]), whole(pair[1])};
  require(normal.x != 0 || normal.y != 0, "a normal is zero");
  return normal;
}

Clear::Clear(const PiecesOfBoth& by, bool strict_, MovingPath path_, Scales scales_,
             const Value& normals, const Value& codes, const mpz_class& unit, Normals& table,
             Budget& budget)
    : strict(strict_),
      path(std::move(path_)),
      scales(std::move(scales_)),
      by_(by),
      unit_(unit),
      table_(table),
      budget_(budget) {
  for (const Value& normal : items(normals)) normals_.push_back(read_normal(normal));
  const auto ways = segments(path);
  const auto& all = items(codes, ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    try {
      follow(Way(by_, ways[i], scales, unit_, table_), items(all[i]));
    } catch (const NotVerified& error) {
      throw NotVerified(error.code, "segment " + std::to_string(i) + ": " + error.what());
    }
  }
}

Cell Clear::left(const Cell& cell, const Gap& gap) const {
  budget_.spend(cell.size());
  const bool overlap = strict || std::any_of(cell.begin(), cell.end(),
                                             [&](const Corner& c) { return gap.at(c) < 0; });
  if (!overlap) return {};
  Cell rest = not_above(gap, cell);
  return scales.meet(rest) ? rest : Cell{};
}

void Clear::follow(const Way& way, const std::vector<Value>& code) const {
  struct Entry {
    Cell cell;
    std::uint32_t A, B;
  };
  std::vector<Entry> stack;
  if (!is_empty()) stack.push_back({way.cell(), by_[0]->last(), by_[1]->last()});
  for (const Value& token : code) {
    const mpz_class what = integer(token);
    budget_.spend(1);
    demand(!stack.empty(), "a code goes on after its end");
    Entry entry = std::move(stack.back());
    stack.pop_back();
    if (what == -1 || what == -2) {
      const bool of_R = what == -1;
      const auto& children = of_R ? by_[0]->children[entry.A] : by_[1]->children[entry.B];
      demand(!children.empty(), "a code splits a piece");
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        stack.push_back({entry.cell, of_R ? *child : entry.A, of_R ? entry.B : *child});
      }
    } else if (what == -3) {
      for (Cell& half : halves(entry.cell)) {
        stack.push_back({std::move(half), entry.A, entry.B});
      }
    } else {
      const Vector& normal = normals_[index(token, normals_.size())];
      Cell rest = left(entry.cell, way.gap(normal, entry.A, entry.B));
      if (!rest.empty()) stack.push_back({std::move(rest), entry.A, entry.B});
    }
  }
  demand(stack.empty(), "a code ends too early");
}

bool Clear::apart(const MovingPlace& place, const Vector& normal) const {
  if (is_empty()) return true;
  const Way way(by_, {place, place}, scales, unit_, table_);
  return left(way.cell(), way.gap(normal, by_[0]->last(), by_[1]->last())).empty();
}

}  // namespace minkref::checker
