#include "oracle/checker/plane/region.hpp"

#include <algorithm>
#include <numeric>

namespace minkref::checker {
namespace {

mpz_class floor_div(const mpz_class& a, const mpz_class& b) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return quotient;
}

Vertex at_scale(const Vertex& v, const mpq_class& s) {
  if (v.size() == 2) return v;
  return {v[0] + s * v[1], v[2] + s * v[3]};
}

mpq_class doubled_area(const std::vector<Vertex>& ring) {
  mpq_class area;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vertex &a = ring[i], &b = ring[(i + 1) % ring.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

}  // namespace

std::vector<Rings> canonical_order(std::vector<Rings> polygons) {
  for (Rings& rings : polygons) {
    for (auto& ring : rings)
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    std::sort(rings.begin() + 1, rings.end());
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

std::string canonical_json(const std::vector<Rings>& polygons) {
  const auto ring_text = [](const std::vector<Vertex>& ring) {
    std::string text;
    for (const Vertex& v : ring) {
      text += text.empty() ? "[" : ",[";
      for (std::size_t i = 0; i < v.size(); ++i) text += (i ? ",\"" : "\"") + v[i].get_str() + "\"";
      text += "]";
    }
    return "[" + text + "]";
  };
  std::string text;
  for (const Rings& rings : polygons) {
    std::string holes;
    for (std::size_t i = 1; i < rings.size(); ++i)
      holes += (i > 1 ? "," : "") + ring_text(rings[i]);
    text += (text.empty() ? "" : ",") + std::string("{\"holes\":[") + holes +
            "],\"outer\":" + ring_text(rings[0]) + "}";
  }
  return "{\"polygons\":[" + text + "]}";
}

Region::Region(const Value& step, const Pieces& P, const Pieces& Q, const mpz_class& unit,
               Normals& normals, Budget& budget)
    : P_(P), Q_(Q), unit_(unit), normals_(normals), budget_(budget) {
  const auto parts =
      members(step, "rule scales by box elements cells normals proofs contacts polygons");
  for (std::size_t i = 3; i < parts.size(); ++i) items(*parts[i]);
  const bool moves = text(*parts[0]) == "move";
  for (const Value& s : items(*parts[1], moves ? 2 : 1)) scales_.push_back(scale(s));
  require(!moves || scales_[0] < scales_[1], "the scales do not ascend");
  for (std::size_t i = 0; i < 4; ++i) box_[i] = number(items(*parts[3], 4)[i]) * unit_;
  demand(box_[0] < box_[2] && box_[1] < box_[3], "the box is empty");
  for (std::size_t wall = 0; wall < 4; ++wall) {
    const mpz_class& d = box_[wall].get_den();
    const Triple line{wall % 2 ? mpz_class(0) : d, wall % 2 ? d : mpz_class(0),
                      box_[wall].get_num()};
    elements_.emplace_back(scales_.size(), line);
    is_point_.push_back(false);
  }
  for (const Value& entry : items(*parts[4])) add_element(entry);
  for (const Value& entry : items(*parts[5])) {
    auto& cell = cells_.emplace_back();
    for (const Value& corner : items(entry)) cell.push_back(point_number(corner));
  }
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) check_cell(cell);
  check_box();
  own_normals_ = read_normals(*parts[6], normals_);
  const auto& proofs = items(*parts[7], cells_.size());
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    const auto& proof = items(proofs[cell]);
    require(!proof.empty() && proof[0].kind == Value::Kind::text &&
                (proof[0].text == "cov" || proof[0].text == "sep"),
            "a cell has no proof");
    inside_.push_back(proof[0].text == "cov");
    const Value *first = proof.data() + 1, *last = proof.data() + proof.size();
    if (inside_.back()) {
      check_cover(cell, first, last);
    } else {
      check_apart(cells_[cell], first, last);
    }
  }
  for (const Value& entry : items(*parts[8])) {
    const auto& contact = items(entry);
    require(!contact.empty(), "a contact is empty");
    Contact points;
    for (const Value& point : items(contact[0])) points.push_back(point_number(point));
    require(points.size() == 1 || (points.size() == 2 && points[0] != points[1]),
            "this is no point or segment");
    check_apart(points, contact.data() + 1, contact.data() + contact.size());
    contacts_.insert(points);
  }
  count();
  read_polygons(*parts[9]);
}

std::uint32_t Region::point_number(const Value& value) const {
  const std::uint32_t n = index(value, elements_.size());
  require(is_point_[n], "element " + std::to_string(n) + " is no point");
  return n;
}

const Region::Ends& Region::line(const Value& value) const {
  const std::uint32_t n = index(value, elements_.size());
  require(!is_point_[n], "element " + std::to_string(n) + " is no line");
  return elements_[n];
}

void Region::add_element(const Value& value) {
  budget_.spend(1);
  const auto& entry = items(value);
  require(!entry.empty(), "an element has no kind");
  const std::string kind = text(entry[0]);
  Ends ends;
  if (kind == "meet") {
    items(value, 3);
    const Ends &first = line(entry[1]), &second = line(entry[2]);
    for (std::size_t e = 0; e < scales_.size(); ++e) {
      const Triple &f = first[e], &g = second[e];
      Triple p{f.c * g.b - f.b * g.c, f.a * g.c - f.c * g.a, f.a * g.b - f.b * g.a};
      demand(p.c != 0, "parallel lines do not meet");
      mpz_class divisor = gcd(gcd(p.a, p.b), p.c);
      if (p.c < 0) divisor = -divisor;
      ends.push_back({p.a / divisor, p.b / divisor, p.c / divisor});
    }
  } else if (kind == "up") {
    items(value, 2);
    for (const Triple& p : elements_[point_number(entry[1])]) ends.push_back({p.c, 0, p.a});
  } else {
    require(kind == "P" || kind == "Q", "there is no element " + kind);
    items(value, 4);
    for (const mpq_class& s : scales_) ends.push_back(moving_line(kind == "P", entry, s));
  }
  elements_.push_back(std::move(ends));
  is_point_.push_back(kind == "meet");
}

Region::Triple Region::moving_line(bool of_P, const std::vector<Value>& entry,
                                   const mpq_class& s) const {
  const auto& ours = (of_P ? P_ : Q_).operand.points;
  const auto& other = (of_P ? Q_ : P_).operand.points;
  const Vector& from = ours[index(entry[1], ours.size())];
  const Vector d = minus(ours[index(entry[2], ours.size())], from);
  const Vector& by = other[index(entry[3], other.size())];
  demand(d.x != 0 || d.y != 0, "a line has no direction");
  const Vector n{-d.y, d.x};
  const mpz_class own = dot(n, from), moved = dot(n, by);
  const mpz_class &u = s.get_num(), &v = s.get_den();
  Triple line{n.x * v, n.y * v, of_P ? u * own + v * moved : v * own + u * moved};
  const mpz_class divisor = gcd(gcd(line.a, line.b), line.c);
  return {line.a / divisor, line.b / divisor, line.c / divisor};
}

void Region::check_cell(std::uint32_t cell) {
  const auto& corners = cells_[cell];
  budget_.spend(corners.size());
  std::vector<Vector> directions;
  const std::string name = "cell " + std::to_string(cell);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Edge edge{corners[i], corners[(i + 1) % corners.size()]};
    std::vector<Vector> moves;
    for (std::size_t e = 0; e < scales_.size(); ++e) {
      const Triple &p = elements_[edge.first][e], &q = elements_[edge.second][e];
      const Vector d{q.a * p.c - p.a * q.c, q.b * p.c - p.b * q.c};
      if (d.x != 0 || d.y != 0) moves.push_back(d);
    }
    demand(!moves.empty(), name + " has an edge without length");
    demand(moves.size() == 1 || (cross(moves[0], moves[1]) == 0 && dot(moves[0], moves[1]) > 0),
           name + " has an edge that turns");
    demand(owner_.try_emplace(edge, cell).second, "two cells have one edge");
    direction_[edge] = moves[0];
    directions.push_back(moves[0]);
  }
  demand(directions.size() > 2 && is_convex(directions), name + " is not convex");
}

void Region::check_box() const {
  EdgeSum sum;
  const auto at = [&](std::uint32_t n) {
    const Triple& p = elements_[n][0];
    Point result{mpq_class(p.a, p.c), mpq_class(p.b, p.c)};
    result.x.canonicalize();
    result.y.canonicalize();
    return result;
  };
  for (const auto& [edge, cell] : owner_) {
    if (owner_.count({edge.second, edge.first})) continue;
    bool on_wall = false;
    for (std::size_t wall = 0; wall < 4 && !on_wall; ++wall) {
      on_wall = true;
      for (const std::uint32_t n : {edge.first, edge.second}) {
        for (const Triple& p : elements_[n]) {
          on_wall = on_wall && box_[wall] * p.c == (wall % 2 ? p.b : p.a);
        }
      }
    }
    demand(on_wall, "an edge of a cell has no cell on its other side");
    sum.add(at(edge.first), at(edge.second), 1);
  }
  const std::array<Point, 4> corners{Point{box_[0], box_[1]}, Point{box_[2], box_[1]},
                                     Point{box_[2], box_[3]}, Point{box_[0], box_[3]}};
  for (std::size_t i = 0; i < 4; ++i) sum.add(corners[i], corners[(i + 1) % 4], -1);
  demand(sum.is_nothing(), "the cells do not add up to the box");
  if (P_.hulls.empty() || Q_.hulls.empty()) return;
  const std::array<Vector, 4> outward{Vector{-1, 0}, Vector{0, -1}, Vector{1, 0}, Vector{0, 1}};
  for (std::size_t e = 0; e < scales_.size(); ++e) {
    for (std::size_t wall = 0; wall < 4; ++wall) {
      const mpz_class value = most(e, P_.last(), Q_.last(), normals_.add(outward[wall]));
      const mpq_class limit = (wall < 2 ? -1 : 1) * box_[wall] * scales_[e].get_den();
      demand(value < limit, "the box does not hold the sum");
    }
  }
}

mpz_class Region::most(std::size_t end, std::uint32_t A, std::uint32_t B,
                       std::uint32_t normal) const {
  return scales_[end].get_num() * P_.most(A, normal) + scales_[end].get_den() * Q_.most(B, normal);
}

/// Returns the least value (side 1) on points, rounded down, or the largest (side -1), rounded up.
mpz_class Region::least(std::size_t end, const std::vector<std::uint32_t>& corners,
                        const Vector& normal, int side) const {
  const mpz_class factor = side * scales_[end].get_den();
  mpz_class least;
  bool first = true;
  for (const std::uint32_t corner : corners) {
    const Triple& p = elements_[corner][end];
    mpz_class value = floor_div(factor * (normal.x * p.a + normal.y * p.b), p.c);
    if (first || value < least) least = std::move(value);
    first = false;
  }
  return side * least;
}

void Region::check_cover(std::uint32_t cell, const Value* first, const Value* last) {
  const std::vector<std::uint32_t>& corners = cells_[cell];
  require(last - first == 2, "`cov` names two nodes");
  const std::uint32_t A = index(first[0], P_.hulls.size()), B = index(first[1], Q_.hulls.size());
  demand(P_.solid[A] && Q_.solid[B], "a node is not convex");
  covers_[cell] = {A, B};
  for (const auto* hull : {&P_.hulls[A], &Q_.hulls[B]}) {
    for (std::size_t i = 0; i < hull->size(); ++i) {
      budget_.spend(corners.size());
      const Vector d = minus((*hull)[(i + 1) % hull->size()], (*hull)[i]);
      const Vector normal{d.y, -d.x};
      const std::uint32_t n = normals_.add(normal);
      for (std::size_t e = 0; e < scales_.size(); ++e) {
        demand(least(e, corners, normal, -1) <= most(e, A, B, n),
               "a cell is not in the sum of its nodes");
      }
    }
  }
}

void Region::check_apart(const std::vector<std::uint32_t>& corners, const Value* first,
                         const Value* last) {
  budget_.spend(static_cast<std::size_t>(last - first));
  std::map<std::pair<std::size_t, std::uint32_t>, mpz_class> known;
  follow_code(P_, Q_, first, last, [&](std::uint32_t A, std::uint32_t B, const Value& entry) {
    const std::uint32_t normal = own_normals_[index(entry, own_normals_.size())];
    for (std::size_t e = 0; e < scales_.size(); ++e) {
      const auto [place, fresh] = known.try_emplace({e, normal});
      if (fresh) place->second = least(e, corners, normals_[normal], 1);
      demand(place->second >= most(e, A, B, normal), "a normal does not separate");
    }
  });
}

void Region::count() {
  root_.resize(cells_.size());
  std::iota(root_.begin(), root_.end(), 0U);
  const auto find = [&](std::uint32_t cell) {
    while (root_[cell] != cell) cell = root_[cell] = root_[root_[cell]];
    return cell;
  };
  for (const auto& [edge, cell] : owner_) {
    const auto other = owner_.find({edge.second, edge.first});
    if (other != owner_.end() && inside_[cell] == inside_[other->second]) {
      root_[find(cell)] = find(other->second);
    }
  }
  std::set<std::uint32_t> covered, others;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    (inside_[cell] ? covered : others).insert(root_[cell] = find(cell));
  }
  components_ = covered.size();
  holes_ = others.size() - 1;
}

