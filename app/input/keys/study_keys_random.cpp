/// Random samples, reliability and fragility: keys of the study file.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/study_key_table.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/reading/wall_numbers.hpp"
#include "fragility/codes/code_table.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using Mode = dem::ModeThresholds;

constexpr std::array kDesigns = {named("lhs", uq::DesignKind::latin_random),
                                 named("lhs_centred", uq::DesignKind::latin_centred),
                                 named("lhs_optimised", uq::DesignKind::latin_optimised),
                                 named("monte_carlo", uq::DesignKind::monte_carlo),
                                 named("sobol", uq::DesignKind::sobol)};
constexpr std::array kMethods = {named("monte_carlo", ReliabilityMethod::monte_carlo),
                                 named("form", ReliabilityMethod::form),
                                 named("importance", ReliabilityMethod::importance),
                                 named("subset", ReliabilityMethod::subset),
                                 named("multi_fidelity", ReliabilityMethod::multi_fidelity),
                                 named("sobol", ReliabilityMethod::sobol),
                                 named("active", ReliabilityMethod::active)};
/// Names of the responses, from their table, after other words.
template <std::size_t N> constexpr auto with_responses(const std::array<Named, N>& others)
{
    std::array<Named, N + kJudged> names;
    std::ranges::copy(others, names.begin());
    for (std::size_t i = 0; i < kJudged; ++i) names[N + i] = named(kWallNumbers[i].name, i);
    return names;
}
constexpr auto kResponses = with_responses(std::array<Named, 0>{});
constexpr auto kStops =
    with_responses(std::array{named("none", kNoStop), named("mixed_share", kStopAtMixedShare)});
constexpr std::array kSpatial = {
    named("none", Spatial::none), named("independent", Spatial::independent),
    named("stratified", Spatial::stratified), named("correlated", Spatial::correlated)};
constexpr std::array kKernels = {named("exponential", FieldKernel::exponential),
                                 named("squared_exponential", FieldKernel::squared_exponential),
                                 named("exponential_l1", FieldKernel::exponential_l1),
                                 named("matern", FieldKernel::matern),
                                 named("same_course", FieldKernel::same_course),
                                 named("same_unit", FieldKernel::same_unit),
                                 named("all", FieldKernel::all)};
constexpr std::array kCrossings = {named("first", fragility::Crossing::first),
                                   named("last", fragility::Crossing::last)};
constexpr std::array kBackbones = {named(fragility::kSideNames[0], fragility::Side::mean),
                                   named(fragility::kSideNames[1], fragility::Side::worse),
                                   named(fragility::kSideNames[2], fragility::Side::right),
                                   named(fragility::kSideNames[3], fragility::Side::left)};
// Files of 0.2.0 say two and three.
constexpr std::array kModeRules = {
    named("mechanism", dem::ModeRule::mechanism), named("paper", dem::ModeRule::paper),
    named("two", dem::ModeRule::paper), named("three", dem::ModeRule::mechanism)};
constexpr std::array kDriftLaws = {
    named("lognormal", fragility::Law::lognormal), named("normal", fragility::Law::normal),
    named("weibull", fragility::Law::weibull), named("gamma", fragility::Law::gamma)};

constexpr Condition kToAndFro{
    asks<&Study::load>([](auto& l) { return push_way(l).direction == 0; }),
    "the push goes one way"};

bool is_by_group(FieldKernel k)
{
    return k == FieldKernel::same_course || k == FieldKernel::same_unit ||
           k == FieldKernel::all;
}

constexpr Condition kWithRandom{asks<&Study::random>([](auto& r) { return !r.empty(); }),
                                "no value of the study is a distribution"};
constexpr Condition kWithSamples{
    asks<&Study::geometry, &Study::random>([](auto& g, auto& r) { return is_random(g, r); }),
    "no value of the study is a distribution"};
constexpr Condition kWithRandomAlone{
    kWithRandom.holds, "no value of the study is a distribution; remove it", true};
