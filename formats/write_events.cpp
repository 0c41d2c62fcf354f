#include "formats/write_events.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>

#include "formats/event_row.hpp"
#include "formats/machine_fraction.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref {

namespace {

/// Calls use(frame) if its numbers fit machine words, else otherwise().
template <class Use, class Otherwise>
void in_machine_words_or(const PolygonSet& P, const PolygonSet& Q, const Use& use,
                         const Otherwise& otherwise) {
  on_exact_frame(P, Q, [&](const auto& frame) {
    if constexpr (std::is_same_v<std::decay_t<decltype(frame)>, GridFrame<Grid64>>) {
      if (frame.denominator <= std::numeric_limits<std::uint64_t>::max()) {
        use(frame);
        return;
      }
    }
    otherwise(frame);
  });
}

class EventText {
 public:
  EventText(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
            const std::vector<std::string>& edges, std::string_view end)
      : events_(events), P_(P), Q_(Q), edges_(edges), end_(end) {}

  std::string of(std::size_t first, std::size_t last) {
    std::string text;
    in_machine_words_or(
        P_, Q_, [&](const auto& frame) { in_machine_words(text, frame, first, last); },
        [&](const auto&) { in_rationals(text, first, last); });
    return text;
  }

 private:
  using Frame = GridFrame<Grid64>;

  void in_machine_words(std::string& text, const Frame& frame, std::size_t first,
                        std::size_t last) {
    const auto edges = moving_edges(events_.edges, frame.P, frame.Q);
    const auto unit = frame.denominator.convert_to<std::uint64_t>();
    text.reserve((last - first) * 400);
    MachineFraction scale;
    std::optional<std::uint32_t> rank;
    for (std::size_t i = first; i < last; ++i) {
      look_for_interrupt();
      const PairEvent& event = events_.events[i];
      if (event.parallel) {
        in_rationals(text, i, i + 1);
        continue;
      }
      const auto &a = edges[event.a], &b = edges[event.b];
      if (event.rank != rank) {
        const auto root = event_scale(frame.kernel, a, b, event);
        scale = reduced(root.num, root.den);
        rank = event.rank;
      }
      begin(text, event, scale);
      // One end lies on the other edge: the edges meet there.
      const auto end = end_of_event(a, b, static_cast<PairEnd>(event.half_line));
      append_position(text, scale, end.p.x(), end.q.x(), unit);
      text += "\", \"";
      append_position(text, scale, end.p.y(), end.q.y(), unit);
      text += "\"], \"to\": null}";
      text += end_;
    }
  }

  template <class V>
  static MovingVertex<V> end_of_event(const MovingEdge<V>& a, const MovingEdge<V>& b, PairEnd end) {
    switch (end) {
      case PairEnd::a0:
        return start_of(a);
      case PairEnd::a1:
        return minkref::end_of(a);
      case PairEnd::b0:
        return start_of(b);
      case PairEnd::b1:
        break;
    }
    return minkref::end_of(b);
  }

  void in_rationals(std::string& text, std::size_t first, std::size_t last) {
    if (rational_.empty()) {
      rational_ = moving_edges<Vector2<Rational>>(events_.edges, scalar_operand<Rational>(P_, {}),
                                                  scalar_operand<Rational>(Q_, {}));
    }
    const auto places = event_places(events_, first, last, rational_);
    for (std::size_t i = first; i < last; ++i) {
      const PairEvent& event = events_.events[i];
      const EventPlace& place = places[i - first];
      append_json(text,
                  {place.scale,
                   event.rank,
                   event.parallel ? "parallel" : "pair",
                   name(event.change),
                   {event.a, event.b},
                   place.at,
                   place.to},
                  edges_, end_);
    }
  }

  void begin(std::string& text, const PairEvent& event, const MachineFraction& scale) const {
    text += "{\"s\": \"";
    append(text, scale);
    text += "\", \"rank\": ";
    text += std::to_string(event.rank);
    text += ", \"kind\": \"pair\", \"change\": \"";
    text += name(event.change);
    text += "\", \"parents\": [";
    text += edges_[event.a];
    text += ", ";
    text += edges_[event.b];
    text += "], \"at\": [\"";
  }

  const PairEvents& events_;
  const PolygonSet &P_, &Q_;
  const std::vector<std::string>& edges_;
  std::string_view end_;
  std::vector<RationalEdge> rational_;  // made if needed
};

}  // namespace

std::string events_as_json(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                           const std::vector<std::string>& edges, std::size_t first,
                           std::size_t last, std::string_view end) {
  last = std::min(last, events.events.size());
  if (first >= last) return {};
  return EventText(events, P, Q, edges, end).of(first, last);
}

ScaleTexts scale_texts(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                       std::size_t first, std::size_t last) {
  last = std::min(last, events.events.size());
  ScaleTexts result;
  const auto each = [&](const auto& frame, const auto& append_scale) {
    const auto edges = moving_edges(events.edges, frame.P, frame.Q);
    for (std::size_t i = first; i < last; ++i) {
      look_for_interrupt();
      const PairEvent& event = events.events[i];
      if (i == first || event.rank != events.events[i - 1].rank) {
        append_scale(event_scale(frame.kernel, edges[event.a], edges[event.b], event));
        result.begins.push_back(static_cast<std::int64_t>(result.text.size()));
      }
      result.which.push_back(static_cast<std::int32_t>(result.begins.size() - 2));
    }
  };
  if (first >= last) return result;
  in_machine_words_or(
      P, Q,
      [&](const auto& frame) {
        each(frame, [&](const auto& root) {
          const MachineFraction scale = reduced(root.num, root.den);
          append(result.text, scale);
          result.nearest.push_back(nearest_double(scale));
        });
      },
      [&](const auto& frame) {
        each(frame, [&](const auto& root) {
          const Rational scale = exact_parameter(frame.kernel, root);
          result.text += to_string(scale);
          result.nearest.push_back(to_double(scale));
        });
      });
  return result;
}

}  // namespace minkref
