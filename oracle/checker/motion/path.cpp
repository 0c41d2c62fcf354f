#include "oracle/checker/motion/path.hpp"

#include <algorithm>
#include <memory>
#include <set>

#include "oracle/checker/following.hpp"
#include "oracle/checker/motion/path_clear.hpp"
#include "oracle/checker/sha256.hpp"

namespace minkref::checker {
namespace {

constexpr const char* path_form = "path-certificate-v1";
constexpr const char* sets[] = {"R", "O"};

const Value* member_of(const Value& object, const std::string& name) {
  for (const auto& [member, value] : object.members) {
    if (member == name) return &value;
  }
  return nullptr;
}

std::string word_of(const Value& object, const std::string& name) {
  const Value* found = member_of(object, name);
  return found != nullptr && found->kind == Value::Kind::text ? found->text : "?";
}

/// Whether a closed polyline that misses a point winds around the point.
bool winds_around(const Path& ring, const Point& x) {
  int times = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y <= x.y) == (b.y <= x.y)) continue;
    const mpq_class side = (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
    if (b.y > a.y && side > 0) ++times;
    if (b.y < a.y && side < 0) --times;
  }
  return times != 0;
}

/// A claim about the path or the place, kept for later claims.
struct Said {
  std::string kind;
  bool strict;
  Scales scales;
};

class PathCertificate {
 public:
  PathCertificate(Operand R, Operand O, Path path, Budget& budget)
      : operands_{std::move(R), std::move(O)},
        path_(std::move(path)),
        ways_(segments(path_)),
        budget_(budget) {
    require(!(operands_[0].thin && operands_[1].thin), "both operands are points or segments");
    for (const Operand& operand : operands_) {
      for (const Point& p : operand.exact) {
        unit_ = lcm(lcm(unit_, p.x.get_den()), p.y.get_den());
        budget_.spend_unit(unit_, operands_[0].exact.size() + operands_[1].exact.size());
      }
    }
    for (Operand& operand : operands_) {
      for (const Point& p : operand.exact) {
        operand.points.push_back({mpz_class(p.x * unit_), mpz_class(p.y * unit_)});
      }
      check_orientation(operand);
    }
  }

  void add_step(const Value& step) {
    const std::string rule = word_of(step, "rule");
    require(rule == "pieces" || rule == "clear", "there is no such rule");
    if (rule == "pieces") {
      const auto m = members(step, "rule of pieces groups");
      const std::string name = word_of(step, "of");
      require(name == "R" || name == "O", "there is no such operand");
      pieces_.push_back(
          std::make_unique<Pieces>(*m[1], *m[2], *m[3], operands_[name == "O"], normals_, budget_));
      clear_.emplace_back();
    } else {
      const auto m = members(step, "rule by contact path scales normals codes");
      const PiecesOfBoth by = pieces_of_both(*m[1]);
      const bool strict = is_strict(*m[2]);
      clear_.push_back(std::make_unique<Clear>(
          by, strict, m[3]->is_null() ? staying(path_) : read_moving_path(*m[3]), Scales(*m[4]),
          *m[5], *m[6], unit_, normals_, budget_));
      pieces_.emplace_back();
    }
    used_.push_back(false);
  }

  std::string add_claim(const Value& claim) {
    const std::string kind = word_of(claim, "claim");
    budget_.spend(64);
    said_.emplace_back();
    if (kind == "free") return free(claim);
    if (kind == "hit") return hit(claim);
    if (kind == "valid") return answer(claim, "valid", {"free", "hit"});
    if (kind == "trap") {
      place();
      return answer(claim, "trapped", {"trapped", "escapes", "hit"});
    }
    if (kind == "escapes") return escapes(claim);
    if (kind == "trapped") return trapped(claim);
    throw NotVerified(Code::malformed, "there is no such claim");
  }

