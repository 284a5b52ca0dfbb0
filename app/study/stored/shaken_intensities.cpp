#include "app/study/stored/shaken_intensities.hpp"

#include "app/input/study/study.hpp"
#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "ground/call_text.hpp"

#include <algorithm>
#include <string_view>

namespace app {
namespace {

ground::Measure measure_of(const ShakingInput& shaking, const StudyFile& source)
{
    using Kind = ground::MeasureKind;
    const ground::Measure measure = read_at(
        source, "shaking.measure", [&] { return ground::parse_measure(shaking.measure); });
    if (measure.kind != Kind::pga && measure.kind != Kind::pgv && measure.kind != Kind::sa)
        throw error_at(source, "shaking.measure", "use pga, pgv or sa(0.3 s)");
    return measure;
}

std::vector<double> values_of(const ShakingInput& shaking, const StudyFile& source,
                              const ground::Measure& measure)
{
    constexpr const char* kKey = "shaking.intensities";
    std::vector<double> all;
    if (shaking.intensities.empty()) return all;
    const auto dimension = measure.kind == ground::MeasureKind::pgv
                               ? ground::Dimension::velocity
                               : ground::Dimension::acceleration;
    const auto parts = split_outside_brackets(shaking.intensities);
    const auto unit_of = [](std::string_view part) {
        return std::string(
            part.substr(std::min(part.find_first_not_of("0123456789.+-eE "), part.size())));
    };
    // the unit may stand at the end alone; without any it is that of the measure
    std::string unit = unit_of(parts.back());
    if (unit.empty()) unit = measure_unit(measure);
    for (const std::string& part : parts) {
        const double x = read_at(source, kKey, [&] {
            return ground::quantity(unit_of(part).empty() ? part + " " + unit : part,
                                    dimension);
        });
        if (x <= 0.0)
            throw error_at(source, kKey, "must be above 0; write e.g. 0.1, 0.2 " + unit);
        all.push_back(x);
    }
    return all;
}

} // namespace

ShakenIntensities shaken_intensities(const ShakingInput& shaking, const StudyFile& source)
{
    const ground::Measure measure = measure_of(shaking, source);
    return {measure, values_of(shaking, source, measure), shaking.scale};
}

std::string intensity_head(const ShakenIntensities& all)
{
    if (all.values.empty()) return "factor [-]";
    return measure_text(all.measure) + " [" + std::string(measure_unit(all.measure)) + "]";
}

std::string intensity_text(const ShakenIntensities& all, std::size_t intensity)
{
    if (all.values.empty()) return {};
    const double level = all.scale * all.values.at(intensity);
    return " at " + measure_text(all.measure) + " " +
           number(level / measure_unit_value(all.measure), 6) + " " +
           std::string(measure_unit(all.measure));
}

Number intensity_cell(const ShakenIntensities& all, std::size_t intensity)
{
    if (all.values.empty()) return given(all.scale);
    return given(all.scale * all.values.at(intensity) / measure_unit_value(all.measure));
}

} // namespace app
