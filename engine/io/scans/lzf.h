#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gable {

/// LZF makes of one byte at most this many: 264 of 3.
inline constexpr size_t kLzfGrowth = 88;

/// Decompresses LZF (Lehmann's format, as PCD files use it): a control byte below 32 announces that
/// many plus one literal bytes; any other one a copy from what is already there, its upper three
/// bits the length minus two (7: one more byte adds to it), the lower five and the next byte how
/// far back, minus one. Returns false where the input is damaged or does not give exactly `size`
/// bytes.
bool decompress_lzf(std::string_view input, size_t size, std::string* output);

}  // namespace gable
