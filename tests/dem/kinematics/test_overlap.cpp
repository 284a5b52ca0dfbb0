#include "dem/block/model.hpp"
#include "dem/kinematics/overlap.hpp"
#include "dem/solver/state/step_tables.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

using Frame = dem::BlockFrame<double>;

dem::FacePair bed_joint()
{
    dem::FacePair p;
    p.nz = 1.0;
    p.side_a = {-0.05, 0.05, 0.05};
    p.side_b = {-0.05, 0.05, -0.05};
    p.length = 0.1;
    p.deepest = 0.05;
    p.shallow = 0.005;
    return p;
}

Frame frame(double x, double z, double turn)
{
    Frame f;
    f.x = x;
    f.z = z;
    f.turn = turn;
    f.half = dem::half_turn(turn);
    return f;
}

/// Turned about the origin, as part of one rigid body.
Frame turned(const Frame& f, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    Frame g = frame(f.x * c + f.z * s, f.z * c - f.x * s, f.turn + angle);
    g.spin = 1e-3;
    g.vx = g.spin * g.z;
    g.vz = -g.spin * g.x;
    return g;
}

} // namespace

TEST_CASE("overlap: two blocks turned rigidly by any angle feel nothing of it",
          "[dem][overlap]")
{
    const double angle = GENERATE(0.0, 1e-6, 0.3, -1.2, 2.8, 3.5);
    const double slide = GENERATE(0.0, 0.02, -0.07), tilt = GENERATE(0.0, 0.04, -0.2);
    const dem::FacePair p = bed_joint();
    const Frame a = frame(0.3, 0.05, 0.1), b = frame(0.3 + slide, 0.151, 0.1 + tilt);
    const double centre = 0.7;
    const auto before = dem::overlap_of(p, a, b, centre);
    const Frame a2 = turned(a, angle), b2 = turned(b, angle);
    const auto after = dem::overlap_of(p, a2, b2, centre);
    CHECK(after.gap == Approx(before.gap).margin(1e-12));
    CHECK(after.widening == Approx(before.widening).margin(1e-12));
    CHECK(after.length == Approx(before.length).margin(1e-12));
    CHECK(after.tilt == Approx(before.tilt).margin(1e-12));
    CHECK(dem::slip_of(after, a2, b2) == Approx(0.0).margin(1e-15));
}

TEST_CASE("overlap: both blocks feel the same force at the same point", "[dem][overlap]")
{
    const double tilt = GENERATE(0.0, 0.05, -0.4), slide = GENERATE(0.0, 0.03, -0.06);
    Frame a = frame(0.3, 0.05, 0.2), b = frame(0.32 + slide, 0.148, 0.2 + tilt);
    const auto o = dem::overlap_of(bed_joint(), a, b, 0.4);
    dem::add_forces(o, dem::StressSum<double>{-3e4, 1e4, -1.1e4, 0.4e4}, a, b);
    CHECK(a.fx + b.fx == Approx(0.0).margin(1e-10));
    CHECK(a.fz + b.fz == Approx(0.0).margin(1e-10));
    const auto about_origin = [](const Frame& f) { return f.moment + f.z * f.fx - f.x * f.fz; };
    CHECK(about_origin(a) + about_origin(b) == Approx(0.0).margin(1e-9));
}

TEST_CASE(
    "overlap: what a stress does on the blocks is the opening of its contact, wherever that is",
    "[dem][overlap]")
{
    const double turn = GENERATE(0.005, -0.005, 0.4, -0.4), slide = GENERATE(0.0, 0.03, -0.06);
    const double place = GENERATE(0.0, 0.2, 1.0);
    const dem::FacePair p = bed_joint();
    Frame a = frame(0.0, 0.05, 0.0), b = frame(slide, 0.1499, turn);
    const auto before = dem::overlap_of(p, a, b, place);
    dem::add_forces(before, dem::StressSum<double>{1.0, 0.0, place, 0.0}, a, b);
    const double x = 1e-7, z = -2e-7, spin = 3e-6;
    const Frame moved = frame(b.x + x, b.z + z, turn + spin);
    const auto after = dem::overlap_of(p, a, moved, place);
    const double opened = after.gap - before.gap + place * (after.widening - before.widening);
    CHECK(-(b.fx * x + b.fz * z + b.moment * spin) == Approx(opened).margin(1e-11));
}

