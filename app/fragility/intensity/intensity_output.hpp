#pragma once
/// Tables, pictures and files of fragility on the intensity of an earthquake.

#include "app/fragility/intensity/intensity_data.hpp"
#include "app/fragility/numbers/fragility_output.hpp"

#include <string>
#include <vector>

namespace app {

[[nodiscard]] FragilityOutput intensity_output(const IntensityData& data);

/// Median and dispersion of a curve with their intervals.
[[nodiscard]] Row intensity_curve_cells(const fragility::ClusteredFit& fit);

/// All fits, by stress and state.
using AllIntensityFits = std::vector<std::vector<IntensityFits>>;

/// Fragility model for the OpenQuake engine (NRML 0.5): one function for each stress, with the
/// drift states and collapse in the order of their medians under the first stress. Where curves
/// of a stress cross within the range of its intensities, its function is discrete and each
/// curve is lifted to those of severer states: no damage state has a probability below 0. The
/// description names states and stresses that were left out or lifted, and why. Empty where no
/// state has a curve, or the measure is none that the engine knows.
[[nodiscard]] std::string openquake_xml(const IntensityData& data,
                                        const AllIntensityFits& fits);

/// One component for each stress, as pelicun_csv; four states at most. Empty where pelicun has
/// no name for the measure.
[[nodiscard]] std::string intensity_pelicun_csv(const IntensityData& data,
                                                const AllIntensityFits& fits);

/// Fragility curves with the observed shares, IDA with its fractiles, and the cloud, for each
/// stress.
[[nodiscard]] std::vector<NamedPicture> intensity_pictures(const IntensityData& data,
                                                           const AllIntensityFits& fits);

/// Name of the states' set in files: "0.50_MPa".
[[nodiscard]] std::string level_file(const HistoryLevel& level);

} // namespace app
