#include "oracle/checker/disc/disc_sum.hpp"

#include <algorithm>
#include <memory>

#include "oracle/checker/disc/disc_curve.hpp"
#include "oracle/checker/following.hpp"
#include "oracle/checker/sha256.hpp"

namespace minkref::checker {
namespace {

constexpr const char* disc_sum_form = "disc-sum-certificate-v1";

using Name = std::vector<mpq_class>;
using Names = std::vector<Name>;
using Ring = std::vector<std::size_t>;  // pieces by number

RootPoint read_joint(const Value& value) {
  const auto& parts = items(value, 4);
  const mpq_class first = number(parts[0]);
  const Point more = point(parts[1]);
  demand(first > 0, "a root is not of a positive number");
  const auto simple = std::make_shared<const RootField>(RootField{first, 1, 0});
  demand(sign(Root(simple, more.x, more.y, 0, 0)) > 0, "a root is not of a positive number");
  const auto field = std::make_shared<const RootField>(RootField{first, more.x, more.y});
  const auto read = [&](const Value& entry) {
    const auto& c = items(entry, 4);
    return Root(field, number(c[0]), number(c[1]), number(c[2]), number(c[3]));
  };
  Root x = read(parts[2]);
  return {std::move(x), read(parts[3])};
}

/// Curves that go on count once; the ring begins so as to be least.
Names least(const Names& ring) {
  Names names;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != ring[(i + ring.size() - 1) % ring.size()]) names.push_back(ring[i]);
  }
  if (names.empty()) names.push_back(ring.front());
  Names best = names;
  for (std::size_t i = 1; i < names.size(); ++i) {
    std::rotate(names.begin(), names.begin() + 1, names.end());
    best = std::min(best, names);
  }
  return best;
}

std::string told(const Names& ring) {
  std::string text;
  for (const Name& name : ring) {
    text += std::string(text.empty() ? "[[" : ",[") + (name[0] == 0 ? "\"arc\"" : "\"line\"");
    for (std::size_t i = 1; i < name.size(); ++i) text += ",\"" + name[i].get_str() + "\"";
    text += "]";
  }
  return text + "]";
}

std::size_t classes(const std::vector<DiscPiece>& pieces, std::size_t& keys) {
  std::map<Key, Key> above;
  const auto root = [&](Key x) {
    while (!(above.at(x) == x)) x = above.at(x);
    return x;
  };
  for (const DiscPiece& piece : pieces) {
    above.insert({piece.start, piece.start});
    above.insert({piece.end, piece.end});
    above.at(root(piece.start)) = root(piece.end);
  }
  keys = above.size();
  return static_cast<std::size_t>(std::count_if(
      above.begin(), above.end(), [](const auto& pair) { return pair.first == pair.second; }));
}

class DiscSum {
 public:
  DiscSum(const Operand& P, const mpq_class& square, Budget& budget) : region_(P, square, budget) {}

  std::string claim(const Value& claim) {
    region_.budget_.spend(64);
    require(claim.kind == Value::Kind::object, "a claim is no object");
    for (const auto& [name, value] : claim.members) {
      if (name != "claim" || value.kind != Value::Kind::text) continue;
      if (value.text == "sum") return sum(claim) + region_.of_radius();
      if (value.text == "point") return where(claim) + region_.of_radius();
    }
    throw NotVerified(Code::malformed, "there is no such claim");
  }

 private:
  std::string sum(const Value& claim) {
    const auto m = members(claim, "claim joints edges arcs components holes digest");
    Followed all;
    for (const Value& joint : items(*m[1])) all.joints.push_back(read_joint(joint));
    const std::vector<std::unique_ptr<DiscCurve>> curves = made();
    const auto& edges = items(*m[2], region_.count());
    const auto& arcs = items(*m[3], curves.size() - edges.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      within(curves[i]->what(),
             [&] { curves[i]->follow(i < edges.size() ? edges[i] : arcs[i - edges.size()], all); });
    }
    std::set<std::uint32_t> used;
    for (const auto& [joint, n, is_arc] : all.on) used.insert(joint);
    require(used.size() == all.joints.size(), "a joint is not used");
    demand_joints_where_touched(all);
    return counted(*m[4], *m[5], *m[6], all);
  }

  std::vector<std::unique_ptr<DiscCurve>> made() const {
    std::vector<std::unique_ptr<DiscCurve>> curves;
    for (const bool is_arc : {false, true}) {
      for (std::uint32_t n = 0; n < region_.count(); ++n) {
        if (is_arc && !region_.turns_left(n)) continue;
        curves.push_back(std::make_unique<DiscCurve>(region_, n, is_arc));
      }
    }
    return curves;
  }

  void demand_joints_where_touched(const Followed& all) const {
    for (const auto& [joint, f] : all.touched) {
      bool is_there = all.on.contains({joint, f, false});
      for (std::uint32_t n = 0; n < region_.count() && !is_there; ++n) {
        is_there = region_.has_end(f, region_.at(n)) && all.on.contains({joint, n, true});
      }
      demand(is_there, "edge " + std::to_string(f) + " has no joint where it touches");
    }
  }

