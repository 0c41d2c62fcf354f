// The index of all scales for Python; an answer's columns are arrays over its own memory.
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <variant>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/exact_number.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/refusal_place.hpp"
#include "reference/build/stage.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/index/lazy_index.hpp"
#include "reference/plane/index/scale_index.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

constexpr int precise_bits =
    40;  // an area in doubles is given out where it has as many that are certain

/// The boundary at a scale, with any of the forms.
struct Rings {
  Rational scale;
  std::string form;
  std::variant<RoundedRings, HomogeneousRings, RationalRings, TrackRings> rings;

  const RingShape& shape() const {
    return std::visit([](const auto& r) -> const RingShape& { return r; }, rings);
  }
};

template <class T>
using Array = nb::ndarray<nb::numpy, const T>;

template <class T>
Array<T> array_of(const std::vector<T>& values, nb::handle owner) {
  return Array<T>(values.data(), {values.size()}, owner);
}

template <class Form>
const Form& in_form(const Rings& rings, const char* what) {
  const Form* found = std::get_if<Form>(&rings.rings);
  if (found == nullptr) {
    throw BadInput("other-form",
                   std::string("rings in the form ") + rings.form + " have no " + what,
                   "ask for them in another form");
  }
  return *found;
}

constexpr std::array<const char*, 4> forms_of_boundary{"double", "homogeneous", "rational",
                                                       "track"};

Rings empty_rings(const std::string& form) {
  Rings result{{}, form, RoundedRings{}};
  if (form == forms_of_boundary[1]) {
    result.rings = HomogeneousRings{};
  } else if (form == forms_of_boundary[2]) {
    result.rings = RationalRings{};
  } else if (form == forms_of_boundary[3]) {
    result.rings = TrackRings{};
  } else if (form != forms_of_boundary[0]) {
    throw BadInput("no-form", "there is no form \"" + form + "\"",
                   "choose one of double, homogeneous, rational, track");
  }
  return result;
}

class Index {
 public:
  using Progress = std::function<void(std::string, std::uint64_t, std::uint64_t)>;

  Index(const Set& P, const Set& Q, const std::optional<std::string>& from,
        const std::optional<std::string>& to, unsigned threads, std::uint64_t limit,
        const std::optional<Progress>& progress, bool lazy) {
    const Stopwatch watch;
    BuildOptions options;
    options.threads = threads;
    options.memory_limit = limit != 0 ? limit : memory_limit();
    if (lazy) {
      refuse_large_convolution(P.value, Q.value);
      lazy_ = std::make_shared<LazyIndex>(P.value, Q.value, window_of(from, to), options);
      return;
    }
    if (progress) {
      options.progress = [&](const BuildProgress& now) {
        static constexpr std::array<const char*, 4> stages{"cells", "pairs", "patches", "rings"};
        const nb::gil_scoped_acquire locked;
        (*progress)(stages.at(static_cast<std::size_t>(now.stage)), now.done, now.total);
      };
    }
    refuse_large_convolution(P.value, Q.value);
    index_.emplace(P.value, Q.value, window_of(from, to), options);
    seconds = watch.seconds();
  }
  explicit Index(const std::string& path) {
    const Stopwatch watch;
    index_ = ScaleIndex::open(path);
    seconds = watch.seconds();
  }

  /// An index of other operands; lazy unless this index is built.
  Index updated(const Set* P, const Set* Q, unsigned threads) const {
    for (const auto& [name, set] : {std::pair("P", P), std::pair("Q", Q)}) {
      if (set != nullptr) validate_as_read(set->value, set->origins, name, Lines::allowed);
    }
    const PolygonSet new_P = P != nullptr ? P->value : this->P(),
                     new_Q = Q != nullptr ? Q->value : this->Q();
    refuse_large_convolution(new_P, new_Q);
    BuildOptions options;
    options.threads = threads;
    options.memory_limit = memory_limit();
    const Stopwatch watch;
    Index result;
    if (is_built()) {
      result.index_.emplace(index().updated(new_P, new_Q, options));
      result.seconds = watch.seconds();
    } else {
      result.lazy_ = std::make_shared<LazyIndex>(new_P, new_Q, lazy_->window(), options);
    }
    return result;
  }

  Fields reuse() const {
    Fields fields;
    if (!is_built()) return fields;
    const ScaleIndex::Reuse reuse = index().reuse();
    MINKREF_PUT(reuse, reused, rebuilt, pairs, faces);
    return fields;
  }

