#include "app/output/backbones_csv.hpp"

#include "app/text/number_text.hpp"

namespace app {

std::string backbones_csv(const fragility::Path& path)
{
    constexpr int kDigits = 9; // as in capacity.csv
    std::string table = "side,displacement_mm,force_kN\n";
    for (const int direction : {1, -1}) {
        const fragility::Backbone b = fragility::backbone(path, direction);
        for (std::size_t i = 0; i < b.force.size(); ++i)
            table += (direction > 0 ? "right," : "left,") +
                     number(b.displacement[i] * 1e3, kDigits) + ',' +
                     number(b.force[i] * 1e-3, kDigits) + '\n';
    }
    return table;
}

} // namespace app
