#include "app/text/number_text.hpp"
#include "bench/speed/scaling_parts.hpp"
#include "bench/speed/step_time.hpp"
#include "bench/speed/work_count.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/rubble.hpp"
#include "scenes/paper_wall.hpp"

#include <iostream>
#include <string>
#include <utility>

namespace bench {

namespace {

struct Wall {
    std::string name;
    scenes::Scene scene;
    dem::Model model;
};

Wall running_bond(const std::string& name, int courses, bool cracks)
{
    Wall w{name, scenes::paper_wall(0.75), {}};
    if (!cracks) w.scene.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    w.scene.wall.courses = courses;
    w.scene.wall.length = w.scene.wall.course_height * courses;
    w.scene.loads.height = w.scene.wall.length + w.scene.beam.height;
    dem::Discretisation d;
    d.zones_per_interval = 1; // long beams
    w.model = scenes::model_of(w.scene, d);
    return w;
}

/// Twice as long as high.
Wall rubble(double height)
{
    Wall w{"rubble", scenes::paper_wall(0.75), {}};
    dem::DrawnWall drawn;
    for (dem::Outline& outline : dem::rubble({.length = 2.0 * height, .height = height}))
        drawn.units.push_back({std::move(outline)});
    w.scene.loads.height = height + w.scene.beam.height;
    w.model = dem::discretise(dem::drawn_layout(drawn, w.scene.beam.height), w.scene.stone,
                              w.scene.beam, w.scene.loads, {w.scene.joint, w.scene.crack});
    return w;
}

template <class Real>
double contact_time(const Wall& wall, const dem::StepTables& t, dem::Kinematics kinematics)
{
    dem::SolverOptions options;
    options.kinematics = kinematics;
    const double step = step_time<Real>(
        wall.model, t, options, [&](int) { return scenes::uniform(wall.scene, wall.model); });
    return step / (1.0 * t.n_contacts * dem::lanes<Real>);
}

} // namespace

app::Table stone_table()
{
    app::Table table;
    table.head = {"wall", "blocks", "contacts", "matrices [MB]"};
    const std::string walls = std::to_string(dem::lanes<dem::Pack>) + " walls";
    for (const std::string& displacements : {std::string("small, "), std::string("finite, ")})
        for (const std::string& how : {std::string("alone"), walls})
            table.head.push_back(displacements + how + " [ns]");
    const auto add = [&](const Wall& w) {
        const dem::StepTables t = dem::step_tables(w.model);
        app::Row row{w.name, std::to_string(t.blocks.size()), std::to_string(t.n_contacts),
                     app::fixed(1e-6 * static_cast<double>(work_of(t).matrix_bytes), 1)};
        for (const dem::Kinematics k : {dem::Kinematics::small, dem::Kinematics::finite}) {
            row.push_back(app::fixed(1e9 * contact_time<double>(w, t, k), 1));
            row.push_back(app::fixed(1e9 * contact_time<dem::Pack>(w, t, k), 1));
        }
        table.rows.push_back(std::move(row));
        std::cerr << w.name << ", " << t.blocks.size() << " blocks\n";
    };
    add(running_bond("the paper's", 10, true));
    for (const int courses : {10, 20, 44, 58})
        add(running_bond("running bond", courses, false));
    for (const double height : {0.8, 1.1, 1.55, 2.2, 4.5}) add(rubble(height));
    return table;
}

} // namespace bench
