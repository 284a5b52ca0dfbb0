#include "dem/scene/mechanism/quality_terms.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

namespace {

dem::Layout layout_of(const std::vector<std::vector<dem::Point>>& units)
{
    dem::Layout layout;
    for (const auto& outline : units) layout.blocks.push_back(dem::block_of(outline));
    layout.beam = static_cast<int>(units.size());
    return layout;
}

} // namespace

TEST_CASE("quality terms: sizes and shapes of units by hand, staggering by the trace",
          "[dem][quality_terms]")
{
    const std::vector<std::vector<dem::Point>> units = {
        {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.2}, {0.0, 0.2}},
        {{0.5, 0.0}, {0.8, 0.0}, {0.5, 0.2}},
        {{0.8, 0.0}, {0.9, 0.0}, {0.9, 0.45}, {0.8, 0.45}}};
    using enum dem::Fulfilled;
    dem::BondIndices indices;
    indices.trace_ratio = 1.5;
    const dem::QualityTerms terms = dem::quality_terms(indices, layout_of(units));
    CHECK(terms.long_stones == Approx(2.0 / 3.0));
    CHECK(terms.middle_stones == Approx(1.0 / 3.0));
    CHECK(terms.filled == Approx((0.1 + 0.03 + 0.045) / (0.1 + 0.06 + 0.045)));
    CHECK(terms.dimensions == fully);
    CHECK(terms.staggered == partly);
    const std::vector<dem::Point> small = {{0.0, 0.0}, {0.15, 0.0}, {0.15, 0.1}, {0.0, 0.1}};
    const dem::Layout halves = layout_of({units[0], small}), // no class has more than half
        all_small = layout_of({small, small, small});
    indices.trace_ratio = 1.3;
    CHECK(dem::quality_terms(indices, halves).dimensions == partly);
    CHECK(dem::quality_terms(indices, all_small).dimensions == no);
    CHECK(dem::quality_terms(indices, all_small).staggered == no);
    indices.trace_ratio = std::numeric_limits<double>::quiet_NaN(); // no way at all
    CHECK(dem::quality_terms(indices, all_small).staggered == fully);
}
