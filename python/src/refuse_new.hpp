#pragma once
/// Classes of the module whose objects the module alone makes.

#include <pybind11/pybind11.h>

namespace bindings {

/// Python cannot make an object of this class, not even by __new__ alone: such an object would
/// be memory in which nothing was ever put, and the first call of a method would end the
/// process. Copies of an object are the object, which never changes.
template <class Class> void make_here_alone(Class& type)
{
    auto* const python = reinterpret_cast<PyTypeObject*>(type.ptr());
    python->tp_new = [](PyTypeObject* t, PyObject*, PyObject*) -> PyObject* {
        PyErr_Format(PyExc_TypeError, "%s: made by the functions of drystone alone",
                     t->tp_name);
        return nullptr;
    };
    PyType_Modified(python);
    type.def("__copy__", [](pybind11::object self) { return self; });
    type.def("__deepcopy__", [](pybind11::object self, const pybind11::dict&) { return self; });
}

} // namespace bindings
