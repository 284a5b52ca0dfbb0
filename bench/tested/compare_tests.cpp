/// Our walls against the measured ones: a picture per stress level and two tables.
///
///   drystone push configs/levels.ini --out runs/levels
///   drystone push configs/uncoupled.ini --out runs/uncoupled
///   compare_tests runs/levels EXPERIMENTS_DIR runs/comparison [runs/uncoupled]
///
/// With the last argument also laws.svg: coupled against uncoupled law at 1.25 MPa, as Fig. 7
/// of the paper. EXPERIMENTS_DIR: the digitised curves, see bench/tested/measured_walls.hpp.

#include "app/output/atomic_output.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/text/number_text.hpp"
#include "bench/tested/comparison.hpp"
#include "bench/tested/curve_table.hpp"
#include "bench/tested/measured_walls.hpp"
#include "fragility/curve/curve_reading.hpp"

#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Output {
    std::vector<std::pair<std::string, std::string>> files; ///< name, content
    std::vector<bench::LevelComparison> levels;
};

struct OurCurve {
    std::string name;
    bench::CurveTable table;
    app::LineStyle line = app::LineStyle::solid;
};

std::string picture(const std::string& title, const std::vector<OurCurve>& ours,
                    const std::vector<bench::MeasuredWall>& tests)
{
    app::Chart chart;
    chart.title = title;
    chart.x_label = "Top displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    for (const bench::MeasuredWall& t : tests)
        chart.series.push_back({.name = "test " + t.name,
                                .x = t.table.displacement_mm,
                                .y = t.table.force_kN,
                                .width = 1.3});
    for (const OurCurve& c : ours)
        chart.series.push_back({.name = c.name,
                                .x = c.table.displacement_mm,
                                .y = c.table.force_kN,
                                .colour = "#111",
                                .line = c.line,
                                .width = 2.4});
    return app::line_chart(chart);
}

Output compare(const fs::path& study, const fs::path& experiments)
{
    Output out;
    for (const bench::StressLevel& level : bench::kLevels) {
        const fs::path file = study / level.folder / "capacity.csv";
        if (!fs::exists(file)) {
            std::cerr << "no " << file.string() << ": level left out\n";
            continue;
        }
        const bench::CurveTable ours = bench::read_capacity_curve(file);
        const auto tests = bench::read_series(experiments, level.series);
        if (tests.empty() && !level.series.empty())
            throw std::runtime_error(experiments.string() + ": no files FD_SW" +
                                     std::string(level.series) + "*.csv");
        bench::LevelComparison row{level.stress_MPa, bench::facts("drystone", ours), {}};
        for (const bench::MeasuredWall& t : tests)
            row.tests.push_back(bench::facts(t.name, t.table));
        out.levels.push_back(std::move(row));
        out.files.emplace_back(
            std::string(level.folder) + ".svg",
            picture("Vertical stress " + app::fixed(level.stress_MPa, 2) + " MPa",
                    {{"Drystone", ours}}, tests));
    }
    if (out.levels.empty())
        throw std::runtime_error(study.string() + ": no level folder such as 0.50_MPa");
    out.files.emplace_back("comparison.md", bench::comparison_markdown(out.levels));
    out.files.emplace_back("comparison.csv", bench::comparison_csv(out.levels));
    return out;
}

/// Fig. 7: both laws at 1.25 MPa over the test.
std::string laws(const fs::path& study, const fs::path& uncoupled, const fs::path& experiments)
{
    return picture(
        "Coupled and uncoupled law, 1.25 MPa",
        {{"coupled", bench::read_capacity_curve(study / "1.25_MPa" / "capacity.csv")},
         {"uncoupled", bench::read_capacity_curve(uncoupled / "capacity.csv"),
          app::LineStyle::dashed}},
        bench::read_series(experiments, "250"));
}

int run(int argc, char** argv)
{
    if (argc != 4 && argc != 5) {
        std::cerr << "usage: compare_tests STUDY_OUT_DIR EXPERIMENTS_DIR OUT_DIR "
                     "[UNCOUPLED_OUT_DIR]\n";
        return 2;
    }
    const fs::path folder = argv[3];
    Output out = compare(argv[1], argv[2]); // everything is read before anything is written
    if (argc == 5) out.files.emplace_back("laws.svg", laws(argv[1], argv[4], argv[2]));
    app::make_folder(folder);
    for (const auto& [name, content] : out.files) app::write_file(folder / name, content);
    std::cerr << "wrote " << out.files.size() << " files to " << folder.string() << '\n';
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "compare_tests: " << e.what() << '\n';
        return 1;
    }
}
