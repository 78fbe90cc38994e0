#include "core/skin/profile_curves.h"

#include <numbers>

#include "core/skin/scatter_profile.h"

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

// A channel's share per mm of distance at r, for dipoles that are stretched by `width`.
glm::dvec3 sharePerMm(const DipoleRgb& dipoles, double width, double r) {
  glm::dvec3 share(0);
  for (int c = 0; c < 3 && width > 0; ++c) {
    const Dipole& dipole = dipoles[size_t(c)];
    share[c] =
        2 * kPi * r / (width * width) * diffuseReflectance(dipole, r / width) / totalReflectance(dipole);
  }
  return share;
}

}  // namespace

ProfileCurves makeProfileCurves(const SkinOptions& options) {
  ProfileCurves curves;
  curves.fitted = options.profile != ScatterProfile::adult && options.width > 0;
  const GaussianFit fit = curves.fitted ? fitProfile(options) : GaussianFit{};
  curves.error = fit.error;
  curves.sum = curves.fitted ? scaledByWidth(asSum(fit), options.width) : diffusionOf(options);
  const DipoleRgb dipoles = makeDipoles(mediumOf(options));
  for (int i = 0; i < ProfileCurves::kSteps; ++i) {
    const double part = double(i) / (ProfileCurves::kSteps - 1), r = ProfileCurves::kReach * part * part;
    curves.radius.push_back(r);
    curves.fit.push_back(2 * kPi * r * profileAt(curves.sum, r));
    curves.target.push_back(curves.fitted ? sharePerMm(dipoles, options.width, r) : curves.fit.back());
  }
  return curves;
}

}  // namespace sonoskin
