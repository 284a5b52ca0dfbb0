#include "app/serve/served_surrogate.hpp"

#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/serve/served_walls.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/surrogate/surrogate_data.hpp"
#include "app/text/config_error.hpp"

#include <filesystem>

namespace app {
namespace {

bool has_surrogate(const LearnedLevel& level) { return level.chaos || level.process; }

std::vector<ServedColumn> inputs_of(const LearnedSurrogate& s)
{
    std::vector<ServedColumn> columns;
    for (const LearnedInput& in : s.inputs) {
        const Key& key = *find_key(in.key);
        columns.push_back({in.key, key.unit.empty() ? "-" : std::string(si_unit(key.unit)),
                           std::string(key.meaning)});
    }
    return columns;
}

std::vector<ServedColumn> outputs_of(const WallNumber& response, const LearnedLevel& level)
{
    const std::string name(response.name), unit(response.unit.si);
    const std::string doubt =
        level.doubts.empty() ? "" : "; not to be trusted: " + level.doubts.front();
    std::vector<ServedColumn> columns = {
        {name, unit, meaning(response) + ", learned" + doubt},
        {name + "_sd", unit, "standard deviation of one wall about it"},
        {"outside", "-", "inputs beyond those of the walls learned from"}};
    if (!level.modes) return columns;
    const std::string unsure = level.modes->doubts.empty()
                                   ? ""
                                   : "; not to be trusted: " + level.modes->doubts.front();
    for (const std::string& mode : level.modes->names) {
        columns.push_back({mode, "-", "probability of this failure mode, learned" + unsure});
        columns.push_back({mode + "_sd", "-", "standard error of that probability"});
    }
    return columns;
}

std::vector<double> answer_of(const LearnedSurrogate& s, const LearnedLevel& level,
                              std::span<const double> x)
{
    const Eigen::MatrixXd row =
        Eigen::Map<const Eigen::RowVectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    const SurrogateAnswers a = predict(s, level, row);
    std::vector values = {a.mean(0), a.sd(0), static_cast<double>(a.outside(0))};
    if (!level.modes) return values;
    const ModeAnswers modes = predict_modes(s, level, row);
    for (Eigen::Index k = 0; k < modes.probability.cols(); ++k)
        values.insert(values.end(), {modes.probability(0, k), modes.sd(0, k)});
    return values;
}

} // namespace

std::vector<ServedModel>
surrogate_models(const std::shared_ptr<const LearnedSurrogate>& surrogate)
{
    const WallNumber& response = surrogate_response(surrogate->response);
    const std::string stem = std::filesystem::path(surrogate->study).stem().string();
    std::vector<ServedModel> models;
    for (const LearnedLevel& level : surrogate->levels) {
        if (!has_surrogate(level)) continue;
        ServedModel model;
        model.name = served_name(stem, surrogate->levels.size(), level.stress) + "_surrogate";
        model.inputs = inputs_of(*surrogate);
        model.outputs = outputs_of(response, level);
        // the list keeps the level alive
        model.evaluate = [surrogate, at = &level](std::span<const double> x) {
            return answer_of(*surrogate, *at, x);
        };
        models.push_back(std::move(model));
    }
    if (models.empty())
        throw ConfigError(
            surrogate->path, 0, "",
            "no stress has a surrogate: " +
                (surrogate->levels.empty() || surrogate->levels.front().doubts.empty()
                     ? std::string("there is none")
                     : surrogate->levels.front().doubts.front()));
    return models;
}

std::string surrogate_doubts(const LearnedSurrogate& surrogate)
{
    std::string text;
    for (const LearnedLevel& level : surrogate.levels)
        for (const std::string& doubt : level.doubts)
            text += stress_text(level.stress) +
                    (has_surrogate(level) ? ": not to be trusted. " : ": not served. ") +
                    doubt + "\n";
    return text;
}

} // namespace app
