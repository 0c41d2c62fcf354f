#include "oracle/checker/plane/claims.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "oracle/checker/following.hpp"
#include "oracle/checker/plane/predicate.hpp"
#include "oracle/checker/sha256.hpp"

namespace minkref::checker {
namespace {

/// A claim's regions, for later claims: none, a sum's region, or an interval's regions.
using Shown = std::vector<const Region*>;

struct Event {
  mpq_class scale;
  const char* kind;  ///< topology where components or holes change
};

/// Contacts of a step, along a passage.
struct Passage {
  const Region* region;
  std::vector<Region::Contact> contacts;
};

class Certificate {
 public:
  Certificate(Operand P, Operand Q, Budget& budget)
      : P_(std::move(P)), Q_(std::move(Q)), budget_(budget) {
    require(!(P_.thin && Q_.thin), "both operands are points or segments");
    unit_ = 1;
    for (const Operand* operand : {&P_, &Q_}) {
      for (const Point& p : operand->exact) {
        unit_ = lcm(lcm(unit_, p.x.get_den()), p.y.get_den());
        budget_.spend_unit(unit_, P_.exact.size() + Q_.exact.size());
      }
    }
    for (Operand* operand : {&P_, &Q_}) {
      for (const Point& p : operand->exact) {
        budget_.spend(1 + mpz_sizeinbase(unit_.get_mpz_t(), 2) / 64);
        operand->points.push_back({mpz_class(p.x * unit_), mpz_class(p.y * unit_)});
      }
      check_orientation(*operand);
    }
  }

  void add_step(const Value& step) {
    require(step.kind == Value::Kind::object, "a step is no object");
    const std::string rule = rule_of(step, "rule");
    if (rule == "pieces") {
      const auto parts = members(step, "rule of pieces groups");
      const std::string of = parts[1]->kind == Value::Kind::text ? parts[1]->text : "";
      require(of == "P" || of == "Q", "there is no such operand");
      pieces_.push_back(std::make_unique<Pieces>(*parts[1], *parts[2], *parts[3],
                                                 of == "P" ? P_ : Q_, normals_, budget_));
      regions_.emplace_back();
    } else {
      require(rule == "eq" || rule == "move", "there is no rule " + rule);
      const auto parts =
          members(step, "rule scales by box elements cells normals proofs contacts polygons");
      const auto& by = items(*parts[2], 2);
      const Pieces &p = pieces(by[0]), &q = pieces(by[1]);
      require(p.operand.name == "P" && q.operand.name == "Q", "`by` is not of P and Q");
      regions_.push_back(std::make_unique<Region>(step, p, q, unit_, normals_, budget_));
      pieces_.emplace_back();
    }
    used_.push_back(false);
  }

  std::string add_claim(const Value& claim) {
    require(claim.kind == Value::Kind::object, "a claim is no object");
    const std::string kind = rule_of(claim, "claim");
    budget_.spend(64);
    shown_.emplace_back();
    events_.emplace_back();
    passages_.emplace_back();
    if (kind == "sum") return kind + sum(claim);
    if (kind == "interval") return kind + interval(claim);
    if (kind == "event") return kind + event(claim);
    if (kind == "events") return kind + events(claim);
    if (kind == "point") return kind + point_of_sum(claim);
    if (kind == "outside") return kind + outside(claim);
    if (kind == "passage") return kind + passage(claim);
    if (kind == "passages") return kind + passages(claim);
    if (kind == "sign") return kind + sign(claim);
    throw NotVerified(Code::malformed, "there is no claim " + kind);
  }

  void end() const {
    require(!shown_.empty(), "nothing is claimed");
    for (const bool used : used_) require(used, "a step is not used");
  }

 private:
  static void check_orientation(const Operand& operand) {
    if (operand.thin) return;
    for (std::size_t n = 0; n < operand.rings.size(); ++n) {
      const auto& ring = operand.rings[n];
      mpz_class area;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        area += cross(operand.points[ring[i]], operand.points[ring[(i + 1) % ring.size()]]);
      }
      require(sgn(area) == (operand.outer[n] ? 1 : -1),
              operand.name + " has a ring that runs the wrong way");
    }
  }

  static std::string rule_of(const Value& object, const std::string& name) {
    for (const auto& [member, value] : object.members) {
      if (member == name && value.kind == Value::Kind::text) return value.text;
    }
    return "?";
  }

