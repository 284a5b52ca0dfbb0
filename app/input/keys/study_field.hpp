#pragma once
/// A member of Study, of whatever type, seen as a list of numbers.

#include "app/input/study/study.hpp"

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace app {

/// Values in SI. A single number is a list of one; counts, choices and yes/no are whole
/// numbers; a text is the list of its characters.
struct Field {
    std::vector<double> (*get)(const Study&) = nullptr;
    void (*set)(Study&, const std::vector<double>&) = nullptr;
    ParameterPlace place = nullptr; ///< of a number among the parameters; nullptr: of none
};

/// The member at the end of a path of member pointers.
template <auto First, auto... Rest> auto& follow(auto& object)
{
    if constexpr (sizeof...(Rest) == 0) {
        return object.*First;
    } else {
        return follow<Rest...>(object.*First);
    }
}

template <auto... Path> std::vector<double> get_field(const Study& study)
{
    const auto& field = follow<Path...>(study);
    if constexpr (std::is_same_v<decltype(field), const std::vector<double>&>) {
        return field;
    } else if constexpr (std::is_same_v<decltype(field), const std::string&>) {
        return {field.begin(), field.end()};
    } else {
        return {static_cast<double>(field)};
    }
}

template <auto... Path> void set_field(Study& study, const std::vector<double>& values)
{
    using Value = std::remove_reference_t<decltype(follow<Path...>(study))>;
    if constexpr (std::is_same_v<Value, std::vector<double>>) {
        follow<Path...>(study) = values;
    } else if constexpr (std::is_same_v<Value, std::string>) {
        follow<Path...>(study).assign(values.begin(), values.end());
    } else {
        follow<Path...>(study) = static_cast<Value>(values.front());
    }
}

template <auto... Path> double& parameter(Parameters& p) { return follow<Path...>(p); }

template <auto First, auto... Rest> constexpr ParameterPlace place_of()
{
    if constexpr (std::is_same_v<decltype(First), Parameters Masonry::*>) {
        using End = decltype(follow<Rest...>(std::declval<Parameters&>()));
        if constexpr (std::is_same_v<End, double&>) return &parameter<Rest...>;
    }
    return nullptr;
}

/// kAt<&Study::wall, &dem::WallGeometry::length>
template <auto... Path>
constexpr Field kAt{&get_field<Path...>, &set_field<Path...>, place_of<Path...>()};

} // namespace app
