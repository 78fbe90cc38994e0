#pragma once

#include <cstddef>
#include <vector>

#include "core/face/face_fit.h"
#include "core/pipeline/found_points.h"
#include "core/pipeline/kept_parts.h"
#include "core/pipeline/prepared.h"
#include "core/pipeline/scan_evidence.h"
#include "core/rbf/surface/fitted_surface.h"

namespace sonoskin {

// bytesOf: the memory that a stage's result takes, for the budget of ResultMemory and for reports. A new kind of result
// gets one.
std::size_t bytesOf(const Volume<float>& volume);
std::size_t bytesOf(const Prepared& prepared);
std::size_t bytesOf(const FoundPoints& found);
std::size_t bytesOf(const ScanEvidence& evidence);
std::size_t bytesOf(const FaceFit& face);
std::size_t bytesOf(const FittedSurface& fit);
std::size_t bytesOf(const Mesh& mesh);
std::size_t bytesOf(const std::vector<Mesh>& pieces);
std::size_t bytesOf(const PartedSurface& surface);
std::size_t bytesOf(const KeptParts& kept);

}  // namespace sonoskin