  const Pieces& pieces(const Value& value) {
    const std::uint32_t n = index(value, used_.size());
    require(pieces_[n] != nullptr, "a step is no pieces");
    used_[n] = true;
    return *pieces_[n];
  }
  const Region& region(const Value& value) {
    const std::uint32_t n = index(value, used_.size());
    require(regions_[n] != nullptr, "a step is no region");
    used_[n] = true;
    return *regions_[n];
  }
  const Region& region_at(const Value& step, const Value& at) {
    const Region& found = region(step);
    demand(found.scales() == std::vector{scale(at)}, "the step is about another scale");
    return found;
  }
  const Shown& earlier(const Value& value, bool interval) const {
    const Shown& found = shown_[index(value, shown_.size() - 1)];
    require(!found.empty() && (found[0]->scales().size() == 2) == interval,
            "a claim is of another kind");
    return found;
  }

  static void same_counts(const Region& region, const Value& components, const Value& holes) {
    const mpz_class c = integer(components), h = integer(holes);
    demand(region.components() == c && region.holes() == h, "components or holes are others");
  }
  static void same_digest(const Region& region, const Value& digest) {
    demand(digest.kind == Value::Kind::text &&
               sha256(canonical_json(region.polygons())) == digest.text,
           "the digest is another");
  }

  /// sum: the sum at a scale.
  std::string sum(const Value& claim) {
    const auto m = members(claim, "claim scale step components holes digest polygons?");
    const Region& found = region_at(*m[2], *m[1]);
    same_counts(found, *m[3], *m[4]);
    same_digest(found, *m[5]);
    if (!m[6]->is_null()) {
      demand(written_out(*m[6]) ==
                 written_out(parse_json(canonical_json(found.polygons()), false).members[0].value),
             "the polygons are others");
    }
    shown_.back() = {&found};
    return ": at " + found.scales()[0].get_str() + ", " + m[5]->text;
  }

  /// interval: no event of the boundary between two scales.
  std::string interval(const Value& claim) {
    const auto m = members(claim, "claim from to steps components holes digest");
    mpq_class at = scale(*m[1]);
    Shown regions;
    for (const Value& step : items(*m[3])) regions.push_back(&region(step));
    require(regions.size() % 2 == 1, "moves, and scales between");
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const Region& here = *regions[i];
      require(here.scales().size() == (i % 2 ? 1 : 2), "moves, and scales between");
      demand(here.scales().front() == at, "the steps do not reach from end to end");
      at = here.scales().back();
      same_counts(here, *m[4], *m[5]);
      demand(here.form() == (i % 2 ? regions[0]->at(at) : regions[0]->form()),
             "the boundary changes at a joint");
    }
    demand(at == scale(*m[2]), "the steps do not reach from end to end");
    same_digest(*regions[0], *m[6]);
    shown_.back() = regions;
    return ": from " + regions[0]->scales()[0].get_str() + " to " + at.get_str() + ", " +
           m[6]->text;
  }

  /// event: the boundary or topology at a scale differs from below or above.
  std::string event(const Value& claim) {
    const auto m = members(claim, "claim scale kind before at after");
    const std::string kind = m[2]->kind == Value::Kind::text ? m[2]->text : "";
    require(kind == "boundary" || kind == "topology", "there is no such event");
    const Shown &low = earlier(*m[3], true), &high = earlier(*m[5], true);
    const Region& here = *earlier(*m[4], false)[0];
    const mpq_class s = scale(*m[1]);
    demand(low.back()->scales().back() == s && here.scales()[0] == s && high[0]->scales()[0] == s,
           "not at one scale");
    const auto counts = [](const Region& r) { return std::pair(r.components(), r.holes()); };
    const bool as_many = counts(*low[0]) == counts(here) && counts(here) == counts(*high[0]);
    const bool same = kind == "boundary"
                          ? low[0]->form() == high[0]->form() && low[0]->at(s) == here.form()
                          : as_many;
    demand(!same, "nothing changes");
    events_.back() = Event{s, as_many ? "boundary" : "topology"};
    return ": " + kind + " at " + s.get_str();
  }

  /// events: all events of the boundary between two scales; intervals without any, and events where
  /// they meet.
  std::string events(const Value& claim) {
    const auto m = members(claim, "claim from to intervals events scales kinds components holes");
    const auto &through = items(*m[3]), &claims = items(*m[4]);
    require(through.size() == claims.size() + 1, "intervals, and events between");
    const std::size_t count = claims.size();
    const auto &scales = items(*m[5], count), &kinds = items(*m[6], count);
    const auto &components = items(*m[7], count + 1), &holes = items(*m[8], count + 1);
    const mpq_class from = scale(*m[1]), to = scale(*m[2]);
    mpq_class at = from;
    for (std::size_t i = 0; i <= count; ++i) {
      const Shown& interval = earlier(through[i], true);
      demand(interval[0]->scales().front() == at, "the intervals do not reach from end to end");
      same_counts(*interval[0], components[i], holes[i]);
      at = interval.back()->scales().back();
      if (i == count) break;
      const std::optional<Event>& event = events_[index(claims[i], events_.size() - 1)];
      require(event.has_value(), "a claim is of another kind");
      demand(event->scale == at && scale(scales[i]) == at, "no event where intervals meet");
      demand(kinds[i].kind == Value::Kind::text && kinds[i].text == event->kind,
             "an event is of the other kind");
    }
    demand(at == to, "the intervals do not reach from end to end");
    return ": from " + from.get_str() + " to " + to.get_str() + ", all " + std::to_string(count);
  }