void Region::read_polygons(const Value& value) {
  std::set<Edge> left;
  for (const auto& [edge, cell] : owner_) {
    if (!inside_[cell]) continue;
    const auto other = owner_.find({edge.second, edge.first});
    if (other == owner_.end() || !inside_[other->second]) left.insert(edge);
  }
  const mpq_class middle = (scales_.front() + scales_.back()) / 2;
  std::vector<Rings> made;
  std::set<Vertex> passed;
  for (const Value& polygon : items(value)) {
    Rings rings;
    std::set<std::uint32_t> roots;
    for (const Value& entry : items(polygon)) {
      std::vector<std::uint32_t> ring;
      for (const Value& corner : items(entry)) ring.push_back(point_number(corner));
      demand(ring.size() > 2 && std::set(ring.begin(), ring.end()).size() == ring.size(),
             "a ring is not simple");
      std::vector<Vertex> corners;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t before = ring[(i + ring.size() - 1) % ring.size()];
        const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
        demand(left.erase(edge) == 1, "a ring is not on the boundary, or twice");
        Vertex here = vertex(ring[i]);
        if (!passed.insert(here).second) form_.touching.push_back(std::move(here));
        roots.insert(root_[owner_.at(edge)]);
        const auto in = direction_.find({before, ring[i]});
        demand(in != direction_.end(), "a ring is not on the boundary");
        if (cross(in->second, direction_.at(edge)) != 0) corners.push_back(vertex(ring[i]));
      }
      std::vector<Vertex> here;
      for (const Vertex& v : corners) here.push_back(at_scale(v, middle));
      demand((doubled_area(here) > 0) == rings.empty(), "a ring runs the wrong way");
      rings.push_back(std::move(corners));
    }
    require(!rings.empty(), "a polygon has no ring");
    demand(roots.size() == 1, "a polygon has two components");
    made.push_back(std::move(rings));
  }
  demand(left.empty() && made.size() == components_,
         "the rings are not the boundary, a polygon a component");
  form_.polygons = canonical_order(std::move(made));
  std::sort(form_.touching.begin(), form_.touching.end());
}

