#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_candidates.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/heights/mask_outline.h>
#include <gable/engine/stopwatch.h>
#include <glog/logging.h>

#include <cstdio>
#include <optional>
#include <utility>

namespace gable {
namespace {

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f m", value);
  return text;
}

/// First values from the detectors and from the structural scales.
FirstValues first_values(const HeightImage& image, const BuildingOptions& options,
                         const DetectValues& detect) {
  FirstValues values;
  if (detect) {
    DetectedValues detected = detect(image);
    values.foundation = detected.foundation;
    values.houses = std::move(detected.houses);
  }
  if (options.scales) {
    const HouseScales scales = house_scales(image, nullptr, options.house_scales);
    for (FirstValue& value : scale_values(image, scales, options.scale_values)) {
      values.houses.push_back(std::move(value));
    }
  }
  return values;
}

/// Decides which candidate becomes the building.
class Verdict {
 public:
  Verdict(const std::string& id, const HeightImage& image, const PlanPolygon* outline,
          const BuildingOptions& options)
      : id_(id),
        image_(image),
        outline_(outline),
        options_(options),
        extrusion_(extruded_outline(
            id, image, outline ? *outline : outline_of_mask(image, options.outline_tolerance))) {}

  ReconstructedBuilding reached(const DetectValues& detect) {
    const double area = extrusion_.fit.pixels * image_.gsd * image_.gsd;
    if (area < options_.least_area) {
      char text[64];
      std::snprintf(text, sizeof(text), "only %.1f square metres with heights", area);
      return given(extrusion_.building, text);
    }
    HouseChoiceOptions choice_options = options_.choice;
    choice_options.outline_known = outline_ != nullptr;
    choice_ = choose_house(image_, choice_options, first_values(image_, options_, detect));
    if (!choice_.found) return planes_or_extrusion("no house of the grammar explains the heights");

    const double farthest = extrusion_.fit.charge + options_.extrusion_margin;
    BuildingCandidate house = chosen_house(id_, image_, choice_, outline_, farthest);
    if (house.fit.charge > farthest) {
      return planes_or_extrusion("the best house of the grammar is " + metres(house.fit.charge) +
                                 " from the heights on average, the extruded outline " +
                                 metres(extrusion_.fit.charge));
    }
    BuildingModel model;
    if (const std::string defect = raise_house(image_, &house, &model); !defect.empty()) {
      return planes_or_extrusion(defect);
    }
    // Found in the heights, a building's cells are too uncertain at their rim to tell planes from
    // smear, and closing takes longer than all the rest.
    if (outline_ && options_.planes_may_replace(house.fit.charge)) {
      const PlanesCandidate& closed = planes();
      const double charge = closed.planes.fit.charge;
      if (closed.defect.empty() && charge < house.fit.charge - options_.planes_margin &&
          charge < options_.planes_ratio * house.fit.charge) {
        return planes_or_extrusion("the best house of the grammar is " + metres(house.fit.charge) +
                                   " from the heights on average, the planes of its roof " +
                                   metres(charge));
      }
    }
    return {std::move(house.building), std::move(model), std::move(choice_)};
  }

 private:
  const PlanesCandidate& planes() {
    if (!planes_) planes_ = closed_roof(image_, options_.closing, extrusion_.building);
    return *planes_;
  }

  ReconstructedBuilding given(Building building, const std::string& reason) {
    building.reason = reason;
    BuildingModel model = build_model(building);
    return {std::move(building), std::move(model), std::move(choice_)};
  }

  /// The planes of the roof where they can be closed and are nearer than one height, else that.
  ReconstructedBuilding planes_or_extrusion(const std::string& reason) {
    const PlanesCandidate& closed = planes();
    if (!closed.defect.empty()) return given(extrusion_.building, reason + "; " + closed.defect);
    const double charge = closed.planes.fit.charge;
    if (charge > extrusion_.fit.charge - options_.extrusion_margin) {
      return given(extrusion_.building,
                   reason + "; the planes of its roof are " + metres(charge) + " from the heights");
    }
    return given(closed.planes.building, reason);
  }

  const std::string& id_;
  const HeightImage& image_;
  const PlanPolygon* outline_;
  const BuildingOptions& options_;
  const BuildingCandidate extrusion_;
  HouseChoice choice_;
  std::optional<PlanesCandidate> planes_;
};

}  // namespace

ReconstructedBuilding reconstruct_building(const std::string& id, const HeightImage& image,
                                           const PlanPolygon* outline,
                                           const BuildingOptions& options,
                                           const DetectValues& detect) {
  CHECK(check(options).empty()) << check(options);
  const Stopwatch watch;
  ReconstructedBuilding building = Verdict(id, image, outline, options).reached(detect);
  building.building.quality.time_ms = watch.ms();
  return building;
}

}  // namespace gable
