#include "app/text/number_text.hpp"
#include "bench/speed/scaling_parts.hpp"
#include "bench/speed/shortest.hpp"
#include "bench/speed/step_time.hpp"
#include "bench/speed/work_count.hpp"
#include "scenes/paper_wall.hpp"

#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace bench {

namespace {

/// The paper's wall, n times as long and high.
scenes::Scene large_wall(int courses)
{
    scenes::Scene s = scenes::paper_wall(0.75);
    s.wall.courses = courses;
    s.wall.length = s.wall.course_height * courses;
    s.loads.height = s.wall.length + s.beam.height;
    return s;
}

struct Measured {
    double state = 0.0; ///< [bytes]
    double each = 0.0;  ///< block-step of one wall [s]
    double speed = 0.0; ///< of what is moved [bytes/s]
};

template <class Real>
Measured measure(const scenes::Scene& scene, const dem::Model& model,
                 const dem::StepTables& tables)
{
    const double step = step_time<Real>(model, tables, {}, [&](int lane) {
        return scenes::table5_spatial_sample(scene, model, lane);
    });
    const double blocks = static_cast<double>(tables.blocks.size());
    const Traffic t = traffic_of(work_of(tables), sizeof(Real));
    return {t.state, step / (blocks * dem::lanes<Real>), t.moved() / step};
}

void add(const Measured& m, const Measured& smallest, app::Row& row)
{
    row.push_back(app::fixed(1e-6 * m.state, 1));
    row.push_back(app::fixed(1e9 * m.each, 1));
    row.push_back(app::fixed(m.each / smallest.each, 2));
    row.push_back(app::fixed(1e-9 * m.speed, 1));
}

} // namespace

app::Table block_table()
{
    app::Table t;
    t.head = {"courses", "blocks", "contacts", "model [s]"};
    const std::string register_of = std::to_string(dem::lanes<dem::Pack>) + " walls";
    for (const std::string& walls : {std::string("alone"), register_of})
        for (const char* what : {" [MB]", " [ns]", ", against the first", " [GB/s]"})
            t.head.push_back(walls + what);
    Measured first_alone, first;
    for (const int courses : {10, 18, 32, 56, 100, 178, 316}) {
        const scenes::Scene scene = large_wall(courses);
        dem::Discretisation d;
        d.zones_per_interval = 1;
        dem::Model model;
        dem::StepTables tables;
        const double building = shortest(1, [&] {
            model = scenes::model_of(scene, d);
            tables = dem::step_tables(model);
        });
        const Measured alone = measure<double>(scene, model, tables),
                       walls = measure<dem::Pack>(scene, model, tables);
        if (t.rows.empty()) first_alone = alone, first = walls;
        app::Row row{std::to_string(courses), std::to_string(tables.blocks.size()),
                     std::to_string(tables.n_contacts), app::fixed(building, 2)};
        add(alone, first_alone, row);
        add(walls, first, row);
        t.rows.push_back(std::move(row));
        std::cerr << tables.blocks.size() << " blocks\n";
    }
    return t;
}

} // namespace bench
