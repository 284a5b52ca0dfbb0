#include "app/input/study/study_file.hpp"
#include "app/surrogate/surrogate_output.hpp"
#include "app/text/check_sum.hpp"
#include "app/text/json_text.hpp"

#include <algorithm>

namespace app {
namespace {

Json list_of(const auto& values)
{
    Json list = Json::array();
    for (const double v : values) list.push_back(or_null(v));
    return list;
}

/// All digits: a prediction from the file is that of the program.
Json exact_list(const Eigen::VectorXd& values)
{
    Json list = Json::array();
    for (const double v : values) list.push_back(v);
    return list;
}

Json exact_rows(const Eigen::MatrixXd& m)
{
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < m.rows(); ++i)
        rows.push_back(exact_list(m.row(i).transpose()));
    return rows;
}

Json input_json(const SurrogateStudy& s, std::size_t k)
{
    const StoredInput& input = s.walls->inputs[k];
    const Entry* entry = find_entry(s.walls->study.source, input.key);
    return {{"key", input.key},
            {"unit", input.unit},
            {"distribution", entry != nullptr ? Json(entry->value) : Json()},
            {"from", or_null(input.marginal->lower, input.scale)},
            {"to", or_null(input.marginal->upper, input.scale)},
            {"coordinate", std::string(uq::name(uq::family_of(*input.marginal)))}};
}

Json error_json(const SurrogateError& e)
{
    return {{"q2", or_null(e.q2)}, {"rmse", or_null(e.rmse)}};
}

Json chaos_json(const LevelSurrogate& l)
{
    if (!l.chaos) return {};
    Json degrees = Json::array();
    const Eigen::MatrixXi& d = l.chaos->chaos.degrees;
    for (Eigen::Index t = 0; t < d.rows(); ++t) {
        Json row = Json::array();
        for (Eigen::Index k = 0; k < d.cols(); ++k) row.push_back(d(t, k));
        degrees.push_back(row);
    }
    return {{"error", error_json(l.chaos_error)},
            {"degrees", degrees},
            {"coefficients", exact_list(l.chaos->chaos.coefficients)}};
}

Json process_json(const LevelSurrogate& l)
{
    if (!l.process) return {};
    const uq::GaussianProcess& p = *l.process;
    Json j = {
        {"error", error_json(l.process_error)}, {"kernel", std::string(uq::name(p.kernel))},
        {"variance", p.parameters.variance},    {"lengths", exact_list(p.parameters.lengths)},
        {"noise", p.parameters.noise},          {"constant", p.trend_weights(0)},
        {"weights", exact_list(p.weights)},     {"points", exact_rows(p.data.x)},
        {"responses", exact_list(p.data.y)},    {"inflation", l.inflation}};
    if (p.parameters.noise_slopes.size() > 0)
        j["noise_slopes"] = exact_list(p.parameters.noise_slopes);
    return j;
}

Json estimate_json(const std::optional<uq::Estimate>& e)
{
    if (!e) return {};
    return {{"value", e->value},
            {"lower", e->interval.lower},
            {"upper", e->interval.upper},
            {"confidence", e->interval.confidence}};
}

/// Indices of the inputs: only results, null for all others.
Json indices_json(const SurrogateStudy& s, const LevelSurrogate& l)
{
    Json all = Json::array();
    const bool has_shares = l.no_indices.empty() && l.chaos;
    const uq::ChaosIndices shares =
        has_shares ? uq::sobol_indices(l.chaos->chaos) : uq::ChaosIndices{};
    for (std::size_t k = 0; k < l.given.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        all.push_back({{"key", s.walls->inputs[s.inputs[k]].key},
                       {"sobol_first", has_shares ? Json(shares.first(i)) : Json()},
                       {"sobol_total", has_shares ? Json(shares.total(i)) : Json()},
                       {"cramer_von_mises", estimate_json(l.given[k].rank)},
                       {"hsic", estimate_json(l.given[k].hsic)},
                       {"p_of_no_dependence", l.given[k].p_value}});
    }
    return all;
}

/// Modes: ln(P(names[k]) / P(names[0])) = coefficients[k - 1] (1, c).
Json modes_json(const ModeSurrogate& m)
{
    Json names = Json::array(), doubts = Json::array();
    for (const int mode : m.modes) names.push_back(mode_name(mode));
    for (const std::string& d : m.doubts) doubts.push_back(d);
    Json j = {{"walls", m.walls}, {"names", names}, {"none", m.none}, {"doubts", doubts}};
    if (!m.none.empty()) return j;
    j["error"] = {{"right", m.right}, {"skill", m.skill}};
    j["coefficients"] = exact_rows(m.model.coefficients);
    j["covariance"] = exact_rows(m.model.covariance);
    return j;
}

Json level_json(const SurrogateStudy& s, const LevelSurrogate& l)
{
    Json doubts = Json::array();
    for (const std::string& d : l.doubts) doubts.push_back(d);
    Json j = {{"vertical_stress_MPa", or_null(l.points.stress, 1e-6)},
              {"walls", l.points.sample.size()},
              {"trusted", l.doubts.empty()},
              {"doubts", doubts},
              {"better",
               l.chaos || l.process ? Json(l.chaos_is_better ? "chaos" : "process") : Json()}};
    if (l.points.y.size() > 0) {
        j["learned_between"] = {{"least", list_of(l.points.x.colwise().minCoeff().eval())},
                                {"most", list_of(l.points.x.colwise().maxCoeff().eval())}};
    }
    j["indices"] = indices_json(s, l);
    j["chaos"] = chaos_json(l);
    j["process"] = process_json(l);
    return j;
}

} // namespace

Json surrogate_data(const SurrogateStudy& s)
{
    const bool linear = std::ranges::any_of(s.inputs, [&](std::size_t k) {
        const auto kind = uq::family_of(*s.walls->inputs[k].marginal).kind;
        return kind == uq::PolynomialFamily::jacobi || kind == uq::PolynomialFamily::laguerre;
    });
    const bool varies = std::ranges::any_of(s.levels, [](const LevelSurrogate& l) {
        return l.process && l.process->parameters.noise_slopes.size() > 0;
    });
    Json j = {{"format", linear || varies ? kNewerSurrogateFormat : kSurrogateFormat},
              {"study", s.walls->name},
              {"study_sum", check_sum(s.walls->head.configuration)},
              {"response", std::string(s.response->name)},
              {"unit", std::string(s.response->unit.name)}};
    j["inputs"] = Json::array();
    for (const std::size_t k : s.inputs) j["inputs"].push_back(input_json(s, k));
    j["surrogates"] = Json::array();
    for (std::size_t i = 0; i < s.levels.size(); ++i) {
        j["surrogates"].push_back(level_json(s, s.levels[i]));
        j["surrogates"].back()["modes"] = i < s.modes.size() ? modes_json(s.modes[i]) : Json();
    }
    return j;
}

std::string surrogate_json(const SurrogateStudy& s)
{
    return text_of(surrogate_data(s), 1) + "\n";
}

} // namespace app
