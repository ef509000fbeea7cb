#include <gable/engine/reconstruct/choice/leftovers.h>
#include <gable/engine/reconstruct/heights/pixel_regions.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

namespace gable {
namespace {

// A garage is wider than this many times what heights are means over: what is narrower could be of
// any height.
constexpr double kResolved = 1.25;

// The part of an image around a box, for refinements that move one rule only.
HeightImage crop(const HeightImage& image, PixelBox box, double margin) {
  const int m = static_cast<int>(std::ceil(margin / image.gsd));
  box.row0 = std::max(0, box.row0 - m);
  box.col0 = std::max(0, box.col0 - m);
  box.row1 = std::min(image.rows, box.row1 + m);
  box.col1 = std::min(image.cols, box.col1 + m);
  HeightImage out;
  out.origin = image.origin;
  out.gsd = image.gsd;
  out.spread = image.spread;
  out.first_center = image.center_of(box.row0, box.col0);
  out.rows = box.row1 - box.row0;
  out.cols = box.col1 - box.col0;
  for (int row = box.row0; row < box.row1; ++row) {
    const size_t from = image.index(row, box.col0), to = image.index(row, box.col1);
    out.height.insert(out.height.end(), image.height.begin() + from, image.height.begin() + to);
    out.ground.insert(out.ground.end(), image.ground.begin() + from, image.ground.begin() + to);
    out.weight.insert(out.weight.end(), image.weight.begin() + from, image.weight.begin() + to);
    out.inside.insert(out.inside.end(), image.inside.begin() + from, image.inside.begin() + to);
  }
  return out;
}

// A region's extent in the house frame, pixels as squares of their true area.
struct HouseBox {
  double x0, x1, y0, y1;
};

HouseBox house_box(const HeightImage& image, const HeightField& field, const PixelRegion& region) {
  std::vector<double> xs, ys;
  for (size_t i : region.pixels) {
    const Eigen::Vector2d p = field.house_from_local(
        image.center_of(static_cast<int>(i / image.cols), static_cast<int>(i % image.cols)));
    xs.push_back(p.x());
    ys.push_back(p.y());
  }
  std::sort(xs.begin(), xs.end());
  std::sort(ys.begin(), ys.end());
  const size_t trim = xs.size() / 25;
  const double half = 0.4 * image.gsd;
  return {xs[trim] - half, xs[xs.size() - 1 - trim] + half, ys[trim] - half,
          ys[ys.size() - 1 - trim] + half};
}

double mean_height(const HeightImage& image, const PixelRegion& region) {
  double sum = 0.0;
  for (size_t i : region.pixels) sum += image.height[i];
  return sum / static_cast<double>(region.pixels.size());
}

// Fits the rule at position `rule` of `house` alone and returns how much the house with it costs
// less than `before`, its price included. The penalised cost is additive over pixels, so a crop
// around the region is enough.
double fit_one(const HeightImage& window, int rule, double price, const PenaltyOptions& penalty,
               const House& before, double first_support, House* house) {
  RefinementOptions refinement;
  refinement.stages = {{first_support, LossKind::kSoftL1, 0.3, 1, 12},
                       {penalty.support, penalty.loss, penalty.loss_scale, 1, 8}};
  refinement.function_tolerance = 1e-4;
  refinement.only_rules = {rule};
  refinement.deviations = false;
  refine_house(window, refinement, house);
  const double scale = 1.0 / (penalty.noise * penalty.noise);
  const double gain =
      squared_residuals(window, before, penalty) - squared_residuals(window, *house, penalty);
  return gain * scale - price * charged_parameters(*house->derivation()[rule]);
}

// What a rule that explains a region perfectly would save.
double most_gain(const HeightImage& image, const HeightField& field, const PixelRegion& region,
                 const PenaltyOptions& penalty) {
  const RobustLoss loss(penalty.loss, penalty.loss_scale);
  double sum = 0.0;
  for (size_t i : region.pixels) {
    const Eigen::Vector2d p =
        image.center_of(static_cast<int>(i) / image.cols, static_cast<int>(i) % image.cols);
    sum += loss.cost(field.at_local(p, image.spread, image.ground[i]) - image.height[i]);
  }
  return sum / (penalty.noise * penalty.noise);
}

struct Proposal {
  double gain = 0.0;
  House house;
};

void keep_better(double gain, const House& house, Proposal* best) {
  if (gain > best->gain) *best = {gain, house};
}

// The pixels of a region within 0.4 m of its commonest height.
PixelRegion flat_part(const HeightImage& image, const PixelRegion& region) {
  std::vector<float> heights;
  for (size_t i : region.pixels) heights.push_back(image.height[i]);
  std::sort(heights.begin(), heights.end());
  constexpr float kBand = 0.8f;
  size_t best_begin = 0, best_count = 0;
  for (size_t begin = 0, end = 0; begin < heights.size(); ++begin) {
    while (end < heights.size() && heights[end] <= heights[begin] + kBand) ++end;
    if (end - begin > best_count) {
      best_count = end - begin;
      best_begin = begin;
    }
  }
  PixelRegion flat = region;
  flat.pixels.clear();
  for (size_t i : region.pixels) {
    const float above = image.height[i] - heights[best_begin];
    if (above >= 0.0f && above <= kBand) flat.pixels.push_back(i);
  }
  return flat;
}

Rule garage_rectangle(const HouseBox& box, double height) {
  Rule rule = make_rule(RuleKind::kGarageI);
  rule.values = {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1), box.x1 - box.x0, box.y1 - box.y0,
                 height};
  return rule;
}

// Share of the pixels a garage shows that lie near its top: a crown is never flat.
double fitting_share(const HeightImage& image, const House& house) {
  const HeightField field(house);
  const int garage = static_cast<int>(house.garages.size()) - 1;
  int seen = 0, near = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      const int b = field.block_at_house(p);
      if (b < 0 || field.sources()[b].role != BlockRole::kGarage ||
          field.sources()[b].index != garage) {
        continue;
      }
      ++seen;
      near += std::abs(field.at_house(p, image.spread, image.ground[i]) - image.height[i]) < 0.5;
    }
  }
  return seen > 0 ? static_cast<double>(near) / seen : 0.0;
}

