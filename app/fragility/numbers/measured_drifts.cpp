#include "app/fragility/numbers/measured_drifts.hpp"

#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"

#include <array>

namespace app {
namespace {

/// Drifts measured on walls without strengthening, the smaller of both directions; computed
/// from the tables of Vanin, Zaganelli, Penna, Beyer (2017), doi 10.5281/zenodo.812145, at
/// commit 6f340243 of github.com/eesd-epfl/StoneMasonryDatabase.
struct Measured {
    const char *typology, *mode;
    int tests;
    double median, dispersion; ///< exp(mean ln) [%], standard deviation of ln [-]
};

constexpr std::array kMeasured = {
    Measured{"dry joints", "flexure, rocking", 17, 2.35, 0.39},
    Measured{"dry joints", "hybrid", 4, 1.59, 0.38},
    Measured{"ashlar in mortar (E)", "flexure, rocking", 14, 1.61, 0.59},
    Measured{"ashlar in mortar (E)", "hybrid", 6, 1.64, 0.31},
    Measured{"ashlar in mortar (E)", "shear", 13, 1.00, 0.50},
    Measured{"rubble to cut stone (A to D)", "flexure, rocking", 14, 0.97, 0.57},
    Measured{"rubble to cut stone (A to D)", "hybrid", 8, 0.76, 0.90},
    Measured{"rubble to cut stone (A to D)", "shear", 29, 0.61, 0.58},
    Measured{"all stone", "flexure, rocking", 45, 1.59, 0.62},
    Measured{"all stone", "hybrid", 18, 1.16, 0.74},
    Measured{"all stone", "shear", 42, 0.71, 0.60},
};

} // namespace

Table measured_drifts()
{
    Table t = titled_table("measured_drifts", {});
    t.keys = 2;
    t.head = {"typology", "mode", "tests", "median ultimate drift [%]", "dispersion"};
    for (const Measured& m : kMeasured)
        t.rows.push_back({std::string(m.typology), std::string(m.mode), count(m.tests),
                          plain_number(m.median, 2), plain_number(m.dispersion, 2)});
    return t;
}

} // namespace app
