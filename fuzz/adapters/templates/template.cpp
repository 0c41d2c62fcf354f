// An adapter for `minkref verify` in C++17 without dependencies: sums of convex polygons.
// Put your own call into `minkowski_sum`, and say in `declaration` what it can do (the words are in
// docs/adapter-protocol.md). c++ -std=c++17 -O2 NAME_adapter.cpp -o NAME_adapter
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

using Ring = std::vector<std::pair<double, double>>;
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;  // clockwise
};
using Set = std::vector<Polygon>;  // rings may touch at points; none is the empty set

const char* declaration =
    R"("result","protocol":"adapter-v1","name":"NAME","version":"1","language":"C++",)"
    R"("arithmetic":"float64","numbers":"double","tolerance":{"absolute":"0","relative":"1e-9"},)"
    R"("sum":"region","capabilities":["plane"])";

// The sum of two convex rings: the edges of both in the order of their directions, from the
// leftmost vertices.
Ring convex_sum(Ring P, Ring Q) {
  Ring sum;
  for (Ring* ring : {&P, &Q}) {
    std::rotate(ring->begin(), std::min_element(ring->begin(), ring->end()), ring->end());
    ring->push_back(ring->front());
  }
  for (std::size_t i = 0, j = 0, n = P.size() - 1, m = Q.size() - 1; i < n || j < m;) {
    const auto [x, y] = P[i];
    const auto [u, v] = Q[j];
    sum.emplace_back(x + u, y + v);
    double turn = j == m ? 1 : -1;
    if (i < n && j < m)
      turn = (P[i + 1].first - x) * (Q[j + 1].second - v) -
             (P[i + 1].second - y) * (Q[j + 1].first - u);
    i += turn >= 0, j += turn <= 0;
  }
  return sum;
}

// PUT YOUR OWN CALL HERE. Outer rings run counter-clockwise. To be asked for sets with holes and of
// several polygons, declare "non-convex", "holes" and "components"; false: it cannot.
bool minkowski_sum(const Set& sP, const Set& Q, Set& sum) {
  if (sP.size() != 1 || Q.size() != 1 || !sP[0].holes.empty() || !Q[0].holes.empty()) return false;
  sum = {{convex_sum(sP[0].outer, Q[0].outer), {}}};
  return true;
}

// P grown by a disc, likewise: here the sum with a polygon of 128 corners. To be asked for it,
// declare "offset", and in the tolerance "radius":"0.0004".
bool offset(const Set& P, double radius, Set& grown) {
  Ring disc;
  for (int k = 0; k < 128; ++k) {
    disc.emplace_back(radius * std::cos(k * std::acos(-1.0) / 64),
                      radius * std::sin(k * std::acos(-1.0) / 64));
  }
  return minkowski_sum(P, {{disc, {}}}, grown);
}

// [[x, y], ...] at c, which is moved behind it.
Ring read_ring(const char*& c) {
  Ring ring;
  double x = 0, y = 0;
  int n = 0;
  for (c = std::strchr(c, '[') + 1; std::sscanf(c, " [%lf ,%lf ]%n", &x, &y, &n) == 2;) {
    ring.emplace_back(x, y);
    c += n;
    if (*c == ',') ++c;
  }
  ++c;
  return ring;
}

// The set under the key, the last of its line: no JSON reader, but enough for what minkref sends.
Set read_set(const std::string& line, const char* key) {
  Set set;
  const char* c = std::strstr(line.c_str(), key);
  while (c != nullptr && (c = std::strstr(c, "\"outer\"")) != nullptr) {
    set.push_back({read_ring(c), {}});
    c = std::strchr(std::strstr(c, "\"holes\""), '[') + 1;
    for (c += std::strspn(c, ", "); *c == '['; c += std::strspn(c, ", ")) {
      set.back().holes.push_back(read_ring(c));
    }
  }
  return set;
}

std::string written(const Ring& ring) {
  std::string text;
  for (const auto& [x, y] : ring) {
    char point[80];
    std::snprintf(point, sizeof point, "%s[%.17g,%.17g]", text.empty() ? "" : ",", x, y);
    text += point;
  }
  return "[" + text + "]";
}

std::string written(const Set& set) {
  std::string text;
  for (const Polygon& polygon : set) {
    std::string holes;
    for (const Ring& hole : polygon.holes) holes += (holes.empty() ? "" : ",") + written(hole);
    text += text.empty() ? "" : ",";
    text += "{\"outer\":" + written(polygon.outer) + ",\"holes\":[" + holes + "]}";
  }
  return "[" + text + "]";
}

std::string answer(const std::string& line, Set& Q) {
  const auto has = [&](const char* word) { return line.find(word) != std::string::npos; };
  if (has("\"hello\"")) return declaration;
  if (has("\"load\"")) Q = read_set(line, "\"Q\"");
  if (has("\"load\"") || has("\"stop\"")) return R"("result")";
  Set sum;
  double radius = 0;
  const char* found = std::strstr(line.c_str(), "\"radius\"");
  const bool grows = found != nullptr && std::sscanf(found, "\"radius\" : %lf", &radius) == 1;
  const Set sP = read_set(line, grows ? "\"P\"" : "\"sP\"");
  if (sP.empty() || (Q.empty() && !grows)) return R"("errored","reason":"not understood")";
  if (!(grows ? offset(sP, radius, sum) : minkowski_sum(sP, Q, sum)))
    return R"("skipped","reason":"more than one ring")";
  return R"("result","polygons":)" + written(sum);
}

int main() {
  Set Q;
  for (std::string line; std::getline(std::cin, line);) {
    int seq = 0;
    std::sscanf(line.c_str(), "{\"seq\":%d", &seq);  // the first member of every request
    std::cout << "{\"seq\":" << seq << ",\"status\":" << answer(line, Q) << '}' << std::endl;
    if (line.find("\"stop\"") != std::string::npos) return 0;
  }
}