void propose_on_roof(const HeightImage& image, const PixelRegion& region, double price,
                     const LeftoverOptions& options, const House& house, Proposal* best) {
  const HeightField field(house);
  const HouseBox box = house_box(image, field, region);
  const Eigen::Vector2d center(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1));
  const double height = mean_height(image, region);
  const HeightImage window = crop(image, region.box, 2.0);

  House with = house;
  Rule chimney = make_rule(RuleKind::kChimney);
  const double side = std::sqrt((box.x1 - box.x0) * (box.y1 - box.y0));
  chimney.values = {center.x(), center.y(), std::clamp(side, 0.5, 1.5), height};
  with.chimneys.push_back(chimney);
  const int chimney_block = with.chimney_block(static_cast<int>(house.chimneys.size()));
  const double chimney_gain =
      fit_one(window, chimney_block, price, options.penalty, house, 0.5, &with);
  const Rule& fitted = with.chimneys.back();
  const Eigen::Vector2d foot(fitted[0], fitted[1]);
  const int under = field.block_at_house(foot);
  const double up = fitted[param::chimney::kHeight] - field.at_house(foot, 0.0, 0.0);
  if (under >= 0 && field.sources()[under].role == BlockRole::kComponent &&
      up >= options.least_chimney_rise && up <= options.most_chimney_rise) {
    keep_better(chimney_gain, with, best);
  }

  // The component under the centre carries the dormer.
  int component = -1;
  double top = 0.0;
  for (size_t b = 0; b < field.blocks().size(); ++b) {
    if (field.sources()[b].role != BlockRole::kComponent) continue;
    const std::span<const Block<double>> one(&field.blocks()[b], 1);
    const auto seen = layers_at<double, double>(one, center.x(), center.y(), 0.0);
    if (seen.count > 0 && (component < 0 || seen.layers[0].height > top)) {
      component = field.sources()[b].index;
      top = seen.layers[0].height;
    }
  }
  if (component < 0 || house.roofs[component].kind == RuleKind::kRoofFlat) return;
  const bool along_x = house.roofs[component].ridge == Axis::kX;
  const double seen_width = along_x ? box.x1 - box.x0 : box.y1 - box.y0;
  const double seen_depth = along_x ? box.y1 - box.y0 : box.x1 - box.x0;
  // What is seen, and the paper's common size: a low dormer shows its front only.
  const Eigen::Vector2d sizes[] = {{std::max(seen_width, 1.2), std::max(seen_depth, 1.0)},
                                   {2.0, 2.0}};
  for (const Eigen::Vector2d& size : sizes) {
    with = house;
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = component;
    const double rise = std::tan(M_PI / 6.0) * 0.5 * size.x();
    dormer.values = {center.x(), center.y(), size.x(), size.y(), height - 0.5 * rise, rise};
    with.dormers.push_back(dormer);
    const int dormer_block = with.dormer_block(static_cast<int>(house.dormers.size()));
    const double gain = fit_one(window, dormer_block, price, options.penalty, house, 0.5, &with);
    namespace d = param::dormer;
    const Rule& fit = with.dormers.back();
    const double above =
        fit[d::kEaves] + fit[d::kRise] - field.at_house({fit[0], fit[1]}, 0.0, 0.0);
    if (above <= options.most_dormer_rise &&
        fit[d::kWidth] * fit[d::kDepth] >= options.least_dormer_area) {
      keep_better(gain, with, best);
    }
  }
}