TEST_CASE("overlap: the centre of pressure is that of the stresses, or where blocks will touch",
          "[dem][overlap]")
{
    const auto o = dem::overlap_of(bed_joint(), frame(0, 0.05, 0), frame(0, 0.15, 0.01), 0.5);
    CHECK(dem::centre_of_pressure(o, dem::StressSum<double>{-4.0, 0.0, -1.0, 0.0}) == 0.25);
    CHECK(dem::centre_of_pressure(o, dem::StressSum<double>{}) == 1.0); // clockwise
    CHECK(dem::centre_of_pressure(o, dem::StressSum<double>{-1.0, 0.0, -2.0, 0.0}) == 1.0);
}

TEST_CASE("overlap: a block that turns about a common corner neither slips nor opens there",
          "[dem][overlap]")
{
    const double turn = GENERATE(1e-3, 0.05, 0.3);
    // About the lower right corner (0.05, 0.1), clockwise.
    const double c = std::cos(turn), s = std::sin(turn);
    const Frame a = frame(0.0, 0.05, 0.0);
    Frame b = frame(0.05 - 0.05 * c + 0.05 * s, 0.1 + 0.05 * c + 0.05 * s, turn);
    const auto o = dem::overlap_of(bed_joint(), a, b, 1.0);
    CHECK(o.gap + o.widening == Approx(0.0).margin(1e-12));
    CHECK(o.gap > 0.09 * s);
    CHECK(dem::share_of(bed_joint(), o, 1.0) == Approx(1.0).epsilon(1e-12));
    b.spin = 1e-4;
    b.vx = b.spin * (b.z - 0.1);
    b.vz = -b.spin * (b.x - 0.05);
    CHECK(dem::slip_of(o, a, b) == Approx(0.0).margin(1e-15));
}

TEST_CASE("overlap: sides that press on each other may close deeply, those that come from "
          "beside may not",
          "[dem][overlap]")
{
    const auto share = [](double closed, double before) {
        const auto o = dem::overlap_of(bed_joint(), frame(0.0, 0.05, 0.0),
                                       frame(0.02, 0.15 - closed, 0.0), 0.5);
        return dem::share_of(bed_joint(), o, before);
    };
    const double touching = GENERATE(1e-6, 0.8, 1.0); // share of one step earlier
    CHECK(share(0.039, touching) == Approx(0.8));     // four fifths of `deepest`
    CHECK(share(0.041, touching) == 0.0);
    CHECK(share(0.004, 0.0) == Approx(0.8));
    CHECK(share(0.006, 0.0) == 0.0);
}

TEST_CASE("overlap: a block that slides over head joints rests on the same area all the way, "
          "without a jump",
          "[dem][overlap]")
{
    const dem::Model m = small_wall::model();
    const dem::StepTables t = dem::step_tables(m);
    const dem::FiniteTables& f = t.finite;
    REQUIRE(!f.reaches.empty());
    const auto at = [&](int block, double slide) {
        return frame(f.blocks[block].x + slide, f.blocks[block].z, 0.0);
    };
    for (const dem::FiniteTables::Reach& r : f.reaches) {
        const dem::FacePair& home = f.pairs[r.home];
        // Only this block moves, and its neighbours under it are whole.
        if (r.count < 2) continue;
        double last = 1.0;
        for (int i = 0; i <= 180; ++i) {
            const double slide = (r.far ? 1.0 : -1.0) * 1e-3 * i;
            const Frame b = at(home.b, slide);
            double share =
                dem::share_of(home, dem::overlap_of(home, at(home.a, 0.0), b, 0.5), 1.0);
            for (int row = r.first; row < r.first + r.count; ++row) {
                const dem::FacePair& p = f.further[row];
                share += dem::share_of(p, dem::overlap_of(p, at(p.a, 0.0), b, 0.5), 0.0);
            }
            if (share < 1.0 - 3.0 * dem::kRoundedCorner || share > 1.0 + 1e-9 ||
                std::abs(share - last) > 0.0101)
                FAIL("pair " << r.home << " at " << slide << ": " << share << " after "
                             << last);
            last = share;
        }
    }
}
