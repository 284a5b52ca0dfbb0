#include "fragility/modes/mode_sensitivity.hpp"

#include <stdexcept>
#include <string>

namespace fragility {
namespace {

std::vector<int> modes_of(std::span<const std::vector<double>> walls,
                          std::span<const double> thresholds, const ModeRule& rule, int modes)
{
    std::vector<int> found;
    for (const std::vector<double>& figures : walls) {
        found.push_back(rule(figures, thresholds));
        if (found.back() < 0 || found.back() >= modes)
            throw std::invalid_argument("mode rule: wall " + std::to_string(found.size()) +
                                        ": mode " + std::to_string(found.back()) +
                                        " is not within 0 to " + std::to_string(modes - 1));
    }
    return found;
}

} // namespace

std::vector<ThresholdShares> mode_shares(std::span<const std::vector<double>> walls,
                                         std::span<const std::vector<double>> thresholds,
                                         const ModeRule& rule, int modes)
{
    if (walls.empty() || thresholds.empty())
        throw std::invalid_argument("mode shares: at least one wall and one set of thresholds");
    const double n = static_cast<double>(walls.size());
    const std::vector<int> first = modes_of(walls, thresholds[0], rule, modes);
    std::vector<ThresholdShares> all;
    for (const std::vector<double>& t : thresholds) {
        const std::vector<int> found = modes_of(walls, t, rule, modes);
        ThresholdShares s{t, std::vector<double>(static_cast<std::size_t>(modes)), {}, 0.0};
        for (std::size_t i = 0; i < found.size(); ++i) {
            s.counts[static_cast<std::size_t>(found[i])] += 1.0;
            if (found[i] != first[i]) s.moved += 1.0 / n;
        }
        for (const double c : s.counts) s.shares.push_back(c / n);
        all.push_back(std::move(s));
    }
    return all;
}

std::vector<std::vector<double>> threshold_grid(std::span<const std::vector<double>> values)
{
    std::vector<std::vector<double>> grid{{}};
    for (const std::vector<double>& options : values) {
        std::vector<std::vector<double>> longer;
        for (const std::vector<double>& head : grid)
            for (const double x : options) {
                longer.push_back(head);
                longer.back().push_back(x);
            }
        grid = std::move(longer);
    }
    return grid;
}

} // namespace fragility
