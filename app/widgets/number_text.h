#pragma once

#include <cstddef>
#include <string>

namespace sonoskin::ui {

// grouped: 1234567 as "1,234,567", or as the language in use has it.
std::string grouped(std::size_t number);
// millimetres: without needless digits: "0.52", "12.3".
std::string millimetres(double value);

}  // namespace sonoskin::ui
