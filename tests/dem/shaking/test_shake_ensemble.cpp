/// Histories side by side in the lanes of a register.

#include "dem/shaking/shake_ensemble.hpp"
#include "tests/dem/shaken_blocks.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <vector>

using namespace shaken_blocks;

namespace {

/// Two blocks on each other, on a dry joint.
scenes::Scene two_blocks(double tan_phi)
{
    scenes::Scene s = block(0.15, 0.25, 1e9, tan_phi);
    s.wall.courses = 2;
    s.wall.course_height = 0.25;
    s.wall.bond_offset = 0.0;
    return s;
}

/// Gives it joints that close, lose energy and crush.
void close(scenes::Scene& s)
{
    s.closure = dem::Closure::exponential;
    s.joint.closing = {4e8, 1e-4, 0.1, 4e10};
    s.joint.kn = 5e8;
    s.joint.ks = 2e8;
    s.joint.crushing = {0.2e6, 0.0};
}

dem::Model closing_model()
{
    scenes::Scene s = two_blocks(0.4);
    close(s);
    return scenes::model_of(s, rigid());
}

constexpr std::size_t kHistories = 21;

/// Walls, records, time steps and lengths differ; some stand still, some slide, some fall.
dem::HistoryInput history(const dem::Model& m, std::size_t i, double damping)
{
    const auto x = static_cast<double>(i);
    dem::HistoryInput in;
    scenes::Scene s = two_blocks(0.2 + 0.2 * static_cast<double>(i % 7));
    if (m.layout.closure != dem::Closure::linear) close(s);
    in.materials = scenes::uniform(s, m);
    in.plan = half_sine((0.1 + 0.1 * x) * kGravity, 0.12 + 0.1 * static_cast<double>(i % 4),
                        30 + static_cast<int>(i % 3));
    in.plan.free_vibration = 0.3 + 0.1 * static_cast<double>(i % 5);
    in.plan.quiet = 1e-3;
    in.plan.contact_damping = std::max(0.0, damping);
    in.plan.record_every = 0.01;
    return in;
}

std::vector<std::uint64_t> bits_of(const dem::ShakeResult& r)
{
    std::vector<double> all{r.most_displacement,
                            r.most_at,
                            r.residual_displacement,
                            r.collapse_time,
                            r.end,
                            r.first_opening,
                            r.last_opening,
                            r.residual,
                            r.energy.work,
                            r.energy.kinetic,
                            r.energy.friction,
                            r.energy.damping,
                            r.ground_work,
                            r.fall_work,
                            r.time_step,
                            static_cast<double>(r.steps),
                            static_cast<double>(r.step_reductions),
                            static_cast<double>(r.outcome)};
    for (const dem::HistoryPoint& p : r.history)
        all.insert(all.end(), {p.time, p.ground, p.displacement, p.base_shear});
    for (const dem::Snapshot* s : {&r.at_most, &r.at_end})
        for (const dem::BlockState& b : s->blocks)
            for (const dem::Point& p : b.displacement) all.insert(all.end(), {p.x, p.z});
    std::vector<std::uint64_t> bits;
    for (const double v : all) bits.push_back(std::bit_cast<std::uint64_t>(v));
    return bits;
}

std::vector<dem::ShakeResult> shaken_together(const dem::Model& m, double damping,
                                              const dem::Workers& workers)
{
    std::vector<dem::ShakeResult> all(kHistories);
    dem::ShakenEnsemble e;
    e.size = kHistories;
    e.damps = damping > 0.0;
    e.history = [&](std::size_t i) { return history(m, i, damping); };
    e.done = [&](std::size_t i, dem::ShakeResult&& r) { all[i] = std::move(r); };
    dem::shake_ensemble(m, e, {}, workers);
    return all;
}

} // namespace

TEST_CASE("shake ensemble: a history has the same bits alone, in any lane and in any thread",
          "[dem][shaking]")
{
    const double damping = GENERATE(0.0, 0.1, -1.0); // below 0: joints that close and crush
    const bool closes = damping < 0.0;
    const dem::Model m = closes ? closing_model() : model(two_blocks(0.4));
    const auto lanes = shaken_together(m, damping, {.threads = 1});
    const auto threads = shaken_together(m, damping, {.threads = 3});
    const auto scalar = shaken_together(m, damping, {.threads = 2, .scalar = true});
    std::set<dem::ShakeOutcome> outcomes;
    for (std::size_t i = 0; i < kHistories; ++i) {
        INFO("history " << i << " " << dem::name_of(lanes[i].outcome));
        const dem::HistoryInput in = history(m, i, damping);
        const auto alone = bits_of(dem::shake(m, in.materials, in.plan));
        CHECK(bits_of(lanes[i]) == alone);
        CHECK(bits_of(threads[i]) == alone);
        CHECK(bits_of(scalar[i]) == alone);
        CHECK(lanes[i].seconds > 0.0);
        outcomes.insert(lanes[i].outcome);
    }
    CHECK(outcomes == std::set{dem::ShakeOutcome::stood, dem::ShakeOutcome::collapsed});
}

TEST_CASE("shake ensemble: histories that are passed over are not handed out, and an "
          "exception ends all threads",
          "[dem][shaking]")
{
    const dem::Model m = model(two_blocks(0.4));
    std::set<std::size_t> seen;
    dem::ShakenEnsemble e;
    e.size = kHistories;
    e.history = [&](std::size_t i) -> std::optional<dem::HistoryInput> {
        if (i % 2 == 0) return {};
        return history(m, i, 0.0);
    };
    e.done = [&](std::size_t i, dem::ShakeResult&&) { seen.insert(i); };
    dem::shake_ensemble(m, e, {}, {.threads = 2});
    CHECK(seen.size() == kHistories / 2);
    CHECK_FALSE(seen.contains(2));
    e.done = [](std::size_t, dem::ShakeResult&&) { throw std::runtime_error("disk full"); };
    CHECK_THROWS_WITH(dem::shake_ensemble(m, e, {}, {.threads = 2}), "disk full");
    e.damps = true;
    CHECK_THROWS_WITH(dem::shake_ensemble(m, e, {}, {.threads = 2}),
                      Catch::Matchers::Contains("or none has"));
}
