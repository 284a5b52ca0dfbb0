#include "app/input/study/model_factor_text.hpp"

#include "app/input/study/distribution_text.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study/study_file.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <cmath>
#include <variant>

namespace app {
namespace {

constexpr std::string_view kHowTo =
    "write none, tests, or a factor such as \"lognormal(median 0.8, sigma_log 0.4)\"";

} // namespace

FactorChoice parse_model_factor(std::string_view text)
{
    const std::string_view word = trimmed(text);
    if (word == "none") return {};
    if (word == "tests") return {.tests = true, .given = {}};
    if (!is_distribution(word))
        throw BadValue(in_quotes(word) + " is no factor of the model; " + std::string(kHowTo));
    const uq::Marginal marginal = parse_distribution(word, "");
    const auto* const law = std::get_if<uq::Lognormal>(&marginal.shape);
    if (law == nullptr || marginal.lower > 0.0 || std::isfinite(marginal.upper))
        throw BadValue(in_quotes(word) +
                       " is not a lognormal distribution without from and to; " +
                       std::string(kHowTo));
    const double median = std::exp(law->mu_log);
    if (!(median >= 0.05 && median <= 20.0))
        throw BadValue("the median of " + in_quotes(word) +
                       " is out of range; it is test over prediction, in [0.05, 20]");
    if (!(law->sigma_log <= 3.0))
        throw BadValue("the scatter of " + in_quotes(word) +
                       " is out of range; sigma_log is a standard deviation of ln, in (0, 3]");
    return {.tests = false, .given = fragility::ModelFactor{median, law->sigma_log, 0.0}};
}

std::string model_factor_text(const fragility::ModelFactor& factor)
{
    return "lognormal(median " + number(factor.median, 3) + ", sigma_log " +
           number(fragility::model_dispersion(factor), 3) + ")";
}

void check_model_factors(const FragilityInput& fragility, const StudyFile& source)
{
    const auto check = [&](const char* key, const std::string& text) {
        read_at(source, key, [&] { static_cast<void>(parse_model_factor(text)); });
    };
    check("fragility.model_factor", fragility.model_factor);
    check("fragility.model_factor_force", fragility.model_factor_force);
}

} // namespace app
