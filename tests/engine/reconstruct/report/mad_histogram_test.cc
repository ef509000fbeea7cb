#include <gable/engine/reconstruct/report/mad_histogram.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(MadHistogram, LastBinHoldsAllThatIsLarger) {
  const Histogram histogram = make_histogram({0.0, 0.05, 0.12, 0.2, 7.0, NAN, -1.0}, 0.1, 3);
  EXPECT_THAT(histogram.counts, ElementsAre(2, 1, 2));
}

TEST(MadHistogram, MedianOfAnEvenNumberIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, NAN, 2.0, 3.0}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(MadHistogram, DrawsOneBarPerBinAndMarksTheMedian) {
  const std::string svg = histogram_svg(make_histogram({0.05, 0.25}, 0.1, 3), 0.15);
  size_t bars = 0;
  for (size_t at = svg.find("<rect"); at != std::string::npos; at = svg.find("<rect", at + 1)) {
    ++bars;
  }
  EXPECT_EQ(bars, 3u);
  EXPECT_THAT(svg, HasSubstr("median 0.15 m"));
  EXPECT_THAT(histogram_svg(make_histogram({}, 0.1, 3), NAN), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace gable
