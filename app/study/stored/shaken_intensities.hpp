#pragma once
/// The intensities to which a study scales its records, and how tables write them.

#include "app/output/table/table.hpp"
#include "ground/intensity.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

struct ShakingInput;
struct StudyFile;

struct ShakenIntensities {
    ground::Measure measure;
    std::vector<double> values; ///< of the measure [SI]; empty: the records as they are
    double scale = 1.0;         ///< on all of them [-]
};

/// The unit may follow each value or the last; without any, values are in that in which people
/// read the measure.
/// @throws ConfigError about shaking.measure and shaking.intensities
[[nodiscard]] ShakenIntensities shaken_intensities(const ShakingInput& shaking,
                                                   const StudyFile& source);

/// Head of the column that tells them apart: "sa(0.3 s) [g]"; "factor [-]" where records are as
/// they are.
[[nodiscard]] std::string intensity_head(const ShakenIntensities& all);

/// Words behind the name of a record: " at sa(0.3 s) 0.2 g"; empty where records are as they
/// are.
[[nodiscard]] std::string intensity_text(const ShakenIntensities& all, std::size_t intensity);

/// Its cell. @param intensity index of a value, 0 where there is none
[[nodiscard]] Number intensity_cell(const ShakenIntensities& all, std::size_t intensity);

} // namespace app
