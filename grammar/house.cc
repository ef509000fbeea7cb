#include <gable/grammar/house.h>

#include <array>
#include <utility>

namespace gable {
namespace {

constexpr std::array<std::pair<Foundation, std::string_view>, kNumFoundationTypes>
    kFoundationNames = {{
        {Foundation::kI, "I"},
        {Foundation::kII, "II"},
        {Foundation::kIII, "III"},
        {Foundation::kL, "L"},
        {Foundation::kU, "U"},
        {Foundation::kC, "C"},
        {Foundation::kMany, "N"},
    }};

RuleKind footprint_kind(Foundation foundation) {
  switch (foundation) {
    case Foundation::kL:
      return RuleKind::kFootprintL;
    case Foundation::kU:
      return RuleKind::kFootprintU;
    default:
      return RuleKind::kFootprintI;
  }
}

// How many footprints a foundation of so many components has.
int num_footprints(Foundation foundation, int components) {
  return footprint_kind(foundation) == RuleKind::kFootprintI ? components : 1;
}

template <typename RulePointer, typename HouseType>
std::vector<RulePointer> collect(HouseType& house) {
  std::vector<RulePointer> rules;
  rules.reserve(1 + house.footprints.size() + house.roofs.size() + house.dormers.size() +
                house.chimneys.size() + house.garages.size());
  rules.push_back(&house.azimuth);
  for (auto* list :
       {&house.footprints, &house.roofs, &house.dormers, &house.chimneys, &house.garages}) {
    for (auto& rule : *list) rules.push_back(&rule);
  }
  return rules;
}

}  // namespace

std::string_view foundation_name(Foundation foundation) {
  return kFoundationNames[static_cast<int>(foundation)].second;
}

bool foundation_from_name(std::string_view name, Foundation* foundation) {
  for (const auto& [value, value_name] : kFoundationNames) {
    if (value_name == name) {
      *foundation = value;
      return true;
    }
  }
  return false;
}

int num_components(Foundation foundation) {
  constexpr std::array<int, kNumFoundationTypes> kComponents = {1, 2, 3, 2, 3, 0, 4};
  return kComponents[static_cast<int>(foundation)];
}

std::vector<Rule*> House::derivation() { return collect<Rule*>(*this); }

std::vector<const Rule*> House::derivation() const { return collect<const Rule*>(*this); }

int House::num_parameters() const {
  int n = 0;
  for (const Rule* rule : derivation()) n += rule->size();
  return n;
}

bool is_well_formed(const House& house) {
  if (house.foundation == Foundation::kC) return false;
  if (house.azimuth.kind != RuleKind::kAzimuth) return false;
  const int components = house.num_components(), expected = num_components(house.foundation);
  if (house.foundation == Foundation::kMany ? components < expected : components != expected) {
    return false;
  }
  if (static_cast<int>(house.footprints.size()) != num_footprints(house.foundation, components)) {
    return false;
  }
  for (const Rule& r : house.footprints) {
    if (r.kind != footprint_kind(house.foundation)) return false;
  }
  for (const Rule& r : house.roofs) {
    if (!is_roof(r.kind)) return false;
  }
  for (const Rule& r : house.dormers) {
    if (r.kind != RuleKind::kDormer) return false;
    if (r.component < 0 || r.component >= house.num_components()) return false;
  }
  for (const Rule& r : house.chimneys) {
    if (r.kind != RuleKind::kChimney) return false;
  }
  for (const Rule& r : house.garages) {
    if (r.kind != RuleKind::kGarageI && r.kind != RuleKind::kGarageL) return false;
  }
  return true;
}

House make_house(Foundation foundation) {
  House house;
  house.foundation = foundation;
  const int components = num_components(foundation);
  house.footprints.assign(num_footprints(foundation, components),
                          make_rule(footprint_kind(foundation)));
  house.roofs.assign(components, make_rule(RuleKind::kRoofGable));
  if (foundation == Foundation::kL || foundation == Foundation::kU) {
    for (size_t i = 1; i < house.roofs.size(); ++i) house.roofs[i].ridge = Axis::kY;
  }
  return house;
}

}  // namespace gable
