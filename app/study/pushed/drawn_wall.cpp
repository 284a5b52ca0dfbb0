#include "app/study/pushed/drawn_wall.hpp"

#include "app/input/study/units.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace app {
namespace {

constexpr std::string_view kMean = "mean";

/// The values of "joint.friction_angle = 25.82 deg".
const std::vector<double>& read_part(const std::vector<RandomInput>& random,
                                     std::string_view part,
                                     std::vector<std::vector<double>>& values)
{
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view name = trimmed(part.substr(0, equals));
    for (std::size_t i = 0; i < random.size(); ++i) {
        if (random[i].key != name) continue;
        if (equals == part.size()) throw BadValue(in_quotes(part) + " has no value");
        return values[i] = parse_quantities(trimmed(part.substr(equals + 1)), random[i].unit);
    }
    throw BadValue(in_quotes(name) + " is not a distribution of this study");
}

WallDraw parse_draw(const PreparedStudy& ready, const std::vector<std::string_view>& parts)
{
    const Study& study = ready.study;
    if (parts.size() == 2 && parts.back() == kMean) return {};
    std::vector<std::vector<double>> values(study.random.size());
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (!parts[i].empty()) static_cast<void>(read_part(study.random, parts[i], values));
    const std::vector<int> sites = sites_of(study.random, study.uq.spatial, ready.layout);
    std::vector<double> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::cmp_not_equal(values[i].size(), sites[i]))
            throw BadValue(study.random[i].key + " has " + std::to_string(values[i].size()) +
                           " values; the wall takes " + std::to_string(sites[i]));
        all.insert(all.end(), values[i].begin(), values[i].end());
    }
    return checked_draw(study.random, sites, all);
}

} // namespace

int level_at(const LoadInput& load, std::string_view text)
{
    const double stress = parse_quantity(text, "MPa");
    const std::vector<double>& all = load.vertical_stress;
    const auto found = std::ranges::find(all, stress);
    if (found == all.end())
        throw BadValue(in_quotes(text) + " is not one of load.vertical_stress, " +
                       format_quantities(all, "MPa"));
    return static_cast<int>(found - all.begin());
}

std::string drawn_text(const LoadInput& load, const std::vector<RandomInput>& random,
                       const WantedWall& wall)
{
    const double stress = load.vertical_stress[wall.level];
    std::string text = format_quantities({&stress, 1}, "MPa");
    if (wall.draw.values.empty()) return text + "; " + std::string(kMean);
    for (std::size_t i = 0; i < random.size(); ++i)
        text += "; " + random[i].key + " = " +
                format_quantities(wall.draw.values[i], random[i].unit);
    return text;
}

WantedWall drawn_wall(const PreparedStudy& ready)
{
    const Study& study = ready.study;
    return read_at(study.source, "uq.drawn", [&]() -> WantedWall {
        const auto parts = split(study.uq.drawn, ";");
        return {level_at(study.load, parts.front()), parse_draw(ready, parts)};
    });
}

Study with_drawn(Study study, const WantedWall& wall)
{
    constexpr std::string_view kName = "uq.drawn";
    study.uq.drawn = drawn_text(study.load, study.random, wall);
    auto& entries = study.source.entries;
    std::erase_if(entries, [&](const Entry& e) { return e.key == kName; });
    entries.push_back({std::string(kName), study.uq.drawn, 1});
    return study;
}

} // namespace app
