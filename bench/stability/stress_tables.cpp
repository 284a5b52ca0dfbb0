#include "bench/stability/stress_tables.hpp"

#include "app/text/number_text.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/step/stability_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bench {

namespace {

using dem::Outcome;

constexpr std::array kOutcomes = {Outcome::reached_target, Outcome::lost_equilibrium,
                                  Outcome::energy_astray, Outcome::not_finite,
                                  Outcome::out_of_steps};

std::string share(int part, int whole)
{
    return std::to_string(part) + " (" + app::fixed(100.0 * part / std::max(1, whole), 2) +
           " %)";
}

template <class F> void for_each_wall(const std::vector<SceneReport>& scenes, F f)
{
    for (const SceneReport& s : scenes)
        for (const WallReport& w : s.walls) f(s, w);
}

constexpr double kTooFast = 100.0; // steps per mm; default: 400

std::string laws_of(const StressScene& s)
{
    std::string text = s.scene.closure == dem::Closure::hyperbolic    ? "hyperbolic closure"
                       : s.scene.closure == dem::Closure::exponential ? "exponential closure"
                       : s.mortar                                     ? "bonds"
                                                                      : "linear";
    if (s.scene.joint.closing.loss > 0.0) text += ", loss";
    if (s.scene.joint.crushing.strength > 0.0) text += ", crushing";
    if (s.mixed_mode) text += ", mixed modes";
    return text;
}

std::string group_of(const SceneReport& s, const WallReport& w)
{
    if (w.spoilt) return "spoilt on purpose";
    if (s.scene.laws == DrawnLaws::all) return laws_of(s.scene);
    const bool fast = s.scene.solver.steps_per_mm < kTooFast;
    if (s.scene.solver.step_fraction > 1.0)
        return fast ? "step beyond the bound, drive too fast" : "step beyond the bound";
    return fast ? "step within the bound, drive too fast" : "step within the bound";
}

/// Scenes of one reason, as a reader types them after --only.
struct FailedScenes {
    int walls = 0;
    std::vector<std::string> scenes;
};

void add(FailedScenes& f, const SceneReport& s)
{
    ++f.walls;
    const std::string number = std::to_string(s.number);
    if (f.scenes.empty() || f.scenes.back() != number) f.scenes.push_back(number);
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

} // namespace

CampaignSums sums_of(const std::vector<SceneReport>& scenes)
{
    CampaignSums sum;
    sum.scenes = static_cast<int>(scenes.size());
    for (const SceneReport& s : scenes) {
        sum.broken_rules += static_cast<int>(s.broken_rules.size());
        sum.compared_scenes += s.scene.spoil.has_value();
        sum.slowest = std::max(sum.slowest, s.seconds);
        sum.seconds += s.seconds;
        sum.alone += s.alone;
        sum.on_the_way += s.on_the_way > 0.0;
        sum.most_on_the_way = std::max(sum.most_on_the_way, s.on_the_way);
    }
    for_each_wall(scenes, [&](const SceneReport&, const WallReport& w) {
        ++sum.walls;
        sum.steps += w.steps;
        sum.beyond_bound += w.over_limit > 0.0;
        sum.over_limit = std::max(sum.over_limit, w.over_limit);
        if (w.outcome == Outcome::reached_target)
            sum.residual = std::max(sum.residual, w.residual);
    });
    return sum;
}

app::Table outcome_table(const std::vector<SceneReport>& scenes)
{
    std::map<std::string, std::map<Outcome, int>> count;
    for_each_wall(scenes, [&](const SceneReport& s, const WallReport& w) {
        ++count[group_of(s, w)][w.outcome];
    });
    app::Table t;
    t.head = {"walls", "all"};
    for (const Outcome o : kOutcomes) t.head.push_back(name_of(o));
    for (const auto& [group, by_outcome] : count) {
        int all = 0;
        for (const auto& [outcome, n] : by_outcome) all += n;
        app::Row row{group, std::to_string(all)};
        for (const Outcome o : kOutcomes)
            row.push_back(share(by_outcome.contains(o) ? by_outcome.at(o) : 0, all));
        t.rows.push_back(row);
    }
    return t;
}

app::Table reduction_table(const std::vector<SceneReport>& scenes)
{
    std::map<int, std::map<Outcome, int>> count;
    for_each_wall(scenes, [&](const SceneReport&, const WallReport& w) {
        if (!w.spoilt) ++count[w.step_reductions][w.outcome];
    });
    app::Table t;
    t.head = {"step halved"};
    for (const Outcome o : kOutcomes) t.head.push_back(name_of(o));
    for (const auto& [times, by_outcome] : count) {
        app::Row row{std::to_string(times) + " times"};
        for (const Outcome o : kOutcomes)
            row.push_back(std::to_string(by_outcome.contains(o) ? by_outcome.at(o) : 0));
        t.rows.push_back(row);
    }
    return t;
}

app::Table within_bound_table(const std::vector<SceneReport>& scenes)
{
    constexpr std::array kStep = {0.2, 0.6, 0.8, 0.866, 0.95, 1.0};
    constexpr std::array kDamping = {0.0, 1e-9, 0.2, 0.5, 0.95};
    app::Table t;
    t.head = {"damping factor"};
    for (std::size_t j = 0; j + 1 < kStep.size(); ++j)
        t.head.push_back("step " + app::fixed(kStep[j], 2) + " to " +
                         app::fixed(kStep[j + 1], 2));
    for (std::size_t i = 0; i + 1 < kDamping.size(); ++i) {
        app::Row row{i == 0 ? "0"
                            : app::fixed(kDamping[i], 2) + " to " +
                                  app::fixed(kDamping[i + 1], 2)};
        for (std::size_t j = 0; j + 1 < kStep.size(); ++j) {
            int all = 0, reduced = 0;
            for_each_wall(scenes, [&](const SceneReport& s, const WallReport& w) {
                const dem::SolverOptions& o = s.scene.solver;
                const bool here = o.damping_factor >= kDamping[i] &&
                                  o.damping_factor < kDamping[i + 1] &&
                                  o.step_fraction >= kStep[j] && o.step_fraction < kStep[j + 1];
                if (!here || w.spoilt || o.steps_per_mm < kTooFast) return;
                ++all;
                reduced += w.step_reductions > 0;
            });
            row.push_back(std::to_string(reduced) + "/" + std::to_string(all));
        }
        t.rows.push_back(row);
    }
    return t;
}

app::Table failed_table(const std::vector<SceneReport>& scenes)
{
    std::map<std::string, FailedScenes> by_reason;
    for_each_wall(scenes, [&](const SceneReport& s, const WallReport& w) {
        if (!w.spoilt && dem::failed(w.outcome)) add(by_reason[name_of(w.outcome)], s);
    });
    for (const SceneReport& s : scenes)
        for (const std::string& rule : s.broken_rules)
            add(by_reason["broken rule: " + rule], s);
    app::Table t;
    t.head = {"reason", "walls", "scenes", "their numbers"};
    for (const auto& [reason, f] : by_reason)
        t.rows.push_back({reason, std::to_string(f.walls), std::to_string(f.scenes.size()),
                          joined(f.scenes)});
    return t;
}

app::Table limit_table()
{
    constexpr int kSamples = 8;
    app::Table t;
    t.head = {"fidelity", "step / proven bound", "step / measured limit",
              "random walls, least and most", "without damping"};
    const scenes::Scene scene = scenes::paper_wall(0.50);
    const dem::SolverOptions o;
    for (const auto& [name, fidelity] : {std::pair{"rigid", dem::Fidelity::rigid},
                                         {"simple", dem::Fidelity::simple},
                                         {"standard", dem::Fidelity::standard},
                                         {"zones", dem::Fidelity::zones}}) {
        const dem::Model m = scenes::model_of(scene, dem::discretisation_of(fidelity));
        const double mean = dem::step_over_limit(m, scenes::uniform(scene, m), o);
        double least = 1e9, most = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double x = dem::step_over_limit(m, scenes::table5_sample(scene, m, i), o);
            least = std::min(least, x);
            most = std::max(most, x);
        }
        t.rows.push_back({name, app::fixed(o.step_fraction, 3), app::fixed(mean, 3),
                          app::fixed(least, 3) + " to " + app::fixed(most, 3),
                          app::fixed(mean / std::sqrt(1.0 + o.damping_factor), 3)});
    }
    return t;
}

} // namespace bench