  static bool is_in_box(const Point& at, const std::vector<Vector>& ring) {
    Vector low = ring[0], high = ring[0];
    for (const Vector& v : ring) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
    return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
  }

  /// point: x = s p + q; a piece of P holds p, a piece of Q holds q.
  std::string point_of_sum(const Value& claim) {
    const auto m = members(claim, "claim scale point p q by pieces");
    const mpq_class s = scale(*m[1]);
    const Point x = point(*m[2]), p = point(*m[3]), q = point(*m[4]);
    demand(Point{s * p.x + q.x, s * p.y + q.y} == x, "s p + q is another point");
    const auto &by = items(*m[5], 2), &numbers = items(*m[6], 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const Pieces& set = pieces(by[i]);
      require(set.operand.name == (i ? "Q" : "P"), "no pieces of it");
      const auto& ring = set.hulls[index(numbers[i], set.count)];
      const Point &given = i ? q : p, at{given.x * unit_, given.y * unit_};
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector d = minus(ring[(k + 1) % ring.size()], ring[k]);
        demand(d.x * (at.y - ring[k].y) - d.y * (at.x - ring[k].x) >= 0,
               "a point is not in its piece");
      }
      demand(is_in_box(at, ring), "a point is not in its piece");  // of a segment, or a point
    }
    return ": at " + s.get_str();
  }

  /// outside: normals hold a point strictly apart from all pairs of pieces.
  std::string outside(const Value& claim) {
    const auto m = members(claim, "claim scale point by normals code");
    const mpq_class s = scale(*m[1]);
    const Point x = point(*m[2]);
    const auto& by = items(*m[3], 2);
    const Pieces &p = pieces(by[0]), &q = pieces(by[1]);
    require(p.operand.name == "P" && q.operand.name == "Q", "`by` is not of P and Q");
    const std::vector<std::uint32_t> own = read_normals(*m[4], normals_);
    const auto& code = items(*m[5]);
    budget_.spend(code.size());
    const auto apart = [&](std::uint32_t A, std::uint32_t B, const Value& entry) {
      const std::uint32_t normal = own[index(entry, own.size())];
      const Vector& n = normals_[normal];
      const mpq_class here = (n.x * x.x + n.y * x.y) * unit_;
      demand(here > s * p.most(A, normal) + q.most(B, normal), "a normal does not separate");
    };
    follow_code(p, q, code.data(), code.data() + code.size(), apart);
    return ": at " + s.get_str();
  }

  /// passage: points inside the sum, but outside the sum of the interiors.
  std::string passage(const Value& claim) {
    const auto m = members(claim, "claim scale step points path");
    const Region& found = region_at(*m[2], *m[1]);
    require(!P_.thin && !Q_.thin, "passages of a point or a segment are not proven by contacts");
    std::vector<std::uint32_t> ids;
    for (const Value& id : items(*m[4])) ids.push_back(found.point_number(id));
    std::vector<Vertex> points, places;
    for (const Value& value : items(*m[3])) {
      const Point p = point(value);
      points.push_back({p.x, p.y});
    }
    for (const std::uint32_t id : ids) places.push_back(found.vertex(id));
    demand(points == places, "other points");
    require(!ids.empty(), "a passage has no point");
    passages_.back() = Passage{&found, {}};
    for (std::size_t i = 0; i + 1 < ids.size() || i == 0; ++i) {
      const Region::Contact contact = ids.size() == 1 ? ids : Region::Contact{ids[i], ids[i + 1]};
      demand(found.is_contact(contact) && found.is_within(contact),
             "not inside the sum, or not apart from that of the interiors");
      passages_.back()->contacts.push_back(contact);
    }
    return ": at " + found.scales()[0].get_str();
  }

  /// passages: all points inside the sum that the sum of the interiors misses are on these.
  std::string passages(const Value& claim) {
    const auto m = members(claim, "claim scale step passages inner");
    const Region& found = region_at(*m[2], *m[1]);
    require(!P_.thin && !Q_.thin, "passages of a point or a segment are not proven by contacts");
    std::map<Region::Contact, std::set<Region::NodePair>> places = found.places_between();
    std::set<std::uint32_t> listed;
    for (const Value& value : items(*m[3])) {
      const std::uint32_t n = index(value, passages_.size() - 1);
      require(passages_[n] && passages_[n]->region == &found, "no passage of this step");
      require(listed.insert(n).second, "a passage is listed twice");
      for (Region::Contact contact : passages_[n]->contacts) {
        for (const std::uint32_t point : contact) places.erase({point});
        std::sort(contact.begin(), contact.end());
        places.erase(contact);
      }
    }
    std::erase_if(places, [&](const auto& place) {
      return found.is_in_open_sums(place.first, place.second);
    });
    for (const Value& entry : items(*m[4])) {
      const auto& parts = items(entry, 2);
      Region::Contact place;
      for (const Value& id : items(parts[0])) place.push_back(found.point_number(id));
      std::sort(place.begin(), place.end());
      require(places.erase(place) == 1, "it is between no cells, or shown already");
      std::set<Region::NodePair> nodes;
      for (const Value& pair : items(parts[1])) nodes.insert(found.solid_pair(pair));
      demand(found.is_in_open_sums(place, nodes), "it is not inside these sums");
    }
    demand(places.empty(), "a point is on no passage that is listed");
    return ": " + std::to_string(listed.size()) + " at " + found.scales()[0].get_str();
  }

  /// sign: a predicate's sign between two scales, or at one scale.
  std::string sign(const Value& claim) {
    const auto m = members(claim, "claim of from to sign");
    const mpq_class from = scale(*m[2]), to = scale(*m[3]);
    require(from <= to, "the scales do not ascend");
    const mpz_class wanted = integer(*m[4]);
    require(abs(wanted) <= 1, "this is no sign");
    std::set<int> signs = signs_of(*m[1], P_, Q_, from, to);
    const int sign = static_cast<int>(wanted.get_si());
    const bool has = signs.erase(sign) == 1;
    if (sign != 0) signs.erase(0);
    demand(has && signs.empty(), "the sign is another");
    return ": from " + from.get_str() + " to " + to.get_str();
  }

  Operand P_, Q_;
  Budget& budget_;
  mpz_class unit_;
  Normals normals_;
  std::vector<std::unique_ptr<Pieces>> pieces_;
  std::vector<std::unique_ptr<Region>> regions_;
  std::vector<bool> used_;
  std::vector<Shown> shown_;
  std::vector<std::optional<Event>> events_;
  std::vector<std::optional<Passage>> passages_;
};

