// 3MF core specification 1.3 (github.com/3MFConsortium/spec_core).
#include <fmt/format.h>

#include <iterator>
#include <string>

#include "core/base/version.h"
#include "core/io/mesh_encoders.h"
#include "core/io/zip_writer.h"
#include "core/mesh/mesh_check.h"

namespace sonoskin {
namespace {

constexpr const char* kTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

std::string model(const Mesh& mesh) {
  std::string xml;
  const auto out = std::back_inserter(xml);
  fmt::format_to(out,
                 "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<model unit=\"millimeter\" xml:lang=\"en-US\" "
                 "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                 "<metadata name=\"Application\">Sonoskin {}</metadata>\n"
                 "<resources><object id=\"1\" type=\"{}\"><mesh>\n<vertices>\n",
                 kVersion, checkMesh(mesh).closed() ? "model" : "surface");
  for (const glm::vec3& p : mesh.positions)
    fmt::format_to(out, "<vertex x=\"{:.9g}\" y=\"{:.9g}\" z=\"{:.9g}\"/>\n", p.x, p.y, p.z);
  xml += "</vertices>\n<triangles>\n";
  for (const auto& [a, b, c] : mesh.triangles)
    if (a != b && b != c && c != a)
      fmt::format_to(out, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  xml += "</triangles>\n</mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";
  return xml;
}

}  // namespace

Bytes encode3mf(const Mesh& mesh) {
  return zipFiles(
      {{"[Content_Types].xml", kTypes}, {"_rels/.rels", kRelations}, {"3D/3dmodel.model", model(mesh)}});
}

}  // namespace sonoskin