  /// Builds a lazy one: not with the interpreter lock (`ready`).
  const ScaleIndex& index() const { return lazy_ ? lazy_->index() : *index_; }
  double seconds = 0;  ///< of building or opening it; 0 for a lazy one

  bool is_built() const { return !lazy_ || lazy_->is_built(); }
  /// With the interpreter lock, which is let go for a build or a static sum.
  const Index& ready() const {
    if (!is_built()) computed([&] { return &lazy_->index(); });
    return *this;
  }
  template <class Work>
  auto quickly(const Work& work) const {
    return is_built() ? work() : computed(work);
  }

  PolygonSet P() const { return lazy_ ? lazy_->P() : index().P(); }
  PolygonSet Q() const { return lazy_ ? lazy_->Q() : index().Q(); }

  std::pair<std::optional<ExactNumber>, std::optional<ExactNumber>> window() const {
    const ScaleWindow& window = lazy_ ? lazy_->window() : index().window();
    return {exact_number(window.from), exact_number(window.to)};
  }

  Fields counts() const {
    const IndexCounts& counts = index().counts();
    const IndexColumns& columns = index().columns();
    Fields fields;
    MINKREF_PUT(counts, s_edges, t_edges, meeting_pairs, pairs_inside, faces_tested, pieces);
    fields["tracks"] = index().tracks();
    fields["links"] = columns.links.size();
    const auto [first, last] = index().events_within();
    const auto is_within = [first = first, last = last](const auto& event) {
      return event.event >= first && event.event < last;
    };
    const auto count = [&](const auto& events) {
      return std::count_if(events.begin(), events.end(), is_within);
    };
    fields["scales"] = last - first;
    fields["boundary_events"] = count(columns.boundary);
    fields["topology_events"] = count(columns.topology);
    fields["buckets"] = columns.buckets.size();
    fields["corners"] = columns.entries.size();
    fields["bits"] = counts.track_bits;
    fields["bytes"] = index().bytes();
    return fields;
  }

  Rings rings(const std::string& scale, const std::string& form) const {
    Rings result = empty_rings(form);
    result.scale = parse_rational(scale);
    std::visit(
        [&](auto& rings) {
          lazy_ ? lazy_->rings(result.scale, rings) : index().rings(result.scale, rings);
        },
        result.rings);
    return result;
  }

  std::vector<Rings> batch(const std::vector<std::string>& scales, const std::string& form,
                           unsigned threads) const {
    std::vector<Rings> result(scales.size(), empty_rings(form));
    BuildOptions options;
    options.threads = threads;
    const BuildControl control(options, "the index");
    // One after another until a lazy index is built: threads change no answer.
    std::size_t done = 0;
    for (; done < scales.size() && !is_built(); ++done) {
      result[done] = rings(scales[done], form);
      if (done == 0) lazy_->expect(scales.size() - 1);
    }
    in_parallel(scales.size() - done, control, BuildProgress::Stage::rings, [&](unsigned) {
      return [&](std::size_t k) { result[done + k] = rings(scales[done + k], form); };
    });
    return result;
  }

  TimedSum sum(const std::string& scale, bool passages) const {
    const Rational s = parse_rational(scale);
    const Stopwatch watch;
    const Passages wanted = passages ? Passages::find : Passages::leave;
    Sum sum = lazy_ ? lazy_->sum(s, wanted) : index().sum(s, wanted);
    const auto find = [this, s] { return tight_passages(P(), Q(), s); };
    return {{std::move(sum.region), true},
            sum.components,
            sum.holes,
            watch.seconds(),
            std::move(sum.statistics),
            LaterPassages(find, std::move(sum.tight_passages))};
  }

  std::pair<double, double> area(const std::string& scale) const {
    const FloatEnvironment standard;
    const Rational s = parse_rational(scale);
    if (!is_built()) return rounded_area(minkref::area(lazy_->sum(s)));
    const auto area = index().area(s);
    if (std::isfinite(area.value) &&
        area.error <= std::ldexp(std::abs(area.value), -precise_bits)) {
      return {area.value, area.error};
    }
    // Far from the origin, and beyond doubles, these do not tell.
    const auto polynomial = index().area_polynomial(index().place(s).interval);
    return rounded_area(polynomial[0] + s * (polynomial[1] + s * polynomial[2]));
  }
  static std::pair<double, double> rounded_area(const Rational& exact) {
    const double nearest = to_double(exact);
    if (!std::isfinite(nearest)) {
      throw LimitExceeded("not-representable", "the area is beyond the range of doubles",
                          "ask for area_polynomial, which is exact");
    }
    const Enclosure around = enclose(exact);
    return {nearest, std::max(around.upper - nearest, nearest - around.lower)};
  }
  ExactTriple area_polynomial(const std::string& scale) const {
    const auto place = index().place(parse_rational(scale));
    const auto polynomial = index().area_polynomial(place.interval);
    return {{polynomial[0]}, {polynomial[1]}, {polynomial[2]}};
  }
  std::pair<std::uint32_t, std::uint32_t> features_at(const std::string& scale) const {
    const Rational s = parse_rational(scale);
    const auto found = lazy_ ? lazy_->features(s) : index().features(s);
    return {found.components, found.holes};
  }