  void end() const {
    require(!said_.empty(), "nothing is claimed");
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

  /// Whether contact is forbidden. With contact allowed both operands need an area, else a part
  /// could pass through seams between pieces.
  bool is_strict(const Value& contact) const {
    const std::string word = contact.kind == Value::Kind::text ? contact.text : "?";
    require(word == "allowed" || word == "forbidden", "there is no such contact");
    require(word == "forbidden" || !(operands_[0].thin || operands_[1].thin),
            "with contact allowed neither may be a point or a segment");
    return word == "forbidden";
  }

  PiecesOfBoth pieces_of_both(const Value& by) {
    const auto& pair = items(by, 2);
    PiecesOfBoth found{};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t n = index(pair[k], used_.size());
      require(pieces_[n] != nullptr, "a step is no pieces");
      used_[n] = true;
      found[k] = pieces_[n].get();
    }
    require(found[0]->operand.name == sets[0] && found[1]->operand.name == sets[1],
            "`by` is not of R and O");
    return found;
  }

  const Clear& clear(const Value& step, bool strict, const Value& scales) {
    const std::uint32_t n = index(step, used_.size());
    require(clear_[n] != nullptr, "a step is no clear");
    used_[n] = true;
    demand(clear_[n]->strict == strict && clear_[n]->scales == Scales(scales),
           "the step is about another contact, or other scales");
    return *clear_[n];
  }

  /// Reads nodes of R and O known to be convex.
  static std::array<std::uint32_t, 2> nodes_of(const PiecesOfBoth& by, const Value& value) {
    const auto& pair = items(value, 2);
    std::array<std::uint32_t, 2> nodes{};
    for (std::size_t k = 0; k < 2; ++k) nodes[k] = index(pair[k], by[k]->hulls.size());
    demand(by[0]->solid[nodes[0]] && by[1]->solid[nodes[1]], "a node is not convex");
    return nodes;
  }

  std::string said(const Scales& scales, bool strict) const {
    return ": at " + scales.said() + ", contact " + (strict ? "forbidden" : "allowed");
  }

  /// free: at no scale does a place on the path collide.
  std::string free(const Value& claim) {
    const auto m = members(claim, "claim contact scales step");
    const Clear& step = clear(*m[3], is_strict(*m[1]), *m[2]);
    demand(step.path == staying(path_), "the step is about another path");
    said_.back() = Said{"free", step.strict, step.scales};
    return "free" + said(step.scales, step.strict);
  }

  /// hit: at each scale some place of the path collides.
  std::string hit(const Value& claim) {
    const auto m = members(claim, "claim contact scales by hits");
    const bool strict = is_strict(*m[1]);
    const Scales scales(*m[2]);
    const PiecesOfBoth by = pieces_of_both(*m[3]);
    Cut reach = scales.low;
    std::size_t n = 0;
    for (const Value& one : items(*m[4])) {
      within("hit " + std::to_string(n++), [&] {
        const auto [low, high] = scales_of_hit(one, by, !strict);
        demand(!(reach < low) && reach < high, "it leaves out scales before it, or adds none");
        reach = high;
      });
    }
    demand(!(reach < scales.high), "the hits do not reach to the last scale");
    said_.back() = Said{"hit", strict, scales};
    return "hit" + said(scales, strict);
  }

