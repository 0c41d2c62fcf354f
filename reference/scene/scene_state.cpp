#include "reference/scene/scene_state.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <tuple>

#include "reference/build/stage.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline scene {
/// The boxes within which a change can be seen, and the sum that came.
struct SceneState::Change {
  std::vector<Box> boxes;
  std::uint32_t came = no_entry;

  bool reaches(const Box& box) const {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Box& changed) { return changed.overlaps(box); });
  }
};

SceneState::SceneState(std::shared_ptr<SumStore> store, std::vector<Copy> copies,
                       const BuildOptions& options)
    : store_(std::move(store)) {
  const FloatEnvironment standard;
  const BuildControl control(options, "the union of the sums");
  copies_.reserve(copies.size());
  for (Copy& copy : copies) {
    refuse_bad_copy(copy, store_->shapes().size());
    copies_.push_back(std::make_shared<const Copy>(std::move(copy)));
  }
  place_all(options, control);
  find_all(control);
}

void SceneState::place_all(const BuildOptions& options, const BuildControl& control) {
  // Equal copies get the number of the first.
  std::map<SumStore::Key, std::uint32_t> sum_of_key;
  std::vector<SumStore::Key> keys;
  std::vector<std::pair<std::uint32_t, Point>> places;
  std::map<std::tuple<std::uint32_t, Rational, Rational>, std::uint32_t> number_of_place;
  for (const auto& copy : copies_) {
    control.look();
    SumStore::Key key{store_->shape(copy->shape), copy->scale};
    const auto [entry, is_new] = sum_of_key.emplace(key, static_cast<std::uint32_t>(keys.size()));
    if (is_new) keys.push_back(std::move(key));
    const auto [place, is_first] =
        number_of_place.emplace(std::tuple(entry->second, copy->place.x, copy->place.y),
                                static_cast<std::uint32_t>(places.size()));
    if (is_first) places.emplace_back(entry->second, copy->place);
    sum_numbers_.push_back(place->second);
  }
  const auto sums = store_->sums(keys, options, counts_);
  sums_.resize(places.size());
  in_parallel(places.size(), control, BuildProgress::Stage::patches, [&](unsigned) {
    return [&](std::size_t k) {
      sums_[k] = std::make_shared<const PlacedSum>(sums[places[k].first], places[k].second);
    };
  });
  for (const auto& sum : sums_) boxes_.push_back(sum->box);
}

void SceneState::find_all(const BuildControl& control) {
  const BoxTree tree(boxes_);
  stretches_.resize(sums_.size());
  in_parallel(sums_.size(), control, BuildProgress::Stage::pairs, [&](unsigned) {
    return [&, finder = StretchFinder(sums_, store_->passages()),
            neighbours = std::vector<std::uint32_t>()](std::size_t k) mutable {
      const auto own = static_cast<std::uint32_t>(k);
      neighbours.clear();
      tree.query(boxes_[k], [&](std::uint32_t other) {
        if (other != own) neighbours.push_back(other);
        return false;
      });
      finder.set(own, neighbours);
      auto result = std::make_shared<SumStretches>(sums_[k]->boxes.size());
      for (std::uint32_t edge = 0; edge < result->size(); ++edge) {
        control.look();
        (*result)[edge] = finder.find(edge);
      }
      stretches_[k] = std::move(result);
    };
  });
  counts_.copies_redone = copies_.size();
  for (const auto& sum : sums_) counts_.edges_redone += sum->boxes.size();
}

std::vector<Copy> SceneState::copies() const {
  std::vector<Copy> result;
  result.reserve(copies_.size());
  for (const auto& copy : copies_) result.push_back(*copy);
  return result;
}

std::vector<std::vector<std::uint32_t>> SceneState::copies_of_sums() const {
  std::vector<std::vector<std::uint32_t>> result(sums_.size());
  for (std::uint32_t k = 0; k < sum_numbers_.size(); ++k) result[sum_numbers_[k]].push_back(k);
  return result;
}

