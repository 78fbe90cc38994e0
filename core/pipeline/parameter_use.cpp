#include "core/pipeline/parameter_use.h"

#include <algorithm>
#include <array>

#include "core/rbf/global/global_basis.h"

namespace sonoskin {
namespace {

template <std::size_t n>
bool isOneOf(const std::array<std::string_view, n>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// What the thesis' equations have no place for.
constexpr std::array<std::string_view, 6> kOursAlone{
    "gradientSource", "gradientReference", "tangentialLength", "noiseFloor", "farthest", "directionScale"};

std::string_view classificationUse(const ClassificationOptions& o, std::string_view field) {
  const bool closed = o.formulation == Formulation::thesisClosed,
             skew = o.formulation == Formulation::thesisSkew;
  if (field == "isoShare" && o.isoValue > 0) return "The iso-value is given";
  if (!closed && !skew) {
    if (field == "curl" || field == "rescale") return "Only the thesis' formulations have it";
    if (field == "tangentialLength" && o.beta == 0) return "Beta is 0: nothing is smoothed along the surface";
    if ((field == "beta" || field == "directionScale") && o.tangentialLength == 0)
      return "The tangential length is 0: nothing is smoothed along the surface";
    return {};
  }
  if (isOneOf(kOursAlone, field)) return "The thesis' equations do not have it";
  if (closed && field == "beta")
    return "The curl of a gradient is zero: in the thesis' equation beta has no effect";
  if (closed && field == "curl") return "The closed form has no curl";
  if (closed && field == "tolerance") return "The closed form is exact: nothing is repeated";
  if (skew && field == "curl" && o.beta == 0) return "Beta is 0";
  return {};
}

std::string_view enhancementUse(const EnhancementOptions& o, std::string_view field) {
  if (o.method == EnhancementMethod::none && field != "method") return "The volume is taken as it is";
  return {};
}

std::string_view surfaceUse(const SurfaceOptions& o, std::string_view field) {
  if (field == "skinDepth" && !o.offsetCorrection) return "The points stay where they were found";
  if (field == "sides" && o.thinning == ThinningMethod::thesis)
    return "The thesis' thinning follows no sides";
  if (field == "sides" && o.facing <= -0.7) return "All sides are kept already";
  if (o.clusters == ClusterRule::largest &&
      (field == "strongThreshold" || field == "strongShare" || field == "lobeStrength"))
    return "Only the largest piece is kept, however strong it is";
  return {};
}

std::string_view reconstructionUse(const Parameters& p, std::string_view field) {
  const ReconstructionOptions& o = p.reconstruction;
  if (field == "measuredNoise" && !p.surface.offsetCorrection)
    return "The noise is measured as points are moved";
  if (o.method == ReconstructionMethod::global)
    return field == "method" ? "" : "The global function has parameters of its own";
  if (o.method == ReconstructionMethod::thesis &&
      (field == "neighbours" || field == "maxSupport" || field == "confidence" || field == "measuredNoise"))
    return "The thesis has it fixed: 20 neighbours, supports of up to 0.07 of the longest axis, all points "
           "alike";
  if (field == "regularisation" && !o.fitWeights) return "No weights are fitted";
  return {};
}

bool isGlobal(const Parameters& p) { return p.reconstruction.method == ReconstructionMethod::global; }

std::string_view globalUse(const Parameters& p, std::string_view field) {
  if (!isGlobal(p)) return "Only used if the reconstruction's method is global";
  if (field == "width" && !hasWidth(p.global.basis)) return "This basis has no width";
  return {};
}

std::string_view meshUse(const Parameters& p, std::string_view field) {
  if (field == "support" && isGlobal(p)) return "The global function is defined everywhere";
  if (field == "resolution" && p.mesh.cell > 0) return "The size of a cell is given in mm";
  if (field == "companions" && p.mesh.piece != PieceChoice::probe)
    return "Only used beside the piece in the probe's view";
  if (!cutsParts(p.mesh) && (field == "partsAdd" || field == "partsDrop" || field == "partsCut"))
    return "Whole pieces are chosen";
  if (field == "pieceIndex" && p.mesh.piece != PieceChoice::index)
    return "Only used if the piece is chosen by its index";
  if (field == "piecePoint" && p.mesh.piece != PieceChoice::point)
    return "Only used if the piece is chosen by a point";
  return {};
}

std::string_view skinUse(const Parameters& p, std::string_view field) {
  const SkinOptions& o = p.skin;
  constexpr std::array<std::string_view, 6> kPigments{"melanin",   "blood", "oxygen",
                                                      "epidermis", "flush", "mottling"};
  if (o.colour != SkinColour::pigments && isOneOf(kPigments, field))
    return "Only used if the colour comes from pigments";
  if (o.profile != ScatterProfile::custom &&
      (field == "absorption" || field == "scattering" || field == "gaussians"))
    return "Only used if the profile is custom";
  if (o.width == 0 && field == "mix") return "The width is 0: light does not enter the skin";
  if (o.gloss == 0 && field == "roughness") return "The gloss is 0: the surface reflects nothing";
  if (o.translucency == 0 && (field == "thinModel" || field == "density"))
    return "The translucency is 0: no light comes through";
  if (p.light.kind != LightKind::inside && field == "density")
    return "Only used if the light is inside the body";
  return {};
}

std::string_view lightUse(const LightOptions& o, std::string_view field) {
  if (o.kind == LightKind::far && field == "distance") return "A far light has no distance";
  if (o.kind == LightKind::inside && o.distance == 0 && (field == "azimuth" || field == "elevation"))
    return "The distance is 0: the light is in the middle";
  if (o.strength == 0 && field == "warmth") return "The strength is 0: the light is off";
  if (!o.shadows && field == "softness") return "The lights cast no shadows";
  return {};
}

// Eyes and nose redden or blue the skin, lips are wet besides.
std::string_view landmarkUse(const Parameters& p, std::string_view field) {
  const LandmarkOptions& o = p.landmarks;
  const bool mouth = field == "mouthRight" || field == "mouthLeft";
  const bool painted = p.skin.colour == SkinColour::pigments && p.skin.flush > 0;
  if (!painted && !(mouth && p.skin.wetness > 0))
    return "Only used if the skin's colour comes from pigments and has some flush";
  const bool eyes = isSet(o.rightEye) && isSet(o.leftEye);
  if (field == "rightEye" && isSet(o.rightEye) && !eyes) return "The lids need the left eye too";
  if (field == "leftEye" && isSet(o.leftEye) && !eyes) return "The lids need the right eye too";
  if (field == "noseTip" && isSet(o.noseTip) && !eyes) return "The nose needs both eyes too";
  const bool right = isSet(o.mouthRight), left = isSet(o.mouthLeft);
  if (field == "mouthRight" && right && !left) return "The lips need the left corner of the mouth too";
  if (field == "mouthLeft" && left && !right) return "The lips need the right corner of the mouth too";
  return {};
}

std::string_view rawUse(const RawOptions& o, std::string_view field) {
  if (!isTold(o) && field != "dims") return "Only used for files without a header: tell the dimensions first";
  const bool ofSector = field == "firstRadius" || field == "axisDepth" || field == "fanAngle";
  if (ofSector && o.grid != RawGrid::sector) return "Only used if the grid is a sector";
  if (field == "sweepAngle" && o.grid == RawGrid::cartesian) return "Voxels have no beams";
  if (field == "aperture" && o.grid != RawGrid::pyramid) return "Only used if the grid is a pyramid";
  return {};
}

}  // namespace

std::string_view unusedBecause(const Parameters& parameters, std::string_view group, std::string_view field) {
  if (group == "enhancement") return enhancementUse(parameters.enhancement, field);
  if (group == "classification") return classificationUse(parameters.classification, field);
  if (group == "scan" && field == "apex" && parameters.scan.beamOrigin != BeamOrigin::given)
    return "Only used if the beams' origin is given";
  if (group == "raw") return rawUse(parameters.raw, field);
  if (group == "reconstruction") return reconstructionUse(parameters, field);
  if (group == "print" && field != "form" && parameters.print.form == PrintForm::none)
    return "Choose a form first: shell or block";
  if (group == "surface") return surfaceUse(parameters.surface, field);
  if (group == "global") return globalUse(parameters, field);
  if (group == "mesh") return meshUse(parameters, field);
  if (group == "skin") return skinUse(parameters, field);
  if (group == "light") return lightUse(parameters.light, field);
  if (group == "landmarks") return landmarkUse(parameters, field);
  return {};
}

}  // namespace sonoskin
