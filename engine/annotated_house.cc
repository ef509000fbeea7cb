#include <gable/engine/annotated_house.h>

namespace gable {
namespace {

constexpr std::array<std::string_view, 3> kConfidences = {"low", "medium", "high"};
constexpr std::array<std::string_view, kNumRoofTypes> kRoofTypes = {"flat", "gable", "hip"};

template <typename Value, size_t N>
std::optional<Value> value_from_name(const std::array<std::string_view, N>& names,
                                     std::string_view name) {
  for (size_t i = 0; i < N; ++i) {
    if (names[i] == name) return static_cast<Value>(i);
  }
  return std::nullopt;
}

}  // namespace

std::string_view confidence_name(Confidence confidence) {
  return kConfidences[static_cast<size_t>(confidence)];
}

std::optional<Confidence> confidence_from_name(std::string_view name) {
  return value_from_name<Confidence>(kConfidences, name);
}

std::string_view roof_type_name(RoofType type) { return kRoofTypes[static_cast<size_t>(type)]; }

std::optional<RoofType> roof_type_from_name(std::string_view name) {
  return value_from_name<RoofType>(kRoofTypes, name);
}

int num_annotated_rectangles(Foundation foundation) {
  switch (foundation) {
    case Foundation::kI:
      return 1;
    case Foundation::kII:
      return 2;
    case Foundation::kIII:
      return 3;
    default:
      return 0;
  }
}

int num_annotated_roofs(Foundation foundation) {
  const bool polygon = foundation == Foundation::kL || foundation == Foundation::kU;
  return polygon ? 1 : num_annotated_rectangles(foundation);
}

int num_annotated_corners(Foundation foundation) {
  if (foundation == Foundation::kL) return 6;
  return foundation == Foundation::kU ? 8 : 0;
}

}  // namespace gable
