#include <gable/engine/dataset/annotated_images.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>
#include <gable/grammar/ring.h>

#include <algorithm>
#include <utility>

namespace gable {
namespace {

bool holds(const AnnotatedHouse& house, const Eigen::Vector2d& world) {
  return ring_holds(house.outline, world) ||
         std::any_of(house.garages.begin(), house.garages.end(),
                     [&](const auto& ring) { return ring_holds(ring, world); });
}

}  // namespace

double annotation_iou(const HeightImage& image, const AnnotatedHouse& house) {
  int both = 0, any = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const bool inside = image.inside[image.index(row, col)] != 0;
      const bool held = holds(house, image.origin.head<2>() + image.center_of(row, col));
      both += inside && held;
      any += inside || held;
    }
  }
  return any > 0 ? static_cast<double>(both) / any : 0.0;
}

std::vector<AnnotatedImage> annotated_images(const TileInput& input, const TileOptions& options,
                                             const std::vector<AnnotatedHouse>& houses,
                                             double least_iou, const std::stop_token& stop) {
  std::vector<double> best(houses.size(), 0.0);
  std::vector<AnnotatedImage> found(houses.size());
  TileCallbacks callbacks;
  callbacks.deliver = [&](TileBuilding&& building) {
    const HeightImage& image = building.image;
    const double reach = image.gsd * std::max(image.rows, image.cols);
    for (size_t i = 0; i < houses.size(); ++i) {
      if ((houses[i].center - image.origin.head<2>()).norm() > reach) continue;
      const double iou = annotation_iou(image, houses[i]);
      if (iou < least_iou || iou <= best[i]) continue;
      best[i] = iou;
      found[i] = {i, image};
    }
  };
  visit_tile(input, options, stop, callbacks,
             [](const std::string& id, const PlanPolygon*, TileBuilding* building) {
               building->building.id = id;
             });
  std::vector<AnnotatedImage> images;
  for (size_t i = 0; i < found.size(); ++i) {
    if (best[i] > 0.0) images.push_back(std::move(found[i]));
  }
  return images;
}

}  // namespace gable
