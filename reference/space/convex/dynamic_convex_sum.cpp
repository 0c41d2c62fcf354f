#include "reference/space/convex/dynamic_convex_sum.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/convex/static_convex_sum.hpp"

namespace minkref::inline space {

UpdateCounts& UpdateCounts::operator+=(const UpdateCounts& other) {
  fv_errors += other.fv_errors;
  vf_errors += other.vf_errors;
  descent_steps += other.descent_steps;
  ee_errors += other.ee_errors;
  ee_pairs_added += other.ee_pairs_added;
  chains_walked += other.chains_walked;
  chains_mended_by_proof += other.chains_mended_by_proof;
  chains_without_error += other.chains_without_error;
  facets_examined += other.facets_examined;
  chains_examined += other.chains_examined;
  signs += other.signs;
  exact_signs += other.exact_signs;
  return *this;
}

namespace {

Compatibility from_scratch(Contacts& contacts, const RoundedScaling& scaling) {
  require_positive(scaling.exact);
  contacts.rescale(scaling);
  return by_traversal(contacts);
}

}  // namespace

DynamicConvexSum::DynamicConvexSum(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                                   const Scaling& at, const FloatEnvironment& /*standard*/)
    : contacts_(P, Q),
      scaling_(at),
      state_(from_scratch(contacts_, scaling_)),
      vertices_(P, Q, state_),
      deadline_P_(P.facets(), 0),
      deadline_Q_(Q.facets(), 0),
      deadline_chain_(P.edges(), 0),
      deadline_links_(P.edges()),
      suspects_(P.edges()),
      moved_(Q.facets()),
      changed_at_P_(P.vertices()),
      changed_at_Q_(Q.vertices()),
      in_chain_(Q.edges()) {
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    deadline_links_[e].resize(state_.chains[e].size(), 0);
    ee_pairs_ += state_.chains[e].size();
  }
}

UpdateCounts DynamicConvexSum::update(const Scaling& to) {
  const FloatEnvironment standard;
  require_positive(to);
  UpdateCounts counts;
  for (IndexSet* set : {&suspects_, &moved_, &changed_at_P_, &changed_at_Q_}) set->clear();
  changed_.vertex_of_Q.clear();
  changed_.vertex_of_P.clear();
  changed_.chains.clear();
  changed_.links.clear();
  const std::uint64_t signs = contacts_.evaluations(), exact = contacts_.exact_evaluations();
  RoundedScaling next(to);
  add_drift(drift(scaling_, next));
  std::swap(scaling_, next);
  contacts_.rescale(scaling_);
  try {
    mend_facets_of_P(counts);
    mend_facets_of_Q(counts);
    mend_chains(counts);
    renew_vertices();
  } catch (...) {
    undo(next);
    throw;
  }
  counts.signs = contacts_.evaluations() - signs;
  counts.exact_signs = contacts_.exact_evaluations() - exact;
  return counts;
}

/// Below 8 the sum's last place lies far below the amount that `drift` adds for rounding; beyond 8,
/// or with an unknown drift, everything is examined anew.
void DynamicConvexSum::add_drift(double step) {
  drift_ += step;
  if (drift_ < 8) return;  // false for NaN
  drift_ = 0;
  for (auto* deadlines : {&deadline_P_, &deadline_Q_, &deadline_chain_}) {
    std::fill(deadlines->begin(), deadlines->end(), 0);
  }
  for (auto& deadlines : deadline_links_) std::fill(deadlines.begin(), deadlines.end(), 0);
}

/// Finds fv-errors, and beside each the facet's edges.
void DynamicConvexSum::mend_facets_of_P(UpdateCounts& counts) {
  const ConvexPolyhedron& body = P();
  for (const auto& [f, before] : body.traversal()) {
    if (drift_ < deadline_P_[f]) continue;
    if (counts.facets_examined++ % 4 == 0) look_for_interrupt();
    const Climb found =
        climb(contacts_.across_P, f, state_.vertex_of_Q[f], state_.vertex_of_Q[before], way_);
    deadline_P_[f] = until(found.slack);
    if (found.vertex == state_.vertex_of_Q[f]) continue;
    ++counts.fv_errors;
    counts.descent_steps += found.steps;
    changed_.vertex_of_Q.emplace_back(f, state_.vertex_of_Q[f]);
    state_.vertex_of_Q[f] = found.vertex;
    const std::uint32_t start = body.start(f);
    std::uint32_t h = start;
    do {
      suspects_.insert(body.edge(h));
      changed_at_P_.insert(body.origin(h));
    } while ((h = body.next(h)) != start);
  }
}

/// vf-errors, and beside each the edges of P on the way to the new vertex.
void DynamicConvexSum::mend_facets_of_Q(UpdateCounts& counts) {
  moved_.clear();
  for (const auto& [g, before] : Q().traversal()) {
    if (drift_ < deadline_Q_[g]) continue;
    if (counts.facets_examined++ % 4 == 0) look_for_interrupt();
    const Climb found =
        climb(contacts_.across_Q, g, state_.vertex_of_P[g], state_.vertex_of_P[before], way_);
    for (const std::uint32_t h : way_) suspects_.insert(P().edge(h));
    deadline_Q_[g] = until(found.slack);
    if (found.vertex == state_.vertex_of_P[g]) continue;
    ++counts.vf_errors;
    counts.descent_steps += found.steps;
    moved_.insert(g);
    changed_.vertex_of_P.emplace_back(g, state_.vertex_of_P[g]);
    state_.vertex_of_P[g] = found.vertex;
    for_vertices_of(Q(), g, [&](std::uint32_t q) { changed_at_Q_.insert(q); });
  }
}

