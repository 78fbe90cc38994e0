# Writes OUTPUT, a C++ file that holds every file of the folder FOLDER (run with cmake -P at build time).
file(GLOB_RECURSE shaders RELATIVE ${FOLDER} ${FOLDER}/*.vert ${FOLDER}/*.frag ${FOLDER}/*.glsl)
list(SORT shaders)
set(entries "")
foreach(name ${shaders})
  file(READ ${FOLDER}/${name} text)
  string(APPEND entries "    {\"${name}\", R\"~glsl~(${text})~glsl~\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/gl/shader_source.h\"

namespace sonoskin::gl {
namespace {

constexpr EmbeddedShader shaders[] = {
${entries}};

}  // namespace

std::span<const EmbeddedShader> embeddedShaders() { return shaders; }

}  // namespace sonoskin::gl
")
