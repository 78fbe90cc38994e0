#include "core/pipeline/scan_stages.h"

#include "core/enhancement/diffusion.h"
#include "core/surface/find_surface.h"
#include "core/surface/first_hit.h"
#include "core/volume/resample.h"

namespace sonoskin {

Keyed<Volume<float>> enhanceScan(const StageContext& c) {
  const EnhancementOptions& options = c.parameters.enhancement;
  const Key key = enhancedKey(c.scan.key, options);
  if (options.method == EnhancementMethod::none) return {c.scan.volume, key};
  return c.run.stage<Volume<float>>(c.shares.enhanced, key,
                                    [&](const Progress& p) { return diffuse(*c.scan.volume, options, p); });
}

Keyed<Volume<float>> halveVolume(const StageContext& c, const Keyed<Volume<float>>& volume) {
  return c.run.stage<Volume<float>>(c.shares.coarser, coarserKey(volume.key),
                                    [&](const Progress& p) { return halveResolution(*volume.value, p); });
}

ClassifierInput prepareVolume(const StageContext& c, const Keyed<Volume<float>>& volume) {
  return {volume, c.run.stage<Prepared>(
                      c.shares.prepared, preparedKey(volume.key, c.parameters),
                      [&](const Progress& p) { return prepare(c.scan, *volume.value, c.parameters, p); })};
}

double isoValueOf(const ClassificationOptions& options, const GreyLevels& levels) {
  return options.isoValue > 0 ? options.isoValue : double(levels.iso(options.isoShare));
}

Keyed<Volume<float>> classifyVolume(const StageContext& c, const ClassifierInput& in, LiveSolver* live) {
  ClassificationOptions options = c.parameters.classification;
  const Smoothed& smoothed = in.prepared.value->smoothed;
  const Key final = classifiedKey(in.prepared.key, options),
            hurried = classifiedKey(in.prepared.key, options, true);
  // The thesis' formulations know one iso-value for the whole volume.
  if (options.formulation != Formulation::variational)
    options.isoValue = isoValueOf(options, smoothed.levels);
  if (live && !c.run.knows<Volume<float>>(final))
    return c.run.stage<Volume<float>>(c.shares.classified, hurried,
                                      [&](const Progress& p) { return live->classify(in, options, p); });
  return c.run.stage<Volume<float>>(c.shares.classified, final, [&](const Progress& p) {
    return classify(*in.volume.value, smoothed, options, p);
  });
}

Keyed<FoundPoints> findPoints(const StageContext& c, const ClassifierInput& in,
                              const Keyed<Volume<float>>& classified) {
  const Key key = pointsKey(classified.key, c.scan.erasedKey, c.parameters);
  return c.run.stage<FoundPoints>(c.shares.points, key, [&](const Progress& p) {
    const Prepared& prepared = *in.prepared.value;
    const SurfaceInput input{*c.scan.volume,
                             *classified.value,
                             prepared.smoothed.lowPassed,
                             {prepared.beam, prepared.view, regionOf(c.scan, c.parameters.region)},
                             isoValueOf(c.parameters.classification, prepared.smoothed.levels)};
    FoundSurface found = findSurface(input, c.parameters.surface, p);
    return FoundPoints{
        std::make_shared<const Volume<std::uint8_t>>(thinnedVolume(found.voxels, classified.value->geometry)),
        std::make_shared<const SurfacePoints>(std::move(found.points)), found.edge};
  });
}

Keyed<ScanEvidence> weighScan(const StageContext& c, const ClassifierInput& in,
                              const Keyed<FoundPoints>& found) {
  const Prepared& from = *in.prepared.value;
  return c.run.stage<ScanEvidence>(c.shares.evidence, evidenceKey(found.key), [&](const Progress& p) {
    return weighEvidence({*c.scan.volume, from.smoothed.lowPassed, from.view, from.beam, from.smoothed.levels,
                          *found.value->points, found.value->edge},
                         p);
  });
}

Keyed<FaceFit> findFace(const StageContext& c, const ClassifierInput& in, const Keyed<FoundPoints>& found,
                        bool hurried) {
  const FaceOptions& options = c.parameters.face;
  const Key key = faceKey(found.key, options);
  if (!options.find || (hurried && !c.run.knows<FaceFit>(key))) return {};
  return c.run.stage<FaceFit>(c.shares.face, key, [&](const Progress& p) {
    const Prepared& from = *in.prepared.value;
    const Volume<float>& lowPassed = from.smoothed.lowPassed;
    const double iso = isoValueOf(c.parameters.classification, from.smoothed.levels);
    const float dark = findFluidLevels(lowPassed, from.view, iso).dark;
    return fitFace({*found.value->points, &lowPassed, dark, from.beam}, options, p);
  });
}

}  // namespace sonoskin
