#include "reference/plane/history/spans_on_line.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace minkref::inline plane {

SpansOnLine::SpansOnLine(const std::vector<Span>& spans) : order_(spans.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  // By the middle, doubled, at the scale 1.
  std::vector<double> place;
  place.reserve(spans.size());
  for (const Span& span : spans) {
    look_for_interrupt();
    place.push_back(span.start_p + span.start_q + span.end_p + span.end_q);
    for (const double end : {span.start_p, span.start_q, span.end_p, span.end_q}) {
      size_ = std::max(size_, std::fabs(end));
    }
    if (std::isnan(place.back())) place.back() = 0;
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b]; });
  if (!spans.empty()) build(spans, 0, spans.size());
}

void SpansOnLine::build(const std::vector<Span>& spans, std::size_t begin, std::size_t end) {
  look_for_interrupt();
  const std::size_t at = nodes_.size();
  const Span& any = spans[order_[begin]];
  Node node{any.start_p, any.start_q, any.start_p, any.start_q, begin, end, 0};
  for (std::size_t k = begin; k < end; ++k) {
    const Span& span = spans[order_[k]];
    node.low_p = std::min({node.low_p, span.start_p, span.end_p});
    node.low_q = std::min({node.low_q, span.start_q, span.end_q});
    node.high_p = std::max({node.high_p, span.start_p, span.end_p});
    node.high_q = std::max({node.high_q, span.start_q, span.end_q});
  }
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return;
  const std::size_t middle = begin + (end - begin) / 2;
  build(spans, begin, middle);
  nodes_[at].right = nodes_.size();
  build(spans, middle, end);
}

/// Beyond the error from conversions and a few roundings.
double SpansOnLine::doubt(double place, double scale) const {
  return 0x1p-48 * (size_ * (1 + scale) + std::fabs(place)) + 1e-300 * (1 + scale);
}

}  // namespace minkref::inline plane
