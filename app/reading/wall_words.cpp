#include "app/reading/wall_words.hpp"

namespace app {

std::string_view words(dem::FailureMode mode)
{
    return kModes.at(static_cast<std::size_t>(mode));
}

std::string_view words(fragility::Reading reading)
{
    switch (reading) {
    case fragility::Reading::observed:
        return "observed";
    case fragility::Reading::censored:
        return "censored";
    case fragility::Reading::not_defined:
        break;
    }
    return "not defined";
}

std::string_view words(dem::Outcome outcome)
{
    return kOutcomes.at(static_cast<std::size_t>(outcome));
}

std::string_view why_failed(dem::Outcome outcome)
{
    switch (outcome) {
    case dem::Outcome::not_finite:
        return "the numbers of this run are not finite";
    case dem::Outcome::energy_astray:
        return "the energy ledger does not close at any step tried";
    default:
        return "solver.most_steps were not enough";
    }
}

} // namespace app
