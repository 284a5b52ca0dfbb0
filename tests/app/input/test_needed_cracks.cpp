/// Units that need no cracks, because a coarse push shows that they stay far below their
/// strength.

#include "app/input/needed_cracks.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/unit_cracks.hpp"
#include "app/study_texts.hpp"
#include "dem/block/model.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace {

app::Study wall_with(const std::string& where, const std::string& strength = "2 MPa")
{
    return study_texts::read_good(
        {"unit.cracks=grid(2, 2)", "unit.cracks_where=" + where, "unit.cracks_elsewhere=none",
         "unit.tensile_strength=" + strength, "load.vertical_stress=0.15 MPa",
         "joint.wall_modulus=600 MPa", "load.max_displacement=1 mm", "solver.accuracy=10 %"});
}

double peak(const app::Study& study)
{
    const dem::Model model = app::model_of(app::prepare(study));
    const dem::PushResult r =
        dem::push(model, study_texts::materials(study, 0), app::push_plan(study), study.solver);
    double force = 0.0;
    for (const dem::CurvePoint& p : r.curve) force = std::max(force, p.force);
    return force;
}

} // namespace

TEST_CASE("needed cracks: the toe of a rocking wall, and the same answer as with all",
          "[app][cracks][slow]")
{
    const app::Study needed = wall_with("needed");
    const dem::Layout some = study_texts::laid(needed),
                      all = study_texts::laid(wall_with("0 m, 0 m, 9 m, 9 m"));
    CHECK(some.n_cracks > 0);
    CHECK(2 * some.n_cracks < all.n_cracks);
    for (const dem::Face& f : some.faces)
        if (f.kind == dem::FaceKind::unit_crack) CHECK(f.from.x > 0.3 * all.length);
    // Pieces and cracks together are within 2 % as stiff as the unit (test_crack_strength).
    CHECK(peak(needed) == Approx(peak(wall_with("0 m, 0 m, 9 m, 9 m"))).epsilon(0.02));
    // The study that is kept says the boxes, and is the same wall.
    const app::Study kept = study_texts::read(app::effective_configuration(needed));
    CHECK(kept.cracks.where == needed.cracks.where);
    CHECK(kept.cracks.where.find("needed") == std::string::npos);
    CHECK(study_texts::laid(kept).n_cracks == some.n_cracks);
}

TEST_CASE("needed cracks: none, where no unit comes near its strength", "[app][cracks]")
{
    CHECK(study_texts::laid(wall_with("needed", "900 MPa")).n_cracks == 0);
}
