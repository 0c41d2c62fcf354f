// Sums of convex polygons on an integer grid, exact in 128-bit words. Written from
// docs/adapter-protocol.md alone; reads the numbers of a line, no JSON.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Point = std::pair<long long, long long>;

// The points of the first set under the key: pairs of integers, with or without quotes.
std::vector<Point> points_of(const std::string& line, const std::string& key) {
  std::vector<Point> points;
  std::vector<long long> numbers;
  int depth = 0;
  for (std::size_t at = line.find("\"" + key + "\""), i = line.find('{', at); i < line.size();
       ++i) {
    if (line[i] == '{') ++depth;
    if (line[i] == '}' && --depth == 0) break;
    if (line[i] == '-' || std::isdigit(static_cast<unsigned char>(line[i]))) {
      char* end = nullptr;
      numbers.push_back(std::strtoll(line.c_str() + i, &end, 10));
      i = static_cast<std::size_t>(end - line.c_str()) - 1;
    }
  }
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    points.emplace_back(numbers[k], numbers[k + 1]);
  return points;
}

bool left_turn(const Point& a, const Point& b, const Point& c) {
  const auto wide = [](long long value) { return static_cast<__int128>(value); };
  return wide(b.first - a.first) * (c.second - a.second) >
         wide(b.second - a.second) * (c.first - a.first);
}

std::vector<Point> hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> ring;
  for (int way = 0; way < 2; ++way) {
    const std::size_t first = ring.size();
    for (const Point& point : points) {
      while (ring.size() > first + 1 && !left_turn(ring.end()[-2], ring.back(), point))
        ring.pop_back();
      ring.push_back(point);
    }
    ring.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return ring;
}

int main() {
  std::vector<Point> Q;
  for (std::string line; std::getline(std::cin, line);) {
    const auto has = [&](const char* word) { return line.find(word) != std::string::npos; };
    const std::string seq =
        std::to_string(std::atoll(line.c_str() + line.find(':', line.find("\"seq\"")) + 1));
    if (has("\"stop\"")) return 0;
    std::string body = "\"status\": \"result\"";
    if (has("\"hello\"")) {
      body +=
          R"(, "protocol": "adapter-v1", "name": "convex.cpp", "version": "1", "language": "C++",
"arithmetic": "exact", "grid": {"unit": "1", "largest": "1e15"}, "sum": "region", "capabilities": ["plane"])";
      body.erase(std::remove(body.begin(), body.end(), '\n'), body.end());
    } else if (has("\"load\"")) {
      Q = points_of(line, "Q");
    } else {
      std::vector<Point> sums;
      for (const auto& [a, b] : points_of(line, "sP"))
        for (const auto& [c, d] : Q) sums.emplace_back(a + c, b + d);
      std::string ring;
      for (const auto& [x, y] : hull(sums))
        ring += (ring.empty() ? "[" : ", [") + std::to_string(x) + ", " + std::to_string(y) + "]";
      body += ", \"rings\": [[" + ring + "]]";
    }
    std::cout << "{ " << body << ", \"seq\" :" << seq << " }" << std::endl;
  }
}