/// ee-errors: first from the fv- and vf-errors, then whatever the proof of the rest brings up.
void DynamicConvexSum::mend_chains(UpdateCounts& counts) {
  for (const std::uint32_t e : suspects_.members()) {
    look_for_interrupt();
    mend_chain(e, counts);
  }
  for (std::uint32_t e = 0; e < P().edges(); ++e) {
    if (drift_ < deadline_chain_[e] || suspects_.contains(e)) continue;
    if (counts.chains_examined++ % 4 == 0) look_for_interrupt();
    if (is_chain_right(e)) continue;
    mend_chain(e, counts);
    ++counts.chains_mended_by_proof;
    if (!beside_moved_facet(chain_before_) && !beside_moved_facet(state_.chains[e])) {
      ++counts.chains_without_error;
    }
  }
  suspects_.clear();
}

/// Examines only links that may have become wrong; the chain's ends are right.
bool DynamicConvexSum::is_chain_right(std::uint32_t edge) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<double>& deadlines = deadline_links_[edge];
  for (std::size_t k = 0; k < deadlines.size(); ++k) {
    if (drift_ >= deadlines[k]) {
      const LinkState state = examine_link(contacts_.across_Q, edge, state_.chains[edge][k]);
      if (!state.right) return false;
      deadlines[k] = until(state.slack);
    }
    least = std::min(least, deadlines[k]);
  }
  deadline_chain_[edge] = least;
  return true;
}

/// How many edges two chains have in common, either way round.
std::uint64_t DynamicConvexSum::common_edges(const std::vector<std::uint32_t>& chain,
                                             const std::vector<std::uint32_t>& other) {
  in_chain_.clear();
  for (const std::uint32_t h : chain) in_chain_.insert(Q().edge(h));
  return static_cast<std::uint64_t>(std::count_if(other.begin(), other.end(), [&](std::uint32_t h) {
    return in_chain_.contains(Q().edge(h));
  }));
}

bool DynamicConvexSum::beside_moved_facet(const std::vector<std::uint32_t>& chain) const {
  return std::any_of(chain.begin(), chain.end(), [&](std::uint32_t h) {
    return moved_.contains(Q().left(h)) || moved_.contains(Q().right(h));
  });
}

void DynamicConvexSum::mend_chain(std::uint32_t edge, UpdateCounts& counts) {
  const std::uint32_t h = P().half_edge(edge);
  std::vector<std::uint32_t>& chain = state_.chains[edge];
  ++counts.chains_walked;
  walk_chain(contacts_.across_Q, edge, state_.vertex_of_Q[P().left(h)],
             state_.vertex_of_Q[P().right(h)], chain_after_, deadline_links_[edge]);
  deadline_chain_[edge] = std::numeric_limits<double>::infinity();
  for (double& slack : deadline_links_[edge]) {
    slack = until(slack);
    deadline_chain_[edge] = std::min(deadline_chain_[edge], slack);
  }
  chain_before_.clear();
  if (chain == chain_after_) return;
  changed_.chains.emplace_back(edge, static_cast<std::uint32_t>(chain.size()));
  changed_.links.insert(changed_.links.end(), chain.begin(), chain.end());
  changed_at_P_.insert(P().origin(h));
  changed_at_P_.insert(P().target(h));
  const std::uint64_t common = common_edges(chain, chain_after_);
  counts.ee_errors += chain.size() - common;
  counts.ee_pairs_added += chain_after_.size() - common;
  ee_pairs_ = ee_pairs_ - chain.size() + chain_after_.size();
  chain_before_.swap(chain);
  chain.swap(chain_after_);
}

void DynamicConvexSum::renew_vertices() {
  for (const std::uint32_t p : changed_at_P_.members()) {
    look_for_interrupt();
    vertices_.renew_at_P(p, state_);
  }
  for (const std::uint32_t q : changed_at_Q_.members()) {
    look_for_interrupt();
    vertices_.renew_at_Q(q, state_);
  }
}

/// Proofs at the new scaling stay valid, as after a step back; the next update examines everything
/// put back.
void DynamicConvexSum::undo(const RoundedScaling& before) {
  const Interruptible deaf([] {});
  for (const auto& [f, vertex] : changed_.vertex_of_Q) {
    state_.vertex_of_Q[f] = vertex;
    deadline_P_[f] = 0;
  }
  for (const auto& [g, vertex] : changed_.vertex_of_P) {
    state_.vertex_of_P[g] = vertex;
    deadline_Q_[g] = 0;
  }
  auto link = changed_.links.begin();
  for (const auto& [e, links] : changed_.chains) {
    ee_pairs_ = ee_pairs_ - state_.chains[e].size() + links;
    state_.chains[e].assign(link, link + links);
    link += links;
    deadline_links_[e].assign(links, 0);
    deadline_chain_[e] = 0;
  }
  renew_vertices();
  add_drift(drift(scaling_, before));
  scaling_ = before;
  contacts_.rescale(scaling_);
}

}  // namespace minkref::inline space
