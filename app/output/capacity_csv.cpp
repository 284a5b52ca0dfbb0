#include "app/output/capacity_csv.hpp"

#include "app/text/number_text.hpp"

#include <cstddef>
#include <stdexcept>

namespace app {

std::string capacity_csv(std::span<const double> displacement, std::span<const double> force,
                         double height, const BodyForceColumns& body)
{
    if (displacement.size() != force.size())
        throw std::invalid_argument(
            "capacity curve: as many displacements as forces are needed");
    if (!(height > 0.0))
        throw std::invalid_argument(
            "capacity curve: the height for the drift must be positive");

    const bool with_body = !body.load_factor.empty();
    if (with_body &&
        (body.load_factor.size() != force.size() || body.corner.size() != force.size()))
        throw std::invalid_argument(
            "capacity curve: as many load factors and corners as forces are needed");
    constexpr int kDigits = 9; // more than any run is accurate to; hides 0.30000000000000004
    std::string table = "displacement_mm,drift_percent,force_kN";
    table += with_body ? ",load_factor,corner_displacement_mm\n" : "\n";
    for (std::size_t i = 0; i < displacement.size(); ++i) {
        table += number(displacement[i] * 1e3, kDigits) + ',';
        table += number(displacement[i] / height * 100.0, kDigits) + ',';
        table += number(force[i] * 1e-3, kDigits);
        if (with_body)
            table += ',' + number(body.load_factor[i], kDigits) + ',' +
                     number(body.corner[i] * 1e3, kDigits);
        table += '\n';
    }
    return table;
}

} // namespace app
