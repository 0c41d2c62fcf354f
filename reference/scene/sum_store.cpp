#include "reference/scene/sum_store.hpp"

#include <algorithm>

#include "reference/build/stage.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline scene {
namespace {

void add_rings(const RationalRings& rings, SceneSum& sum) {
  const IntegerColumn numbers = rings.column();
  std::size_t k = 0;
  for (const std::uint32_t end : rings.ring_ends) {
    std::vector<FilteredPoint> points;
    points.reserve(end - k);
    for (; k < end; ++k)
      points.emplace_back(Point{numbers.reduced(4 * k), numbers.reduced(4 * k + 2)});
    sum.add_ring(std::move(points));
  }
}

void add_rings(const PolygonSet& region, SceneSum& sum) {
  for (const Polygon& polygon : region.polygons) {
    sum.add_ring({polygon.outer.begin(), polygon.outer.end()});
    for (const Ring& hole : polygon.holes) sum.add_ring({hole.begin(), hole.end()});
  }
}

void add_passages(const std::vector<TightPassage>& passages, SceneSum& sum) {
  for (const TightPassage& passage : passages) sum.add_passage(passage);
}

}  // namespace

SumStore::SumStore(PolygonSet robot, std::vector<PolygonSet> shapes, bool passages)
    : robot_(std::move(robot)),
      reflected_(scaled(robot_, -1)),
      shapes_(std::move(shapes)),
      passages_(passages),
      indices_(shapes_.size()),
      convolutions_(shapes_.size()) {
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

const SceneConvolution& SumStore::convolution(std::uint32_t shape) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::optional<SceneConvolution>& found = convolutions_[shape];
  if (!found) found.emplace(shapes_[shape], reflected_);
  return *found;
}

const SumContacts& SumStore::contacts(const SceneSum& sum) {
  return sum.contacts([&]() -> const SceneConvolution& { return convolution(sum.shape); });
}

std::shared_ptr<const SceneSum> SumStore::found_sum(const Key& key) const {
  const auto& [number, scale] = key;
  const PolygonSet& shape = shapes_[number];
  auto sum = std::make_shared<SceneSum>(number, scale);
  if (shape.empty() || robot_.empty()) return sum;
  // A point has no passages: the union of the open obstacles has all of the closed one's interior.
  const bool passages = passages_ && !robot_.is_point();
  const std::optional<ScaleIndex>& index = indices_[number];
  if (index && *index->window().from <= scale && scale <= *index->window().to) {
    RationalRings rings;
    index->rings(scale, rings);
    add_rings(rings, *sum);
    if (passages) add_passages(tight_passages(shape, reflected_, scale), *sum);
  } else {
    const Sum found = minkowski_sum(shape, reflected_, scale, Route::paper, "rational",
                                    passages ? Passages::find : Passages::leave);
    add_rings(found.region, *sum);
    if (passages) add_passages(*found.tight_passages, *sum);
  }
  sum->finish();
  return sum;
}

std::shared_ptr<const SceneSum> SumStore::sum(const Key& key, std::uint64_t& evaluated) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = sums_.find(key);
    if (found != sums_.end()) {
      if (auto sum = found->second.lock()) return sum;
    }
  }
  auto sum = found_sum(key);
  ++evaluated;
  const std::lock_guard<std::mutex> lock(mutex_);
  forget_unused();
  auto& kept = sums_[key];
  if (auto other = kept.lock()) return other;  // another thread was faster
  kept = sum;
  return sum;
}

void SumStore::build_indices(const std::vector<Key>& keys, const BuildOptions& options,
                             const BuildControl& control, SceneCounts& counts) {
  std::vector<std::vector<const Rational*>> scales(shapes_.size());
  for (const Key& key : keys) scales[key.first].push_back(&key.second);
  std::vector<std::uint32_t> many;
  for (std::uint32_t k = 0; k < scales.size(); ++k) {
    if (scales[k].size() >= many_scales && !shapes_[k].empty() && !robot_.empty())
      many.push_back(k);
  }
  BuildOptions quiet = options;
  quiet.progress = nullptr;
  if (many.empty()) return;
  quiet.threads = std::max(1U, control.threads() / static_cast<unsigned>(many.size()));
  in_parallel(many.size(), control, BuildProgress::Stage::cells, [&](unsigned thread) {
    // A build in another thread hears when this loop ends.
    std::unique_ptr<const Interruptible> heard;
    if (thread != 0) heard = std::make_unique<Interruptible>([&] { control.end_if_stopped(); });
    return [&, heard = std::move(heard)](std::size_t number) {
      const std::uint32_t k = many[number];
      const auto [least, greatest] =
          std::minmax_element(scales[k].begin(), scales[k].end(),
                              [](const Rational* a, const Rational* b) { return *a < *b; });
      indices_[k].emplace(shapes_[k], reflected_, ScaleWindow{**least, **greatest}, quiet);
    };
  });
  counts.indices_built += many.size();
}

std::vector<std::shared_ptr<const SceneSum>> SumStore::sums(const std::vector<Key>& keys,
                                                            const BuildOptions& options,
                                                            SceneCounts& counts) {
  const BuildControl control(options, "the union of the sums");
  build_indices(keys, options, control, counts);
  std::vector<std::shared_ptr<const SceneSum>> result(keys.size());
  std::vector<std::uint64_t> evaluated(control.threads(), 0);
  in_parallel(keys.size(), control, BuildProgress::Stage::cells, [&](unsigned thread) {
    return [&, thread](std::size_t k) { result[k] = sum(keys[k], evaluated[thread]); };
  });
  for (const std::uint64_t count : evaluated) counts.sums_evaluated += count;
  return result;
}

}  // namespace minkref::inline scene
