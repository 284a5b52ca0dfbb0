#pragma once
/// Reads the arrays of a .vtu file back.

#include "tests/scenes/xml_tree.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace scenes {

template <class T>
[[nodiscard]] std::vector<double> numbers(const char* bytes, std::size_t size)
{
    std::vector<double> values;
    for (std::size_t at = 0; at < size; at += sizeof(T)) {
        T value;
        std::memcpy(&value, bytes + at, sizeof(T));
        values.push_back(static_cast<double>(value));
    }
    return values;
}

/// Values of the array of this name; none if there is no such array.
[[nodiscard]] inline std::vector<double> vtu_array(const std::string& vtu,
                                                   const std::string& name)
{
    const std::string tag = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t bytes = vtu.find(tag) + tag.size();
    for (const Xml& data :
         elements(parse_xml(vtu.substr(0, bytes) + "</AppendedData></VTKFile>"), "DataArray")) {
        if (attribute(data, "Name") != name) continue;
        const char* at = vtu.data() + bytes + std::stoul(attribute(data, "offset"));
        std::uint64_t size = 0;
        std::memcpy(&size, at, sizeof(size));
        at += sizeof(size);
        const std::string type = attribute(data, "type");
        if (type == "Float64") return numbers<double>(at, size);
        if (type == "Int64") return numbers<std::int64_t>(at, size);
        if (type == "Int32") return numbers<std::int32_t>(at, size);
        return numbers<std::uint8_t>(at, size);
    }
    return {};
}

} // namespace scenes
