#include "reference/scene/edge_stretches.hpp"

#include <algorithm>
#include <limits>

#include "reference/plane/location.hpp"

namespace minkref::inline scene {
namespace {

/// For an edge wholly on the boundary.
std::shared_ptr<const EdgeStretches> whole_edge() {
  static const auto whole = [] {
    auto result = std::make_shared<EdgeStretches>();
    result->pieces.push_back({0, 1, false});
    return result;
  }();
  return whole;
}

/// Whether a point lies in the open sum.
bool in_open_sum(const PlacedSum& sum, const FilteredPoint& point) {
  Box level = box_of(point);
  if (!sum.box.overlaps(level)) return false;
  level.xmax = std::numeric_limits<double>::infinity();
  int winding = 0;
  bool on_edge = false;
  sum.near(level, [&](std::uint32_t edge) {
    int of_passage = 0;
    on_edge = add_winding(sum.start(edge), sum.end(edge), point,
                          sum.is_boundary(edge) ? winding : of_passage) ||
              on_edge;
  });
  return !on_edge && winding > 0;
}

}  // namespace

void StretchFinder::set(std::uint32_t own, std::span<const std::uint32_t> neighbours) {
  own_ = sums_[own].get();
  neighbours_ = neighbours;
  states_.assign(neighbours.size(), State{});
  group_ = 0;
  favourite_ = 0;
}

std::shared_ptr<const EdgeStretches> StretchFinder::find(std::uint32_t edge) {
  if (own_->is_point(edge)) return find_point(edge);
  is_passage_ = !own_->is_boundary(edge);
  if (!start(edge)) return nullptr;
  if (contacts_.empty() && !passages_) {
    return kind() == Kind::boundary ? whole_edge() : nullptr;
  }
  EdgeStretches result;
  sweep(result);
  if (result.pieces.empty() && result.points.empty()) return nullptr;
  if (result.points.empty() && result.pieces.size() == 1 && result.cuts.empty() &&
      !result.pieces[0].tight) {
    return whole_edge();
  }
  return std::make_shared<const EdgeStretches>(std::move(result));
}

std::shared_ptr<const EdgeStretches> StretchFinder::find_point(std::uint32_t edge) const {
  const FilteredPoint& point = own_->start(edge);
  if (std::any_of(neighbours_.begin(), neighbours_.end(),
                  [&](std::uint32_t k) { return in_open_sum(*sums_[k], point); })) {
    return nullptr;
  }
  auto result = std::make_shared<EdgeStretches>();
  result->points.push_back(0);
  return result;
}

/// The neighbour's state just behind the edge's start, and its contacts. False if its open sum has
/// the whole edge: then nothing counts.
bool StretchFinder::start_beside(std::uint32_t neighbour, std::uint32_t edge, EndContacts& ends) {
  const PlacedSum& other = sum(neighbour);
  State& state = states_[neighbour];
  const std::size_t before = contacts_.size();
  ends = line_.meet(other, neighbour, contacts_);
  const SceneSum::Edge& own = own_->sum->edges[edge];
  const bool known = state.edge == own.before && own.before != edge;
  if (!other.box.overlaps(box_of(own_->start(edge)))) {
    state.right = 0;
  } else if (!known || ends.start) {
    state.right = line_.winding_beside(other);
  }
  state.along = static_cast<int>(ends.along);
  state.touches_end = ends.end;
  state.meets = true;
  state.edge = edge;
  return contacts_.size() != before || ends.start || ends.end || !state.open();
}

bool StretchFinder::start(std::uint32_t edge) {
  contacts_.clear();
  covers_ = opens_ = 0;
  start_in_one_ = false;
  const Box& box = own_->boxes[edge];
  line_.set(own_->start(edge), own_->end(edge), box);
  const auto add = [&](std::uint32_t k) {
    EndContacts ends;
    if (!start_beside(k, edge, ends)) {
      favourite_ = k;
      // Contacts with other sums stay unpassed.
      for (State& state : states_) state.edge = no_entry;
      return false;
    }
    count(states_[k], 1);
    start_in_one_ = start_in_one_ || (states_[k].open() && !ends.start);
    return true;
  };
  for (State& state : states_) state.meets = false;
  const auto size = static_cast<std::uint32_t>(neighbours_.size());
  if (favourite_ < size && sum(favourite_).box.overlaps(box) && !add(favourite_)) return false;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (!states_[k].meets && sum(k).box.overlaps(box) && !add(k)) return false;
  }
  const auto& touches = own_->sum->touches;
  auto touch = std::lower_bound(touches.begin(), touches.end(), std::pair(edge, 0U));
  for (; touch != touches.end() && touch->first == edge; ++touch) {
    EdgeContact contact;
    contact.neighbour = size;
    line_.touch(*own_, touch->second, contact, contacts_);
  }
  return true;
}

void StretchFinder::count(const State& state, int sign) {
  covers_ += static_cast<std::uint32_t>(state.right != 0 ? sign : 0);
  opens_ += static_cast<std::uint32_t>(state.open() ? sign : 0);
}

StretchFinder::Kind StretchFinder::kind() const {
  if (covers_ == 0 && !is_passage_) return Kind::boundary;
  return passages_ && opens_ == 0 ? Kind::tight : Kind::covered;
}

/// Passes all contacts at one point from `first` on; returns the first contact behind. Tells
/// whether some open sum has the point.
std::size_t StretchFinder::pass_group(std::size_t first, bool& hidden_in_one) {
  const auto sums = [&](std::uint32_t k) -> const PlacedSum& { return sum(k); };
  std::size_t end = first + 1;
  while (end < contacts_.size() && !line_.before(contacts_[first], contacts_[end], sums)) ++end;
  ++group_;
  std::uint32_t through = opens_;
  for (std::size_t i = first; i < end; ++i) {
    const EdgeContact& contact = contacts_[i];
    if (contact.neighbour == neighbours_.size()) continue;
    State& state = states_[contact.neighbour];
    if (state.group != group_ && state.open()) --through;
    state.group = group_;
    count(state, -1);
    state.right += contact.right;
    state.along += contact.along;
    count(state, 1);
  }
  hidden_in_one = through != 0;
  return end;
}

void StretchFinder::sweep(EdgeStretches& result) {
  const auto sums = [&](std::uint32_t k) -> const PlacedSum& { return sum(k); };
  std::sort(contacts_.begin(), contacts_.end(),
            [&](const EdgeContact& a, const EdgeContact& b) { return line_.before(a, b, sums); });
  Kind now = kind();
  if (passages_ && now == Kind::covered && !start_in_one_) result.points.push_back(0);
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < contacts_.size();) {
    const Kind was = now;
    bool hidden_in_one = false;
    const std::size_t first = i;
    i = pass_group(i, hidden_in_one);
    now = kind();
    const bool alone = was == Kind::covered && now == Kind::covered;
    if (alone && (hidden_in_one || !passages_)) continue;
    const auto node = static_cast<std::uint32_t>(result.cuts.size() + 2);
    result.cuts.push_back(line_.point(contacts_[first], sums(contacts_[first].neighbour)));
    if (alone) result.points.push_back(node);
    if (was != Kind::covered) result.pieces.push_back({begin, node, was == Kind::tight});
    begin = node;
  }
  if (now != Kind::covered) {
    result.pieces.push_back({begin, 1, now == Kind::tight});
  } else if (passages_ && is_passage_ &&
             std::none_of(states_.begin(), states_.end(), [&](const State& state) {
               return state.meets && state.open() && !state.touches_end;
             })) {
    result.points.push_back(1);
  }
}

}  // namespace minkref::inline scene
