#include "reference/paper/reading_name.hpp"

#include <string>

#include "reference/error.hpp"

namespace minkref {

void refuse_reading(const std::vector<ReadingName>& known, std::string_view name,
                    std::string_view value) {
  std::string listed;
  for (const ReadingName& reading : known) {
    listed += (listed.empty() ? "" : "; ") + std::string(reading.name) + ": ";
    for (std::size_t i = 0; i < reading.values.size(); ++i) {
      listed += (i == 0 ? "" : ", ") + std::string(reading.values[i]);
    }
  }
  throw BadInput("unknown-reading",
                 "there is no reading " + std::string(name) + " = " + std::string(value),
                 "give one of these: " + listed);
}

}  // namespace minkref
