#include <gable/grammar/rule.h>

#include <cassert>

namespace gable {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

constexpr ParameterSpec kAzimuth[] = {
    {"azimuth", "rad", -kInf, kInf, 0.0, "mask and normals"},
};

constexpr ParameterSpec kFootprintI[] = {
    {"center_x", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"center_y", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"length", "m", 1.0, 200.0, 10.0, "detected corners (NPR 4.1)"},
    {"width", "m", 1.0, 200.0, 8.0, "detected corners (NPR 4.1)"},
};

constexpr ParameterSpec kFootprintL[] = {
    {"corner_x", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"corner_y", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"wing_x_length", "m", 1.0, 200.0, 12.0, "detected corners (NPR 4.1)"},
    {"wing_x_width", "m", 1.0, 200.0, 6.0, "detected corners (NPR 4.1)"},
    {"wing_y_length", "m", 1.0, 200.0, 12.0, "detected corners (NPR 4.1)"},
    {"wing_y_width", "m", 1.0, 200.0, 6.0, "detected corners (NPR 4.1)"},
};

constexpr ParameterSpec kFootprintU[] = {
    {"corner_x", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"corner_y", "m", -kInf, kInf, 0.0, "detected corners (NPR 4.1)"},
    {"base_length", "m", 1.0, 200.0, 18.0, "detected corners (NPR 4.1)"},
    {"base_width", "m", 1.0, 200.0, 6.0, "detected corners (NPR 4.1)"},
    {"left_length", "m", 1.0, 200.0, 12.0, "detected corners (NPR 4.1)"},
    {"left_width", "m", 1.0, 200.0, 6.0, "detected corners (NPR 4.1)"},
    {"right_length", "m", 1.0, 200.0, 12.0, "detected corners (NPR 4.1)"},
    {"right_width", "m", 1.0, 200.0, 6.0, "detected corners (NPR 4.1)"},
};

constexpr ParameterSpec kRoof[] = {
    {"eaves", "m", 0.5, 200.0, 5.0, "mean of the lowest 10 % of heights inside (NPR 4.1)"},
    {"rise", "m", 0.0, 50.0, 2.5, "mean of the highest 5 % less the eaves (NPR 4.2)"},
    {"hip_start", "1", 0.0, 0.5, 0.1, "common value (NPR 4.2)"},
    {"hip_end", "1", 0.0, 0.5, 0.1, "common value (NPR 4.2)"},
};

constexpr ParameterSpec kMansard[] = {
    kRoof[param::roof::kEaves],
    kRoof[param::roof::kRise],
    {"break_height", "1", 0.5, 0.95, 0.65, "common value"},
    {"break_run", "1", 0.05, 0.5, 0.3, "common value"},
};

constexpr ParameterSpec kDormer[] = {
    {"center_x", "m", -kInf, kInf, 0.0, "detected centre (NPR 4.3)"},
    {"center_y", "m", -kInf, kInf, 0.0, "detected centre (NPR 4.3)"},
    {"width", "m", 1.2, 4.5, 2.0, "common value (NPR 4.3)"},
    {"depth", "m", 1.2, 4.2, 2.0, "common value (NPR 4.3)"},
    {"eaves", "m", 0.5, 200.0, 6.5, "heights at the centre"},
    {"rise", "m", 0.0, 1.6, 0.577, "roof at 30 degrees (NPR 4.3)"},
};

constexpr ParameterSpec kChimney[] = {
    {"center_x", "m", -kInf, kInf, 0.0, "detected centre (NPR 4.3)"},
    {"center_y", "m", -kInf, kInf, 0.0, "detected centre (NPR 4.3)"},
    {"side", "m", 0.4, 1.6, 0.7, "common value (NPR 4.3)"},
    {"height", "m", 0.5, 200.0, 9.0, "roof height at the centre + 2.5 m (NPR 4.3)"},
};

constexpr ParameterSpec kGarageI[] = {
    {"center_x", "m", -kInf, kInf, 0.0, "detected pixels by IoU (NPR 4.4)"},
    {"center_y", "m", -kInf, kInf, 0.0, "detected pixels by IoU (NPR 4.4)"},
    {"length", "m", 1.0, 200.0, 6.0, "detected pixels by IoU (NPR 4.4)"},
    {"width", "m", 1.0, 200.0, 3.0, "detected pixels by IoU (NPR 4.4)"},
    {"height", "m", 0.5, 200.0, 2.6, "mean height inside (NPR 4.4)"},
};

constexpr ParameterSpec kGarageL[] = {
    {"corner_x", "m", -kInf, kInf, 0.0, "detected pixels by IoU (NPR 4.4)"},
    {"corner_y", "m", -kInf, kInf, 0.0, "detected pixels by IoU (NPR 4.4)"},
    {"wing_x_length", "m", 1.0, 200.0, 6.0, "detected pixels by IoU (NPR 4.4)"},
    {"wing_x_width", "m", 1.0, 200.0, 3.0, "detected pixels by IoU (NPR 4.4)"},
    {"wing_y_length", "m", 1.0, 200.0, 6.0, "detected pixels by IoU (NPR 4.4)"},
    {"wing_y_width", "m", 1.0, 200.0, 3.0, "detected pixels by IoU (NPR 4.4)"},
    {"height", "m", 0.5, 200.0, 2.6, "mean height inside (NPR 4.4)"},
};

// What the names of all roofs begin with.
constexpr std::string_view kRoofPrefix = "roof_";

struct RuleTable {
  std::string_view name;
  std::span<const ParameterSpec> specs;
};

const RuleTable& table(RuleKind kind) {
  static constexpr RuleTable kTables[kNumRuleKinds] = {
      {"azimuth", kAzimuth},
      {"footprint_i", kFootprintI},
      {"footprint_l", kFootprintL},
      {"footprint_u", kFootprintU},
      {"roof_flat", std::span(kRoof, 1)},
      {"roof_gable", std::span(kRoof, 2)},
      {"roof_hip", std::span(kRoof, 4)},
      {"roof_mansard", kMansard},
      {"dormer", kDormer},
      {"chimney", kChimney},
      {"garage_i", kGarageI},
      {"garage_l", kGarageL},
  };
  return kTables[static_cast<int>(kind)];
}

}  // namespace

std::span<const ParameterSpec> parameter_specs(RuleKind kind) { return table(kind).specs; }

std::string_view rule_name(RuleKind kind) { return table(kind).name; }

bool rule_kind_from_name(std::string_view name, RuleKind* kind) {
  for (int i = 0; i < kNumRuleKinds; ++i) {
    if (table(static_cast<RuleKind>(i)).name == name) {
      *kind = static_cast<RuleKind>(i);
      return true;
    }
  }
  return false;
}

bool is_roof(RuleKind kind) { return rule_name(kind).starts_with(kRoofPrefix); }

std::string_view roof_name(RuleKind kind) {
  assert(is_roof(kind));
  return rule_name(kind).substr(kRoofPrefix.size());
}

int Rule::size() const { return static_cast<int>(parameter_specs(kind).size()); }

Rule make_rule(RuleKind kind) {
  Rule rule;
  rule.kind = kind;
  const auto specs = parameter_specs(kind);
  for (size_t i = 0; i < specs.size(); ++i) rule.values[i] = specs[i].initial;
  return rule;
}

}  // namespace gable
