#include "formats/case.hpp"
#include "formats/json_string.hpp"

namespace minkref {
namespace {

std::string quote(const Rational& value) { return "\"" + to_string(value) + "\""; }

std::string ring_text(const Ring& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    text += (i > 0 ? ", [" : "[") + quote(ring[i].x) + ", " + quote(ring[i].y) + "]";
  }
  return text + "]";
}

/// `items` between brackets, one a line.
std::string block(const std::vector<std::string>& items, const std::string& indent) {
  if (items.empty()) return "[]";
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i > 0 ? ",\n" : "\n") + indent + "  " + items[i];
  }
  return text + "\n" + indent + "]";
}

std::string set_text(const PolygonSet& set, const std::string& indent) {
  std::vector<std::string> polygons;
  for (const Polygon& polygon : set.polygons) {
    std::vector<std::string> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(ring_text(hole));
    polygons.push_back("{\"outer\": " + ring_text(polygon.outer) +
                       ", \"holes\": " + block(holes, indent + "  ") + "}");
  }
  return "{\"polygons\": " + block(polygons, indent) + "}";
}

std::string words(const std::vector<std::string>& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += (i > 0 ? ", " : "") + encode_json_string(list[i]);
  }
  return text + "]";
}

/// Members of an object as text, kept as added.
class Members {
 public:
  explicit Members(std::string indent) : indent_(std::move(indent)) {}

  void add(const std::string& name, const std::string& value) {
    text_ += (text_.empty() ? "\n" : ",\n") + indent_ + "  \"" + name + "\": " + value;
  }
  void add_text(const std::string& name, const std::string& value) {
    if (!value.empty()) add(name, encode_json_string(value));
  }
  void add_count(const std::string& name, const std::optional<std::uint64_t>& value) {
    if (value) add(name, std::to_string(*value));
  }
  std::string object() const { return "{" + text_ + "\n" + indent_ + "}"; }

 private:
  std::string indent_, text_;
};

std::string axes_text(const PlaneScaling& scaling) {
  return "[" + quote(scaling.x) + ", " + quote(scaling.y) + "]";
}

std::string claim_text(const Expected& claim) {
  Members members("    ");
  members.add("scale", claim.axes ? axes_text(*claim.axes) : quote(claim.scale));
  if (claim.digest) members.add_text("digest", *claim.digest);
  members.add_count("components", claim.components);
  members.add_count("holes", claim.holes);
  members.add_count("vertices", claim.vertices);
  if (claim.area) members.add("area", quote(*claim.area));
  if (claim.result) members.add("result", set_text(*claim.result, "      "));
  return members.object();
}

std::string interval_text(const CaseInterval& interval) {
  std::string text;
  if (interval.from) text += "\"from\": " + quote(*interval.from);
  if (interval.to) text += (text.empty() ? "" : ", ") + ("\"to\": " + quote(*interval.to));
  return "{" + text + "}";
}

}  // namespace

std::string write_case(const Case& value) {
  Members members("");
  members.add("schema", "\"case-v1\"");
  members.add_text("id", value.id);
  members.add_text("title", value.title);
  members.add_text("comment", value.comment);
  members.add("dimension", "2");
  members.add("P", set_text(value.P, "  "));
  members.add("Q", set_text(value.Q, "  "));
  if (value.interval) {
    members.add("interval", interval_text(*value.interval));
  } else {
    std::string scales;
    for (const Rational& s : value.scales) scales += (scales.empty() ? "" : ", ") + quote(s);
    for (const PlaneScaling& s : value.axes) scales += (scales.empty() ? "" : ", ") + axes_text(s);
    members.add("scales", "[" + scales + "]");
  }
  if (!value.tags.empty()) members.add("tags", words(value.tags));
  if (!value.flags.empty()) members.add("flags", words(value.flags));
  if (!value.expected.empty()) {
    std::vector<std::string> claims;
    for (const Expected& claim : value.expected) claims.push_back(claim_text(claim));
    members.add("expected", block(claims, "  "));
  }
  members.add_text("source", value.source);
  members.add_text("licence", value.licence);
  members.add_text("certificate", value.certificate);
  return members.object() + "\n";
}

}  // namespace minkref
