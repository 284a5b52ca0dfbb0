#include "app/calibration/calibrated_inputs.hpp"

#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/sampling/study_dependence.hpp"
#include "app/text/words.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <string_view>

namespace app {
namespace {

constexpr const char* kKey = "calibration.inputs";

[[noreturn]] void refuse(const StudyFile& source, const std::string& why)
{
    throw error_at(source, kKey, why);
}

/// Places in Study::random, ascending.
std::vector<std::size_t> places_of(const CalibrationInput& calibration,
                                   const std::vector<RandomInput>& random,
                                   const StudyFile& source)
{
    std::vector<std::size_t> places;
    for (const std::string_view word : split(calibration.inputs, ",")) {
        if (word != "all")
            places.push_back(input_named(random, source, word, kKey));
        else
            for (std::size_t i = 0; i < random.size(); ++i) places.push_back(i);
    }
    std::ranges::sort(places);
    if (std::ranges::adjacent_find(places) != places.end())
        refuse(source, "names an input twice; keep one of them");
    if (places.empty()) refuse(source, "no value of this study is a distribution");
    return places;
}

void check_input(const UqInput& uq, const StudyFile& source, const RandomInput& r)
{
    if (uq.spatial != Spatial::none && r.varies != Varies::by_wall)
        refuse(source, r.key + " varies from joint to joint, and tests teach one value for the "
                               "wall; write uq.spatial = none");
    if (std::holds_alternative<uq::Constant>(r.marginal.shape))
        refuse(source, r.key + " does not vary: there is nothing to learn; take it out");
    const auto together = split(uq.together, ",");
    if (std::ranges::count(together, std::string_view(r.key)) > 0)
        refuse(source, r.key +
                           " stands row by row with others (uq.together), and a posterior is "
                           "no prior here; calibrate the first study with all tests");
}

/// Correlation of the normal images of the inputs at these places.
Eigen::MatrixXd correlation_of(const Sampling& sampling, const StudyFile& source,
                               const std::vector<std::size_t>& places)
{
    const auto n = static_cast<Eigen::Index>(places.size());
    const auto dependence = dependence_of(sampling, source);
    Eigen::MatrixXd rho = Eigen::MatrixXd::Identity(n, n);
    if (!dependence) return rho;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto a = static_cast<Eigen::Index>(places[static_cast<std::size_t>(i)]);
        for (Eigen::Index b = 0; b < dependence->rho_z.cols(); ++b) {
            const auto found = std::ranges::find(places, static_cast<std::size_t>(b));
            if (found != places.end())
                rho(i, found - places.begin()) = dependence->rho_z(a, b);
            else if (dependence->rho_z(a, b) != 0.0)
                refuse(source, sampling.random[static_cast<std::size_t>(a)].key +
                                   " is correlated with " +
                                   sampling.random[static_cast<std::size_t>(b)].key +
                                   " (uq.pearson), which is not named; name both");
        }
    }
    return rho;
}

} // namespace

int fewest_walls(std::size_t inputs)
{
    constexpr int kEach = 5, kLeast = 10;
    return std::max(kLeast, kEach * static_cast<int>(inputs));
}

CalibratedInputs calibrated_inputs(const CalibrationInput& calibration,
                                   const Sampling& sampling, const StudyFile& source)
{
    const std::vector<std::size_t> places = places_of(calibration, sampling.random, source);
    CalibratedInputs c;
    c.all = places.size() == sampling.random.size();
    for (const std::size_t place : places) {
        const RandomInput& r = sampling.random[place];
        check_input(sampling.uq, source, r);
        const std::string_view unit = find_key(r.key)->unit;
        c.inputs.push_back({r.key, std::string(unit), from_si(1.0, unit), place, r.marginal});
    }
    c.factor = Eigen::LLT<Eigen::MatrixXd>(correlation_of(sampling, source, places))
                   .matrixL()
                   .toDenseMatrix();
    if (const int least = fewest_walls(places.size()); sampling.uq.samples < least)
        throw error_at(source, "uq.samples",
                       std::to_string(sampling.uq.samples) +
                           " walls under each stress are too few "
                           "to learn " +
                           counted(places.size(), "input", "inputs") + "; write " +
                           std::to_string(least) + " or more");
    return c;
}

Eigen::VectorXd to_coordinates(const CalibratedInputs& c, const Eigen::VectorXd& values)
{
    Eigen::VectorXd z(values.size());
    for (Eigen::Index i = 0; i < z.size(); ++i)
        z(i) = uq::to_normal(c.inputs[static_cast<std::size_t>(i)].marginal, values(i));
    return c.factor.triangularView<Eigen::Lower>().solve(z);
}

Eigen::VectorXd to_values(const CalibratedInputs& c, const Eigen::VectorXd& coordinates)
{
    Eigen::VectorXd x = c.factor.triangularView<Eigen::Lower>() * coordinates;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        x(i) = uq::from_normal(c.inputs[static_cast<std::size_t>(i)].marginal, x(i));
    return x;
}

} // namespace app