  /// The greatest event below a scale, the least above, and whether the scale has an event.
  std::tuple<std::optional<ExactNumber>, bool, std::optional<ExactNumber>> neighbours(
      const std::string& scale) const {
    const auto place = index().place(parse_rational(scale));
    const auto [first, last] = index().events_within();
    const auto event = [&, first = first, last = last](std::uint32_t k) {
      return k < first || k >= last ? std::nullopt : std::optional(ExactNumber{index().event(k)});
    };
    return {place.interval == 0 ? std::nullopt : event(place.interval - 1), place.at_event,
            event(place.interval + (place.at_event ? 1 : 0))};
  }

  std::vector<EdgeRow> edges() const {
    return convolution_rows(is_built() ? index().edges()
                                       : reduced_convolution(lazy_->P(), lazy_->Q()));
  }
  std::vector<ExactNumber> event_scales() const {
    std::vector<ExactNumber> scales;
    const auto [first, last] = index().events_within();
    for (std::uint32_t k = first; k < last; ++k) scales.push_back({index().event(k)});
    return scales;
  }

  template <class Ask>
  auto ask(Ask&& ask) const {
    const TopologyTimeline timeline = index().timeline();
    return ask(TimelineRows(timeline, index().window(),
                            [&](std::uint32_t event) { return index().event(event); }));
  }
  auto boundary_events() const {
    return ask([](const TimelineRows& rows) { return rows.boundary_events(); });
  }
  auto topology_events() const {
    return ask([](const TimelineRows& rows) { return rows.topology_events(); });
  }
  auto features(const std::string& kind) const {
    return ask([&](const TimelineRows& rows) { return rows.features(kind); });
  }
  auto lives(const std::string& kind) const {
    return ask([&](const TimelineRows& rows) { return rows.lives(kind); });
  }

  std::vector<std::pair<ExactPoint, ExactPoint>> tracks() const {
    std::vector<std::pair<ExactPoint, ExactPoint>> rows;
    for (std::uint32_t k = 0; k < index().tracks(); ++k) {
      const Track track = index().track(k);
      rows.emplace_back(to_strings(track.a), to_strings(track.b));
    }
    return rows;
  }

  void ring_states(const std::function<void(TimelineRows::RingState)>& report) const {
    ready();
    if (index().columns().edges.empty()) return;
    TrackRings rings;
    const auto tell = [&](std::uint32_t interval) {
      index().rings_of_interval(interval, rings);
      TimelineRows::RingState row;
      if (interval > 0) row.first = to_string(index().event(interval - 1));
      std::uint32_t first = 0;
      for (std::size_t r = 0; r < rings.ring_ends.size(); ++r) {
        const RingFeatures& of = rings.rings[r];
        row.second.emplace_back(
            of.is_hole, of.component, of.hole,
            std::vector<std::uint32_t>(rings.tracks.begin() + first,
                                       rings.tracks.begin() + rings.ring_ends[r]));
        first = rings.ring_ends[r];
      }
      report(std::move(row));
    };
    tell(0);
    for (const IndexBoundaryEvent& event : index().columns().boundary) tell(event.event + 1);
  }

  std::string first_difference(const std::vector<std::string>& scales) const {
    const PolygonSet P = this->P(), Q = this->Q();
    for (const std::string& scale : scales) {
      const Rational s = parse_rational(scale);
      const Sum found = index().sum(s), expected = minkowski_sum(P, Q, s);
      if (found.region != expected.region || found.components != expected.components ||
          found.holes != expected.holes) {
        return scale;
      }
    }
    return "";
  }

 private:
  Index() = default;

  std::optional<ScaleIndex> index_;
  std::shared_ptr<const LazyIndex> lazy_;  ///< instead
};

