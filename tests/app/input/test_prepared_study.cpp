/// Reading a study file reads it; what costs time is done once, when the study is prepared.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace app;

namespace {

Study read_alone(const std::vector<std::string>& overrides)
{
    return read_study(
        with_overrides(parse_study_text("study.ini", study_texts::kSmallWall), overrides));
}

const std::vector<std::string> kRubble = {"wall.bond=rubble", "wall.unit_cracks=no",
                                          "wall.layouts=3", "wall.seed=11"};

} // namespace

TEST_CASE("prepared study: reading grows no rubble, preparing does", "[app][prepared_study]")
{
    const Study read = read_alone(kRubble);
    CHECK(read.geometry.units.empty());
    const PreparedStudy ready = prepare(read);
    CHECK_FALSE(ready.study.geometry.units.empty());
    CHECK(ready.layout.blocks.size() ==
          layout_of(ready.study, ready.study.source).blocks.size());
}

TEST_CASE("prepared study: reading looks for no cracks, and scales no protocol",
          "[app][prepared_study]")
{
    const Study read = read_alone({"wall.unit_cracks=yes", "unit.cracks=grid(2, 2)",
                                   "unit.cracks_where=needed", "load.max_displacement=0.5 mm",
                                   "load.protocol=iso16670", "load.protocol_scale=one_way",
                                   "solver.accuracy=10 %"});
    CHECK(read.cracks.where == "needed");
    CHECK(read.load.scaled.empty());
    const PreparedStudy ready = prepare(read);
    CHECK(ready.study.cracks.where != "needed");
    CHECK_FALSE(ready.study.load.scaled.empty());
    CHECK(ready.layout.n_cracks == layout_of(ready.study, ready.study.source).n_cracks);
}

TEST_CASE("prepared study: another layout is the study with its seed, read anew",
          "[app][prepared_study]")
{
    const PreparedStudy again = in_layout(prepare(read_alone(kRubble)).study, 13);
    const PreparedStudy anew =
        prepare(read_alone({"wall.bond=rubble", "wall.unit_cracks=no", "wall.seed=13"}));
    CHECK(effective_configuration(again.study) == effective_configuration(anew.study));
    REQUIRE(again.layout.blocks.size() == anew.layout.blocks.size());
    for (std::size_t b = 0; b < anew.layout.blocks.size(); ++b)
        CHECK(again.layout.blocks[b].x1 == anew.layout.blocks[b].x1);
}
