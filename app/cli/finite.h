#pragma once

#include <CLI/App.hpp>

namespace sonoskin {

// finite: a check of an option's number: refuses NaN and what is infinite or beyond all numbers, which CLI::Range lets through.
CLI::Validator finite();

}  // namespace sonoskin