template <class Form>
void add_numbers(nb::class_<Rings>& rings, const char* name, std::size_t per, const char* doc) {
  rings.def_prop_ro(
      name,
      [name, per](nb::handle self) {
        const Form& form = in_form<Form>(nb::cast<const Rings&>(self), name);
        return Array<std::uint64_t>(
            form.numbers.data(), {form.numbers.size() / (per * form.words), per, form.words}, self);
      },
      doc);
}

void bind_rings(nb::module_& module) {
  nb::class_<Rings> rings(module, "IndexRings",
                          "The boundary at a scale: rings one after the other, in no particular "
                          "order, outer ones counter-clockwise. Arrays are views of it.");
  rings.def_prop_ro("scale", [](const Rings& r) { return to_string(r.scale); })
      .def_ro("form", &Rings::form)
      .def(
          "__len__", [](const Rings& r) { return r.shape().edges.size(); }, "Vertices.")
      .def_prop_ro(
          "ring_ends",
          [](nb::handle self) {
            return array_of(nb::cast<const Rings&>(self).shape().ring_ends, self);
          },
          "Behind the last vertex of each ring.")
      .def_prop_ro(
          "edges",
          [](nb::handle self) {
            return array_of(nb::cast<const Rings&>(self).shape().edges, self);
          },
          "The convolution edge that the side behind each vertex lies on: a row of edges().")
      .def(
          "features",
          [](const Rings& r) {
            std::vector<std::tuple<bool, std::uint32_t, std::uint32_t>> rows;
            for (const RingFeatures& f : r.shape().rings) {
              rows.emplace_back(f.is_hole, f.component, f.hole);
            }
            return rows;
          },
          Released(),
          "Of each ring: whether it is a hole's, its component, the hole on its other side.")
      .def_prop_ro(
          "x",
          [](nb::handle self) {
            return array_of(in_form<RoundedRings>(nb::cast<const Rings&>(self), "x").x, self);
          },
          "Doubles, each off by at most `error`.")
      .def_prop_ro(
          "y",
          [](nb::handle self) {
            return array_of(in_form<RoundedRings>(nb::cast<const Rings&>(self), "y").y, self);
          },
          "Doubles, each off by at most `error`.")
      .def_prop_ro("error", [](const Rings& r) { return in_form<RoundedRings>(r, "error").error; })
      .def_prop_ro(
          "tracks",
          [](nb::handle self) {
            return array_of(in_form<TrackRings>(nb::cast<const Rings&>(self), "tracks").tracks,
                            self);
          },
          "Of each vertex, among the tracks of the index.");
  add_numbers<HomogeneousRings>(rings, "homogeneous", 3,
                                "Shape (vertices, 3, words): X, Y, W of the point (X / W, Y / W), "
                                "W > 0; each integer in two's "
                                "complement, its lowest word first.");
  add_numbers<RationalRings>(
      rings, "rational", 4,
      "Shape (vertices, 4, words): numerator and denominator of x and of y, in lowest terms; "
      "integers as in `homogeneous`.");
}

void bind_update(nb::class_<Index>& index) {
  index
      .def("updated", &Index::updated, "P"_a.none() = nb::none(), "Q"_a.none() = nb::none(),
           "threads"_a = 1, Released(),
           "The index of another P or Q, or of both, in this window: the same as a new one. Where "
           "the change is local, so is the search of the boundary; this index stays as it is. The "
           "operands are validated first. docs/scale-index.md, \"Updates\". Raises BadInput, "
           "LimitExceeded.")
      .def("reuse", &Index::reuse,
           "What the update that gave this index did: convolution edges reused and rebuilt, pairs "
           "of edges looked at, faces tested by a point. Empty before a lazy index is built; zeros "
           "for one from a file.");
}

}  // namespace

