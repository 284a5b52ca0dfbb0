#pragma once
/// Notes on what a table of tests holds and a calibration does not use.

#include "app/text/csv.hpp"

#include <string>

namespace app {

/// Lines "note: tests.csv:1: ...": columns that no test has, as misspelt ones are; columns that
/// only inputs learn from, where none is taught; and rows that repeat an earlier row, which
/// count as tests of their own.
/// @param height of the load [m], > 0  @param taught whether the study has calibration.inputs
[[nodiscard]] std::string test_notes(const Csv& csv, double height, bool taught);

} // namespace app
