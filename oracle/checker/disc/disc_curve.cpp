#include "oracle/checker/disc/disc_curve.hpp"

#include <algorithm>

namespace minkref::checker {
namespace {

Point right_of(const Point& d) { return {d.y, -d.x}; }

}  // namespace

DiscCurve::DiscCurve(const DiscRegion& region, std::uint32_t n, bool is_arc)
    : region_(region),
      n_(n),
      is_arc_(is_arc),
      v_(region.at(n)),
      along_(region.along(n)),
      tips_{v_, is_arc ? v_ : region.end_of(n)},
      square_(dot(along_, along_)) {
  const Key own{is_arc ? Key::Kind::arc : Key::Kind::edge, n};
  if (is_arc) {
    ends_.push_back(place(right_of(region.along(region.before(n))), own));
    ends_.push_back(place(right_of(along_), {Key::Kind::edge, n}));
  } else {
    ends_.push_back(place({0, 0}, own));
    ends_.push_back(place({1, 0}, region.key_after(n)));
  }
}

/// At a part of the edge (`t.x`), or in a direction.
Place DiscCurve::place(const Point& t, Key key) const {
  const Point way = is_arc_ ? t : right_of(along_);
  const mpq_class part = is_arc_ ? mpq_class(0) : t.x;
  const auto field = std::make_shared<const RootField>(region_.square_ / dot(way, way), 1, 0);
  const RootPoint at{Root(field, v_.x + part * along_.x, way.x, 0, 0),
                     Root(field, v_.y + part * along_.y, way.y, 0, 0)};
  return {at, is_arc_ ? t : Point{part * square_, 0}, key};
}

Place DiscCurve::joint(const Value& value, const Followed& all) const {
  const std::uint32_t number = index(value, all.joints.size());
  const RootPoint& at = all.joints[number];
  const RootPoint way = minus(at, v_);
  const Key key{Key::Kind::joint, number};
  if (is_arc_) {
    demand(sign(dot(way, way) - region_.square_) == 0, "a joint is off its arc");
    return {at, way, key};
  }
  const Root high = height(at);
  demand(sign(high * high - mpq_class(region_.square_ * square_)) == 0 && sign(high) > 0,
         "a joint is off its line");
  return {at, {dot(along_, way), 0}, key};
}

int DiscCurve::order(const RootPoint& x, const RootPoint& y) const {
  return sign(is_arc_ ? cross(x, y) : y.x - x.x);
}

Place DiscCurve::end(const Value& value, const Place& end, Followed& all) const {
  const Place found = value.is_null() ? end : joint(value, all);
  const bool is_same = order(end.mark, found.mark) == 0;
  demand(is_same && (!is_arc_ || sign(dot(end.mark, found.mark)) > 0),
         "a joint is not at the end of its curve");
  const auto went = all.ends.insert({end.key, found.key}).first;
  demand(went->second == found.key, "two curves meet at a joint of one of them");
  return found;
}

Place DiscCurve::between(const Value& value, const Followed& all) const {
  Place found = ends_[0];
  if (value.kind == Value::Kind::integer) {
    found = joint(value, all);
  } else {
    const Point t = is_arc_ ? point(value) : Point{number(value), 0};
    require(!is_arc_ || t.x != 0 || t.y != 0, "a direction is zero");
    found = place(t);
  }
  demand(order(ends_[0].mark, found.mark) > 0 && order(found.mark, ends_[1].mark) > 0,
         "a place is off its curve");
  return found;
}

/// The heights of an edge's ends, the lower one first, and how far along they are.
std::pair<DiscCurve::Over, DiscCurve::Over> DiscCurve::over(std::uint32_t f) const {
  const auto of = [&](const Point& p) {
    return Over{region_.height(n_, p), dot(along_, minus(p, v_))};
  };
  std::pair<Over, Over> ends{of(region_.at(f)), of(region_.end_of(f))};
  if (ends.second < ends.first) std::swap(ends.first, ends.second);
  return ends;
}

/// Whether a point nearest to edge f lies between, not farther than the radius.
bool DiscCurve::is_nearest(std::uint32_t f, const Place& x, const Place& y) const {
  if (!is_arc_) return is_nearest_to_line(f, x, y);
  const Point way = minus(nearest(v_, region_.at(f), region_.end_of(f)), v_);
  return order(x.mark, way) > 0 && order(way, y.mark) > 0 && dot(way, way) <= 4 * region_.square_;
}

bool DiscCurve::is_nearest_to_line(std::uint32_t f, const Place& x, const Place& y) const {
  const auto [low, high] = over(f);
  const mpq_class square = region_.square_ * square_;
  const auto above = [&](const mpq_class& h) { return h <= 0 ? -1 : cmp(h * h, square); };
  if (above(low.height) < 0 && above(high.height) > 0) {  // the edge crosses the line
    const mpq_class part = (high.along - low.along) / (high.height - low.height);
    const auto past = [&](const Place& z) {
      return sign((height(z.at) - low.height) * part + low.along - z.mark.x);
    };
    return past(x) > 0 && past(y) < 0;
  }
  const mpq_class level = above(high.height) <= 0 ? high.height : low.height;
  if (level < 0 || level * level > 4 * square) return false;
  const bool both = low.height == high.height;
  const mpq_class& first = both || low.height == level ? low.along : high.along;
  const mpq_class& last = both || high.height == level ? high.along : low.along;
  return sign(Root(last) - x.mark.x) > 0 && sign(y.mark.x - first) > 0;
}

/// All points between are farther than the radius from all edges but their own.
void DiscCurve::demand_free(const Place& x, const Place& y, Followed& all) const {
  for (const std::uint32_t f : region_.near(n_)) {
    if (is_arc_ ? region_.has_end(f, v_) : f == n_) continue;
    region_.budget_.spend(1);
    demand(region_.far(x.at, f) >= 0 && region_.far(y.at, f) >= 0 && !is_nearest(f, x, y),
           "edge " + std::to_string(f) + " is near to a free part");
    for (const Place* z : {&x, &y}) {
      if (region_.far(z->at, f) > 0) continue;
      if (z->key.is_joint()) {
        all.touched.insert({z->key.number, f});
        continue;
      }
      const Point& tip = tips_[z->key == ends_[0].key ? 0 : 1];
      demand(z->key.kind != Key::Kind::none && region_.has_end(f, tip),
             "edge " + std::to_string(f) + " touches a curve where no joint is");
    }
  }
}

/// All points between are nearer to edge f than the radius.
void DiscCurve::demand_blocked(const Place& x, const Place& y, std::uint32_t f) const {
  region_.budget_.spend(1);
  const int a = region_.far(x.at, f), b = region_.far(y.at, f);
  bool is_good = a <= 0 && b <= 0 && a + b < 0;
  if (is_arc_ && is_good) {
    const Point way = minus(v_, nearest(v_, region_.at(f), region_.end_of(f)));
    const bool is_past = order(x.mark, way) > 0 && order(way, y.mark) > 0;
    is_good = (way.x != 0 || way.y != 0) && !is_past;
  }
  demand(is_good, "edge " + std::to_string(f) + " is not near to a blocked part");
}

/// All points between are right between this edge and edge f.
void DiscCurve::demand_facing(const Place& x, const Place& y, std::uint32_t f) const {
  const auto [low, high] = over(f);
  const mpq_class& h = low.height;
  const bool is_good = !is_arc_ && h == high.height && h > 0 &&
                       h * h == 4 * region_.square_ * square_ && sign(x.mark.x - low.along) >= 0 &&
                       sign(Root(high.along) - y.mark.x) >= 0;
  demand(is_good, "edge " + std::to_string(f) + " does not face the curve's");
}

void DiscCurve::follow(const Value& walk, Followed& all) const {
  const auto& entries = items(walk);
  require(entries.size() > 2 && entries.size() % 2 == 1, "a curve is not places and links");
  std::vector<Place> places{end(entries.front(), ends_[0], all)};
  for (std::size_t i = 2; i + 1 < entries.size(); i += 2) {
    places.push_back(between(entries[i], all));
  }
  places.push_back(end(entries.back(), ends_[1], all));
  for (const Place& z : places) {
    if (z.key.is_joint()) all.on.insert({z.key.number, n_, is_arc_});
  }
  Key start;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Place &x = places[i], &y = places[i + 1];
    const Value& link = entries[2 * i + 1];
    require(!x.key.is_joint() || !y.key.is_joint(), "two joints have no place between");
    demand(order(x.mark, y.mark) > 0, "places are out of order");
    if (link.kind != Value::Kind::text || link.text != "free") {
      require(start.kind == Key::Kind::none, "a free part ends nowhere");
      const bool is_list = link.kind == Value::Kind::list;
      const std::uint32_t f = index(is_list ? items(link, 1)[0] : link, region_.count());
      is_list ? demand_facing(x, y, f) : demand_blocked(x, y, f);
      continue;
    }
    demand_free(x, y, all);
    if (start.kind == Key::Kind::none) start = x.key;
    require(start.kind != Key::Kind::none, "a free part begins nowhere");
    all.parts.push_back({this, x, y, all.pieces.size()});
    if (y.key.kind != Key::Kind::none) {
      all.pieces.push_back({start, y.key, this});
      start = {};
    }
  }
}

std::vector<mpq_class> DiscCurve::name() const {
  if (is_arc_) return {0, v_.x, v_.y};
  const mpz_class unit = lcm(along_.x.get_den(), along_.y.get_den());
  const mpz_class x = along_.x.get_num() * (unit / along_.x.get_den());
  const mpz_class y = along_.y.get_num() * (unit / along_.y.get_den());
  const mpz_class common = gcd(x, y);
  const mpq_class dx(x / common), dy(y / common);
  return {1, dx, dy, dy * v_.x - dx * v_.y};
}

std::string DiscCurve::what() const {
  return (is_arc_ ? "the arc of edge " : "the curve of edge ") + std::to_string(n_);
}

}  // namespace minkref::checker
