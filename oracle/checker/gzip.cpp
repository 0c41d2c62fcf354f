#include "oracle/checker/gzip.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "oracle/checker/json_value.hpp"

namespace minkref::checker {
namespace {

class Bits {
 public:
  explicit Bits(std::string_view data) : data_(data) {}

  /// A whole byte; what is left of the one before is passed over.
  std::uint32_t byte() {
    held_ = 0;
    require(next_ < data_.size(), "a compressed file ends too early");
    return static_cast<unsigned char>(data_[next_++]);
  }
  std::uint32_t bytes(unsigned count) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < count; ++i) value |= byte() << (8 * i);
    return value;
  }
  std::uint32_t bit() {
    if (held_ == 0) {
      last_ = byte();
      held_ = 8;
    }
    const std::uint32_t value = last_ & 1;
    last_ >>= 1;
    --held_;
    return value;
  }
  /// Least significant bit first.
  std::uint32_t bits(unsigned count) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < count; ++i) value |= bit() << i;
    return value;
  }
  /// Whole bytes.
  std::size_t passed() const { return next_; }
  bool at_end() const { return next_ == data_.size(); }

 private:
  std::string_view data_;
  std::size_t next_ = 0;
  std::uint32_t last_ = 0;
  unsigned held_ = 0;
};

constexpr unsigned longest = 15;

/// A canonical Huffman code, by the lengths of its words.
class HuffmanCode {
 public:
  explicit HuffmanCode(const std::vector<unsigned>& lengths) {
    for (const unsigned length : lengths) ++count_[length];
    count_[0] = 0;
    std::array<unsigned, longest + 1> first{};
    int left = 1;
    for (unsigned length = 1; length <= longest; ++length) {
      left = 2 * left - static_cast<int>(count_[length]);
      require(left >= 0, "a compressed file has too many words of one length");
      if (length > 1) first[length] = first[length - 1] + count_[length - 1];
    }
    symbols_.resize(lengths.size());
    for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] != 0) symbols_[first[lengths[symbol]]++] = symbol;
    }
  }

  unsigned symbol(Bits& in) const {
    unsigned word = 0, first = 0, index = 0;
    for (unsigned length = 1; length <= longest; ++length) {
      word |= in.bit();
      if (word - first < count_[length]) return symbols_[index + word - first];
      index += count_[length];
      first = (first + count_[length]) << 1;
      word <<= 1;
    }
    throw NotVerified(Code::malformed, "a compressed file has an unknown word");
  }

 private:
  std::array<unsigned, longest + 1> count_{};
  std::vector<unsigned> symbols_;
};

class Inflation {
 public:
  Inflation(Bits& in, std::size_t most) : in_(in), most_(most) {}

  std::string run() {
    bool last = false;
    while (!last) {
      last = in_.bit() != 0;
      const std::uint32_t kind = in_.bits(2);
      require(kind < 3, "a compressed file has an unknown block");
      if (kind == 0) {
        stored();
      } else if (kind == 1) {
        compressed(fixed(), HuffmanCode(std::vector<unsigned>(30, 5)));
      } else {
        dynamic();
      }
    }
    return std::move(out_);
  }

 private:
  void put(char c) {
    demand(out_.size() < most_, "a compressed file is too large (--bytes)", Code::out_of_budget);
    out_.push_back(c);
  }

  void stored() {
    const std::uint32_t length = in_.bytes(2), check = in_.bytes(2);
    require((length ^ check) == 0xffff, "a compressed file has a block of no length");
    for (std::uint32_t i = 0; i < length; ++i) put(static_cast<char>(in_.byte()));
  }

  static HuffmanCode fixed() {
    std::vector<unsigned> lengths(288, 8);
    for (unsigned i = 144; i < 256; ++i) lengths[i] = 9;
    for (unsigned i = 256; i < 280; ++i) lengths[i] = 7;
    return HuffmanCode(lengths);
  }

