#include "app/input/study/units.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/text/config_error.hpp"
#include "app/version.hpp"
#include "dem/solver/solver_lanes.hpp"
#include "dem/solver/solver_revision.hpp"
#include "python/src/bind.hpp"

namespace bindings {

void bind_errors(pybind11::module_& m)
{
    static pybind11::exception<app::ConfigError> input(m, "ConfigError", PyExc_ValueError);
    static pybind11::exception<app::StoreError> store(m, "StoreError", PyExc_OSError);
    for (const pybind11::object& type : {pybind11::object(input), pybind11::object(store)})
        type.attr("__module__") = "drystone";
    input.doc() = "Bad input: FILE:LINE: KEY: what is wrong and what to write.";
    store.doc() = "The file of a study is missing, damaged or in use.";
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const app::ConfigError& bad) {
            input(bad.what());
        } catch (const app::BadValue& bad) {
            input(bad.what());
        } catch (const app::StoreError& bad) {
            store(bad.what());
        }
    });
}

} // namespace bindings

PYBIND11_MODULE(_core, m)
{
    m.attr("__version__") = app::kVersion;
    m.attr("__solver_revision__") = dem::kSolverRevision;
    m.def("lanes", &dem::solver_lanes, "Walls in one register of this build.");
    bindings::bind_errors(m);
    bindings::bind_wall(m);
    bindings::bind_study(m);
    bindings::bind_results(m);
    bindings::bind_fragility(m);
    bindings::bind_sampling(m);
    bindings::bind_shaking(m);
    bindings::bind_surrogate(m);
}
