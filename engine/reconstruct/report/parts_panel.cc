#include <gable/engine/drawing/canvas.h>
#include <gable/engine/reconstruct/report/parts_panel.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

namespace gable {
namespace {

// Drawn this many times larger and reduced at the end, so that edges come out smooth.
constexpr int kOversampling = 2;
constexpr Color kLineColor{60, 50, 42};

using Segment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

// Between pixels of the enlarged panel and the image's local frame.
class PanelFrame {
 public:
  PanelFrame(const HeightImage& image, const PanelScale& scale)
      : pixels_per_meter_(kOversampling * scale.pixels_per_cell / image.gsd),
        north_west_(image.first_center + 0.5 * image.gsd * Eigen::Vector2d(-1.0, 1.0)) {}

  Eigen::Vector2d local_of_pixel(int x, int y) const {
    return north_west_ + Eigen::Vector2d(x + 0.5, -(y + 0.5)) / pixels_per_meter_;
  }
  cv::Point2d pixel_of_local(const Eigen::Vector2d& local) const {
    const Eigen::Vector2d p = (local - north_west_) * pixels_per_meter_;
    return {p.x() - 0.5, -p.y() - 0.5};
  }

 private:
  double pixels_per_meter_;
  Eigen::Vector2d north_west_;
};

// Ridge, hip and break lines of a block in the house frame.
std::vector<Segment> roof_lines(const Block<double>& block) {
  using namespace block_value;
  if (block.flat) return {};
  const bool along_x = block.ridge == Axis::kX;
  const double u0 = along_x ? block[kX0] : block[kY0], u1 = along_x ? block[kX1] : block[kY1];
  const double v0 = along_x ? block[kY0] : block[kX0], v1 = along_x ? block[kY1] : block[kX1];
  const auto point = [along_x](double u, double v) {
    return along_x ? Eigen::Vector2d(u, v) : Eigen::Vector2d(v, u);
  };
  const double middle = 0.5 * (v0 + v1);
  if (block.mansard) {
    const double run = 0.5 * block[kBreakRun] * (v1 - v0);
    return {{point(u0, middle), point(u1, middle)},
            {point(u0, v0 + run), point(u1, v0 + run)},
            {point(u0, v1 - run), point(u1, v1 - run)}};
  }
  const Eigen::Vector2d start = point(u0 + block[kHipStart] * (u1 - u0), middle);
  const Eigen::Vector2d end = point(u1 - block[kHipEnd] * (u1 - u0), middle);
  std::vector<Segment> lines = {{start, end}};
  if (block[kHipStart] > 0.0) {
    lines.push_back({start, point(u0, v0)});
    lines.push_back({start, point(u0, v1)});
  }
  if (block[kHipEnd] > 0.0) {
    lines.push_back({end, point(u1, v0)});
    lines.push_back({end, point(u1, v1)});
  }
  return lines;
}

// Draws those pieces of a block's line from which the block is seen.
void draw_visible_line(cv::Mat& canvas, const BuildingSurface& surface, const PanelFrame& frame,
                       int block, const Segment& line) {
  constexpr double kStep = 0.1;
  const HeightField& field = *surface.field();
  const double length = (line.second - line.first).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  const auto point = [&](double i) -> Eigen::Vector2d {
    return line.first + (line.second - line.first) * (i / steps);
  };
  const auto pixel = [&](double i) {
    const cv::Point2d p = frame.pixel_of_local(field.local_from_house(point(i)) + surface.offset());
    return cv::Point(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  };
  int begin = -1;
  for (int i = 0; i <= steps; ++i) {
    const bool seen = i < steps && field.block_at_house(point(i + 0.5)) == block;
    if (seen && begin < 0) begin = i;
    if (!seen && begin >= 0) {
      cv::line(canvas, pixel(begin), pixel(i), scalar(kLineColor), kOversampling, cv::LINE_AA);
      begin = -1;
    }
  }
}

}  // namespace

Color part_color(BlockRole role, int index) {
  switch (role) {
    case BlockRole::kGarage:
      return kGarageColor;
    case BlockRole::kDormer:
      return kDormerColor;
    case BlockRole::kChimney:
      return kChimneyColor;
    case BlockRole::kComponent:
      break;
  }
  return kComponentColors[index % std::size(kComponentColors)];
}

cv::Mat parts_panel(const BuildingSurface& surface, const HeightImage& image,
                    const PanelScale& scale) {
  const PanelFrame frame(image, scale);
  const cv::Size size(kOversampling * scale.width, kOversampling * scale.height);
  cv::Mat canvas(size, CV_8UC3);
  cv::Mat blocks(size, CV_32SC1);
  for (int y = 0; y < size.height; ++y) {
    const int row = scale.row_of(y / kOversampling, image);
    for (int x = 0; x < size.width; ++x) {
      const SurfacePart part = surface.part(frame.local_of_pixel(x, y));
      blocks.at<int>(y, x) = part.block;
      Color color = kNoDataColor;
      if (part.block >= 0) {
        const int index =
            surface.field() ? surface.field()->sources()[part.block].index : part.block;
        color = part_color(part.role, index);
      } else {
        const int col = scale.col_of(x / kOversampling, image);
        if (is_measured(image, image.index(row, col))) {
          color = mix({196, 198, 202}, {255, 255, 255}, shade(image, image.height, row, col));
        }
      }
      canvas.at<cv::Vec3b>(y, x) = bgr(color);
    }
  }
  for (int y = 0; y + 1 < size.height; ++y) {
    for (int x = 0; x + 1 < size.width; ++x) {
      const int block = blocks.at<int>(y, x);
      if (block == blocks.at<int>(y, x + 1) && block == blocks.at<int>(y + 1, x)) continue;
      cv::rectangle(canvas, cv::Rect(x, y, 2, 2), scalar(kLineColor), cv::FILLED);
    }
  }
  if (const HeightField* field = surface.field()) {
    for (size_t i = 0; i < field->blocks().size(); ++i) {
      for (const Segment& line : roof_lines(field->blocks()[i])) {
        draw_visible_line(canvas, surface, frame, static_cast<int>(i), line);
      }
    }
  }
  cv::Mat panel;
  cv::resize(canvas, panel, cv::Size(scale.width, scale.height), 0.0, 0.0, cv::INTER_AREA);
  return panel;
}

}  // namespace gable
