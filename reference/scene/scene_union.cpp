#include "reference/scene/scene_union.hpp"

#include <mutex>
#include <string>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/sum.hpp"
#include "reference/scene/copy_contacts.hpp"

namespace minkref::inline scene {

/// Answers found on demand.
struct SceneUnion::Kept {
  std::recursive_mutex mutex;
  std::optional<SceneBoundary> boundary;
  std::optional<Canonical> region;
  std::optional<std::vector<RingOwners>> owners;
  std::optional<SceneTightGraph> tight;
  std::optional<ScenePassages> passages;
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

Point moved(const Point& point, const Point& by) { return {point.x + by.x, point.y + by.y}; }

/// Whether parts of one line share more than a point; a point shares itself.
bool shares(const Segment& a, const Segment& b) {
  const auto ends = [](const Segment& s) {
    return compare_xy(s.start, s.end) < 0 ? std::pair(s.start, s.end) : std::pair(s.end, s.start);
  };
  const auto [a0, a1] = ends(a);
  const auto [b0, b1] = ends(b);
  const int left = compare_xy(a0, b1), right = compare_xy(b0, a1);
  return compare_xy(a0, a1) == 0 ? left <= 0 && right <= 0 : left < 0 && right < 0;
}

PolygonSet origin() {
  PolygonSet point;
  point.polygons.emplace_back().outer.emplace_back();
  return point;
}

}  // namespace

SceneUnion SceneUnion::of(const PolygonSet& robot, std::vector<PolygonSet> shapes,
                          std::vector<Copy> copies, bool passages, const BuildOptions& options) {
  return {SceneState(std::make_shared<SumStore>(robot, std::move(shapes), passages),
                     std::move(copies), options),
          nullptr};
}

SceneUnion SceneUnion::beside_segment(SceneUnion obstacles, const PolygonSet& robot, bool passages,
                                      const BuildOptions& options) {
  std::vector<PolygonSet> shapes;
  std::vector<Copy> copies;
  for (const Polygon& obstacle : obstacles.region().region.polygons) {
    copies.push_back({static_cast<std::uint32_t>(shapes.size()), 1, {}});
    shapes.push_back({{obstacle}});
  }
  return {SceneState(std::make_shared<SumStore>(robot, std::move(shapes), passages),
                     std::move(copies), options),
          std::make_shared<const SceneUnion>(std::move(obstacles))};
}

SceneUnion SceneUnion::of(Scene scene, bool passages, const BuildOptions& options) {
  if (!scene.robot.is_segment()) {
    return of(scene.robot, std::move(scene.shapes), std::move(scene.copies), passages, options);
  }
  const FloatEnvironment standard;
  return beside_segment(
      of(origin(), std::move(scene.shapes), std::move(scene.copies), false, options), scene.robot,
      passages, options);
}

SceneUnion::SceneUnion(Scene scene, bool passages, const BuildOptions& options)
    : SceneUnion(of(std::move(scene), passages, options)) {}

SceneUnion::SceneUnion(SceneState state, std::shared_ptr<const SceneUnion> obstacles)
    : state_(std::make_shared<const SceneState>(std::move(state))),
      obstacles_(std::move(obstacles)),
      counts_(state_->counts()),
      kept_(std::make_shared<Kept>()) {
  if (!obstacles_) return;
  counts_.copies_redone = obstacles_->size();
  counts_.edges_redone += obstacles_->counts().edges_redone;
  counts_.sums_evaluated += obstacles_->counts().sums_evaluated;
  counts_.indices_built += obstacles_->counts().indices_built;
}

std::uint32_t SceneUnion::size() const {
  return obstacles_ ? obstacles_->size() : static_cast<std::uint32_t>(state_->size());
}

const Copy& SceneUnion::copy(std::uint32_t number) const {
  return obstacles_ ? obstacles_->copy(number) : state_->copy(number);
}

void SceneUnion::require_copy(std::uint32_t copy) const {
  if (copy < size()) return;
  throw BadInput("no-copy", "there is no copy " + std::to_string(copy),
                 "the scene has " + std::to_string(size()) + " copies, counted from 0");
}

SceneUnion SceneUnion::with(std::uint32_t copy, const std::optional<Copy>& now,
                            const BuildOptions& options) const {
  if (!obstacles_) return {state_->with(copy, now, options), nullptr};
  const FloatEnvironment standard;
  return beside_segment(obstacles_->with(copy, now, options), robot(), state_->store()->passages(),
                        options);
}

SceneUnion SceneUnion::changed(std::uint32_t copy, const Rational& scale, const Point& place,
                               const BuildOptions& options) const {
  require_copy(copy);
  return with(copy, Copy{this->copy(copy).shape, scale, place}, options);
}

SceneUnion SceneUnion::added(const Copy& copy, const BuildOptions& options) const {
  return with(size(), copy, options);
}

SceneUnion SceneUnion::removed(std::uint32_t copy, const BuildOptions& options) const {
  require_copy(copy);
  return with(copy, std::nullopt, options);
}

std::vector<Copy> SceneUnion::copies() const {
  return obstacles_ ? obstacles_->copies() : state_->copies();
}
const PolygonSet& SceneUnion::robot() const { return state_->store()->robot(); }
const std::vector<PolygonSet>& SceneUnion::shapes() const {
  return obstacles_ ? obstacles_->shapes() : state_->store()->shapes();
}

const SceneBoundary& SceneUnion::boundary() const {
  return once(kept_->boundary, kept_->mutex,
              [&] { return scene_boundary(state_->sums(), state_->stretches()); });
}

const Canonical& SceneUnion::region() const {
  return once(kept_->region, kept_->mutex, [&] { return canonical_form(boundary().graph()); });
}

/// Calls take(contact) for the convolution edges along a stretch of a sum's edge.
template <class Take>
void SceneUnion::each_contact(std::uint32_t number, std::uint32_t edge, const Point& from,
                              const Point& to, const Copy& copy, Take&& take) const {
  const PlacedSum& placed = *state_->sums()[number];
  const auto contacts = state_->store()->contacts(*placed.sum).of(edge);
  for (const ConvolutionEdge& contact : contacts) {
    if (contacts.size() > 1) {
      Segment at = at_scale(contact, state_->store()->shapes()[copy.shape],
                            state_->store()->reflected_robot(), copy.scale);
      if (!shares({from, to}, {moved(at.start, copy.place), moved(at.end, copy.place)})) continue;
    }
    take(contact);
  }
}

AddOwners SceneUnion::owners_of_edges() const {
  if (!obstacles_) {
    return [this, copies = state_->copies_of_sums()](std::uint32_t number, std::uint32_t edge,
                                                     const Point& from, const Point& to,
                                                     std::vector<Owner>& owners) {
      each_contact(number, edge, from, to, state_->copy(copies[number][0]),
                   [&](const ConvolutionEdge& contact) {
                     for (const std::uint32_t copy : copies[number])
                       owners.push_back({copy, contact});
                   });
    };
  }
  return [contacts = std::make_shared<CopyContacts>(shapes(), state_->store()->reflected_robot(),
                                                    copies())](
             std::uint32_t, std::uint32_t, const Point& from, const Point& to,
             std::vector<Owner>& owners) { contacts->add(from, to, owners); };
}

const std::vector<RingOwners>& SceneUnion::owners() const {
  return once(kept_->owners, kept_->mutex,
              [&] { return side_owners(region().region, boundary(), owners_of_edges()); });
}

const SceneTightGraph& SceneUnion::tight() const {
  if (!state_->store()->passages()) {
    throw BadInput("no-passages", "this scene was made without tight passages",
                   "make it with them");
  }
  return once(kept_->tight, kept_->mutex, [&] {
    if (robot().is_point()) return SceneTightGraph();  // the seams of its obstacles are blocked
    return scene_tight_graph(state_->sums(), state_->stretches(), boundary(), owners_of_edges());
  });
}

const ScenePassages& SceneUnion::pieces() const {
  const SceneTightGraph& graph = tight();
  return once(kept_->passages, kept_->mutex, [&] { return scene_passages(graph); });
}

const std::vector<ScenePassage>& SceneUnion::passages() const { return pieces().pieces; }

FreeComponents SceneUnion::components(ContactRule rule) const {
  const FloatEnvironment standard;
  if (rule == ContactRule::forbidden) return free_components(boundary().exact_graph(), {}, rule);
  FreeComponents found = free_components(boundary().exact_graph(), tight().graph, rule);
  std::vector<std::uint32_t> of_pieces;
  for (const std::uint32_t edge : pieces().edges) of_pieces.push_back(found.of_passage[edge]);
  found.of_passage = std::move(of_pieces);
  return found;
}

Canonical SceneUnion::sum_of(std::uint32_t copy) const {
  require_copy(copy);
  const FloatEnvironment standard;
  const Copy& placed = this->copy(copy);
  Sum sum = minkowski_sum(shapes()[placed.shape], scaled(robot(), -1), placed.scale);
  return {translated(sum.region, placed.place), sum.components, sum.holes};
}

}  // namespace minkref::inline scene
