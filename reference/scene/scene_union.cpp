#include "reference/scene/scene_union.hpp"

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline scene {

/// What is found when first asked for.
struct SceneUnion::Kept {
  std::recursive_mutex mutex;
  std::optional<SceneBoundary> boundary;
  std::optional<Canonical> region;
  std::optional<std::vector<RingOwners>> owners;
  std::optional<std::vector<ScenePassage>> passages;
};

namespace {

/// Calls find once, for all threads.
template <class Value, class Mutex, class Find>
const Value& once(std::optional<Value>& value, Mutex& mutex, Find&& find) {
  const std::lock_guard<Mutex> lock(mutex);
  if (!value) {
    const FloatEnvironment standard;
    value.emplace(find());
  }
  return *value;
}

}  // namespace

SceneUnion::SceneUnion(Scene scene, bool passages, const BuildOptions& options)
    : SceneUnion(SceneState(std::make_shared<SumStore>(std::move(scene.robot),
                                                       std::move(scene.shapes), passages),
                            std::move(scene.copies), options),
                 options) {}

SceneUnion::SceneUnion(SceneState state, const BuildOptions&)
    : state_(std::make_shared<const SceneState>(std::move(state))),
      kept_(std::make_shared<Kept>()) {}

const SceneState& SceneUnion::outer() const { return *state_; }

void SceneUnion::require_copy(std::uint32_t copy) const {
  if (copy < state_->size()) return;
  throw BadInput("no-copy", "there is no copy " + std::to_string(copy),
                 "the scene has " + std::to_string(state_->size()) + " copies, counted from 0");
}

SceneUnion SceneUnion::with(std::uint32_t copy, const std::optional<Copy>& now,
                            const BuildOptions& options) const {
  return {state_->with(copy, now, options), options};
}

SceneUnion SceneUnion::changed(std::uint32_t copy, const Rational& scale, const Point& place,
                               const BuildOptions& options) const {
  require_copy(copy);
  return with(copy, Copy{state_->copy(copy).shape, scale, place}, options);
}

SceneUnion SceneUnion::added(const Copy& copy, const BuildOptions& options) const {
  return with(static_cast<std::uint32_t>(state_->size()), copy, options);
}

SceneUnion SceneUnion::removed(std::uint32_t copy, const BuildOptions& options) const {
  require_copy(copy);
  return with(copy, std::nullopt, options);
}

std::vector<Copy> SceneUnion::copies() const { return state_->copies(); }
const PolygonSet& SceneUnion::robot() const { return state_->store()->robot(); }
const std::vector<PolygonSet>& SceneUnion::shapes() const { return state_->store()->shapes(); }
const SceneCounts& SceneUnion::counts() const { return state_->counts(); }

const SceneBoundary& SceneUnion::boundary() const {
  return once(kept_->boundary, kept_->mutex,
              [&] { return scene_boundary(outer().sums(), outer().stretches()); });
}

const Canonical& SceneUnion::region() const {
  return once(kept_->region, kept_->mutex, [&] { return canonical_form(boundary().graph()); });
}

AddOwners SceneUnion::owners_of_edges() const {
  return [&sums = outer().sums(), copies = outer().copies_of_sums()](
             std::uint32_t number, std::uint32_t edge, std::vector<Owner>& owners) {
    const SceneSum& sum = *sums[number]->sum;
    for (const std::uint32_t copy : copies[number]) {
      for (std::uint32_t k = sum.first_contact[edge]; k < sum.first_contact[edge + 1]; ++k) {
        owners.push_back({copy, sum.contacts[k]});
      }
    }
  };
}

const std::vector<RingOwners>& SceneUnion::owners() const {
  return once(kept_->owners, kept_->mutex,
              [&] { return side_owners(region().region, boundary(), owners_of_edges()); });
}

const std::vector<ScenePassage>& SceneUnion::passages() const {
  if (!state_->store()->passages()) {
    throw BadInput("no-passages", "this scene was made without tight passages",
                   "make it with them");
  }
  return once(kept_->passages, kept_->mutex, [&] {
    if (robot().is_point()) return std::vector<ScenePassage>();  // a point's seams are blocked
    return scene_passages(outer().sums(), outer().stretches(), boundary(), owners_of_edges());
  });
}

Canonical SceneUnion::sum_of(std::uint32_t copy) const {
  require_copy(copy);
  const FloatEnvironment standard;
  const PlacedSum& placed = state_->sum_of(copy);
  PolygonSet rings;
  Ring ring;
  for (std::uint32_t edge = 0; edge < placed.sum->boundary; ++edge) {
    ring.push_back(placed.start(edge).exact());
    const SceneSum::Edge& own = placed.sum->edges[edge];
    if (own.to <= own.from) rings.polygons.push_back({std::exchange(ring, {}), {}});
  }
  return canonicalize(rings);
}

}  // namespace minkref::inline scene
