// Landmarks and every other parameter as text, one "group.field=value" per line: what is taken reads back the same.
#include "app/document/parameter_text.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

namespace {

void setLine(Parameters& parameters, std::string_view line) {
  const std::size_t cut = std::min(line.find('='), line.size());
  fuzz::attempt(
      [&] { setParameter(parameters, line.substr(0, cut), line.substr(std::min(cut + 1, line.size()))); });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Parameters first;
  std::string_view text = fuzz::textOf({data, size});
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    setLine(first, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  Parameters second;
  for (const ParameterInfo& info : describeParameters(first))
    if (info.name.starts_with("landmarks.")) setParameter(second, info.name, info.value);
  fuzz::claim(second.landmarks == first.landmarks, "landmarks read back the same");
  return 0;
}
