#include <gable/engine/reconstruct/first_values/first_values.h>

namespace gable {

std::string_view value_source_name(ValueSource source) {
  switch (source) {
    case ValueSource::kDetectors:
      return "detectors";
    case ValueSource::kScales:
      return "scales";
    case ValueSource::kClassical:
      break;
  }
  return "classical";
}

std::vector<std::string> origins_of(const House& house, const OriginsByKind& by_kind) {
  std::vector<std::string> origins = {by_kind.azimuth};
  origins.insert(origins.end(), house.footprints.size(), by_kind.footprint);
  origins.insert(origins.end(), house.roofs.size(), by_kind.roof);
  origins.insert(origins.end(), house.dormers.size() + house.chimneys.size(), by_kind.detail);
  origins.insert(origins.end(), house.garages.size(), by_kind.garage);
  return origins;
}

}  // namespace gable
