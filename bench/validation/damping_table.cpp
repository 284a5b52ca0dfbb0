#include "bench/validation/damping_table.hpp"

#include "app/text/number_text.hpp"
#include "bench/validation/cells.hpp"
#include "bench/validation/paper_tables.hpp"

namespace bench {

app::Table damping_table(const std::vector<LevelStatistics>& local,
                         const std::vector<LevelStatistics>& combined)
{
    app::Table t;
    t.caption = "The paper's damping (local, Eq. 1), used in the tables above, and the default "
                "of the program (combined; model.md, section 4): the same 500 walls under each "
                "stress. [95 % intervals].";
    t.head = {"stress [MPa]",        "peak, paper [kN]",
              "peak, local",         "peak, combined",
              "rocking, paper [%]",  "rocking, local",
              "rocking, combined",   "mixed, displacement, paper [mm]",
              "displacement, local", "displacement, combined"};
    const auto rocking = [](const LevelStatistics& s) {
        return share_cell(s.rocking_walls, s.walls);
    };
    const auto displacement = [](const LevelStatistics& s) {
        return with_interval(s.mixed.displacement_mm, 1);
    };
    for (std::size_t l = 0; l < kPaperLevels.size(); ++l) {
        const PaperLevel& p = kPaperLevels[l];
        t.rows.push_back(
            {app::fixed(p.stress_MPa, 2), app::fixed(pooled_peak(p), 2),
             with_interval(local[l].peak_kN, 2), with_interval(combined[l].peak_kN, 2),
             share_cell(static_cast<std::size_t>(p.rocking_walls),
                        static_cast<std::size_t>(p.walls)),
             rocking(local[l]), rocking(combined[l]),
             p.mixed ? app::fixed(p.mixed->displacement_mm, 1) : "none",
             p.mixed ? displacement(local[l]) : "", p.mixed ? displacement(combined[l]) : ""});
    }
    return t;
}

} // namespace bench
