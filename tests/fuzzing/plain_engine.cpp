// A fuzzing engine for compilers without one, to link targets with (MINKREF_FUZZ_ENGINE): runs each
// file given, and those in folders given; then, for -max_total_time=SECONDS, changed copies of
// them. It follows no coverage. Options it does not know are ignored, as the other engines' scripts
// give them.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;

Input read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<Input> read_all(const std::filesystem::path& path) {
  std::vector<Input> inputs;
  if (std::filesystem::is_directory(path)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (entry.is_regular_file()) inputs.push_back(read(entry.path()));
    }
  } else {
    inputs.push_back(read(path));
  }
  return inputs;
}

/// Some bytes replaced, removed, repeated, or taken from another input.
Input changed(const std::vector<Input>& inputs, std::mt19937_64& dice, std::size_t most) {
  Input input = inputs[dice() % inputs.size()];
  for (std::size_t k = 1 + dice() % 4; k > 0 && !input.empty(); --k) {
    const auto at = input.begin() + static_cast<std::ptrdiff_t>(dice() % input.size());
    const auto end =
        at + static_cast<std::ptrdiff_t>(1 + dice() % static_cast<std::size_t>(input.end() - at));
    const Input& other = inputs[dice() % inputs.size()];
    switch (dice() % 4) {
      case 0:
        *at = static_cast<std::uint8_t>(dice());
        break;
      case 1:
        input.erase(at, end);
        break;
      case 2: {
        const Input copy(at, end);
        input.insert(at, copy.begin(), copy.end());
        break;
      }
      default:
        input.insert(at, other.begin(), other.end());
    }
  }
  if (input.size() > most) input.resize(most);
  return input;
}

std::size_t number_after(const std::string& word, const std::string& name, std::size_t otherwise) {
  return word.starts_with(name) ? std::stoull(word.substr(name.size())) : otherwise;
}

int run(const std::vector<std::string>& words) {
  std::vector<Input> inputs;
  std::size_t seconds = 0;
  std::size_t most = 4096;
  std::size_t seed = 1;
  for (const std::string& word : words) {
    seconds = number_after(word, "-max_total_time=", seconds);
    most = number_after(word, "-max_len=", most);
    seed = number_after(word, "-seed=", seed);
    if (word.starts_with("-")) continue;
    for (Input& input : read_all(word)) inputs.push_back(std::move(input));
  }
  for (const Input& input : inputs) LLVMFuzzerTestOneInput(input.data(), input.size());
  std::cout << inputs.size() << " inputs\n";
  if (inputs.empty()) inputs.push_back({'0'});
  std::mt19937_64 dice(seed);
  std::size_t runs = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  for (; std::chrono::steady_clock::now() < end; ++runs) {
    const Input input = changed(inputs, dice, most);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::cout << runs << " changed inputs, seed " << seed << "\n";
  return EXIT_SUCCESS;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::cerr << "a target let an exception out: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
