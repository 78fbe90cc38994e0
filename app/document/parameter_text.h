#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/pipeline/parameters.h"

namespace sonoskin {

// ParameterInfo: one parameter as people read it on the command line and in the documentation.
struct ParameterInfo {
  std::string name;   // "classification.alpha"
  std::string group;  // "classification: finding surfaces in the noise"
  std::string help, unit, symbol;
  std::string kind;  // what a value looks like: "NUMBER", "INTEGER", "on|off", "NxNxN", "X,Y,Z", or the names
  std::string range;  // "0.01 .. 4"; empty for names and switches
  std::string value;  // as setParameter reads it
};

// describeParameters: every parameter, in the order of the pipeline, with its value.
std::vector<ParameterInfo> describeParameters(const Parameters& parameters);

// findParameter: the parameter that a word means: "classification.beta", or "beta" or "v_iso" where one alone has that name or
// symbol.
//   errors  Error (usage): none has it, or several
ParameterInfo findParameter(const Parameters& parameters, std::string_view word);

// setParameter: sets "group.field" from text: 12, 0.7, on, probe, 467x255x124, 1.5,-2,30.
//   errors  Error (usage): an unknown name, text of the wrong kind, or a number out of range; the sentence names it
void setParameter(Parameters& parameters, std::string_view name, std::string_view text);

}  // namespace sonoskin
