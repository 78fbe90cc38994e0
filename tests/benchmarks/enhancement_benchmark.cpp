// Speckle reduction before the classification: one step of ours beside one step of each of ITK's diffusions.
#include <benchmark/benchmark.h>
#include <itkCurvatureAnisotropicDiffusionImageFilter.h>
#include <itkGradientAnisotropicDiffusionImageFilter.h>
#include <itkImage.h>

#include "core/base/parallel.h"
#include "core/enhancement/diffusion.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {
namespace {

void diffusion(benchmark::State& state) {
  EnhancementOptions options;
  options.iterations = int(state.range(0));
  phantomInput();  // made before the clock starts
  for (auto _ : state) benchmark::DoNotOptimize(diffuse(*phantomInput().volume, options));
}
BENCHMARK(diffusion)
    ->ArgName("steps")
    ->Arg(1)
    ->Arg(3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

using Image = itk::Image<float, 3>;

Image::Pointer phantomImage() {
  const Volume<float>& volume = *phantomInput().volume;
  const Image::Pointer image = Image::New();
  Image::RegionType region;
  Image::SpacingType spacing;
  for (int axis = 0; axis < 3; ++axis) {
    region.SetSize(unsigned(axis), itk::SizeValueType(volume.geometry.dims[axis]));
    spacing[unsigned(axis)] = volume.geometry.spacing[axis] / volume.geometry.minSpacing();
  }
  image->SetRegions(region);
  image->SetSpacing(spacing);
  image->Allocate();
  std::copy(volume.data.begin(), volume.data.end(), image->GetBufferPointer());
  return image;
}

// One step; ITK's longest stable one is a quarter of ours.
template <class Filter>
void itkDiffusion(benchmark::State& state) {
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(unsigned(threadCount()));
  const Image::Pointer image = phantomImage();
  for (auto _ : state) {
    const auto filter = Filter::New();
    filter->SetInput(image);
    filter->SetNumberOfIterations(1);
    filter->SetTimeStep(0.0625);
    filter->Update();
    benchmark::DoNotOptimize(filter->GetOutput()->GetBufferPointer());
  }
}
BENCHMARK_TEMPLATE(itkDiffusion, itk::GradientAnisotropicDiffusionImageFilter<Image, Image>)
    ->Name("itkGradientDiffusion")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_TEMPLATE(itkDiffusion, itk::CurvatureAnisotropicDiffusionImageFilter<Image, Image>)
    ->Name("itkCurvatureDiffusion")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sonoskin
