// minkref-check: the checker of certificates in C++ over GMP. docs/certificates.md
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>

#include "oracle/checker/claims.hpp"
#include "oracle/checker/gzip.hpp"

namespace {

using namespace minkref::checker;

constexpr const char* usage =
    "usage: minkref-check [--case FILE] [--seconds N] [--tests N] [--bytes N] FILE...\n"
    "FILE may be compressed by gzip; - is standard input.\n"
    "Exit codes: 0 verified, 1 refuted, 2 malformed, 4 out of budget.\n";

std::string read(const std::string& path, std::size_t most) {
  std::string text;
  if (path == "-") {
    text.assign(std::istreambuf_iterator<char>(std::cin), {});
  } else {
    std::error_code error;
    require(std::filesystem::is_regular_file(path, error), path + " cannot be read");
    demand(std::filesystem::file_size(path) <= most, path + " is too large (--bytes)",
           Code::out_of_budget);
    std::ifstream file(path, std::ios::binary);
    require(file.good(), path + " cannot be read");
    text.assign(std::istreambuf_iterator<char>(file), {});
  }
  if (is_gzip(text)) text = gunzip(text, most);
  demand(text.size() <= most, path + " is too large (--bytes)", Code::out_of_budget);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  std::string case_path, seconds = "600", tests = "10000000000", bytes = "1073741824";
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    std::string* option = word == "--case"      ? &case_path
                          : word == "--seconds" ? &seconds
                          : word == "--tests"   ? &tests
                          : word == "--bytes"   ? &bytes
                                                : nullptr;
    if (option != nullptr && i + 1 < argc) {
      *option = argv[++i];
    } else if (word == "--help" || option != nullptr || (word.size() > 1 && word[0] == '-')) {
      (word == "--help" ? std::cout : std::cerr) << usage;
      return word == "--help" ? 0 : 2;
    } else {
      files.push_back(word);
    }
  }
  if (files.empty()) {
    std::cerr << usage;
    return 2;
  }
  bool refuted = false, malformed = false, out = false;
  for (const std::string& file : files) {
    Code code = Code::verified;
    try {
      const std::size_t most = std::stoull(bytes);
      const auto begin = std::chrono::steady_clock::now();
      const double allowed = std::stod(seconds);
      Budget budget{[&] {
                      const std::chrono::duration<double> spent =
                          std::chrono::steady_clock::now() - begin;
                      return spent.count() <= allowed;
                    },
                    mpz_class(tests)};
      const auto read_case = [&](const std::string& name) {
        const auto beside = std::filesystem::path(file).parent_path() / name;
        return parse_json(read(case_path.empty() ? beside.string() : case_path, 1ULL << 30));
      };
      const auto said = check(parse_json(read(file, most)), read_case, budget);
      std::cout << file << ": verified\n";
      for (const std::string& line : said) std::cout << "  " << line << "\n";
    } catch (const NotVerified& error) {
      code = error.code;
      const char* word = code == Code::refuted     ? "refuted"
                         : code == Code::malformed ? "malformed"
                                                   : "out of budget";
      std::cout << file << ": " << word << ": " << error.what() << "\n";
    } catch (const std::bad_alloc&) {
      code = Code::out_of_budget;
      std::cout << file << ": out of budget: memory\n";
    } catch (const std::invalid_argument& error) {
      std::cerr << "a limit is no number\n" << usage;
      return 2;
    }
    refuted = refuted || code == Code::refuted;
    malformed = malformed || code == Code::malformed;
    out = out || code == Code::out_of_budget;
  }
  return refuted ? 1 : malformed ? 2 : out ? 4 : 0;
}