void SceneState::drop_if_unused(std::uint32_t sum, Change& change) {
  if (std::find(sum_numbers_.begin(), sum_numbers_.end(), sum) != sum_numbers_.end()) return;
  change.boxes.push_back(boxes_[sum]);
  // The last sum takes its number.
  const auto last = static_cast<std::uint32_t>(sums_.size() - 1);
  sums_[sum] = sums_[last];
  boxes_[sum] = boxes_[last];
  stretches_[sum] = stretches_[last];
  sums_.pop_back();
  boxes_.pop_back();
  stretches_.pop_back();
  std::replace(sum_numbers_.begin(), sum_numbers_.end(), last, sum);
}

std::uint32_t SceneState::number_of(const Copy& copy, Change& change) {
  const auto sum = store_->sum({store_->shape(copy.shape), copy.scale}, counts_.sums_evaluated);
  for (std::uint32_t k = 0; k < sums_.size(); ++k) {
    if (sums_[k]->sum == sum && sums_[k]->place == copy.place) return k;
  }
  change.came = static_cast<std::uint32_t>(sums_.size());
  sums_.push_back(std::make_shared<const PlacedSum>(sum, copy.place));
  boxes_.push_back(sums_.back()->box);
  stretches_.push_back(std::make_shared<const SumStretches>(sums_.back()->boxes.size()));
  change.boxes.push_back(boxes_.back());
  return change.came;
}

SceneState SceneState::with(std::uint32_t copy, const std::optional<Copy>& now,
                            const BuildOptions& options) const {
  const FloatEnvironment standard;
  const BuildControl control(options, "the union of the sums");
  if (now) refuse_bad_copy(*now, store_->shapes().size());
  SceneState next = *this;
  next.counts_ = {};
  Change change;
  const auto at = [&](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(copy); };
  std::uint32_t old = no_entry;
  if (copy < size()) {
    old = sum_numbers_[copy];
    next.copies_.erase(at(next.copies_));
    next.sum_numbers_.erase(at(next.sum_numbers_));
  }
  // The sum that goes is dropped last: the same sum may come again.
  if (now) {
    const std::uint32_t number = next.number_of(*now, change);
    next.copies_.insert(at(next.copies_), std::make_shared<const Copy>(*now));
    next.sum_numbers_.insert(at(next.sum_numbers_), number);
  }
  if (old != no_entry) {
    const auto last = static_cast<std::uint32_t>(next.sums_.size() - 1);
    next.drop_if_unused(old, change);
    if (change.came == last && next.sums_.size() == last) change.came = old;
  }
  next.redo(change, control);
  return next;
}

void SceneState::neighbours_of(std::uint32_t sum, std::vector<std::uint32_t>& result) const {
  result.clear();
  for (std::uint32_t k = 0; k < boxes_.size(); ++k) {
    if (k != sum && boxes_[k].overlaps(boxes_[sum])) result.push_back(k);
  }
}

void SceneState::redo(const Change& change, const BuildControl& control) {
  std::vector<std::uint32_t> copies(sums_.size(), 0), near;
  for (const std::uint32_t sum : sum_numbers_) ++copies[sum];
  for (std::uint32_t k = 0; k < sums_.size(); ++k) {
    if (change.reaches(boxes_[k])) near.push_back(k);
  }
  std::atomic<std::uint64_t> edges_redone{0}, copies_redone{0};
  in_parallel(near.size(), control, BuildProgress::Stage::pairs, [&](unsigned) {
    return [&, finder = StretchFinder(sums_, store_->passages()),
            neighbours = std::vector<std::uint32_t>()](std::size_t number) mutable {
      const std::uint32_t k = near[number];
      neighbours_of(k, neighbours);
      finder.set(k, neighbours);
      auto result = std::make_shared<SumStretches>(*stretches_[k]);
      std::uint64_t edges = 0;
      for (std::uint32_t edge = 0; edge < result->size(); ++edge) {
        control.look();
        if (k != change.came && !change.reaches(sums_[k]->boxes[edge])) continue;
        (*result)[edge] = finder.find(edge);
        ++edges;
      }
      if (edges == 0) return;
      stretches_[k] = std::move(result);
      edges_redone += edges;
      copies_redone += copies[k];
    };
  });
  counts_.edges_redone += edges_redone;
  counts_.copies_redone += copies_redone;
}

}  // namespace minkref::inline scene
