#pragma once
/// Walls that were shaken, as fragility on the intensity of an earthquake sees them.

#include "app/study/stored/stored_histories.hpp"
#include "app/text/csv.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/intensity/ida.hpp"
#include "fragility/intensity/intensity_fit.hpp"
#include "ground/intensity.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

/// Number that a damage state is read from.
enum class IntensityResponse {
    drift,
    pushed, ///< drift over the ultimate drift of the push of the same wall
    residual,
    uplift, ///< share of the lowest joint that opened
    collapse
};

struct IntensityState {
    std::string name; ///< "drift 0.5 %"
    IntensityResponse of = IntensityResponse::drift;
    double threshold = 0.0; ///< of the response [-]; infinite: collapse
};

struct IntensityData {
    StoredHistories histories;
    ground::Measure measure;
    std::size_t column = 0;   ///< of the measure in StoredHistory::measures
    std::string measure_name; ///< "sa(0.3 s)"
    std::string unit;         ///< "g"
    double unit_value = 1.0;  ///< in SI
    std::vector<IntensityState> states;
    std::vector<fragility::HazardPoint> hazard; ///< [unit]; empty: none given
    double confidence = 0.95;
};

/// Drift below which a wall counts as elastic in a cloud: nothing but that is known of it [-].
inline constexpr double kElasticDrift = 1e-4; // choice

inline constexpr std::array kIntensityMethods = {
    std::pair{fragility::IntensityMethod::stripes, "stripes"},
    std::pair{fragility::IntensityMethod::ida, "IDA"},
    std::pair{fragility::IntensityMethod::cloud, "cloud"}};

/// @param measure as --intensity gives it; empty: that of the study
/// @throws ConfigError about --intensity where the file has no such measure
[[nodiscard]] IntensityData intensity_data(StoredHistories histories,
                                           const std::string& measure);

/// A table of two columns: the intensity, in the unit of the measure where its head has one,
/// and the annual rate at which it is exceeded.
/// @throws ConfigError at the row
[[nodiscard]] std::vector<fragility::HazardPoint> hazard_points(const Csv& csv,
                                                                const IntensityData& data);

/// Number of a history that a state is read from [-]; 0 where it is not known.
[[nodiscard]] double response_of(const StoredHistory& history, IntensityResponse of);

/// Histories of a stress that gave numbers; intensities in the unit of the measure.
/// @param mode of these alone
[[nodiscard]] std::vector<fragility::ShakenWallPoint>
shaken_points(const IntensityData& data, std::size_t level, const IntensityState& state,
              std::optional<dem::FailureMode> mode = {});

/// Fits of one state under one stress, by kIntensityMethods. A residual has no cloud, as it is
/// often zero, and that of collapse is the stripes. Histories of one mode have no IDA: a wall
/// under a record may change its mode from one intensity to the next.
struct IntensityFits {
    std::array<std::optional<fragility::ClusteredFit>, kIntensityMethods.size()> by{};
};
[[nodiscard]] IntensityFits intensity_fits(const IntensityData& data, std::size_t level,
                                           const IntensityState& state,
                                           std::optional<dem::FailureMode> mode = {});

/// The fit that stands for a state: stripes, else IDA, else the cloud; nothing where none has a
/// curve.
[[nodiscard]] std::optional<std::size_t> chosen_fit(const IntensityFits& fits);

} // namespace app
