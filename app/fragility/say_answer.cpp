#include "app/fragility/say_answer.hpp"

#include "app/fragility/numbers/answer_table.hpp"
#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/table/table.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_walls.hpp"

#include <iostream>

namespace app {

void say_answer(const std::string& file, bool quiet)
{
    Progress progress(std::cerr, stderr_progress(quiet), steady_seconds);
    const StudyWalls walls = read_study_walls(file, {});
    DriftData data = drift_data(walls);
    choose_limits(data, [&](double done, const std::string& fit) {
        end_if_interrupted();
        progress.update(done, "testing the fit of " + fit);
    });
    progress.finish("tested all fits");
    const Table table = answer_table(walls, data);
    std::cout << '\n' << table.title << '\n' << as_text(table, terminal_width());
    std::cout << wrapped("All tables: drystone fragility " + file + "\n", terminal_width());
}

} // namespace app
