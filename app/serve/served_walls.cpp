#include "app/serve/served_walls.hpp"

#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/reliability/wall_black_box.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/sampling/wall_sites.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/layout.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

namespace app {
namespace {

/// Data that all models of a server share.
struct Shared {
    dem::Layout layout;
    std::vector<RandomInput> inputs;
    std::vector<int> sites; ///< of each input
    std::vector<const WallNumber*> outputs;
    WallPush push;
};

RandomInput fixed_input(const Parameters& parameters, const StudyFile& source, const Key& key)
{
    if (key.field.place == nullptr || key.varies == Varies::never)
        throw error_at(source, key.name,
                       "cannot be an input: it changes the wall itself, not its materials");
    Parameters p = parameters;
    RandomInput input;
    input.key = key.name;
    input.unit = key.unit;
    input.place = key.field.place;
    input.mean = key.field.place(p);
    input.varies = key.varies;
    return input;
}

RandomInput input_named(const Parameters& parameters, const std::vector<RandomInput>& random,
                        const StudyFile& source, const std::string& name)
{
    for (const RandomInput& input : random)
        if (input.key == name) return input;
    const Key* const key = find_key(name);
    if (key == nullptr)
        throw ConfigError("drystone", 0, "--input",
                          in_quotes(name) + " is not a key of a study");
    if (find_entry(source, name) == nullptr)
        throw error_at(source, name,
                       "follows from other keys; give it a value, or --set " + name +
                           "=..., to make it an input");
    return fixed_input(parameters, source, *key);
}

std::vector<ServedColumn> output_columns(const std::vector<std::string>& names, Shared& shared)
{
    std::vector<ServedColumn> columns;
    for (const std::string& name : names) {
        const auto* const n = std::ranges::find(kWallNumbers, name, &WallNumber::name);
        if (n == kWallNumbers.end()) {
            std::vector<std::string_view> all; // clang++ 14 has no std::views
            for (const WallNumber& known : kWallNumbers) all.push_back(known.name);
            throw ConfigError("drystone", 0, "--response",
                              in_quotes(name) + " is not a response; " + suggestion(name, all));
        }
        columns.push_back({name, std::string(n->unit.si), meaning(*n)});
        shared.outputs.push_back(n);
    }
    return columns;
}

/// @throws BadValue, std::runtime_error
std::vector<double> answer(const Shared& shared, const PushedWall& wall)
{
    const std::string& why = wall.reading.no_reading;
    if (wall.result.outcome == dem::Outcome::no_wall) throw BadValue(why);
    if (!why.empty()) throw std::runtime_error(why);
    std::vector<double> y;
    for (const WallNumber* n : shared.outputs) y.push_back(value(*n, source_of(wall)));
    return y;
}

std::vector<ServedColumn> physical_columns(const Shared& shared)
{
    std::vector<ServedColumn> columns;
    for (std::size_t i = 0; i < shared.sites.size(); ++i) {
        const Key& key = *find_key(shared.inputs[i].key);
        const std::string unit = key.unit.empty() ? "-" : std::string(si_unit(key.unit));
        const std::string meaning(key.meaning);
        if (shared.sites[i] == 1) {
            columns.push_back({std::string(key.name), unit, meaning});
            continue;
        }
        const bool joint = key.varies == Varies::by_joint;
        const std::vector<uq::Site> sites =
            joint ? joint_sites(shared.layout) : crack_sites(shared.layout);
        for (int site = 1; site <= shared.sites[i]; ++site)
            columns.push_back({std::string(key.name) + "." + std::to_string(site), unit,
                               meaning + ", " + site_meaning(joint, sites.at(site - 1))});
    }
    return columns;
}

/// Farther out a probability is soon 1 in double precision, and its quantile no number.
constexpr double kFarthest = 8.2;

/// The same model over standard normal coordinates.
ServedModel normal_model(const StudyFile& source, const SamplePlan& plan,
                         const ServedModel& physical)
{
    ServedModel model;
    model.name = physical.name + "_normal";
    model.outputs = physical.outputs;
    for (int i = 1; i <= plan.values.n_columns; ++i)
        model.inputs.push_back({"z" + std::to_string(i), "-", "standard normal"});
    for (std::size_t i = 0; i < plan.values.columns.size(); ++i)
        for (const int column : plan.values.columns[i])
            model.inputs[column].meaning =
                "standard normal coordinate of " + plan.inputs[i].key;
    model.evaluate = [to_physical = wall_map(source, plan),
                      at = physical.evaluate](std::span<const double> z) {
        for (std::size_t i = 0; i < z.size(); ++i)
            if (!(std::abs(z[i]) <= kFarthest))
                throw BadValue(
                    "input: z" + std::to_string(i + 1) + " = " + number(z[i], 6) +
                    " is beyond " + number(kFarthest, 2) +
                    " standard deviations, where a probability is 0 or 1 to the last "
                    "digit");
        const Eigen::MatrixXd row =
            Eigen::Map<const Eigen::RowVectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
        const Eigen::MatrixXd x = to_physical(row);
        return at({x.data(), static_cast<std::size_t>(x.size())});
    };
    return model;
}

} // namespace

std::string served_name(const std::string& study, std::size_t stresses, double stress)
{
    if (stresses == 1) return study;
    std::string level = stress_text(stress);
    std::ranges::replace(level, ' ', '_');
    return study + "_" + level;
}

ServedStudy served_study(const PreparedStudy& ready, const std::vector<std::string>& inputs)
{
    const Study& study = ready.study;
    ServedStudy served{ready, inputs.empty() && study.uq.spatial != Spatial::stratified};
    if (!inputs.empty()) {
        served.ready.study.random.clear();
        for (const std::string& name : inputs)
            served.ready.study.random.push_back(
                input_named(study.parameters, study.random, study.source, name));
    }
    refuse_layouts(served.ready.study.geometry, served.ready.study.source);
    check_random(served.ready.study.random, served.ready.study.source,
                 ", or name inputs: --input joint.friction_angle");
    return served;
}

std::vector<ServedModel> served_models(const ServedStudy& served, const std::string& name,
                                       const std::vector<std::string>& responses,
                                       const WallPush& push)
{
    const Study& study = served.ready.study;
    const auto shared =
        std::make_shared<Shared>(Shared{served.ready.layout, study.random, {}, {}, push});
    shared->sites = sites_of(study.random, study.uq.spatial, shared->layout);
    const std::vector<ServedColumn> outputs = output_columns(responses, *shared);
    std::vector<ServedModel> models;
    for (std::size_t l = 0; l < study.load.vertical_stress.size(); ++l) {
        const int level = static_cast<int>(l);
        ServedModel model;
        model.name =
            served_name(name, study.load.vertical_stress.size(), study.load.vertical_stress[l]);
        model.inputs = physical_columns(*shared);
        model.outputs = outputs;
        model.evaluate = [shared, level](std::span<const double> x) {
            return answer(
                *shared, shared->push({level, checked_draw(shared->inputs, shared->sites, x)}));
        };
        if (served.distributions)
            models.push_back(
                normal_model(study.source, any_wall_plan(study, shared->layout), model));
        models.push_back(std::move(model));
    }
    return models;
}

} // namespace app