  void dynamic() {
    constexpr std::array<unsigned, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                             11, 4,  12, 3, 13, 2, 14, 1, 15};
    const unsigned literals = in_.bits(5) + 257, distances = in_.bits(5) + 1;
    const unsigned words = in_.bits(4) + 4;
    require(literals <= 286 && distances <= 30, "a compressed file has too many words");
    std::vector<unsigned> lengths(19, 0);
    for (unsigned i = 0; i < words; ++i) lengths[order[i]] = in_.bits(3);
    const HuffmanCode of_lengths(lengths);
    std::vector<unsigned> all;
    while (all.size() < literals + distances) {
      const unsigned symbol = of_lengths.symbol(in_);
      if (symbol < 16) {
        all.push_back(symbol);
        continue;
      }
      require(symbol != 16 || !all.empty(), "a compressed file repeats nothing");
      const unsigned repeated = symbol == 16 ? all.back() : 0;
      const unsigned times = symbol == 16   ? 3 + in_.bits(2)
                             : symbol == 17 ? 3 + in_.bits(3)
                                            : 11 + in_.bits(7);
      all.insert(all.end(), times, repeated);
    }
    require(all.size() == literals + distances, "a compressed file has too many words");
    const auto middle = all.begin() + literals;
    compressed(HuffmanCode({all.begin(), middle}), HuffmanCode({middle, all.end()}));
  }

  void compressed(const HuffmanCode& of_literals, const HuffmanCode& of_distances) {
    constexpr std::array<unsigned, 29> base{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                            15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                            67, 83, 99, 115, 131, 163, 195, 227, 258};
    constexpr std::array<unsigned, 29> more{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                            2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    for (;;) {
      const unsigned symbol = of_literals.symbol(in_);
      if (symbol == 256) return;
      if (symbol < 256) {
        put(static_cast<char>(symbol));
        continue;
      }
      require(symbol < 286, "a compressed file has an unknown length");
      const unsigned length = base[symbol - 257] + in_.bits(more[symbol - 257]);
      const unsigned word = of_distances.symbol(in_);
      require(word < 30, "a compressed file has an unknown distance");
      const unsigned extra = word < 4 ? 0 : word / 2 - 1;
      const std::size_t distance =
          (word < 4 ? word : (2 + word % 2) << extra) + 1 + in_.bits(extra);
      require(distance <= out_.size(), "a compressed file reaches before its beginning");
      for (unsigned i = 0; i < length; ++i) put(out_[out_.size() - distance]);
    }
  }

  Bits& in_;
  std::size_t most_;
  std::string out_;
};

std::uint32_t checksum(std::string_view data) {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int k = 0; k < 8; ++k) table[i] = (table[i] >> 1) ^ (table[i] & 1 ? 0xedb88320U : 0U);
  }
  std::uint32_t crc = 0xffffffffU;
  for (const char c : data) crc = (crc >> 8) ^ table[(crc ^ static_cast<unsigned char>(c)) & 255U];
  return ~crc;
}

void pass_header(Bits& in, std::string_view data) {
  require(in.bytes(2) == 0x8b1f && in.byte() == 8, "this is not compressed by gzip");
  const std::uint32_t flags = in.byte();
  require((flags & 0xe0U) == 0, "a compressed file has unknown flags");
  in.bytes(4);
  in.bytes(2);
  if ((flags & 4U) != 0) {
    for (std::uint32_t left = in.bytes(2); left > 0; --left) in.byte();
  }
  for (const std::uint32_t text : {8U, 16U}) {
    if ((flags & text) == 0) continue;
    while (in.byte() != 0) {
    }
  }
  if ((flags & 2U) == 0) return;
  const std::uint32_t wanted = checksum(data.substr(0, in.passed())) & 0xffffU;
  require(in.bytes(2) == wanted, "a compressed file has another checksum of its header");
}

}  // namespace

bool is_gzip(std::string_view data) { return data.substr(0, 2) == "\x1f\x8b"; }

std::string gunzip(std::string_view data, std::size_t most) {
  Bits in(data);
  pass_header(in, data);
  std::string out = Inflation(in, most).run();
  require(in.bytes(4) == checksum(out), "a compressed file has another checksum");
  require(in.bytes(4) == static_cast<std::uint32_t>(out.size()),
          "a compressed file has another length");
  require(in.at_end(), "there is more after a compressed file");
  return out;
}

}  // namespace minkref::checker
