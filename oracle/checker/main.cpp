// minkref-check: the checker of certificates in C++ over GMP. docs/certificates.md
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
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
#include "oracle/checker/space/solid_point.hpp"
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

constexpr int lost = 70, memory_ended = 71;  // exit codes: nobody takes the verdict; of a child

/// Ends the process checking a file when memory runs out: no exception may pass through GMP.
void* no_memory() { std::_Exit(memory_ended); }

void* allocate(std::size_t size) {
  void* found = std::malloc(size);
  return found != nullptr ? found : no_memory();
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  void* found = std::realloc(old, size);
  return found != nullptr ? found : no_memory();
}

void release(void* old, std::size_t) { std::free(old); }

/// Whether a path named by a certificate stays in the certificate's folder.
bool is_inside(const std::string& name) {
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('/', at), name.size());
    const std::string step = name.substr(at, end - at);
    if (step.empty() || step == "..") return false;
    at = end + 1;
  }
  return true;
}

/// Reads the digest named by a certificate: once verified, the digest of its case.
std::string digest_of_case(const Value& certificate) {
  for (const Member& m : certificate.members) {
    if (m.name == "case") return text(*members(m.value, "path sha256")[1]);
  }
  return "";
}

/// Says the verdict on a file; returns its exit code.
int say(const std::string& file, Code code, const std::string& why) {
  const char* word = code == Code::verified    ? "verified"
                     : code == Code::refuted   ? "refuted"
                     : code == Code::malformed ? "malformed"
                                               : "out of budget";
  std::cout << shown(file) << ": " << word << (why.empty() ? "" : ": ") << shown(why) << "\n";
  return static_cast<int>(code);
}

/// Ends this process by a signal after some time, even while reading.
void end_after(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(std::ceil((seconds - std::floor(seconds)) * 999999));
  setitimer(ITIMER_REAL, &timer, nullptr);
}

int check_file(const std::string& file, const Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  end_after(std::clamp(options.seconds, 1e-6, 1e9));
  Budget budget{[&] {
                  const std::chrono::duration<double> spent =
                      std::chrono::steady_clock::now() - begin;
                  return spent.count() < options.seconds;
                },
                mpz_class(std::floor(options.tests))};
  const auto most = static_cast<std::size_t>(options.bytes);
  std::string from;
  const auto read_case = [&](const std::string& name) {
    require(options.case_path || is_inside(name),
            "the case " + name + " is in another folder: give --case FILE");
    const auto beside = std::filesystem::path(file).parent_path() / name;
    from = options.case_path.value_or(beside.string());
    return parse_json(read(from, most, false), true);
  };
  try {
    const Value certificate = parse_json(read(file, most, file == "-"), false);
    const auto said =
        is_convex_certificate(certificate)  ? check_convex(certificate, read_case, budget)
        : is_solid_certificate(certificate) ? check_solids(certificate, read_case, budget)
        : is_solid_point_certificate(certificate)
            ? check_solid_points(certificate, read_case, budget)
        : is_path_certificate(certificate)     ? check_paths(certificate, read_case, budget)
        : is_feature_certificate(certificate)  ? check_features(certificate, read_case, budget)
        : is_disc_sum_certificate(certificate) ? check_disc_sums(certificate, read_case, budget)
        : is_union_certificate(certificate)    ? check_unions(certificate, read_case, budget)
                                               : check(certificate, read_case, budget);
    end_after(0);
    say(file, Code::verified, "");
    std::cout << "  case " << shown(from) << ", " << digest_of_case(certificate) << "\n";
    for (const std::string& line : said) std::cout << "  " << shown(line) << "\n";
    return 0;
  } catch (const NotVerified& error) {
    return say(file, error.code, error.what());
  } catch (const std::bad_alloc&) {
    return memory_ended;
  }
}

/// Checks a file in a new process: files do not share time and memory.
int verdict_on(const std::string& file, const Options& options) {
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0) return say(file, Code::out_of_budget, "no process can be started");
  if (child == 0) {
    const int code = check_file(file, options);
    std::cout.flush();
    std::_Exit(std::cout.good() ? code : lost);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  if (code == -SIGALRM) return say(file, Code::out_of_budget, "a limit is reached");
  if (code == memory_ended || code == -SIGKILL || code == -SIGSEGV) {
    return say(file, Code::out_of_budget, "there is too little memory");
  }
  return code;
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
    std::vector<int> codes;
    for (const std::string& file : options.files) codes.push_back(verdict_on(file, options));
    std::cout.flush();
    if (!std::cout.good()) return lost;
    for (const int worst : {lost, 1, 2, 4}) {
      if (std::find(codes.begin(), codes.end(), worst) != codes.end()) return worst;
    }
    const bool all = std::all_of(codes.begin(), codes.end(), [](int code) { return code == 0; });
    return all ? 0 : lost;
  } catch (const WrongUsage&) {
    std::cerr << usage;
    return 2;
  }
}