Vertex Region::vertex(std::uint32_t point) const {
  std::vector<Point> ends;
  for (const Triple& p : elements_[point]) {
    Point end{mpq_class(p.a, p.c * unit_), mpq_class(p.b, p.c * unit_)};
    end.x.canonicalize();
    end.y.canonicalize();
    ends.push_back(std::move(end));
  }
  if (ends.size() == 1) return {ends[0].x, ends[0].y};
  const mpq_class length = scales_[1] - scales_[0];
  const mpq_class x1 = (ends[1].x - ends[0].x) / length, y1 = (ends[1].y - ends[0].y) / length;
  return {ends[0].x - scales_[0] * x1, x1, ends[0].y - scales_[0] * y1, y1};
}

Form Region::at(const mpq_class& scale) const {
  Form form = form_;
  for (Rings& rings : form.polygons) {
    for (auto& ring : rings) {
      for (Vertex& v : ring) v = at_scale(v, scale);
    }
  }
  form.polygons = canonical_order(std::move(form.polygons));
  for (Vertex& v : form.touching) v = at_scale(v, scale);
  std::sort(form.touching.begin(), form.touching.end());
  return form;
}

bool Region::is_within(const Contact& contact) const {
  bool any = false;
  for (const auto& [edge, cell] : owner_) {
    const bool here = contact.size() == 1 ? edge.first == contact[0] || edge.second == contact[0]
                                          : (edge == Edge{contact[0], contact[1]}) ||
                                                (edge == Edge{contact[1], contact[0]});
    if (!here) continue;
    const auto other = owner_.find({edge.second, edge.first});
    if (other == owner_.end() || !inside_[cell] || !inside_[other->second]) return false;
    any = true;
  }
  return any;
}

}  // namespace minkref::checker
