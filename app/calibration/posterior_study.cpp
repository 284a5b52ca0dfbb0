#include "app/calibration/calibration_output.hpp"
#include "app/input/study/model_factor_text.hpp"
#include "app/input/study_reading.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kWrittenDraws = 200; ///< of a posterior study; choice

/// "joint.friction_angle=empirical(31.2, 33.5, ... deg)"
std::string empirical_text(const CalibrationReport& r, std::size_t input)
{
    constexpr int kDigits = 6;
    const CalibratedInput& in = r.inputs->inputs[input];
    const Taught& answer = answer_of((*r.study).calibration, *r.run);
    const std::size_t stride = answer.points.size() / kWrittenDraws;
    std::string text = in.key + "=empirical(";
    for (std::size_t k = 0; k < kWrittenDraws; ++k) {
        const Eigen::VectorXd x = to_values(*r.inputs, answer.points[k * stride].z);
        text += (k == 0 ? "" : ", ") +
                number(in.scale * x(static_cast<Eigen::Index>(input)), kDigits);
    }
    return text + (in.unit.empty() ? "" : " " + in.unit) + ")";
}

/// Root of the mean of tau^2 + s^2: the error of one further wall under a stress not tested.
double factor_dispersion(const Taught& t, std::size_t kind)
{
    double sum = 0.0;
    for (const uq::CalibrationPoint& at : t.points) {
        const auto k = static_cast<Eigen::Index>(kind);
        sum += at.tau(k) * at.tau(k) + at.s(k) * at.s(k);
    }
    return std::sqrt(sum / static_cast<double>(t.points.size()));
}

/// uq.pearson without the pairs of calibrated inputs, whose dependence stands in their rows.
std::string other_pairs(const CalibrationReport& r)
{
    std::string text;
    for (const std::string_view pair : split(r.study->uq.pearson, ",")) {
        const std::string_view first = pair.substr(0, pair.find(' '));
        bool calibrated = pair.empty();
        for (const CalibratedInput& in : r.inputs->inputs) calibrated |= in.key == first;
        if (!calibrated) text += (text.empty() ? "" : ", ") + std::string(pair);
    }
    return text;
}

} // namespace

std::string posterior_study(const CalibrationReport& r, const std::string& source)
{
    std::vector<std::string> values;
    std::string together;
    for (std::size_t i = 0; i < r.inputs->inputs.size(); ++i) {
        values.push_back(empirical_text(r, i));
        together += (i == 0 ? "" : ", ") + r.inputs->inputs[i].key;
    }
    if (r.inputs->inputs.size() > 1) values.push_back("uq.together=" + together);
    if (const std::string pairs = other_pairs(r); !pairs.empty())
        values.push_back("uq.pearson=" + pairs);
    const Taught& answer = answer_of((*r.study).calibration, *r.run);
    for (std::size_t kind = 0; kind < r.data->quantities.size(); ++kind) {
        const TestedQuantity& q = r.data->quantities[kind];
        if (q.factor_key.empty()) continue;
        const fragility::ModelFactor factor{1.0, factor_dispersion(answer, kind), 0.0};
        values.push_back(std::string(q.factor_key) + "=" + model_factor_text(factor));
    }
    StudyFile file = r.study->source;
    std::erase_if(file.entries, [&](const Entry& e) {
        return e.preset || e.key.starts_with("calibration.") || e.key == "uq.pearson" ||
               std::ranges::any_of(
                   values, [&](const std::string& v) { return v.starts_with(e.key + "="); });
    });
    const Study study = read_study(with_overrides(std::move(file), values));
    return "# Posterior of " + source + ": the inputs of uq.together have " +
           std::to_string(kWrittenDraws) +
           " draws, row by row. The factors of the model are\n# the error of one further wall "
           "under a stress that was not tested.\n" +
           effective_configuration(study);
}

} // namespace app
