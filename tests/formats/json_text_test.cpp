// Our JSON parser accepts what RFC 8259 accepts; nlohmann-json is the referee.
#include "formats/json_text.hpp"

#include <nlohmann/json.hpp>
#include <random>

#include "formats/json_string.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref::of_json_text {
namespace {

/// The value as a document of the referee, who parses the text of each number.
nlohmann::json as_document(Json value) {
  switch (value.kind()) {
    case JsonKind::null:
      return nullptr;
    case JsonKind::boolean:
      return value.text() == "true";
    case JsonKind::number:
      return nlohmann::json::parse(value.text());
    case JsonKind::string:
      return value.string();
    case JsonKind::array: {
      nlohmann::json list = nlohmann::json::array();
      for (const Json element : value) list.push_back(as_document(element));
      EXPECT_EQ(list.size(), value.size());
      return list;
    }
    case JsonKind::object: {
      nlohmann::json object = nlohmann::json::object();
      value.for_each_member(
          [&](const std::string& name, Json member) { object[name] = as_document(member); });
      return object;
    }
  }
  return nullptr;
}

/// Whether both accept the text; if so they must have read the same.
bool accepted(const std::string& text) {
  const nlohmann::json referee = nlohmann::json::parse(text, nullptr, false);
  const ReadLimits limits;
  const Input input("input", limits);
  try {
    const JsonText document(text, input);
    EXPECT_FALSE(referee.is_discarded()) << "accepted: " << text;
    if (!referee.is_discarded()) {
      EXPECT_EQ(as_document(document.root()), referee) << text;
    }
    return true;
  } catch (const BadInput& e) {
    EXPECT_TRUE(referee.is_discarded()) << "refused: " << text << ": " << e.what();
    return false;
  }
}

TEST(JsonText, AcceptsTheValuesOfTheStandard) {
  for (const char* text :
       {"null", "true", " false ", "0", "-0", "12.50", "1e5", "1E+5", "-1.5e-5", "\"\"", "[]", "{}",
        "[[],{}]", "[1,[2,[3]],{\"a\":{\"b\":[]}}]", "{\"\":1,\"a\":2}",
        "\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"", "\"\\u00e9\\ud83d\\ude00\"",
        "\"\xC3\xA9\xF0\x9F\x98\x80\"", "\r\n\t [ 1 , 2 ] \r\n"}) {
    EXPECT_TRUE(accepted(text)) << text;
  }
}

TEST(JsonText, RefusesWhatTheStandardRefuses) {
  for (const char* text : {"",
                           "[",
                           "]",
                           "[1",
                           "[1,",
                           "[1,]",
                           "[,1]",
                           "[1 2]",
                           "{",
                           "{\"a\"",
                           "{\"a\":",
                           "{\"a\":1",
                           "{\"a\":1,}",
                           "{a:1}",
                           "{\"a\" 1}",
                           "{1:2}",
                           "[1}",
                           "{\"a\":1]",
                           "01",
                           "+1",
                           ".5",
                           "1.",
                           "1e",
                           "1e+",
                           "-",
                           "0x10",
                           "1_000",
                           "tru",
                           "True",
                           "nul",
                           "NaN",
                           "Infinity",
                           "-Infinity",
                           "'a'",
                           "\"",
                           "\"\\",
                           "\"\\x\"",
                           "\"\\u12\"",
                           "\"\\ud800\"",
                           "\"\\udc00\"",
                           "\"\\ud800\\u0041\"",
                           "\"\n\"",
                           "\"\x01\"",
                           "\"\xC3\"",
                           "\"\xC0\xAF\"",
                           "\"\xED\xA0\x80\"",
                           "\"\xF5\x80\x80\x80\"",
                           "[1] 2",
                           "1 1",
                           "// a\n1",
                           "[1]//",
                           "{\"a\":1 \"b\":2}",
                           "[]]"}) {
    EXPECT_FALSE(accepted(text)) << text;
  }
}

TEST(JsonText, AgreesWithTheRefereeOnMutatedTexts) {
  const std::string original =
      "{\"a\": [1, -2.5e3, \"x\\u0041\\n\", null, true, {\"b\": [[], {}]}], \"c\": \"\xC3\xA9\"}";
  const std::string alphabet = "{}[]\",:\\u0129.-+eE tfn\n\xC3\xA9";
  const unsigned seed = 20261121;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  int valid = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = original;
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 3) {
        case 0:
          text[at] = c;
          break;
        case 1:
          text.insert(at, 1, c);
          break;
        default:
          text.erase(at, 1);
      }
    }
    valid += accepted(text) ? 1 : 0;
  }
  EXPECT_GT(valid, 1000);
}

TEST(JsonText, EveryValueKnowsItsLine) {
  const ReadLimits limits;
  const Input input("input", limits);
  const std::string text = "[1,\n 2,\n\n {\"a\":\n 3}]";
  const JsonText document(text, input);
  std::vector<std::size_t> lines;
  for (const Json element : document.root()) lines.push_back(element.line());
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 2, 4}));
}

TEST(JsonText, EncodedStringsAreReadBack) {
  const std::string text = "quote \" backslash \\ line\nbell \x07 \xC3\xA9";
  const std::string raw = encode_json_string(text);
  EXPECT_EQ(nlohmann::json::parse(raw), text);
  EXPECT_EQ(decode_json_string(raw.substr(1, raw.size() - 2)), text);
}

}  // namespace
}  // namespace minkref::of_json_text
