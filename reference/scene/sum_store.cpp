#include "reference/scene/sum_store.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include "reference/build/stage.hpp"

namespace minkref::inline scene {

SumStore::SumStore(PolygonSet robot, std::vector<PolygonSet> shapes, bool passages)
    : robot_(std::move(robot)),
      reflected_(scaled(robot_, -1)),
      shapes_(std::move(shapes)),
      passages_(passages),
      convolutions_(shapes_.size()) {
  refuse_without_area(robot_, shapes_);
  for (std::uint32_t k = 0; k < shapes_.size(); ++k) {
    const auto first = std::find(shapes_.begin(), shapes_.end(), shapes_[k]);
    same_.push_back(static_cast<std::uint32_t>(first - shapes_.begin()));
  }
}

const std::vector<ConvolutionEdge>& SumStore::convolution(std::uint32_t shape) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto& known = convolutions_[shape];
  if (!known) known = reduced_convolution(shapes_[shape], reflected_);
  return *known;
}

void SumStore::forget_unused() {
  if (sums_.size() < 2 * kept_ + 1000) return;
  std::erase_if(sums_, [](const auto& entry) { return entry.second.expired(); });
  kept_ = sums_.size();
}

std::shared_ptr<const SceneSum> SumStore::sum(const Key& key, std::uint64_t& evaluated) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = sums_.find(key);
    if (found != sums_.end()) {
      if (auto sum = found->second.lock()) return sum;
    }
  }
  auto sum = std::make_shared<SceneSum>();
  const PolygonSet& shape = shapes_[key.first];
  if (shape.empty() || robot_.empty()) {
    sum->first_contact.push_back(0);
  } else {
    // A point has no passages: the union of the open obstacles has all of the closed one's
    // interior.
    const bool passages = passages_ && !robot_.is_point();
    *sum = scene_sum(shape, reflected_, convolution(key.first), key.second,
                     passages ? Passages::find : Passages::leave);
  }
  ++evaluated;
  const std::lock_guard<std::mutex> lock(mutex_);
  forget_unused();
  auto& kept = sums_[key];
  if (auto other = kept.lock()) return other;  // another thread was faster
  kept = sum;
  return sum;
}

std::vector<std::shared_ptr<const SceneSum>> SumStore::sums(const std::vector<Key>& keys,
                                                            const BuildControl& control,
                                                            std::uint64_t& evaluated) {
  std::vector<std::shared_ptr<const SceneSum>> result(keys.size());
  std::vector<std::uint64_t> counts(control.threads(), 0);
  in_parallel(keys.size(), control, BuildProgress::Stage::cells, [&](unsigned thread) {
    return [&, thread](std::size_t k) { result[k] = sum(keys[k], counts[thread]); };
  });
  for (const std::uint64_t count : counts) evaluated += count;
  return result;
}

}  // namespace minkref::inline scene
