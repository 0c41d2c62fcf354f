#include "formats/event_row.hpp"

namespace minkref {
namespace {

void append_point(std::string& text, const Point& point) {
  text += "[\"";
  text += to_string(point.x);
  text += "\", \"";
  text += to_string(point.y);
  text += "\"]";
}

}  // namespace

void append_json(std::string& text, const EventRow& event, const std::vector<std::string>& edges,
                 std::string_view end) {
  text += "{\"s\": \"";
  text += to_string(event.scale);
  text += "\", \"rank\": ";
  text += std::to_string(event.rank);
  text += ", \"kind\": \"";
  text += event.kind;
  text += "\", \"change\": \"";
  text += event.change;
  text += "\", \"parents\": [";
  for (std::size_t i = 0; i < event.edges.size(); ++i) {
    if (i > 0) text += ", ";
    text += edges[event.edges[i]];
  }
  text += "], \"at\": ";
  append_point(text, event.at);
  text += ", \"to\": ";
  if (event.to) {
    append_point(text, *event.to);
  } else {
    text += "null";
  }
  text += '}';
  text += end;
}

}  // namespace minkref
