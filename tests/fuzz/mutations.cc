#include "fuzz/mutations.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace gable {
namespace {

constexpr size_t kLongest = 1 << 14;

constexpr std::array<const char*, 18> kWords = {
    "0",          "-1",         "1",          "3",          "255",  "65536",
    "2147483647", "2147483648", "4294967295", "4294967296", "1e18", "99999999999999999999",
    "nan",        "-inf",       "1e400",      "1e-400",     "0.5",  ""};
constexpr std::array<uint64_t, 10> kNumbers = {0,
                                               1,
                                               0x7f,
                                               0x7fff,
                                               0x7fffffff,
                                               0x80000000,
                                               0xffffffff,
                                               0x100000000,
                                               0x7ff8000000000000,
                                               0xffffffffffffffff};

size_t below(size_t end, Random* random) { return end == 0 ? 0 : random->next() % end; }

/// A part of a text: where it begins and how long it is.
std::pair<size_t, size_t> part_of(const std::string& text, Random* random) {
  const size_t begin = below(text.size() + 1, random);
  const size_t most = random->chance(0.8) ? 16 : 512;
  return {begin, std::min(text.size() - begin, below(most, random) + 1)};
}

/// Replaces a run of digits, the next one behind a random place.
void edit_number(std::string* text, Random* random) {
  const char* digits = "0123456789";
  const size_t begin = text->find_first_of(digits, below(text->size() + 1, random));
  if (begin == std::string::npos) return;
  const size_t end = std::min(text->find_first_not_of(digits, begin), text->size());
  text->replace(begin, end - begin, kWords[below(kWords.size(), random)]);
}

/// Overwrites 1, 2, 4 or 8 bytes, as if a number of either byte order stood there.
void edit_bytes(std::string* text, Random* random) {
  const size_t size = size_t{1} << below(4, random);
  if (text->size() < size) return;
  const uint64_t number = kNumbers[below(kNumbers.size(), random)];
  char bytes[8];
  std::memcpy(bytes, &number, 8);
  if (random->chance(0.3)) std::reverse(bytes, bytes + size);
  text->replace(below(text->size() - size + 1, random), size, std::string(bytes, size));
}

void mutate(const std::vector<std::string>& seeds, std::string* text, Random* random) {
  switch (below(8, random)) {
    case 0:
      if (!text->empty()) (*text)[below(text->size(), random)] ^= 1 << below(8, random);
      break;
    case 1:
      if (!text->empty()) (*text)[below(text->size(), random)] = static_cast<char>(random->next());
      break;
    case 2:
      if (random->chance(0.3)) text->resize(below(text->size() + 1, random));
      break;
    case 3: {
      const auto [begin, size] = part_of(*text, random);
      text->erase(begin, size);
      break;
    }
    case 4: {
      const auto [begin, size] = part_of(*text, random);
      text->insert(below(text->size() + 1, random), text->substr(begin, size));
      break;
    }
    case 5: {
      const std::string& other = seeds[below(seeds.size(), random)];
      const auto [begin, size] = part_of(other, random);
      text->insert(below(text->size() + 1, random), other.substr(begin, size));
      break;
    }
    case 6:
      edit_number(text, random);
      break;
    default:
      edit_bytes(text, random);
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& seeds, Random* random) {
  std::string text = seeds[below(seeds.size(), random)];
  const int count = random->integer(1, 8);
  for (int i = 0; i < count; ++i) mutate(seeds, &text, random);
  if (text.size() > kLongest) text.resize(kLongest);
  return text;
}

}  // namespace gable
