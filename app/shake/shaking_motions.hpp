#pragma once
/// The motions that section [shaking] of a study asks for.

#include "app/study/stored/shaken_intensities.hpp"
#include "dem/shaking/shake.hpp"
#include "ground/ground_motion.hpp"
#include "ground/intensity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct LoadInput;
struct ShakingInput;
struct Study;
struct StudyFile;

/// A record as it is, with the vertical motion that belongs to it.
struct ShakingRecord {
    ground::GroundMotion horizontal;
    std::optional<ground::GroundMotion> vertical; ///< as long
    double own = 0.0; ///< its intensity by the measure of the study [SI], > 0
};

/// The records of a study and the intensities to which each is scaled.
struct ShakingRecords {
    std::vector<ShakingRecord> records;
    ShakenIntensities at;
};

/// One history: a record of one intensity.
struct ShakingMotion {
    std::string name;                             ///< of the record, with its intensity
    double factor = 1.0;                          ///< on the record [-]
    ground::GroundMotion horizontal;              ///< scaled
    std::optional<ground::GroundMotion> vertical; ///< scaled by the same factor, as long
};

/// Files of records are found as path_from tells (app/input/study/study_file.hpp).
/// @throws ConfigError
[[nodiscard]] ShakingRecords shaking_records(const ShakingInput& given, const StudyFile& file);

/// Number of intensities of each record, 1 where they stay as they are.
[[nodiscard]] std::size_t intensity_count(const ShakingRecords& records);

/// @param intensity in [0, intensity_count)
[[nodiscard]] ShakingMotion shaking_motion(const ShakingRecords& records, std::size_t record,
                                           std::size_t intensity);

/// Each record under each intensity.
/// @throws ConfigError
[[nodiscard]] std::vector<ShakingMotion> shaking_motions(const ShakingInput& shaking,
                                                         const StudyFile& source);

/// The plan of a history of the study's wall, without its progress.
[[nodiscard]] dem::ShakePlan shake_plan(const LoadInput& load, const ShakingInput& shaking,
                                        const ShakingMotion& motion);

/// Refuses small displacements, and dashpots in joints that close. @throws ConfigError
void check_shaken_study(const Masonry& masonry, const dem::SolverOptions& solver,
                        const ShakingInput& shaking, const StudyFile& source);

/// The study whose model is shaken: the ground drives it, and its beam is free.
[[nodiscard]] Study moving_study(Study study);

} // namespace app
