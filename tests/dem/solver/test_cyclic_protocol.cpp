#include "dem/solver/cyclic_protocol.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace dem;

TEST_CASE("cyclic protocol: FEMA 461 grows by 1.4 to the largest amplitude",
          "[dem][cyclic_protocol]")
{
    const auto stages = stages_of(Protocol::fema461, 0.03);
    REQUIRE(stages.size() == 10);
    CHECK(stages.back().amplitude == 0.03);
    CHECK(stages.front().amplitude / 0.03 == Approx(0.0484).margin(5e-5)); // 1 / 1.4^9
    CHECK(stages[4].amplitude / stages[3].amplitude == Approx(1.4).epsilon(1e-12));
    CHECK(std::all_of(stages.begin(), stages.end(),
                      [](const CyclicStage& s) { return s.cycles == 2; }));
}

TEST_CASE("cyclic protocol: ISO 16670 has five single and five triple amplitudes",
          "[dem][cyclic_protocol]")
{
    const auto stages = stages_of(Protocol::iso16670, 0.1);
    REQUIRE(stages.size() == 10);
    CHECK(stages.front().amplitude == Approx(0.00125).epsilon(1e-12));
    CHECK(stages[4].cycles == 1);
    CHECK(stages[5].cycles == 3);
    CHECK(stages[5].amplitude == Approx(0.02).epsilon(1e-12));
    CHECK(stages.back().amplitude == Approx(0.1).epsilon(1e-12));
    CHECK(cyclic_targets(stages).size() == 2 * (5 + 15) + 1);
}

TEST_CASE("cyclic protocol: each cycle goes right and left, the push ends at zero",
          "[dem][cyclic_protocol]")
{
    CHECK(cyclic_targets({{0.003, 2}, {0.006, 1}}) ==
          std::vector{0.003, -0.003, 0.003, -0.003, 0.006, -0.006, 0.0});
    CHECK(cyclic_targets({}).empty());
    CHECK(stages_of(Protocol::none, 0.03).empty());
}
