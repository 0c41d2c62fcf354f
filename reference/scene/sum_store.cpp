#include "reference/scene/sum_store.hpp"

#include <algorithm>

#include "reference/build/stage.hpp"

namespace minkref::inline scene {

SumStore::SumStore(PolygonSet robot, std::vector<PolygonSet> shapes, bool passages)
    : robot_(std::move(robot)),
      reflected_(scaled(robot_, -1)),
      shapes_(std::move(shapes)),
      passages_(passages),
      prepared_(shapes_.size()) {
  refuse_without_area(robot_, shapes_);
  for (std::uint32_t k = 0; k < shapes_.size(); ++k) {
    const auto first = std::find(shapes_.begin(), shapes_.end(), shapes_[k]);
    same_.push_back(static_cast<std::uint32_t>(first - shapes_.begin()));
  }
}

void SumStore::forget_unused() {
  if (sums_.size() < 2 * kept_ + 1000) return;
  std::erase_if(sums_, [](const auto& entry) { return entry.second.expired(); });
  kept_ = sums_.size();
}

SceneSum SumStore::found_sum(const Key& key) {
  const auto& [number, scale] = key;
  const PolygonSet& shape = shapes_[number];
  if (shape.empty() || robot_.empty()) {
    SceneSum none;
    none.first_contact.push_back(0);
    return none;
  }
  std::shared_ptr<const ScaleIndex> index;
  const SceneConvolution* convolution = nullptr;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    Shape& prepared = prepared_[number];
    if (!prepared.convolution) prepared.convolution.emplace(shape, reflected_);
    convolution = &*prepared.convolution;
    index = prepared.index;
  }
  // A point has no passages: the union of the open obstacles has all of the closed one's interior.
  const Passages passages = passages_ && !robot_.is_point() ? Passages::find : Passages::leave;
  const bool within = index && *index->window().from <= scale && scale <= *index->window().to;
  return scene_sum(
      within ? index->sum(scale, passages)
             : minkowski_sum(shape, reflected_, scale, Route::paper, "rational", passages),
      *convolution, scale);
}

std::shared_ptr<const SceneSum> SumStore::sum(const Key& key, std::uint64_t& evaluated) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = sums_.find(key);
    if (found != sums_.end()) {
      if (auto sum = found->second.lock()) return sum;
    }
  }
  auto sum = std::make_shared<const SceneSum>(found_sum(key));
  ++evaluated;
  const std::lock_guard<std::mutex> lock(mutex_);
  forget_unused();
  auto& kept = sums_[key];
  if (auto other = kept.lock()) return other;  // another thread was faster
  kept = sum;
  return sum;
}

void SumStore::build_indices(const std::vector<Key>& keys, const BuildOptions& options,
                             SceneCounts& counts) {
  std::vector<std::vector<const Rational*>> scales(shapes_.size());
  for (const Key& key : keys) scales[key.first].push_back(&key.second);
  BuildOptions quiet = options;
  quiet.progress = nullptr;
  for (std::uint32_t k = 0; k < scales.size(); ++k) {
    if (scales[k].size() < many_scales || shapes_[k].empty() || robot_.empty()) continue;
    const auto [least, greatest] =
        std::minmax_element(scales[k].begin(), scales[k].end(),
                            [](const Rational* a, const Rational* b) { return *a < *b; });
    prepared_[k].index = std::make_shared<const ScaleIndex>(
        shapes_[k], reflected_, ScaleWindow{**least, **greatest}, quiet);
    ++counts.indices_built;
  }
}

std::vector<std::shared_ptr<const SceneSum>> SumStore::sums(const std::vector<Key>& keys,
                                                            const BuildOptions& options,
                                                            SceneCounts& counts) {
  const BuildControl control(options, "the union of the sums");
  build_indices(keys, options, counts);
  std::vector<std::shared_ptr<const SceneSum>> result(keys.size());
  std::vector<std::uint64_t> evaluated(control.threads(), 0);
  in_parallel(keys.size(), control, BuildProgress::Stage::cells, [&](unsigned thread) {
    return [&, thread](std::size_t k) { result[k] = sum(keys[k], evaluated[thread]); };
  });
  for (const std::uint64_t count : evaluated) counts.sums_evaluated += count;
  return result;
}

}  // namespace minkref::inline scene
