// The bytes of a file that others may change or cut off at any time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace minkref::inline plane {

/// Aligned for numbers of eight bytes. Copies share the bytes.
struct PrivateCopy {
  std::shared_ptr<const void> owner;
  std::span<const std::byte> bytes;  ///< empty where the file does not begin as it should
};

/// Up to `most_in_memory` bytes the copy stays in memory; a larger copy becomes a mapped file
/// without a name, which nobody else can open, beside the file or, if that folder is not writable,
/// in the folder of temporary files (in memory if neither has files without names): a map of the
/// file itself would end the process when somebody cuts the file off. Throws BadInput "no-file"
/// (absent, no regular file, unreadable, no room for the copy). O(bytes); looks at interrupts.
PrivateCopy private_copy(const std::string& path, std::string_view beginning,
                         std::uint64_t most_in_memory = std::uint64_t{1} << 28);

}  // namespace minkref::inline plane
