#include <gable/engine/dataset/training_sample.h>
#include <gable/engine/dataset/visible_details.h>
#include <gable/engine/detectors/foundation_corners.h>
#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/polygon_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kRoughTurn = 0.026;   // rms error of a rectification that worked, radians
constexpr double kWrongTurn = 0.14;    // most error of one that did not, radians
constexpr double kSurelyHigh = 2.5;    // of what must be found, metres
constexpr double kFoundShare = 0.75;   // of a building, or it is not the one of the labels
constexpr double kOutlineShare = 0.4;  // scenes whose outline is known

/// The angle modulo a quarter turn, in [0, pi / 2).
double quarter(double angle) {
  const double turned = std::fmod(angle, 0.5 * M_PI);
  return turned < 0.0 ? turned + 0.5 * M_PI : turned;
}

void mark_garages(const House& house, const Eigen::Vector3d& image_origin, TrainingSample* sample) {
  if (house.garages.empty()) return;
  const HeightField field(house);
  const HouseCrop& crop = sample->crop;
  const double c = std::cos(crop.azimuth), s = std::sin(crop.azimuth);
  const Eigen::Vector2d shift = (image_origin - house.origin).head<2>();
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const Eigen::Vector2d p = crop.house_from_crop({col + 0.5, row + 0.5});
      const Eigen::Vector2d local(c * p.x() - s * p.y(), s * p.x() + c * p.y());
      const int block = field.block_at_house(field.house_from_local(local + shift));
      sample->garages[static_cast<size_t>(row) * kCropSize + col] =
          block >= 0 && field.sources()[block].role == BlockRole::kGarage;
    }
  }
}

/// The centres of dormers or chimneys in crop pixels.
std::vector<Eigen::Vector2d> centers(const House& house, const std::vector<Rule>& rules,
                                     const HouseCrop& crop, const Eigen::Vector3d& image_origin) {
  std::vector<Eigen::Vector2d> points;
  for (const Rule& rule : rules) {
    points.push_back(crop_from_own_frame(house, {rule[0], rule[1]}, crop, image_origin));
  }
  return points;
}

/// The index of the found building that holds most cells of the scene's, or -1.
int building_of_scene(const TrainingScene& scene, const FoundHouses& found) {
  std::vector<int> count(found.houses.size(), 0);
  for (size_t i = 0; i < scene.truth.values.size(); ++i) {
    const int label = found.label.values[i];
    if (label > 0 && std::isfinite(scene.truth.values[i])) ++count[label - 1];
  }
  const auto most = std::max_element(count.begin(), count.end());
  if (most != count.end() && *most > 0) return static_cast<int>(most - count.begin());
  if (!scene.outline.outer.empty() || found.houses.empty()) return -1;
  const auto largest = std::max_element(
      found.houses.begin(), found.houses.end(),
      [](const FoundHouse& a, const FoundHouse& b) { return a.num_cells < b.num_cells; });
  return static_cast<int>(largest - found.houses.begin());
}

/// The share of the scene's cells, those of low garages aside, that a found building holds; 1 where
/// the scene has none.
double found_share(const TrainingScene& scene, const FoundHouses& found, int index) {
  int all = 0, held = 0;
  for (size_t i = 0; i < scene.truth.values.size(); ++i) {
    if (!(scene.truth.values[i] - scene.dtm.values[i] > kSurelyHigh)) continue;
    ++all;
    held += found.label.values[i] == index + 1;
  }
  return all > 0 ? static_cast<double>(held) / all : 1.0;
}

std::optional<HeightImage> image_of_scene(const TrainingScene& scene, Random* random) {
  const bool by_outline = random->chance(kOutlineShare) || scene.outline_needed;
  if (by_outline && !scene.footprint.outer.empty()) {
    Raster<unsigned char> outlined(scene.dsm.grid, 0);
    for_cells_in_polygon(scene.footprint, Eigen::Vector2d::Zero(), scene.dsm.grid,
                         [&](int row, int col) { outlined.at(row, col) = 1; });
    return crop_footprint(scene.dsm, scene.dtm, outlined, scene.footprint, {});
  }
  const FoundHouses found = find_houses(scene.dsm, scene.dtm, {});
  const int index = building_of_scene(scene, found);
  if (index < 0 || found_share(scene, found, index) < kFoundShare) return std::nullopt;
  return crop_found_house(scene.dsm, scene.dtm, found, static_cast<size_t>(index), {});
}

}  // namespace

std::vector<RoofType> roof_types(const House& house) {
  std::vector<RoofType> types;
  if (house.foundation == Foundation::kL || house.foundation == Foundation::kU) {
    bool hipped = false, flat = true;
    for (size_t i = 0; i < house.roofs.size(); ++i) {
      const Rule& roof = house.roofs[i];
      flat &= roof.kind == RuleKind::kRoofFlat;
      const bool base_of_u = house.foundation == Foundation::kU && i == 0;
      hipped |= !base_of_u && roof.kind == RuleKind::kRoofHip && roof[param::roof::kHipEnd] > 0.0;
    }
    return {flat ? RoofType::kFlat : hipped ? RoofType::kHip : RoofType::kGable};
  }
  for (const Rule& roof : house.roofs) {
    types.push_back(roof.kind == RuleKind::kRoofFlat  ? RoofType::kFlat
                    : roof.kind == RuleKind::kRoofHip ? RoofType::kHip
                                                      : RoofType::kGable);
  }
  return types;
}

TrainingSample label_building(const HeightImage& image, Foundation foundation, const House* house,
                              double azimuth) {
  TrainingSample sample;
  sample.foundation = foundation;
  sample.crop = make_house_crop(image, azimuth);
  sample.turned = make_house_crop(image, 0.0);
  sample.azimuth = std::numeric_limits<double>::quiet_NaN();
  if (house == nullptr) return sample;
  sample.azimuth = quarter(house->azimuth[0]);
  sample.roofs = roof_types(*house);
  for (int i = 0; i < house->num_components(); ++i) {
    sample.components.push_back(component_corners(*house, i, sample.crop, image.origin));
  }
  sample.corners = foundation_corners(*house, sample.crop, image.origin);
  sample.dormers = centers(*house, house->dormers, sample.crop, image.origin);
  sample.chimneys = centers(*house, house->chimneys, sample.crop, image.origin);
  mark_garages(*house, image.origin, &sample);
  return sample;
}

std::optional<TrainingSample> make_training_sample(const TrainingScene& scene, Random* random) {
  const std::optional<HeightImage> image = image_of_scene(scene, random);
  if (!image) return std::nullopt;
  if (scene.foundation == Foundation::kC) {
    return label_building(*image, Foundation::kC, nullptr,
                          azimuth_candidates(*image, 0.1).front().azimuth);
  }
  House shown = scene.house;
  const House faint = keep_visible_details(scene, &shown);
  const double error =
      random->chance(0.9) ? random->normal(kRoughTurn) : random->uniform(-kWrongTurn, kWrongTurn);
  const double azimuth =
      scene.house.azimuth[0] + error + 0.5 * M_PI * static_cast<double>(random->integer(0, 3));
  TrainingSample sample = label_building(*image, scene.foundation, &shown, azimuth);
  sample.faint_dormers = centers(faint, faint.dormers, sample.crop, image->origin);
  sample.faint_chimneys = centers(faint, faint.chimneys, sample.crop, image->origin);
  return sample;
}

}  // namespace gable
