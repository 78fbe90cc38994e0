#include "core/classification/thesis_system.h"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/skew_system.h"
#include "tests/support/test_volumes.h"
#include "tests/support/thesis_matrix.h"

namespace sonoskin {
namespace {

using test::grid;

// The settings of the thesis' baby 2.
ClassificationOptions thesisOptions(Formulation formulation) {
  ClassificationOptions o;
  o.formulation = formulation;
  o.alpha = 0.9;
  o.beta = 0.2;
  o.gamma = 0.4;
  o.isoValue = 0.3;
  o.rawShare = 0.5;
  o.gradientFloor = 0.5;
  o.target = 0.9;
  o.rescale = false;
  return o;
}

Volume<float> testVolume() {
  return test::speckledSphere(grid({12, 13, 11}, {0.3, 0.3, 0.9}), {1.8, 1.9, 5}, 1.4, 0.3);
}

Eigen::VectorXd directSolution(const Volume<float>& v, const ClassificationOptions& o) {
  const auto system = test::thesisMatrix<double>(v, o);
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> direct(system.a);
  return direct.solve(system.b);
}

double largestDifference(const Volume<float>& u, const Eigen::VectorXd& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < u.data.size(); ++i)
    worst = std::max(worst, std::abs(double(u.data[i]) - expected[Eigen::Index(i)]));
  return worst;
}

TEST(ThesisSystem, ClosedFormIsTheFormula) {
  const Volume<float> v = testVolume();
  const ClassificationOptions o = thesisOptions(Formulation::thesisClosed);
  const auto system = test::thesisMatrix<double>(v, o);
  const Volume<float> u = classifyThesis(v, o);
  for (std::size_t i = 0; i < u.data.size(); ++i)
    ASSERT_NEAR(u.data[i], system.b[Eigen::Index(i)] / system.a.coeff(Eigen::Index(i), Eigen::Index(i)), 1e-6)
        << i;
}

// The thesis' own system, with the same differences in gradient and curl, is solved by the closed form.
TEST(ThesisSystem, ClosedFormSolvesTheAssembledSystemWithCentralCurl) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisClosed);
  o.curl = CurlDifferences::central;
  EXPECT_LT(largestDifference(classifyThesis(v, o), directSolution(v, o)), 1e-6);
}

TEST(ThesisSystem, SkewWithCentralCurlIsTheClosedForm) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  o.curl = CurlDifferences::central;
  const Volume<float> skew = classifyThesis(v, o);
  o.formulation = Formulation::thesisClosed;
  const Volume<float> closed = classifyThesis(v, o);
  for (std::size_t i = 0; i < skew.data.size(); ++i) ASSERT_NEAR(skew.data[i], closed.data[i], 1e-6);
  EXPECT_LT(solveSkewSystem(v, o).dominance, 1e-4);  // rounding alone
}

TEST(ThesisSystem, SkewEqualsADirectSolve) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  o.tolerance = 1e-6;
  o.beta = 1;
  const SkewSolution solution = solveSkewSystem(v, o);
  EXPECT_GT(solution.dominance, 0.02);
  EXPECT_GT(solution.sweeps, 2);
  EXPECT_LT(solution.residual, 1e-6);
  EXPECT_LT(largestDifference(solution.u, directSolution(v, o)), 1e-5);
}

// Otherwise the test above would say nothing about beta.
TEST(ThesisSystem, ForwardCurlMovesTheSolution) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  o.beta = 1;
  const Eigen::VectorXd forward = directSolution(v, o);
  o.curl = CurlDifferences::central;
  EXPECT_GT((forward - directSolution(v, o)).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(ThesisSystem, DominanceIsThatOfTheAssembledMatrix) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  const auto system = test::thesisMatrix<double>(v, o);
  double worst = 0;
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = system.a;
  for (Eigen::Index row = 0; row < rows.outerSize(); ++row) {
    double off = -std::abs(rows.coeff(row, row));
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(rows, row); it; ++it)
      off += std::abs(it.value());
    worst = std::max(worst, off / rows.coeff(row, row));
  }
  EXPECT_NEAR(solveSkewSystem(v, o).dominance, worst, 1e-4 * worst);
}

TEST(ThesisSystem, RefusesWhatSweepsCannotSolveAndSaysWhichBetaWouldDo) {
  std::uint64_t n = 0;
  const auto v = test::fill(grid({12, 12, 12}), [&](glm::dvec3) { return test::noise(n++); });
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  o.beta = 4;
  o.alpha = 0.01;
  o.gamma = 0.01;
  try {
    classifyThesis(v, o);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    const auto at = sentence.find("classification.beta below ");
    ASSERT_NE(at, std::string::npos) << sentence;
    o.beta = 0.95 * std::stod(sentence.substr(at + 26));
  }
  EXPECT_NO_THROW(classifyThesis(v, o));
}

