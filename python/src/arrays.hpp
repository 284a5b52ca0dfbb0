#pragma once
/// Numbers of the program as arrays of numpy.

#include <pybind11/numpy.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace bindings {

/// The array takes the numbers over; nothing is copied.
template <class T>
pybind11::array_t<T> array_of(std::vector<T>&& numbers, std::vector<pybind11::ssize_t> shape)
{
    auto* const owned = new std::vector<T>(std::move(numbers));
    const pybind11::capsule owner(owned,
                                  [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return pybind11::array_t<T>(std::move(shape), owned->data(), owner);
}
template <class T> pybind11::array_t<T> array_of(std::vector<T>&& numbers)
{
    const auto n = static_cast<pybind11::ssize_t>(numbers.size());
    return array_of(std::move(numbers), {n});
}
/// Row by row.
template <class T>
pybind11::array_t<T> array_of(std::vector<T>&& numbers, std::size_t rows, std::size_t columns)
{
    return array_of(std::move(numbers), {static_cast<pybind11::ssize_t>(rows),
                                         static_cast<pybind11::ssize_t>(columns)});
}

/// Numbers given to the program; converted where they are of another kind.
using GivenNumbers =
    pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

} // namespace bindings
