# Writes OUTPUT, a C++ file that holds the texts of all licences, Sonoskin's own in OWN (run with cmake -P at build time).
include(${CMAKE_CURRENT_LIST_DIR}/licences.cmake)
file(READ ${OWN} text)
set(entries "    {\"Sonoskin\", \"MIT\", R\"~text~(${text})~text~\"},\n")
foreach(entry ${sonoskin_licences})
  string(REGEX MATCH "^([^|]*)\\|([^|]*)\\|([^|]*)\\|" fits "${entry}")
  set(start "{\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_2}\"")
  set(file /usr/share/doc/${CMAKE_MATCH_3}/copyright)
  if(EXISTS ${file})
    file(READ ${file} text)
  else()  # another system than Debian, or one without documentation
    message(WARNING "The text of a licence is missing, ${file}: it comes with ${CMAKE_MATCH_3}")
    set(text "The text was not there where this program was built; Debian's package ${CMAKE_MATCH_3} has it.")
  endif()
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