  std::pair<Cut, Cut> scales_of_hit(const Value& value, const PiecesOfBoth& by, bool interiors) {
    const auto m = members(value, "segment nodes points");
    const auto& [from, to] = ways_[index(*m[0], ways_.size())];
    const auto [A, B] = nodes_of(by, *m[1]);
    const auto of_A = sides(by[0]->hulls[A]), of_B = sides(by[1]->hulls[B]);
    std::vector<Value> entries = items(*m[2]);
    const bool up =
        !entries.empty() && entries.back().kind == Value::Kind::text && entries.back().text == "up";
    if (up) entries.pop_back();
    require(!entries.empty(), "a hit has no point");
    std::vector<mpq_class> scales;
    std::vector<std::vector<mpq_class>> levels;  // positive: out of a piece
    const auto most = [&](std::size_t k, std::uint32_t node, const Vector& normal) {
      return mpq_class(by[k]->most(node, normals_.add(normal)));
    };
    const auto along = [&](const Vector& n, const Point& p) -> mpq_class {
      return unit_ * (n.x * p.x + n.y * p.y);
    };
    for (const Value& entry : entries) {
      budget_.spend(of_A.size() + of_B.size());
      const auto& parts = items(entry, 3);
      const mpq_class t = number(parts[0]), s = number(parts[1]);
      const Point p = point(parts[2]);
      require(t >= 0 && t <= 1 && s >= 0, "this is no place of a segment, or no scale");
      require(scales.empty() || scales.back() < s, "the scales do not ascend");
      const Point off{p.x - from.x - t * (to.x - from.x), p.y - from.y - t * (to.y - from.y)};
      auto& own = levels.emplace_back();
      for (const Vector& n : of_A) own.push_back(along(n, off) - s * most(0, A, n));
      for (const Vector& n : of_B) own.push_back(along(n, p) - most(1, B, n));
      scales.push_back(s);
    }
    if (up) {
      auto& own = levels.emplace_back();
      for (const Vector& n : of_A) own.push_back(-most(0, A, n));
      own.resize(of_A.size() + of_B.size());
    }
    const auto all_below = [](const std::vector<mpq_class>& level, int bound) {
      return std::all_of(level.begin(), level.end(), [&](const auto& v) { return sgn(v) < bound; });
    };
    for (std::size_t k = 0; k < levels.size(); ++k) {
      demand(all_below(levels[k], 1), "a point is not in its piece");
      if (!interiors || k == 0) continue;
      demand(k + 1 == levels.size() || all_below(levels[k], 0),
             "a point is not in the interior of its piece");
      for (std::size_t i = 0; i < levels[k].size(); ++i) {
        demand(levels[k][i] < 0 || levels[k - 1][i] < 0,
               "a point is not in the interior of its piece");
      }
    }
    const bool first_in = scales[0] > 0 && (!interiors || all_below(levels[0], 0));
    const bool last_in = !up && (!interiors || all_below(levels.back(), 0));
    Cut high{std::nullopt, false};
    if (!up) high = {scales.back(), last_in};
    return {{scales[0], !first_in}, high};
  }

  /// valid, trap: scales that claims of the first kind cover. `name`: the member with these
  /// scales.
  std::string answer(const Value& claim, const std::string& name,
                     const std::vector<std::string>& kinds) {
    const auto m = members(claim, "claim contact scales " + name + " claims");
    const bool strict = is_strict(*m[1]);
    const Scales all(*m[2]);
    std::vector<const Said*> parts;
    for (const Value& entry : items(*m[4])) {
      const auto& part = said_[index(entry, said_.size() - 1)];
      require(part && std::find(kinds.begin(), kinds.end(), part->kind) != kinds.end(),
              "a claim is of another kind");
      parts.push_back(&*part);
    }
    Cut reach = all.low;
    std::vector<std::pair<Cut, Cut>> found;
    for (const Said* part : parts) {
      demand(part->strict == strict && part->scales.low == reach,
             "the claims do not follow each other, or are about another contact");
      reach = part->scales.high;
      if (part->kind != kinds[0]) continue;
      if (!found.empty() && found.back().second == part->scales.low) {
        found.back().second = reach;
      } else {
        found.emplace_back(part->scales.low, reach);
      }
    }
    demand(reach == all.high, "the claims do not reach to the last scale");
    std::string line = name == "valid" ? "valid" : "trap";
    line += ": of " + all.said() + ", contact " + (strict ? "forbidden" : "allowed");
    const auto& listed = items(*m[3]);
    std::vector<std::pair<Cut, Cut>> wanted;
    for (const Value& one : listed) {
      const Scales scales(one);
      wanted.emplace_back(scales.low, scales.high);
      line += ", " + scales.said();
    }
    demand(wanted == found, "the scales are others");
    return line;
  }

  const Point& place() const {
    require(path_.size() == 1, "the path of the case is not one place");
    return path_[0];
  }

  /// escapes: a way from the place to a place beyond all collisions along the normal. The way's
  /// places may move with the scale.
  std::string escapes(const Value& claim) {
    const auto m = members(claim, "claim contact scales step normal");
    const Clear& step = clear(*m[3], is_strict(*m[1]), *m[2]);
    demand(step.path[0] == MovingPlace{place(), {}}, "the way begins elsewhere");
    demand(step.apart(step.path.back(), read_normal(*m[4])),
           "its end is not beyond all collisions");
    said_.back() = Said{"escapes", step.strict, step.scales};
    return "escapes" + said(step.scales, step.strict);
  }

