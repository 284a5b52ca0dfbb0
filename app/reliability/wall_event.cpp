#include "app/input/study/units.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/reliability/event.hpp"
#include "app/reliability/wall_black_box.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/block/model.hpp"
#include "dem/scene/layout.hpp"

namespace app {
namespace {

struct Demand {
    double value; ///< SI
    std::string words;
};

const WallNumber& response_of(const ReliabilityInput& reliability)
{
    return kWallNumbers.at(reliability.response);
}

/// The demand in the unit of its response.
Demand demand_of(const ReliabilityInput& reliability, const StudyFile& source)
{
    std::string text = reliability.demand;
    if (text.empty())
        throw error_at(source, "reliability.demand",
                       "missing; write e.g. \"demand = 40 kN\" under [reliability], or with "
                       "method = active a quantile, such as \"quantile = 0.05\"");
    const WallNumber& r = response_of(reliability);
    const bool percent = r.unit.name == "%";
    if (percent && text.ends_with('%'))
        text = std::string(trimmed(text.substr(0, text.size() - 1)));
    const double value = read_at(source, "reliability.demand", [&] {
        return parse_quantity(text, percent ? "" : r.unit.name);
    });
    return {percent ? value / r.unit.scale : value,
            words(r) + " <= " + text + (percent ? " %" : "")};
}

/// The response of a wall that outlasts its push.
double end_of_push(const LoadInput& load, const ReliabilityInput& reliability)
{
    const double last = push_way(load).farthest;
    WallReading farthest;
    farthest.peak = fragility::Peak{0.0, last, true};
    farthest.ultimate = {last, fragility::Reading::censored, {}};
    return response_of(reliability).reading(farthest, load.height);
}

/// A push that ends before the demand can never show it.
void check_reached(const LoadInput& load, const ReliabilityInput& reliability,
                   const StudyFile& source, const Demand& demand)
{
    const double last = push_way(load).farthest;
    if (response_of(reliability).ends_with_push &&
        demand.value >= end_of_push(load, reliability))
        throw error_at(source, "reliability.demand",
                       "must be below the end of the push, load.max_displacement = " +
                           number(last * 1e3, 12) + " mm");
}

Study cheaper(Study study)
{
    const dem::Discretisation own = study.discretisation;
    study.fidelity = study.reliability.cheap;
    study.discretisation.block_modes = dem::discretisation_of(study.fidelity).block_modes;
    study.discretisation.contact_points = dem::discretisation_of(study.fidelity).contact_points;
    if (study.discretisation == own)
        throw error_at(study.source, "reliability.cheap",
                       "is the fidelity of the study itself; name a lower one");
    return study;
}

/// Relative cost of a wall: modes move through the contact points in every step.
double cost_of(const PreparedStudy& ready)
{
    const dem::Model m = model_of(ready);
    return static_cast<double>(m.n_modes) * ready.study.discretisation.contact_points;
}

} // namespace

uq::ReliabilityProblem wall_problem(const PreparedStudy& ready, const std::string& stress_name,
                                    int threads)
{
    const Study& study = ready.study;
    refuse_layouts(study.geometry, study.source);
    check_random(study.random, study.source);
    const int level = level_of(study.load, stress_name);
    const bool quantile = study.reliability.quantile > 0.0;
    if (quantile && !study.reliability.demand.empty())
        throw error_at(study.source, "reliability.demand",
                       "a demand and reliability.quantile are two questions; remove one");
    const Demand demand = quantile
                              ? Demand{0.0, std::string(words(response_of(study.reliability)))}
                              : demand_of(study.reliability, study.source);
    if (!quantile) check_reached(study.load, study.reliability, study.source, demand);
    const SamplePlan plan = any_wall_plan(study, ready.layout);

    uq::ReliabilityProblem p =
        asked_problem(study.uq, study.reliability, study.source, plan.values.n_columns);
    p.event.model = wall_model(ready, plan, level, threads);
    p.event.to_physical = wall_map(study.source, plan);
    p.event.response = static_cast<Eigen::Index>(study.reliability.response);
    p.event.threshold = demand.value;
    p.quantile = study.reliability.quantile;
    if (quantile && response_of(study.reliability).ends_with_push)
        p.known_below = end_of_push(study.load, study.reliability);
    const double stress = study.load.vertical_stress[level];
    p.words = demand.words + " under " + stress_text(stress);
    for (const Column& c : input_columns(plan)) p.inputs.push_back(c.name);
    const auto& columns = plan.values.columns; // of the design, of each input
    p.normal.resize(static_cast<std::size_t>(plan.values.n_columns));
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (std::size_t c = 0; c < columns[i].size(); ++c)
            p.normal[columns[i][c]] =
                plan.inputs[i].key + (columns[i].size() > 1 ? "." + std::to_string(c + 1) : "");
    p.rough = true;
    if (p.method == ReliabilityMethod::multi_fidelity) {
        const PreparedStudy low{cheaper(study), ready.layout};
        uq::CheapModel cheap;
        cheap.model = wall_model(low, plan, level, threads);
        cheap.cost = cost_of(low) / cost_of(ready);
        cheap.response = p.event.response;
        cheap.threshold = p.event.threshold;
        p.cheap.push_back(cheap);
    }
    return p;
}

} // namespace app
