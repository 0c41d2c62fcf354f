// An adapter for `minkref verify` in C++17 without dependencies: sums of convex polygons.
// Put your own call into `minkowski_sum`, and say in `declaration` what it can do (the words are in
// docs/adapter-protocol.md). c++ -std=c++17 -O2 NAME_adapter.cpp -o NAME_adapter
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

using Ring = std::vector<std::pair<double, double>>;

const char* declaration =
    R"("result","protocol":"adapter-v1","name":"NAME","version":"1","language":"C++",)"
    R"("arithmetic":"float64","numbers":"double","tolerance":{"absolute":"0","relative":"1e-9"},)"
    R"("sum":"region","capabilities":["plane"])";

// PUT YOUR OWN CALL HERE. P, Q and the sum run counter-clockwise. This one takes the edges of both
// in the order of their directions, from the leftmost vertices.
Ring minkowski_sum(Ring P, Ring Q) {
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

// The first ring under the key: no JSON reader, but enough for the lines that minkref sends.
Ring ring_of(const std::string& line, const char* key) {
  const char* c = std::strstr(line.c_str(), key);
  if (c != nullptr) c = std::strstr(c, "[[");
  Ring ring;
  double x, y;
  for (int n = 0; c && std::sscanf(c + 1, " [%lf ,%lf ]%n", &x, &y, &n) == 2; c += 1 + n)
    ring.emplace_back(x, y);
  return ring;
}

std::string answer(const std::string& line, Ring& Q) {
  const auto has = [&](const char* word) { return line.find(word) != std::string::npos; };
  if (has("\"hello\"")) return declaration;
  if (has("\"load\"")) Q = ring_of(line, "\"Q\"");
  if (has("\"load\"") || has("\"stop\"")) return R"("result")";
  const Ring sP = ring_of(line, "\"sP\"");
  if (sP.empty() || Q.empty()) return R"("errored","reason":"not understood")";
  std::string ring;
  for (auto [x, y] : minkowski_sum(sP, Q)) {
    char text[80];
    std::snprintf(text, sizeof text, ",[%.17g,%.17g]", x, y);
    ring += text;
  }
  return R"("result","rings":[[)" + ring.substr(1) + "]]";
}

int main() {
  Ring Q;
  for (std::string line; std::getline(std::cin, line);) {
    int seq = 0;
    std::sscanf(line.c_str(), "{\"seq\":%d", &seq);  // the first member of every request
    std::cout << "{\"seq\":" << seq << ",\"status\":" << answer(line, Q) << '}' << std::endl;
    if (line.find("\"stop\"") != std::string::npos) return 0;
  }
}
