#pragma once

#include "core/base/hash.h"
#include "core/pipeline/parameter_key.h"
#include "core/pipeline/parameters.h"

// The keys of the pipeline's stages: the name and version of the stage, the key of what goes in, and the options that
// change what comes out. A stage whose code changes its results gets another number.
namespace sonoskin {

template <class Options>
Key keyOf(const char* stage, const Key& input, const Options& options) {
  Hasher hasher(stage);
  hasher.add(input);
  addOptions(hasher, options);
  return hasher.key();
}

Key preparedKey(const Key& input, const Parameters& p);
// Only the options of the chosen method count.
Key fitKeyOf(const Key& points, const Parameters& p);
Key surfaceKeyOf(const Key& fit, const MeshOptions& mesh);
Key partsKeyOf(const Key& surface, const MeshOptions& mesh);
// Of what is chosen from pieces or from parts.
Key pieceKeyOf(const Key& surface, const MeshOptions& mesh);
Key cleanKeyOf(const Key& piece, const MeshOptions& mesh);

}  // namespace sonoskin