constexpr Condition kWithLevels{
    asks<&Study::random, &Study::load>(
        [](auto& r, auto& l) { return !r.empty() && l.vertical_stress.size() > 1; }),
    "no value is a distribution, or there is only one stress level"};
constexpr Condition kVariesInWalls{
    asks<&Study::random>([](auto& random) {
        return std::ranges::any_of(random, [](const RandomInput& r) {
            return r.varies == Varies::by_joint || r.varies == Varies::by_crack;
        });
    }),
    "no distribution belongs to a joint or a crack"};
constexpr Condition kWithFields{
    asks<&Study::uq>([](auto& u) { return u.spatial == Spatial::correlated; }),
    "uq.spatial is not correlated"};
constexpr Condition kWithMatern{
    asks<&Study::uq>([](auto& u) { return u.kernel == FieldKernel::matern; }),
    "uq.kernel is not matern"};
constexpr Condition kWithGroups{asks<&Study::uq>([](auto& u) { return is_by_group(u.kernel); }),
                                "uq.kernel is not same_course, same_unit or all"};
constexpr Condition kWithStop{
    asks<&Study::geometry, &Study::random, &Study::uq>(
        [](auto& g, auto& r, auto& u) { return is_random(g, r) && u.stop != kNoStop; }),
    "uq.stop is none, or the study has one wall per stress level"};
constexpr Condition kMultiFidelity{asks<&Study::reliability>([](auto& r) {
                                       return r.method == ReliabilityMethod::multi_fidelity;
                                   }),
                                   "reliability.method is not multi_fidelity"};
constexpr Condition kActive{
    asks<&Study::reliability>([](auto& r) { return r.method == ReliabilityMethod::active; }),
    "reliability.method is not active; only active learning finds a quantile: write active, or "
    "remove it",
    true};
constexpr Condition kSampled{
    asks<&Study::reliability>([](auto& r) {
        const ReliabilityMethod m = r.method;
        return m == ReliabilityMethod::monte_carlo || m == ReliabilityMethod::importance ||
               m == ReliabilityMethod::subset || m == ReliabilityMethod::active;
    }),
    "reliability.method is not monte_carlo, importance, subset or active"};
constexpr Condition kUserStates{asks<&Study::fragility>([](auto& f) {
                                    return f.limit_states.find("user") != std::string::npos;
                                }),
                                "fragility.limit_states does not name user"};
constexpr Condition kOwnCodes{
    [](const Study& s) {
        return std::ranges::any_of(reading_rules(s).sets, [&](const fragility::Code& set) {
            return fragility::find_code(s.fragility.own_codes, set.name) != nullptr;
        });
    },
    "fragility.limit_states names none of its codes"};