void bind_index(nb::module_& module) {
  using OptionalText = std::optional<std::string>;
  bind_rings(module);
  nb::class_<Index> bound(
      module, "ScaleIndex",
      "sP + Q at all scales of a closed window, built once; any one is read off. "
      "Safe to ask from several threads.");
  bound
      .def(nb::init<const Set&, const Set&, const OptionalText&, const OptionalText&, unsigned,
                    std::uint64_t, const std::optional<Index::Progress>&, bool>(),
           "P"_a, "Q"_a, "from_scale"_a = nb::none(), "to_scale"_a = nb::none(), "threads"_a = 1,
           "memory_limit"_a = 0, "progress"_a = nb::none(), "lazy"_a = false, Released())
      .def_static(
          "open", [](const std::string& path) { return Index(path); }, "path"_a, Released(),
          "One that was saved: a copy of its file, which then may change.")
      .def(
          "save", [](const Index& i, const std::string& path) { i.index().save(path); }, "path"_a,
          Released())
      .def_ro("seconds", &Index::seconds, "Of building or opening it; 0 for a lazy one.")
      .def_prop_ro("is_built", &Index::is_built,
                   "Whether the index answers; false while static sums answer for a lazy one.")
      .def_prop_ro("window", &Index::window, "Begin and end; none where it is open.")
      .def_prop_ro(
          "P", [](const Index& i) { return Set{i.P()}; }, Released())
      .def_prop_ro(
          "Q", [](const Index& i) { return Set{i.Q()}; }, Released())
      .def(
          "is_of",
          [](const Index& i, const Set& P, const Set& Q) {
            return i.P() == P.value && i.Q() == Q.value;
          },
          "P"_a, "Q"_a, Released(), "Whether it was built of these operands.")
      .def("counts", [](const Index& i) { return i.ready().counts(); })
      .def("edges", &Index::edges, Released(), "Rows as reduced_convolution's.")
      .def(
          "rings", &Index::rings, "scale"_a, "form"_a = forms_of_boundary[0], Released(),
          nb::sig("def rings(self, scale: " MINKREF_NUMBER ", form: str = 'double') -> IndexRings"),
          "The boundary: double (certified), homogeneous, rational or track.")
      .def("batch", &Index::batch, "scales"_a, "form"_a = forms_of_boundary[0], "threads"_a = 1,
           Released(), "The boundaries at many scales, in their order.")
      .def(
          "sum", &Index::sum, "scale"_a, "passages"_a = false, nb::keep_alive<0, 1>(), Released(),
          nb::sig("def sum(self, scale: " MINKREF_NUMBER ", passages: bool = False) -> Sum"),
          "The sum in canonical form, exact. `passages`: with its tight passages found at once, by "
          "the static route, not when they are first asked for.")
      .def(
          "area",
          [](const Index& i, const std::string& scale) {
            return i.quickly([&] { return i.area(scale); });
          },
          "scale"_a, nb::sig("def area(self, scale: " MINKREF_NUMBER ") -> tuple[float, float]"),
          "(value, error): the area is within the error, which is small beside it; the double next "
          "to the area where other doubles cannot tell. Raises LimitExceeded beyond their range.")
      .def("area_polynomial", &Index::area_polynomial, "scale"_a, Released(),
           nb::sig("def area_polynomial(self, scale: " MINKREF_NUMBER
                   ") -> tuple[fractions.Fraction, fractions.Fraction, fractions.Fraction]"),
           "Exact a0, a1, a2 of the area a0 + a1 s + a2 s^2 in the interval of a scale.")
      .def(
          "components_and_holes",
          [](const Index& i, const std::string& scale) {
            return i.quickly([&] { return i.features_at(scale); });
          },
          "scale"_a,
          nb::sig("def components_and_holes(self, scale: " MINKREF_NUMBER ") -> tuple[int, int]"))
      .def(
          "neighbours",
          [](const Index& i, const std::string& scale) { return i.ready().neighbours(scale); },
          "scale"_a,
          nb::sig("def neighbours(self, scale: " MINKREF_NUMBER
                  ") -> tuple[fractions.Fraction | None, bool, fractions.Fraction | None]"),
          "The next event of the window below a scale, whether one is at it, the next above.")
      .def("event_scales", &Index::event_scales, Released())
      .def_prop_ro(
          "track_integers",
          [](nb::handle self) {
            const IntegerColumn& tracks =
                nb::cast<const Index&>(self).ready().index().columns().tracks;
            return Array<std::uint64_t>(tracks.data.data(),
                                        {tracks.size() / 5, std::size_t{5}, tracks.words}, self);
          },
          "Shape (tracks, 5, words): x0, y0, x1, y1, c of ((x0, y0) + s (x1, y1)) / c.")
      .def_prop_ro(
          "track_doubles",
          [](nb::handle self) {
            const auto tracks =
                nb::cast<const Index&>(self).ready().index().columns().tracks_in_doubles;
            return Array<double>(&tracks.data()->x0, {tracks.size(), std::size_t{4}}, self);
          },
          "Shape (tracks, 4): x0, y0, x1, y1 of (x0, y0) + s (x1, y1), rounded.")
      .def("first_difference", &Index::first_difference, "scales"_a, Released(),
           "The first of these scales at which the sum is not that of the static route; empty: "
           "none.");
  bind_update(bound);
  bind_history(bound);
}

}  // namespace minkref::python
