#include "app/output/capacity_csv.hpp"

#include "app/text/number_text.hpp"
#include "fragility/curve/drift.hpp"

#include <cstddef>
#include <stdexcept>

namespace app {

std::string capacity_csv(std::span<const double> displacement, std::span<const double> force,
                         double height, const std::vector<CurveColumn>& more)
{
    if (displacement.size() != force.size())
        throw std::invalid_argument(
            "capacity curve: as many displacements as forces are needed");
    if (!(height > 0.0))
        throw std::invalid_argument(
            "capacity curve: the height for the drift must be positive");

    for (const CurveColumn& c : more)
        if (c.values.size() != force.size())
            throw std::invalid_argument("capacity curve: as many values of " + c.name +
                                        " as forces are needed");
    constexpr int kDigits = 9; // more than any run is accurate to; hides 0.30000000000000004
    std::string table = "displacement_mm,drift_percent,force_kN";
    for (const CurveColumn& c : more) table += ',' + c.name;
    table += '\n';
    for (std::size_t i = 0; i < displacement.size(); ++i) {
        table += number(displacement[i] * 1e3, kDigits) + ',';
        table += number(100.0 * fragility::drift(displacement[i], height), kDigits) + ',';
        table += number(force[i] * 1e-3, kDigits);
        for (const CurveColumn& c : more) table += ',' + number(c.values[i], kDigits);
        table += '\n';
    }
    return table;
}

} // namespace app
