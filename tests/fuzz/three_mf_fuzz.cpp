// 3MF files; an input that is no ZIP file is taken for the model in one, for checksums would keep most changes out.
#include "core/io/mesh_loader.h"
#include "tests/fuzz/mesh_claims.h"
#include "tests/support/zip.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.3mf");
  std::string bytes(fuzz::textOf({data, size}));
  if (!bytes.starts_with("PK")) bytes = test::zipOf({{"3D/3dmodel.model", bytes}});
  const fuzz::Bytes whole(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  fuzz::attempt([&] { fuzz::claimSound(parseMesh(file.hold(whole))); });
  return 0;
}
