// minkref-check: the checker of certificates in C++ over GMP. docs/certificates.md
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>

#include "oracle/checker/disc/bridges.hpp"
#include "oracle/checker/disc/disc_sum.hpp"
#include "oracle/checker/motion/path.hpp"
#include "oracle/checker/plane/claims.hpp"
#include "oracle/checker/space/convex.hpp"
#include "oracle/checker/space/solid.hpp"
#include "oracle/checker/unions/unions.hpp"

namespace {

using namespace minkref::checker;

constexpr const char* usage =
    "usage: minkref-check [--case FILE] [--seconds N] [--tests N] [--bytes N] FILE...\n"
    "FILE is plain JSON; - is standard input.\n"
    "Exit codes: 0 verified, 1 refuted, 2 malformed, 4 out of budget.\n";

constexpr const char* unpack = "gzip -dc FILE | minkref-check -, or minkref check FILE";

struct Options {
  std::optional<std::string> case_path;
  double seconds = 600, tests = 1e10, bytes = 1 << 28;
  std::vector<std::string> files;
};

struct WrongUsage {};

double limit(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool plain = !text.empty() && text.find_first_not_of("0123456789.eE+") == text.npos;
  if (!plain || *end != '\0' || !(value >= 0 && value <= 1e18)) throw WrongUsage{};
  return value;
}

Options options_of(int argc, char** argv) {
  Options options;
  bool only_files = false;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (only_files || word == "-" || word.empty() || word[0] != '-') {
      options.files.push_back(word);
      continue;
    }
    if (word == "--") {
      only_files = true;
      continue;
    }
    std::string value;
    if (const auto equals = word.find('='); equals != word.npos) {
      value = word.substr(equals + 1);
      word.resize(equals);
    } else if (++i < argc) {
      value = argv[i];
    } else {
      throw WrongUsage{};
    }
    if (word == "--case") {
      options.case_path = value;
    } else if (word == "--seconds") {
      options.seconds = limit(value);
    } else if (word == "--tests") {
      options.tests = limit(value);
    } else if (word == "--bytes") {
      options.bytes = limit(value);
    } else {
      throw WrongUsage{};
    }
  }
  if (options.files.empty()) throw WrongUsage{};
  return options;
}

std::string read(const std::string& path, std::size_t most, bool standard_input) {
  std::ifstream file;
  if (!standard_input) {
    std::error_code error;
    require(std::filesystem::is_regular_file(path, error),
            path.substr(0, 400) + " cannot be read: it is no file");
    file.open(path, std::ios::binary);
    require(file.good(), path + " cannot be read");
  }
  std::istream& in = standard_input ? std::cin : file;
  std::string text;
  std::vector<char> part(1 << 16);
  while (text.size() <= most && in) {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  demand(text.size() <= most, path + " is too large (--bytes)", Code::out_of_budget);
  require(!text.starts_with("\x1f\x8b"), path + " is compressed by gzip: " + unpack);
  return text;
}

/// A line without control characters.
std::string shown(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f && c != '\\') {
      line += c;
      continue;
    }
    char escape[5];
    std::snprintf(escape, sizeof escape, "\\x%02x", byte);
    line += escape;
  }
  return line;
}

// The worst verdict on a file so far: what the process ends with.
bool refuted = false, malformed = false, out = false;

int exit_code() { return refuted ? 1 : malformed ? 2 : out ? 4 : 0; }

/// No exception may pass through GMP where memory ends.
void* no_memory() {
  std::fputs("out of budget: there is too little memory\n", stderr);
  out = true;
  std::cout.flush();
  std::_Exit(exit_code());
}

void* allocate(std::size_t size) {
  void* found = std::malloc(size);
  return found != nullptr ? found : no_memory();
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  void* found = std::realloc(old, size);
  return found != nullptr ? found : no_memory();
}

void release(void* old, std::size_t) { std::free(old); }

void check_file(const std::string& file, const Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  Budget budget{[&] {
                  const std::chrono::duration<double> spent =
                      std::chrono::steady_clock::now() - begin;
                  return spent.count() < options.seconds;
                },
                mpz_class(std::floor(options.tests))};
  const auto most = static_cast<std::size_t>(options.bytes);
  const auto read_case = [&](const std::string& name) {
    const auto beside = std::filesystem::path(file).parent_path() / name;
    return parse_json(read(options.case_path.value_or(beside.string()), most, false), true);
  };
  try {
    const Value certificate = parse_json(read(file, most, file == "-"), false);
    const auto said =
        is_convex_certificate(certificate)     ? check_convex(certificate, read_case, budget)
        : is_solid_certificate(certificate)    ? check_solids(certificate, read_case, budget)
        : is_path_certificate(certificate)     ? check_paths(certificate, read_case, budget)
        : is_feature_certificate(certificate)  ? check_features(certificate, read_case, budget)
        : is_disc_sum_certificate(certificate) ? check_disc_sums(certificate, read_case, budget)
        : is_union_certificate(certificate)    ? check_unions(certificate, read_case, budget)
                                               : check(certificate, read_case, budget);
    std::cout << shown(file) << ": verified\n";
    for (const std::string& line : said) std::cout << "  " << shown(line) << "\n";
  } catch (const NotVerified& error) {
    refuted = refuted || error.code == Code::refuted;
    malformed = malformed || error.code == Code::malformed;
    out = out || error.code == Code::out_of_budget;
    const char* word = error.code == Code::refuted     ? "refuted"
                       : error.code == Code::malformed ? "malformed"
                                                       : "out of budget";
    std::cout << shown(file) << ": " << word << ": " << shown(error.what()) << "\n";
  } catch (const std::bad_alloc&) {
    out = true;
    std::cout << shown(file) << ": out of budget: there is too little memory\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  mp_set_memory_functions(allocate, reallocate, release);
  if (argc == 2 && std::string(argv[1]) == "--help") {
    std::cout << usage;
    return 0;
  }
  try {
    const Options options = options_of(argc, argv);
    for (const std::string& file : options.files) check_file(file, options);
  } catch (const WrongUsage&) {
    std::cerr << usage;
    return 2;
  }
  std::cout.flush();
  return std::cout.good() ? exit_code() : 70;
}