TEST(ThesisSystem, RescaleReachesZeroAndOne) {
  const Volume<float> v = testVolume();
  for (const Formulation f : {Formulation::thesisClosed, Formulation::thesisSkew}) {
    ClassificationOptions o = thesisOptions(f);
    const Volume<float> plain = f == Formulation::thesisSkew ? solveSkewSystem(v, o).u : classifyThesis(v, o);
    const auto [least, greatest] = std::minmax_element(plain.data.begin(), plain.data.end());
    o.rescale = true;
    const Volume<float> u = classifyThesis(v, o);
    EXPECT_EQ(*std::min_element(u.data.begin(), u.data.end()), 0);
    EXPECT_NEAR(*std::max_element(u.data.begin(), u.data.end()), 1, 1e-6);
    for (std::size_t i = 0; i < u.data.size(); ++i)
      ASSERT_NEAR(u.data[i], (plain.data[i] - *least) / (*greatest - *least), 1e-6);
  }
}

// 0/0 where the volume is flat, equal to the iso-value, and delta is zero: the thesis sets it to 0.
TEST(ThesisSystem, NothingDividedByNothingIsZero) {
  const Volume<float> flat(grid({5, 5, 5}), 0.25f);
  for (const Formulation f : {Formulation::thesisClosed, Formulation::thesisSkew}) {
    ClassificationOptions o = thesisOptions(f);
    o.gradientFloor = 0;
    o.isoValue = 0.25;
    o.rescale = true;
    for (const float u : classifyThesis(flat, o).data) ASSERT_EQ(u, 0);
  }
}

TEST(ThesisSystem, IgnoresTheSpacing) {
  Volume<float> v = testVolume();
  const ClassificationOptions o = thesisOptions(Formulation::thesisClosed);
  const Volume<float> u = classifyThesis(v, o);
  v.geometry.spacing = {3, 1, 2};
  EXPECT_EQ(classifyThesis(v, o).data, u.data);
}

TEST(ThesisSystem, SameBitsOnAnyNumberOfThreads) {
  const Volume<float> v = testVolume();
  for (const Formulation f : {Formulation::thesisClosed, Formulation::thesisSkew}) {
    ClassificationOptions o = thesisOptions(f);
    o.beta = 1;
    o.rescale = true;
    setThreadCount(1);
    const Volume<float> one = classifyThesis(v, o);
    setThreadCount(3);
    const Volume<float> three = classifyThesis(v, o);
    setThreadCount(0);
    EXPECT_EQ(one.data, three.data);
  }
}

TEST(ThesisSystem, StopsWhenCancelled) {
  const Volume<float> v = testVolume();
  for (const Formulation f : {Formulation::thesisClosed, Formulation::thesisSkew}) {
    ProgressSink sink;
    sink.cancel = true;
    EXPECT_THROW(classifyThesis(v, thesisOptions(f), Progress(sink)), Cancelled);
  }
}

TEST(ThesisSystem, ProgressRisesToOneAndACancelEndsTheSweeps) {
  const Volume<float> v = testVolume();
  ClassificationOptions o = thesisOptions(Formulation::thesisSkew);
  o.tolerance = 1e-7;
  o.beta = 4;
  for (const bool cancel : {false, true}) {
    ProgressSink sink;
    std::vector<double> seen{0};
    sink.report = [&](double fraction) {
      EXPECT_GE(fraction, seen.back() - 1e-12);
      seen.push_back(fraction);
      sink.cancel = cancel && fraction > 0.5;
    };
    if (cancel) {
      EXPECT_THROW(classifyThesis(v, o, Progress(sink)), Cancelled);
      EXPECT_LT(seen.back(), 0.9);
    } else {
      classifyThesis(v, o, Progress(sink));
      EXPECT_NEAR(seen.back(), 1, 1e-12);
      EXPECT_GT(std::count_if(seen.begin(), seen.end(), [](double x) { return x > 0.45 && x < 0.85; }), 1);
    }
  }
}

TEST(ThesisSystem, RefusesAFlatVolume) {
  EXPECT_THROW(classifyThesis(Volume<float>(grid({20, 20, 2})), thesisOptions(Formulation::thesisClosed)),
               Error);
}

}  // namespace
}  // namespace sonoskin
