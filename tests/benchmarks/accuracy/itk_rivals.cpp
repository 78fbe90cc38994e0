#include <itkCannyEdgeDetectionImageFilter.h>
#include <itkCurvatureAnisotropicDiffusionImageFilter.h>
#include <itkImage.h>
#include <itkMultiThreaderBase.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/pipeline/pipeline.h"
#include "core/volume/gaussian.h"
#include "core/volume/sample.h"
#include "tests/benchmarks/accuracy/methods.h"
#include "tests/benchmarks/accuracy/rival_support.h"

namespace sonoskin::accuracy {
namespace {

using Image = itk::Image<float, 3>;

Image::Pointer toItk(const Volume<float>& volume) {
  const Geometry& g = volume.geometry;
  Image::RegionType region;
  Image::SpacingType spacing;
  for (int axis = 0; axis < 3; ++axis) {
    region.SetSize(unsigned(axis), itk::SizeValueType(g.dims[axis]));
    spacing[unsigned(axis)] = g.spacing[axis] / g.minSpacing();  // gradients per smallest spacing
  }
  Image::Pointer image = Image::New();
  image->SetRegions(region);
  image->SetSpacing(spacing);
  image->Allocate();
  std::copy(volume.data.begin(), volume.data.end(), image->GetBufferPointer());
  return image;
}

Volume<float> fromItk(const Image& image, const Geometry& geometry) {
  Volume<float> volume(geometry);
  std::copy_n(image.GetBufferPointer(), volume.data.size(), volume.data.begin());
  return volume;
}

Image::Pointer diffuse(Image* image) {
  const auto filter = itk::CurvatureAnisotropicDiffusionImageFilter<Image, Image>::New();
  filter->SetInput(image);
  filter->SetNumberOfIterations(5);
  filter->SetTimeStep(0.0625);  // the largest stable one
  filter->SetConductanceParameter(3);
  filter->Update();
  return filter->GetOutput();
}

Image::Pointer canny(Image* image, double lower, double upper) {
  const auto filter = itk::CannyEdgeDetectionImageFilter<Image, Image>::New();
  filter->SetInput(image);
  filter->SetVariance(0);
  filter->SetLowerThreshold(float(lower));
  filter->SetUpperThreshold(float(upper));
  filter->Update();
  return filter->GetOutput();
}

// ITK's marks lie on voxels; a parabola through the gradient's magnitude brings them to a fraction of one, as
// everybody else's points.
glm::vec3 refine(const Volume<float>& magnitude, const glm::ivec3& voxel, glm::vec3 step) {
  step /= std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z), 1e-12f});
  const glm::vec3 here(voxel);
  const float before = sampleTrilinear(magnitude, here - step),
              after = sampleTrilinear(magnitude, here + step);
  const float curvature = before - 2 * magnitude.at(voxel.x, voxel.y, voxel.z) + after;
  return curvature < -1e-6f ? here + step * std::clamp(0.5f * (before - after) / curvature, -0.5f, 0.5f)
                            : here;
}

Finding diffusionAndCanny(const Scan& scan, const Parameters& parameters) {
  const Geometry& g = scan.volume->geometry;
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(unsigned(threadCount()));
  const Image::Pointer diffused = diffuse(toItk(*scan.volume));
  const Volume<float> edges = fromItk(*canny(diffused, 0.08, 0.16), g);
  const Volume<float> low = gaussianBlur(fromItk(*diffused, g), 1), magnitude = gradientMagnitude(low);
  const SurfaceOptions options = rivalOptions(parameters, g, 0);
  const ScanFrame frame = frameOf(scan, parameters);
  const glm::vec3 axisScale = g.axisScale();
  std::vector<SurfaceVoxel> voxels;
  for (int k = 1; k < g.dims.z - 1; ++k)
    for (int j = 1; j < g.dims.y - 1; ++j)
      for (int i = 1; i < g.dims.x - 1; ++i) {
        if (edges.at(i, j, k) <= 0) continue;
        const glm::ivec3 voxel(i, j, k);
        const glm::vec3 gradient = gradientAt(low, axisScale, g.index(i, j, k));
        if (!accepts(frame, options, g, voxel, gradient)) continue;
        voxels.push_back({voxel, refine(magnitude, voxel, gradient * axisScale), 1.0f});
      }
  return {finishRival(voxels, low, options)};
}

// What ITK's diffusion buys before our chain; the sector's zeros stay, as the chain finds the sector by them.
Finding diffusionBeforeOurs(const Scan& scan, const Parameters& parameters) {
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(unsigned(threadCount()));
  Volume<float> volume = fromItk(*diffuse(toItk(*scan.volume)), scan.volume->geometry);
  for (std::size_t v = 0; v < volume.data.size(); ++v)
    if (scan.volume->data[v] == 0) volume.data[v] = 0;
  Scan enhanced = scan;
  enhanced.volume = std::make_shared<const Volume<float>>(std::move(volume));
  Pipeline pipeline;
  const Results results = pipeline.run(enhanced, parameters, Goal::points);
  return {*results.points, results.isoValue};
}

}  // namespace

std::vector<Method> itkRivals() {
  return {{"itkenhanced", "our chain after ITK's curvature diffusion (5 steps)", diffusionBeforeOurs},
          {"itk", "ITK: curvature diffusion (5 steps), Canny (0.08, 0.16)", diffusionAndCanny}};
}

}  // namespace sonoskin::accuracy
