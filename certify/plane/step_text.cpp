#include "certify/plane/step_text.hpp"

#include <nlohmann/json.hpp>

namespace minkref::certify {
namespace {

using Json = nlohmann::ordered_json;

/// Writes an integer as text beyond 64 bits, which JSON integers do not exceed here.
Json integer(const Integer& value) {
  if (value >= std::numeric_limits<std::int64_t>::min() &&
      value <= std::numeric_limits<std::int64_t>::max()) {
    return value.convert_to<std::int64_t>();
  }
  return value.str();
}

Json element(const Element& e) {
  switch (e.kind) {
    case Element::Kind::P:
      return {"P", e.a, e.b, e.c};
    case Element::Kind::Q:
      return {"Q", e.a, e.b, e.c};
    case Element::Kind::up:
      return {"up", e.a};
    case Element::Kind::meet:
      break;
  }
  return {"meet", e.a, e.b};
}

void append(Json& list, const std::vector<std::int64_t>& code) {
  for (const std::int64_t entry : code) list.push_back(entry);
}

}  // namespace

std::string pieces_text(const PieceTree& tree, const std::string& operand) {
  Json step{
      {"rule", "pieces"}, {"of", operand}, {"pieces", Json::array()}, {"groups", Json::array()}};
  for (std::size_t n = 0; n < tree.nodes().size(); ++n) {
    const PieceTree::Node& node = tree.nodes()[n];
    if (node.is_piece) {
      step["pieces"].push_back(node.hull);
    } else {
      step["groups"].push_back(node.children);
    }
  }
  return step.dump();
}

std::string sum_text(const SumProof& proof, std::size_t pieces_of_P, std::size_t pieces_of_Q) {
  Json step{{"rule", proof.scales.size() == 1 ? "eq" : "move"}};
  for (const Rational& scale : proof.scales) step["scales"].push_back(to_string(scale));
  step["by"] = {pieces_of_P, pieces_of_Q};
  for (const Rational& wall : proof.box) step["box"].push_back(to_string(wall));
  step["elements"] = Json::array();
  for (const Element& e : proof.elements) step["elements"].push_back(element(e));
  step["cells"] = proof.cells;
  step["normals"] = Json::array();
  for (const auto& [x, y] : proof.normals) step["normals"].push_back({integer(x), integer(y)});
  step["proofs"] = Json::array();
  for (const CellProof& cell : proof.proofs) {
    Json entry{cell.covered ? "cov" : "sep"};
    if (cell.covered) {
      entry.push_back(cell.A);
      entry.push_back(cell.B);
    } else {
      append(entry, cell.code);
    }
    step["proofs"].push_back(std::move(entry));
  }
  step["contacts"] = Json::array();
  for (const ContactProof& contact : proof.contacts) {
    Json entry = Json::array({contact.corners});
    append(entry, contact.code);
    step["contacts"].push_back(std::move(entry));
  }
  step["polygons"] = proof.polygons;
  return step.dump();
}

}  // namespace minkref::certify