bool is_axes_certificate(const Value& certificate) {
  if (certificate.kind != Value::Kind::object) return false;
  for (const auto& [member, entry] : certificate.members) {
    if (member == "certificate") {
      return entry.kind == Value::Kind::text && entry.text == "axes-certificate-v1";
    }
  }
  return false;
}

/// Scales the operand by a factor for each axis, and returns the words for it.
std::string scaled_by_axes(Operand& P, const Value& axes) {
  const auto& factors = items(axes, 2);
  const mpq_class x = scale(factors[0]), y = scale(factors[1]);
  for (Point& point : P.exact) {
    point.x *= x;
    point.y *= y;
  }
  return "P by " + x.get_str() + "," + y.get_str() + ": ";
}

}  // namespace

std::vector<std::string> check(const Value& certificate,
                               const std::function<Value(const std::string&)>& read_case,
                               Budget& budget) {
  const bool has_axes = is_axes_certificate(certificate);
  const auto m = members(certificate, std::string("certificate title? comment? producer? case ") +
                                          (has_axes ? "axes " : "") + "steps claims");
  require(has_axes || (m[0]->kind == Value::Kind::text && m[0]->text == "certificate-v1"),
          "this is no certificate-v1");
  for (const Value* told : {m[1], m[2], m[3]}) {
    require(told->is_null() || told->kind == Value::Kind::text, "what carries no truth is no text");
  }
  const auto of = members(*m[4], "path sha256");
  const Value value = read_case(path(*of[0]));
  require(value.kind == Value::Kind::object, "this is no case");
  Operand sets[2];
  for (int i = 0; i < 2; ++i) {
    const std::string name = i ? "Q" : "P";
    const Value* found = nullptr;
    for (const auto& [member, entry] : value.members) {
      if (member == name) found = &entry;
    }
    require(found != nullptr, "this is no case");
    sets[i] = read_operand(*found, name);
  }
  const std::string plain = "{\"P\":" + sets[0].plain + ",\"Q\":" + sets[1].plain + "}";
  demand(of[1]->kind == Value::Kind::text && sha256(plain) == of[1]->text,
         "this is not the case that is certified");
  const std::string scaled = has_axes ? scaled_by_axes(sets[0], *m[5]) : "";
  Certificate proof(std::move(sets[0]), std::move(sets[1]), budget);
  std::vector<std::string> said = followed(proof, *m[m.size() - 2], *m[m.size() - 1]);
  for (std::string& line : said) line.insert(0, scaled);
  return said;
}

}  // namespace minkref::checker
