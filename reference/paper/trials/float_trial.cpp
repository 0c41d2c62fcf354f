// float_trial SEED COUNT: the trial within this program, compiled with whatever flags. Prints each
// subject, the count of its tries, and the count of wrong results; exit code 1 if any was wrong.
#include <cstdio>
#include <cstdlib>

#include "reference/paper/trials/float_environments.hpp"

int main(int, char** arguments) {
  try {
    const auto number = [&](int k) { return std::strtoull(arguments[k], nullptr, 10); };
    const auto counts = minkref::float_trial::run(number(1), number(2));
    for (const auto& [what, count] : counts.all()) {
      std::printf("%s\t%llu\t%llu\n", what.c_str(), static_cast<unsigned long long>(count.tried),
                  static_cast<unsigned long long>(count.wrong));
    }
    return counts.wrong() == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