void propose_beside(const HeightImage& image, const PixelRegion& region, double price,
                    const LeftoverOptions& options, const House& house, Proposal* best) {
  const HeightField field(house);
  const HouseBox box = house_box(image, field, region);
  const double height = mean_height(image, region);
  const HeightImage window = crop(image, region.box, 2.5);
  const int rule = house.garage_block(static_cast<int>(house.garages.size()));
  const auto attempt = [&](const Rule& garage) {
    House with = house;
    with.garages.push_back(garage);
    const double gain = fit_one(window, rule, price, options.penalty, house, 1.0, &with);
    const Rule& fitted = with.garages.back();
    namespace box = param::rectangle;
    if (std::min(fitted[box::kLength], fitted[box::kWidth]) < kResolved * image.spread) return;
    if (gain > best->gain && fitting_share(window, with) >= options.fitting_share) {
      *best = {gain, with};
    }
  };
  attempt(garage_rectangle(box, height));
  // The flat part of a region that holds more than a garage.
  const PixelRegion flat = flat_part(image, region);
  if (flat.pixels.size() < region.pixels.size()) {
    attempt(garage_rectangle(house_box(image, field, flat), mean_height(image, flat)));
  }
}

}  // namespace

int add_leftovers(const HeightImage& image, const LeftoverOptions& options, House* house) {
  const double price = parameter_price(image);
  const HeightField field(*house);
  cv::Mat on_roof = cv::Mat::zeros(image.rows, image.cols, CV_8U);
  cv::Mat beside = cv::Mat::zeros(image.rows, image.cols, CV_8U);
  const double least = std::max(options.least_height, 2.5 * options.penalty.noise);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      const double above = image.height[i] - field.at_house(p, image.spread, image.ground[i]);
      if (above < least) continue;
      if (field.block_at_house(p) >= 0) {
        on_roof.at<unsigned char>(row, col) = 1;
      } else if (above > 1.2) {
        beside.at<unsigned char>(row, col) = 1;
      }
    }
  }
  const double pixel_area = image.gsd * image.gsd;
  int added = 0;
  // Beside first: a garage's edge is the wall, and larger regions first.
  std::vector<PixelRegion> regions = largest_regions(beside);
  for (const PixelRegion& region : regions) {
    if (static_cast<double>(region.pixels.size()) * pixel_area < options.least_garage_area) break;
    Proposal best;
    propose_beside(image, region, price, options, *house, &best);
    if (best.gain > 0.0) {
      *house = best.house;
      ++added;
    }
  }
  const double cheapest_on_roof = charged_parameters(make_rule(RuleKind::kChimney));
  regions = largest_regions(on_roof);
  for (const PixelRegion& region : regions) {
    const double area = static_cast<double>(region.pixels.size()) * pixel_area;
    if (region.pixels.size() < 2 || area > options.most_roof_area) continue;
    if (most_gain(image, field, region, options.penalty) < cheapest_on_roof * price) continue;
    Proposal best;
    propose_on_roof(image, region, price, options, *house, &best);
    if (best.gain > 0.0) {
      *house = best.house;
      ++added;
    }
  }
  return added;
}

namespace {

// A dormer or chimney as large as its table allows wants to be something else: a block that the
// hypothesis lacks. Left in, it would make a wrong foundation look right.
bool is_at_upper_bound(const Rule& rule) {
  const auto specs = parameter_specs(rule.kind);
  for (size_t k = 2; k < specs.size(); ++k) {
    if (rule[static_cast<int>(k)] > specs[k].upper - 0.02) return true;
  }
  return false;
}

}  // namespace

int drop_unpaid(const HeightImage& image, const PenaltyOptions& penalty, House* house) {
  int dropped = 0;
  for (std::vector<Rule>* list : {&house->dormers, &house->chimneys}) {
    dropped += static_cast<int>(std::erase_if(*list, is_at_upper_bound));
  }
  double cost = penalised_cost(image, *house, penalty).total;
  for (std::vector<Rule> House::*list : {&House::dormers, &House::chimneys, &House::garages}) {
    for (size_t i = (house->*list).size(); i-- > 0;) {
      House without = *house;
      (without.*list).erase((without.*list).begin() + static_cast<std::ptrdiff_t>(i));
      const double cost_without = penalised_cost(image, without, penalty).total;
      if (cost_without < cost) {
        *house = without;
        cost = cost_without;
        ++dropped;
      }
    }
  }
  return dropped;
}

}  // namespace gable
