// What is known besides the heights, and how well every parameter is known in the end.
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/synthesis/scene.h>

#include <cstdio>
#include <string>

int main() {
  using namespace gable;
  House truth = make_house(Foundation::kI);
  truth.azimuth[0] = 0.35;
  truth.roofs[0].values = {5.0, 2.5};
  Scene scene = make_scene(truth, {.seed = 2, .trees = 0});
  HeightImage image = height_image(scene.dsm, scene.dtm, scene.house.origin);
  // Nothing is known of the eastern half: only a plan tells how long the house is.
  for (int row = 0; row < image.rows; ++row) {
    for (int col = image.cols / 2; col < image.cols; ++col) {
      image.weight[image.index(row, col)] = 0.0f;
    }
  }

  for (const bool with_plan : {false, true}) {
    House house = scene.house;
    RefinementOptions options;
    options.refine_azimuth = false;
    const int footprint = house.footprint_block(0);
    if (with_plan) options.priors = {{footprint, param::rectangle::kLength, 10.0, 0.1}};
    const RefinementSummary summary = refine_house(image, options, &house);

    std::printf("%s\n", with_plan ? "with the plan" : "heights alone");
    const auto rules = house.derivation();
    for (size_t i = 1; i < rules.size(); ++i) {
      const auto specs = parameter_specs(rules[i]->kind);
      for (size_t k = 0; k < specs.size(); ++k) {
        std::printf("  %-10s %6.2f +- %.2f %s\n", std::string(specs[k].name).c_str(),
                    rules[i]->values[k], summary.deviations[i][k],
                    std::string(specs[k].unit).c_str());
      }
    }
  }
}
