#include "app/report/report_parts.hpp"

#include "app/surrogate/surrogate_output.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "core/fit_factors.hpp"
#include "uq/surrogates/polynomials.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace app {
namespace {

/// Why no wall can be asked for: a sentence; empty: it can.
std::string no_question(const StudyWalls& study)
{
    const auto fixed = [](const StoredInput& i) {
        return i.marginal && std::holds_alternative<uq::Constant>(i.marginal->shape);
    };
    if (std::ranges::all_of(study.inputs, fixed))
        return "Nothing was random in this study, so that there is nothing to ask.";
    for (const StoredInput& i : study.inputs)
        if (!i.marginal)
            return "The distribution of " + i.key +
                   " is not in the file, which is of an earlier version; run the study again.";
    return {};
}

/// Values of an input that a slider takes, with their coordinates. Between its ends they are
/// rounded, so that the answer is that of the number that is read.
Json asked_input(const StudyWalls& study, std::size_t k)
{
    const StoredInput& input = study.inputs[k];
    std::vector<double> seen;
    for (const StudyWall* w : all_walls(study)) seen.push_back(w->inputs[k]);
    std::ranges::sort(seen);
    const double least = seen.front(), most = seen.back(), median = seen[seen.size() / 2];
    Json values = Json::array(), coordinates = Json::array();
    for (std::size_t i = 0; i < kAskedValues; ++i) {
        const double share = static_cast<double>(i) / (kAskedValues - 1);
        constexpr int kDigits = 4;
        const double value = i == 0 ? least
                             : i == kAskedValues - 1
                                 ? most
                                 : rounded(least + share * (most - least), kDigits);
        values.push_back(value);
        coordinates.push_back(uq::coordinate(*input.marginal, value / input.scale));
    }
    const double place = most > least ? (median - least) / (most - least) : 0.0;
    return {{"key", input.key},
            {"unit", input.unit},
            {"scale", input.scale},
            {"coordinate", std::string(uq::name(uq::family_of(*input.marginal)))},
            {"values", values},
            {"coordinates", coordinates},
            {"start", static_cast<std::size_t>(place * (kAskedValues - 1) + 0.5)}};
}

/// A level of surrogate.json without what does not predict.
Json asked_level(const SurrogateStudy& s, std::size_t level, Json j)
{
    const LevelSurrogate& l = s.levels[level];
    for (const char* const key : {"indices", "modes"}) j.erase(key);
    if (l.chaos || l.process) {
        j.erase(l.chaos_is_better ? "process" : "chaos");
        j["range"] = {l.points.y.minCoeff(), l.points.y.maxCoeff()};
    }
    j["left_out"] = left_out_text(s, l);
    return j;
}

} // namespace

Json whatif_json(const StudyWalls& study)
{
    Json j = {{"none", no_question(study)}};
    if (!j["none"].get<std::string>().empty()) return j;
    bool any = false;
    std::string why;
    j["responses"] = Json::array();
    for (const WallNumber* const response :
         {&wall_number("peak_force"), &wall_number("ultimate_drift")}) {
        const SurrogateStudy s = surrogate_study(study, *response, kMostAskedWalls);
        Json all = surrogate_data(s);
        Json levels = Json::array(), modes = Json::array();
        for (std::size_t level = 0; level < s.levels.size(); ++level) {
            modes.push_back(all["surrogates"][level]["modes"]);
            levels.push_back(asked_level(s, level, std::move(all["surrogates"][level])));
            any = any || predicts(s.levels[level]);
            if (why.empty() && !s.levels[level].doubts.empty())
                why = s.levels[level].doubts.front();
        }
        j["responses"].push_back({{"name", words(*response)},
                                  {"unit", std::string(response->unit.name)},
                                  {"decimals", response->decimals},
                                  {"levels", levels}});
        j["modes"] = modes;
        if (j.contains("inputs")) continue;
        j["inputs"] = Json::array();
        for (const std::size_t k : s.inputs) j["inputs"].push_back(asked_input(study, k));
    }
    if (!any) return {{"none", "No wall can be predicted. " + why}};
    j["share"] = study.study.fragility.confidence;
    j["factor"] = core::fit_normal_factor(study.study.fragility.confidence);
    return j;
}

} // namespace app