// clang-format off
constexpr std::array kRandomKeys = {
    Key{.name = "uq.design", .kind = Kind::word, .names = kDesigns,
        .effect = kWithRandom, .verbs = "push study sample",
        .meaning = "how the samples are drawn; lhs: Latin hypercube",
        .field = kAt<&Study::uq, &UqInput::design>},
    Key{.name = "uq.samples", .kind = Kind::count, .range = {'[', 1, 1e7, ']'},
        .effect = kWithSamples, .verbs = "push study sample",
        .meaning = "walls per stress level; a larger number adds walls and keeps the old",
        .field = kAt<&Study::uq, &UqInput::samples>},
    Key{.name = "uq.seed", .kind = Kind::count, .range = {'[', 0, 9e15, ']'},
        .effect = kWithRandom,
        .meaning = "another seed gives other samples",
        .field = kAt<&Study::uq, &UqInput::seed>},
    Key{.name = "uq.shared", .kind = Kind::word, .names = kYesNo,
        .effect = kWithLevels, .verbs = "push study sample",
        .meaning = "yes: the same samples under every stress level; no: a design for each (paper)",
        .field = kAt<&Study::uq, &UqInput::shared>},
    Key{.name = "uq.spatial", .kind = Kind::word, .names = kSpatial,
        .effect = kVariesInWalls,
        .meaning = "one value per wall, or per joint ID: independent, stratified in each wall, correlated",
        .field = kAt<&Study::uq, &UqInput::spatial>},
    Key{.name = "uq.kernel", .kind = Kind::word, .names = kKernels, .used = kWithFields,
        .meaning = "correlation between joints by distance of their centres, or by group",
        .field = kAt<&Study::uq, &UqInput::kernel>},
    Key{.name = "uq.correlation_length", .kind = Kind::list, .unit = "m", .range = {'(', 0, 1e6, ']'},
        .used = kWithFields,
        .derived = {"must be given with kernels by distance"},
        .meaning = "correlation length of kernels by distance; two values for exponential_l1, along x and z",
        .field = kAt<&Study::uq, &UqInput::correlation_length>},
    Key{.name = "uq.matern_nu", .range = {'[', 0.05, 50, ']'}, .used = kWithFields,
        .effect = kWithMatern,
        .meaning = "smoothness of the kernel matern",
        .field = kAt<&Study::uq, &UqInput::matern_nu>},
    Key{.name = "uq.group_correlation", .range = {'[', 0, 1, ']'}, .used = kWithFields,
        .effect = kWithGroups,
        .meaning = "correlation between joints of one group, of the kernels same_course, same_unit, all",
        .field = kAt<&Study::uq, &UqInput::group_correlation>},
    Key{.name = "uq.stop", .kind = Kind::word, .names = kStops,
        .effect = kWithSamples, .verbs = "study",
        .meaning = "adds walls until the 95 % interval is narrow enough at every level: of the mean of the peak force, of a share, of the median of displacements and drifts; from 10 walls on",
        .field = kAt<&Study::uq, &UqInput::stop>},
    Key{.name = "uq.stop_half_width", .range = {'(', 0, 1, ']'},
        .effect = kWithStop, .verbs = "study",
        .meaning = "half width of that interval as a share of the mean or median; for mixed_share in absolute terms",
        .field = kAt<&Study::uq, &UqInput::stop_half_width>},
    Key{.name = "uq.most_samples", .kind = Kind::count, .range = {'[', 1, 1e7, ']'},
        .effect = kWithStop, .verbs = "study",
        .meaning = "upper limit on the number of samples",
        .field = kAt<&Study::uq, &UqInput::most_samples>},
    Key{.name = "uq.audit", .kind = Kind::count, .range = {'[', 0, 1e7, ']'},
        .verbs = "study",
        .meaning = "walls of each stress, the first ones, that are pushed again four times slower, so that the error of the solver is seen; a larger number adds walls and keeps the old",
        .field = kAt<&Study::uq, &UqInput::audit>},
    Key{.name = "uq.pearson", .kind = Kind::text,
        .effect = kWithRandom,
        .derived = {"none"},
        .meaning = "correlated variables: joint.friction_angle joint.stiffness_factor 0.3, ...",
        .field = kAt<&Study::uq, &UqInput::pearson>},
    Key{.name = "uq.together", .kind = Kind::text,
        .effect = kWithRandom,
        .derived = {"none"},
        .meaning = "empirical(...) inputs, between commas, whose values stand row by row: value k of each belongs to draw k, as the posterior of calibrate",
        .field = kAt<&Study::uq, &UqInput::together>},
    Key{.name = "uq.drawn", .kind = Kind::text, .used = kWithRandomAlone, .verbs = "push sheet",
        .derived = {"none"},
        .meaning = "one wall of the study, as a push of it writes it into study.ini: 0.5 MPa; joint.friction_angle = 25.8 deg; ...",
        .field = kAt<&Study::uq, &UqInput::drawn>},

    Key{.name = "reliability.method", .kind = Kind::word, .names = kMethods,
        .meaning = "form: design point, FORM and SORM; importance: sampling around it; subset: small probabilities; active: small ones from few walls; sobol: what the response depends on",
        .field = kAt<&Study::reliability, &ReliabilityInput::method>},
    Key{.name = "reliability.response", .kind = Kind::word, .names = kResponses,
        .meaning = "response whose fall to the demand or below is the event; ultimate: at fragility.ultimate_share",
        .field = kAt<&Study::reliability, &ReliabilityInput::response>},
    Key{.name = "reliability.demand", .kind = Kind::text,
        .derived = {"must be given for reliability, or a quantile"},
        .meaning = "demand, such as 40 kN, 15 mm, or 1.2 for a drift of 1.2 %",
        .field = kAt<&Study::reliability, &ReliabilityInput::demand>},
    Key{.name = "reliability.quantile", .range = {'(', 0, 0.5, ']'}, .names = kNone,
        .used = kActive,
        .meaning = "in place of a demand: the response that a wall falls to or below with this probability, such as 0.05, is sought",
        .field = kAt<&Study::reliability, &ReliabilityInput::quantile>},
    Key{.name = "reliability.budget", .kind = Kind::count, .range = {'[', 10, 1e8, ']'},
        .meaning = "largest number of walls; multi_fidelity: largest total cost, in walls",
        .field = kAt<&Study::reliability, &ReliabilityInput::budget>},
    Key{.name = "reliability.target_cov", .range = {'(', 0, 10, ']'},
        .effect = kSampled,
        .meaning = "coefficient of variation that the probability should have: sampling stops there",
        .field = kAt<&Study::reliability, &ReliabilityInput::target_cov>},
    Key{.name = "reliability.cheap", .kind = Kind::word, .names = kFidelities,
        .effect = kMultiFidelity,
        .meaning = "fidelity of the cheap model of multi_fidelity",
        .field = kAt<&Study::reliability, &ReliabilityInput::cheap>},

    Key{.name = "fragility.limit_states", .kind = Kind::text,
        .meaning = "sets, one or more of paper, ntc, ec8, ec8_secondary, collapse, user, or of your own (drystone help codes)",
        .field = kAt<&Study::fragility, &FragilityInput::limit_states>},
    Key{.name = "fragility.codes", .kind = Kind::text,
        .effect = kOwnCodes,
        .derived = {"none"},
        .meaning = "a file of codes of your own, in the format of fragility/codes/codes.json, from the folder of the study, with --set from the current folder (drystone help codes); or its text",
        .field = kAt<&Study::fragility, &FragilityInput::codes>},
    Key{.name = "fragility.user_states", .kind = Kind::text,
        .effect = kUserStates,
        .derived = {"none"},
        .meaning = "limit states of the set user: slight: 0.7 yield; heavy: 0.5 yield + 0.5 ultimate; near: ultimate or 1.0 %",
        .field = kAt<&Study::fragility, &FragilityInput::user_states>},
    Key{.name = "fragility.crossing", .kind = Kind::word, .names = kCrossings,
        .meaning = "which fall to ultimate_share counts on a jerky curve",
        .field = kAt<&Study::fragility, &FragilityInput::crossing>},
    Key{.name = "fragility.ultimate_share", .range = {'(', 0, 1, ')'},
        .meaning = "share of the peak force at the ultimate displacement (paper, section 4.2)",
        .field = kAt<&Study::fragility, &FragilityInput::ultimate_share>},
    Key{.name = "fragility.bilinear_share", .range = {'(', 0, 1, ']'},
        .meaning = "share of the peak force through which the bilinear curve rises (Circolare 7/2019, C7.3.4.2)",
        .field = kAt<&Study::fragility, &FragilityInput::bilinear_share>},
    Key{.name = "fragility.backbone", .kind = Kind::word, .names = kBackbones,
        .effect = kToAndFro,
        .meaning = "curve on which limit states of a push to and fro are read; worse: that of the direction that reaches each state first",
        .field = kAt<&Study::fragility, &FragilityInput::backbone>},
    Key{.name = "fragility.law", .kind = Kind::word, .names = kDriftLaws,
        .verbs = "study fragility",
        .meaning = "distribution of limit drifts and displacements",
        .field = kAt<&Study::fragility, &FragilityInput::law>},
    Key{.name = "fragility.confidence", .range = {'(', 0, 1, ')'},
        .verbs = "study fragility",
        .meaning = "confidence level of all intervals",
        .field = kAt<&Study::fragility, &FragilityInput::confidence>},
    Key{.name = "fragility.bootstrap", .kind = Kind::count, .range = {'[', 0, 1e6, ']'},
        .verbs = "study fragility",
        .meaning = "samples behind the p-values of fits, 100 or more; 0: none",
        .field = kAt<&Study::fragility, &FragilityInput::bootstrap>},
    Key{.name = "fragility.modes", .kind = Kind::word, .names = kModeRules,
        .meaning = "mechanism: rocking, sliding or mixed, by what moves first and what cracks second; paper: walls that slide whole count as rocking, all that lose load as mixed (two and three are their names in older files)",
        .field = kAt<&Study::fragility, &FragilityInput::mode, &Mode::modes>},
    Key{.name = "fragility.rotation_share", .range = {'(', 0, 1, ')'},
        .meaning = "rotation / displacement below which a wall does not rock: it slides, or is of mixed mode where cracked",
        .field = kAt<&Study::fragility, &FragilityInput::mode, &Mode::rotation_share>},
    Key{.name = "fragility.cracked_units", .kind = Kind::count, .range = {'[', 0, 1e6, ']'},
        .meaning = "units cracked through from which a wall counts as cracked; 0: sliding is enough",
        .field = kAt<&Study::fragility, &FragilityInput::mode, &Mode::cracked_units>},
    Key{.name = "fragility.model_factor", .kind = Kind::text,
        .verbs = "fragility report",
        .meaning = "error of the model, test over prediction, on every limit drift: none, tests (docs/fragility.md), or lognormal(median 0.8, sigma_log 0.4)",
        .field = kAt<&Study::fragility, &FragilityInput::model_factor>},
    Key{.name = "fragility.model_factor_force", .kind = Kind::text,
        .verbs = "fragility report",
        .meaning = "the same on every peak force",
        .field = kAt<&Study::fragility, &FragilityInput::model_factor_force>},
    Key{.name = "fragility.shaken_drifts", .kind = Kind::list, .unit = "%", .range = {'(', 0, 100, ']'}, .used = kShaken, .verbs = "study fragility",
        .meaning = "largest drifts that are damage states of walls that are shaken (choice)",
        .field = kAt<&Study::fragility, &FragilityInput::shaken_drifts>},
    Key{.name = "fragility.shaken_residuals", .kind = Kind::list, .unit = "%", .range = {'(', 0, 100, ']'}, .used = kShaken, .verbs = "study fragility",
        .meaning = "residual drifts that are damage states of walls that are shaken (choice)",
        .field = kAt<&Study::fragility, &FragilityInput::shaken_residuals>},
    Key{.name = "fragility.shaken_uplift", .unit = "%", .range = {'[', 0, 100, ')'}, .used = kShaken, .verbs = "study fragility",
        .meaning = "share of the lowest joint above what the ground holds that opens in an uplift, a damage state of walls that are shaken (choice)",
        .field = kAt<&Study::fragility, &FragilityInput::shaken_uplift>},
    Key{.name = "fragility.pushed_limit", .unit = "%", .range = {'(', 0, 100, ']'}, .names = kNone, .used = kShaken, .verbs = "study fragility",
        .meaning = "drift limit of a push; 80 % of it is a damage state of walls that are shaken (shaking.push: of the push of each wall)",
        .field = kAt<&Study::fragility, &FragilityInput::pushed_limit>},
};
// clang-format on

} // namespace

std::span<const Key> random_keys() { return kRandomKeys; }

} // namespace app
