#include "app/parameters_key.h"

#include "core/pipeline/parameter_key.h"

namespace sonoskin {

Key parametersKey(const Parameters& parameters) {
  Hasher hasher("parameters");
  groups([&](const Group&, const auto& options) { addOptions(hasher, options); }, parameters);
  return hasher.key();
}

Key classifiedKey(const Parameters& parameters) {
  Hasher hasher("classified");
  addOptions(hasher, parameters.scan);
  addOptions(hasher, parameters.enhancement);
  addOptions(hasher, parameters.classification);
  return hasher.key();
}

Key pointsKey(const Parameters& parameters) {
  Hasher hasher("points");
  hasher.add(classifiedKey(parameters));
  addOptions(hasher, parameters.region);
  addOptions(hasher, parameters.surface);
  return hasher.key();
}

Key meshKey(const Parameters& parameters) {
  Hasher hasher("mesh");
  hasher.add(pointsKey(parameters));
  addOptions(hasher, parameters.reconstruction);
  addOptions(hasher, parameters.mesh);
  return hasher.key();
}

}  // namespace sonoskin
