# Writes OUTPUT, a C++ file that holds the texts of all licences, Sonoskin's own in OWN (run with cmake -P at build time).
include(${CMAKE_CURRENT_LIST_DIR}/licences.cmake)
file(READ ${OWN} text)
set(entries "    {\"Sonoskin\", \"MIT\", R\"~text~(${text})~text~\"},\n")
foreach(entry ${sonoskin_licences})
  string(REGEX MATCH "^([^|]*)\\|([^|]*)\\|([^|]*)\\|" fits "${entry}")
  set(start "{\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_2}\"")
  set(file /usr/share/doc/${CMAKE_MATCH_3}/copyright)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "The text of a licence is missing, ${file}: install ${CMAKE_MATCH_3}")
  endif()
  file(READ ${file} text)
  string(APPEND entries "    ${start}, R\"~text~(${text})~text~\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"app/panels/licences.h\"

namespace sonoskin::ui {
namespace {

constexpr Licence kLicences[] = {
${entries}};

}  // namespace

std::span<const Licence> licences() { return kLicences; }

}  // namespace sonoskin::ui
")
