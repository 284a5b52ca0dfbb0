#pragma once
/// The parts of the module drystone._core.

#include <pybind11/pybind11.h>

namespace bindings {

void bind_errors(pybind11::module_& m);
void bind_wall(pybind11::module_& m);
void bind_study(pybind11::module_& m);
void bind_results(pybind11::module_& m);
void bind_fragility(pybind11::module_& m);
void bind_sampling(pybind11::module_& m);
void bind_shaking(pybind11::module_& m);
void bind_surrogate(pybind11::module_& m);

} // namespace bindings
