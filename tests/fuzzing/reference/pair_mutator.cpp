// libFuzzer's hooks: a case is changed as a pair of operands and written again, never as bytes.
#include <cstring>

#include "reference/error.hpp"
#include "tests/fuzzing/reference/pair_change.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"
#include "tests/fuzzing/reference/scale_changes.hpp"

namespace minkref::fuzzing {
namespace {

constexpr int patience = 24;
/// Every `invalid_one_in`th mutation may be invalid.
constexpr std::size_t invalid_one_in = 40;

/// A square frame and a square that fits its hole.
Case plainest() {
  const auto box = [](int low, int high) -> Ring {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
  };
  Case pair;
  pair.P = {{Polygon{box(0, 1), {}}}};
  pair.Q = {{Polygon{box(0, 3), {Ring{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  pair.scales = {1};
  return pair;
}

bool has_empty_ring(const PolygonSet& set) {
  for (const Polygon& polygon : set.polygons) {
    if (polygon.outer.empty()) return true;
    for (const Ring& hole : polygon.holes) {
      if (hole.empty()) return true;
    }
  }
  return false;
}

/// A pair to change: the input, or the plainest pair if the input is no pair.
Case to_change(const std::uint8_t* data, std::size_t size) {
  auto pair = read_pair({reinterpret_cast<const char*>(data), size});
  if (!pair || !is_small(*pair) || has_empty_ring(pair->P) || has_empty_ring(pair->Q)) {
    return plainest();
  }
  return std::move(*pair);
}

/// The text of operands and scales, without the rest of a case.
std::string text_of(const Case& pair) {
  Case bare;
  bare.id = "pair";
  bare.P = pair.P;
  bare.Q = pair.Q;
  bare.scales = pair.scales;
  bare.interval = pair.interval;
  return write_case(bare);
}

bool is_pair(const Case& pair) {
  try {
    refuse_bad_pair(pair);
  } catch (const BadInput&) {
    return false;
  }
  return true;
}

void change_operand(Dice& dice, Case& pair, bool simpler) {
  const bool first = dice.one_in(2);
  PolygonSet& shape = first ? pair.P : pair.Q;
  const Rational s = scale_of(pair);
  const PolygonSet other = first ? scaled(pair.Q, 1 / s) : scaled(pair.P, s);
  if (shape.empty()) {
    shape = other;
    return;
  }
  const ChangeSite change{dice, shape, other};
  const std::size_t kind = simpler ? 0 : dice.below(16);
  const auto all = kind < 3    ? simpler_changes()
                   : kind < 8  ? vertex_changes()
                   : kind < 14 ? ring_changes()
                               : operand_changes();
  all[dice.below(all.size())](change);
  orient(shape);
}

/// One to three changes. `simpler`: the text has to become shorter.
Case changed(Dice& dice, const Case& pair, bool simpler) {
  Case result = pair;
  const std::size_t changes = dice.one_in(2) ? 1 : 1 + dice.below(3);
  for (std::size_t i = 0; i < changes; ++i) {
    if (dice.one_in(5) && is_pair(result)) {
      if (simpler && dice.one_in(2)) {
        result.scales.assign(1, dice.one_in(2) ? Rational(1) : scale_of(result));
        result.interval.reset();
      } else {
        change_scale(dice, result);
      }
    } else {
      change_operand(dice, result, simpler);
    }
  }
  return result;
}

/// Operands of two pairs put together.
Case crossed(Dice& dice, const Case& first, const Case& second) {
  Case result = first;
  switch (dice.below(4)) {
    case 0:
      result.Q = second.Q;
      break;
    case 1:
      result.P = second.P;
      break;
    case 2:
      result.Q = second.P;
      break;
    default: {
      result.interval = second.interval;
      result.scales = second.scales;
      PolygonSet& into = dice.one_in(2) ? result.P : result.Q;
      const PolygonSet& from = dice.one_in(2) ? second.P : second.Q;
      if (into.is_region() && from.is_region()) into.polygons.push_back(dice.of(from.polygons));
    }
  }
  orient(result.P);
  orient(result.Q);
  return result;
}

/// Writes the first candidate that is valid, small, short enough and new; otherwise the pair
/// itself, or the plainest pair.
template <class Make>
std::size_t write_first_good(Dice& dice, std::uint8_t* out, std::size_t room, const Case& pair,
                             const Make& make) {
  const std::string known = text_of(pair);
  const bool any = dice.one_in(invalid_one_in);
  std::string text;
  for (int attempt = 0; attempt < patience; ++attempt) {
    const Case made = make();
    if (!is_small(made) || !(any || is_pair(made))) continue;
    text = text_of(made);
    if (text != known && text.size() <= room) break;
    text.clear();
  }
  if (text.empty() && known.size() <= room) text = known;
  if (text.empty()) text = text_of(plainest());
  if (text.size() > room) text.resize(room);
  std::memcpy(out, text.data(), text.size());
  return text.size();
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  using namespace minkref::fuzzing;
  Dice dice(seed);
  const minkref::Case pair = to_change(data, size);
  return write_first_good(dice, data, max_size, pair,
                          [&] { return changed(dice, pair, size >= max_size); });
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_out_size,
                                                 unsigned int seed) {
  using namespace minkref::fuzzing;
  Dice dice(seed);
  const minkref::Case first = to_change(data1, size1), second = to_change(data2, size2);
  return write_first_good(dice, out, max_out_size, first,
                          [&] { return crossed(dice, first, second); });
}
