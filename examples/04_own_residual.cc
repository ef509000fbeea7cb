// A residual of one's own in the shared core: a point that somebody surveyed on the roof.
#include <ceres/autodiff_cost_function.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/scene.h>

#include <cstdio>

using namespace gable;

/// weight * (height of the roof at the point - height of the point), of the first component.
struct SurveyedPoint {
  const House& house;     ///< gives the kinds of its rules
  Eigen::Vector3d point;  ///< local frame, metres
  double weight;

  template <typename T>
  bool operator()(const T* azimuth, const T* footprint, const T* roof, T* residual) const {
    using std::cos, std::sin;
    const T c = cos(azimuth[0]), s = sin(azimuth[0]);
    const T x = c * point.x() + s * point.y();  // in the house frame
    const T y = c * point.y() - s * point.x();
    const BlockSource source = block_sources(house)[0];
    const Block<T> block = expand_block(house, source, roof, footprint);
    residual[0] = weight * (roof_height(block, x, y) - point.z());
    return true;
  }
};

int main() {
  House truth = make_house(Foundation::kI);
  truth.roofs[0].values = {5.0, 2.5};
  const Scene scene = make_scene(truth, {.seed = 4, .trees = 0});
  HeightImage image = height_image(scene.dsm, scene.dtm, scene.house.origin);
  for (float& height : image.height) height += 0.15f;  // the survey has an offset
  const Eigen::Vector3d surveyed(0.0, 0.0, 7.5);       // on the ridge, to a centimetre

  House house = scene.house;
  RefinementOptions options;
  options.add_residuals = [&](const House& h, std::span<double* const> blocks,
                              ceres::Problem* problem) {
    const double weight = options.height_deviation / 0.001;
    problem->AddResidualBlock(new ceres::AutoDiffCostFunction<SurveyedPoint, 1, 1, 4, 2>(
                                  new SurveyedPoint{h, surveyed, weight}),
                              nullptr, blocks[0], blocks[h.footprint_block(0)],
                              blocks[h.roof_block(0)]);
  };
  refine_house(image, options, &house);
  const double there = HeightField(house).at_local(surveyed.head<2>(), 0.0, 0.0);
  std::printf("roof at %.2f m where %.2f m were surveyed\n", there, surveyed.z());
}