  std::string counted(const Value& components, const Value& holes, const Value& digest,
                      const Followed& all) const {
    std::vector<std::vector<Names>> form;
    std::set<std::uint32_t> found;
    std::vector<std::size_t> used;
    for (const Value& component : items(components)) {
      form.push_back(names_of(component, all, found, used));
    }
    std::sort(used.begin(), used.end());
    bool is_each = used.size() == all.pieces.size();
    for (std::size_t i = 0; is_each && i < used.size(); ++i) is_each = used[i] == i;
    require(is_each, "pieces are not in one ring each");
    demand(form.size() == region_.components(),
           "there are " + std::to_string(region_.components()) + " components");
    std::size_t keys = 0;
    const std::size_t connected = classes(all.pieces, keys);
    const mpz_class count = mpz_class(all.pieces.size() + connected) - keys - form.size();
    demand(integer(holes) == count, "there are " + count.get_str() + " holes");
    std::sort(form.begin(), form.end());
    std::string text;
    for (const auto& one : form) {
      text += text.empty() ? "{\"components\":[" : ",";
      text += "{\"holes\":[";
      for (std::size_t i = 1; i < one.size(); ++i) text += (i > 1 ? "," : "") + told(one[i]);
      text += "],\"outer\":" + told(one[0]) + "}";
    }
    text += "],\"squared_radius\":\"" + region_.square_.get_str() + "\"}";
    demand(digest.kind == Value::Kind::text && sha256(text) == digest.text,
           "the sum has another digest");
    return "sum: " + std::to_string(form.size()) + " components, " + count.get_str() + " holes, " +
           digest.text;
  }

  /// The outer ring and the holes, in the canonical form.
  std::vector<Names> names_of(const Value& component, const Followed& all,
                              std::set<std::uint32_t>& found,
                              std::vector<std::size_t>& used) const {
    std::vector<Ring> rings;
    for (const Value& value : items(component)) {
      Ring& ring = rings.emplace_back();
      for (const Value& entry : items(value)) ring.push_back(index(entry, all.pieces.size()));
    }
    require(!rings.empty(), "a ring is missing or empty");
    for (const Ring& ring : rings) require(!ring.empty(), "a ring is missing or empty");
    std::set<std::uint32_t> own;
    for (const Ring& ring : rings) {
      std::set<Key> keys;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const DiscPiece& piece = all.pieces[ring[i]];
        demand(piece.end == all.pieces[ring[(i + 1) % ring.size()]].start,
               "a ring's pieces do not follow each other");
        keys.insert(piece.start);
        own.insert(region_.component(piece.curve->edge()));
      }
      demand(keys.size() == ring.size(), "a ring passes a joint twice");
      used.insert(used.end(), ring.begin(), ring.end());
    }
    require(own.size() == 1 && found.insert(*own.begin()).second, "rings of several components");
    demand_outer_first(rings[0], *own.begin(), all);
    std::vector<Names> names;
    for (const Ring& ring : rings) {
      Names& curves = names.emplace_back();
      for (const std::size_t piece : ring) curves.push_back(all.pieces[piece].curve->name());
      curves = least(curves);
    }
    std::sort(names.begin() + 1, names.end());
    return names;
  }

  /// The component's top, above its highest vertex, is on the outer ring.
  void demand_outer_first(const Ring& outer, std::uint32_t component, const Followed& all) const {
    std::optional<Point> top;
    for (std::uint32_t n = 0; n < region_.count(); ++n) {
      const Point& p = region_.at(n);
      if (region_.component(n) != component) continue;
      if (!top || p.y > top->y || (p.y == top->y && p.x > top->x)) top = p;
    }
    const RootPoint up = Point{0, 1};
    bool is_found = false;
    for (const FreePart& part : all.parts) {
      const DiscCurve& curve = *part.curve;
      if (!curve.is_arc() || !(curve.centre() == *top)) continue;
      if (curve.order(part.from.mark, up) <= 0 || curve.order(up, part.to.mark) < 0) continue;
      is_found = std::find(outer.begin(), outer.end(), part.piece) != outer.end();
      if (!is_found) break;
    }
    demand(is_found, "the outer ring does not come first");
  }

  /// Whether a point is nearer than the radius (-1), or farther (1).
  std::string where(const Value& claim) const {
    const auto m = members(claim, "claim point distance");
    const Point p = point(*m[1]);
    region_.budget_.spend(region_.count());
    std::optional<mpq_class> far;
    for (std::uint32_t n = 0; n < region_.count(); ++n) {
      mpq_class one = squared_distance(p, region_.at(n), region_.end_of(n));
      if (!far || one < *far) far = std::move(one);
    }
    const int found =
        *far > 0 && region_.winds(p) > 0 ? -1 : sgn(mpq_class(*far - region_.square_));
    demand(integer(*m[2]) == found, "the point is not as far from P");
    const char* words[] = {" is inside", " is at the radius", " is outside"};
    return "point: (" + p.x.get_str() + ", " + p.y.get_str() + ")" + words[found + 1];
  }

  DiscRegion region_;
};

}  // namespace

bool is_disc_sum_certificate(const Value& certificate) {
  return has_form(certificate, disc_sum_form);
}

std::vector<std::string> check_disc_sums(const Value& certificate,
                                         const std::function<Value(const std::string&)>& read_case,
                                         Budget& budget) {
  return check_discs(certificate, read_case, [&](const Operand& P, const mpq_class& square) {
    const auto sums = std::make_shared<DiscSum>(P, square, budget);
    return [sums](const Value& claim) { return sums->claim(claim); };
  });
}

}  // namespace minkref::checker
