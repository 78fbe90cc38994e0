#include "core/classification/live_classifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

class LiveClassifierTest : public ::testing::Test {
 protected:
  LiveClassifierTest() { options_.isoValue = 0.35; }
  // The largest difference to the converged answer.
  double worst(const Volume<float>& u) const {
    ClassificationOptions exact = options_;
    exact.tolerance = 1e-6;
    const auto converged = classify(*volume_, *smoothed_, exact);
    double most = 0;
    for (std::size_t v = 0; v < u.data.size(); ++v)
      most = std::max(most, std::abs(double(u.data[v]) - double(converged.data[v])));
    return most;
  }

  std::shared_ptr<const Volume<float>> volume_ = std::make_shared<const Volume<float>>(
      test::speckledSphere(test::grid({120, 40, 30}, {0.3, 0.3, 0.9}), {18, 6, 13}, 4, 0.3));
  ClassificationOptions options_;
  std::shared_ptr<const Smoothed> smoothed_ =
      std::make_shared<const Smoothed>(smooth(*volume_, ClassificationOptions{}));
  LiveClassifier live_{volume_, smoothed_};
};

// A session with a slider: every answer is good, whatever came before.
TEST_F(LiveClassifierTest, StaysWithinTwoHundredths) {
  EXPECT_LT(worst(*live_.classify(options_)), 0.02);
  for (const double iso : {0.36, 0.40, 0.30}) {
    options_.isoValue = iso;
    EXPECT_LT(worst(*live_.classify(options_)), 0.02) << iso;
  }
  options_.gamma = 2;
  EXPECT_LT(worst(*live_.classify(options_)), 0.02);
  options_.tangentialLength = 6;
  EXPECT_LT(worst(*live_.classify(options_)), 0.02);
  options_.beta = 0;
  EXPECT_LT(worst(*live_.classify(options_)), 0.001);  // the closed form
}

TEST_F(LiveClassifierTest, EarlierAnswersStayAsTheyAre) {
  const auto first = live_.classify(options_);
  const auto copy = *first;
  options_.isoValue = 0.45;
  live_.classify(options_);
  EXPECT_EQ(first->data, copy.data);
}

TEST_F(LiveClassifierTest, IsGoodAfterACancel) {
  live_.classify(options_);
  options_.isoValue = 0.42;
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.1; };
  EXPECT_THROW(live_.classify(options_, Progress(sink)), Cancelled);
  EXPECT_LT(worst(*live_.classify(options_)), 0.02);
}

}  // namespace
}  // namespace sonoskin