  /// trapped: the place is free, and a ring of colliding places leads around it. The ring's
  /// vertices move linearly with the scale.
  std::string trapped(const Value& claim) {
    const auto m = members(claim, "claim contact scales step by ring pairs");
    const Clear& step = clear(*m[3], is_strict(*m[1]), *m[2]);
    const PiecesOfBoth by = pieces_of_both(*m[4]);
    demand(step.path == staying({place()}), "the step is about another place");
    MovingPath ring;
    for (const Value& entry : items(*m[5])) ring.push_back(moving(entry));
    const auto& pairs = items(*m[6], ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto [A, B] = nodes_of(by, pairs[i]);
      for (const MovingPlace* vertex : {&ring[i], &ring[(i + 1) % ring.size()]}) {
        check_inside(*vertex, by, A, B, step);
      }
    }
    const mpq_class s = step.scales.middle();
    Path there;
    for (const MovingPlace& v : ring)
      there.push_back({v.at.x + s * v.slope.x, v.at.y + s * v.slope.y});
    demand(winds_around(there, place()), "the ring does not lead around the place");
    said_.back() = Said{"trapped", step.strict, step.scales};
    return "trapped" + said(step.scales, step.strict);
  }

  /// Demands that B + -sA contains a moving place at all the scales; in its interior if contact is
  /// allowed.
  void check_inside(const MovingPlace& place, const PiecesOfBoth& by, std::uint32_t A,
                    std::uint32_t B, const Clear& step) {
    std::vector<Vector> normals = sides(by[1]->hulls[B]);
    for (const Vector& n : sides(by[0]->hulls[A])) normals.push_back({-n.x, -n.y});
    for (const Vector& n : normals) {
      budget_.spend(2);
      const auto along = [&](const Point& p) -> mpq_class {
        return unit_ * (n.x * p.x + n.y * p.y);
      };
      const mpq_class far = along(place.at) - by[1]->most(B, normals_.add(n));
      const mpq_class grows = along(place.slope) - by[0]->most(A, normals_.add({-n.x, -n.y}));
      Cell touching;
      for (const Corner& end : step.scales.ends()) {
        const int level = sgn(grows * end.s + far * end.w);
        demand(level <= 0, "an edge of the ring is not in the sum of its pieces");
        if (level == 0) touching.push_back(end);
      }
      demand(step.strict || !step.scales.meet(touching),
             "an edge of the ring is not inside the sum of its pieces");
    }
  }

  std::array<Operand, 2> operands_;
  Path path_;
  std::vector<std::pair<Point, Point>> ways_;
  Budget& budget_;
  mpz_class unit_ = 1;
  Normals normals_;
  std::vector<std::unique_ptr<Pieces>> pieces_;
  std::vector<std::unique_ptr<Clear>> clear_;
  std::vector<bool> used_;
  std::vector<std::optional<Said>> said_;
};

std::string plain(const Path& path) {
  std::string text;
  for (const Point& p : path) {
    text += (text.empty() ? "[\"" : ",[\"") + p.x.get_str() + "\",\"" + p.y.get_str() + "\"]";
  }
  return "[" + text + "]";
}

}  // namespace

bool is_path_certificate(const Value& certificate) {
  return word_of(certificate, "certificate") == path_form;
}

std::vector<std::string> check_paths(const Value& certificate,
                                     const std::function<Value(const std::string&)>& read_case,
                                     Budget& budget) {
  const auto m = members(certificate, "certificate title? comment? producer? case steps claims");
  for (const Value* telling : {m[1], m[2], m[3]}) {
    require(telling->is_null() || telling->kind == Value::Kind::text,
            "what carries no truth is no text");
  }
  const auto of = members(*m[4], "path sha256");
  const Value value = read_case(path(*of[0]));
  const Value *R = member_of(value, "R"), *O = member_of(value, "O"),
              *way = member_of(value, "path");
  require(R != nullptr && O != nullptr && way != nullptr, "this is no case");
  Operand part = read_operand(*R, "R"), obstacles = read_operand(*O, "O");
  Path places = read_path(*way);
  const std::string text =
      "{\"O\":" + obstacles.plain + ",\"R\":" + part.plain + ",\"path\":" + plain(places) + "}";
  demand(of[1]->kind == Value::Kind::text && sha256(text) == of[1]->text,
         "this is not the case that is certified");
  PathCertificate proof(std::move(part), std::move(obstacles), std::move(places), budget);
  return followed(proof, *m[5], *m[6]);
}

}  // namespace minkref::checker
