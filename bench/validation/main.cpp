/// The paper and the tests against our walls: writes DOCS/validation.md and its pictures from
/// the files that bench/validation.sh leaves in WORK.
///
///   ./drystone validate           runs everything, then
///   validation WORK DOCS
///   ./drystone validate --end     runs the walls of the last section, then writes that section
///   anew
///   validation WORK DOCS --end

#include "app/fragility/fragility_means.hpp"
#include "app/output/atomic_output.hpp"
#include "bench/limit_drifts.hpp"
#include "bench/machine.hpp"
#include "bench/validation/damping_table.hpp"
#include "bench/validation/effects.hpp"
#include "bench/validation/joint_inputs.hpp"
#include "bench/validation/mechanisms.hpp"
#include "bench/validation/numerical_scatter.hpp"
#include "bench/validation/paper_comparison.hpp"
#include "bench/validation/pictures.hpp"
#include "bench/validation/remarks.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;

/// A page that grows, and its pictures.
struct Page {
    std::string text;
    std::vector<app::NamedPicture> pictures;

    void write(const std::string& paragraph) { text += paragraph + "\n\n"; }
    void show(const app::Table& table) { text += app::as_markdown(table) + "\n"; }
    void show(const std::vector<app::NamedPicture>& all)
    {
        for (const app::NamedPicture& p : all) {
            text += "![" + p.title + "](validation/" + p.name + ".svg)\n";
            pictures.push_back(p);
        }
        text += "\n";
    }
};

/// Captions and tables are written for these levels and sizes.
void check_levels(const std::vector<bench::LevelStatistics>& levels, std::size_t stresses,
                  std::size_t walls, const fs::path& file)
{
    if (levels.size() != stresses)
        throw std::runtime_error(file.string() + ": not " + std::to_string(stresses) +
                                 " stress levels");
    for (const bench::LevelStatistics& l : levels)
        if (l.walls + l.failed != walls || l.walls == 0)
            throw std::runtime_error(file.string() + ": not " + std::to_string(walls) +
                                     " walls under each stress");
}

/// The other reading of jerky curves, of each level.
std::vector<bench::Sample> last_falls(const fs::path& work)
{
    const std::vector<std::string> last = {"fragility.crossing=last",
                                           "fragility.limit_states=paper"};
    const app::StudyWalls walls = app::read_study_walls(work / "large.h5", last);
    std::vector<bench::Sample> falls;
    for (std::size_t l = 0; l < walls.levels.size(); ++l)
        falls.push_back(bench::last_falls_mm(walls, l));
    return falls;
}

constexpr const char* kPushedToTheEnd = "## 8. Pushed to the end"; // the last section

/// Page on the paper's walls when they are pushed on, with blocks that turn.
Page pushed_to_the_end(const fs::path& work)
{
    const app::StudyWalls paper = app::read_study_walls(work / "paper.h5", {}),
                          collapse = app::read_study_walls(work / "collapse.h5", {});
    check_levels(bench::level_statistics(paper), 5, 50, work / "paper.h5");
    check_levels(bench::level_statistics(collapse), 5, 50, work / "collapse.h5");
    Page page;
    page.write(kPushedToTheEnd);
    page.write("Written by `./drystone validate --end` on " + bench::machine_line() + ".");
    app::Table t;
    t.caption = "The paper's walls, 50 under each stress, the same samples in both rows.";
    t.head = bench::limit_head();
    for (std::size_t l = 0; l < paper.levels.size(); ++l) {
        t.rows.push_back(
            bench::limit_row("small displacements, 30 mm, as in the paper", paper, l));
        t.rows.push_back(
            bench::limit_row("finite displacements, pushed to zero force", collapse, l));
    }
    page.write(
        "With small displacements the lever arm of the vertical load never shrinks: a wall "
        "that rocks or slides keeps its load, and a wall that stands at 30 mm is censored. "
        "Here the walls of `configs/collapse.ini` are pushed until no force is left. Their "
        "blocks turn and slide by any amount under a load that moves with the beam, with the "
        "default damping and six modes per block. A number after > means that fewer walls than "
        "this share fell to 80 % before their push ended; brackets hold 95 % intervals by "
        "Kaplan and Meier. For other vertical loads, double bending, crushing and cracks at "
        "the toe see [limits.md](limits.md).");
    page.show(t);
    page.show(bench::limits_by_mode(collapse));
    return page;
}

Page page_of(const fs::path& work)
{
    const auto read = [&](const char* name) { return app::read_study_walls(work / name, {}); };
    const app::StudyWalls paper = read("paper.h5"), large = read("large.h5"),
                          spatial = read("spatial.h5"),
                          spatial_large = read("spatial_large.h5"),
                          independent = read("spatial_independent.h5");
    const bench::OurLevels ours{bench::level_statistics(paper), bench::level_statistics(large)};
    check_levels(ours.same_size, 5, 50, work / "paper.h5");
    check_levels(ours.large, 5, 500, work / "large.h5");
    const auto combined = bench::read_levels(work / "large_combined.h5");
    check_levels(combined, 5, 500, work / "large_combined.h5");
    const auto rigid = bench::read_levels(work / "rigid_limit.h5");
    check_levels(rigid, 1, 500, work / "rigid_limit.h5");
    const bench::JointInputs joint_inputs = bench::joint_inputs(work);
    const app::Table effects = bench::effects_table(paper, work / "effects");

    Page page;
    page.write("# Validation: the paper and the tests against Drystone");
    page.write("Written by `./drystone validate` on " + bench::machine_line() +
               "; every number comes from the studies that this command runs. One set of "
               "choices holds for all five stress levels ([model.md](model.md), section 6). "
               "Three choices were made after a first comparison: the rule of modes, the "
               "paper's damping (Eq. 1) in its two studies in place of the program's default, "
               "and the weight of the beam (section 6).");
    page.write("## 1. One wall with mean values, and the tests");
    page.write(bench::remarks_on_tests(paper.study));
    for (const char* stress : {"0.15", "0.50", "0.75", "1.00", "1.25"})
        page.text += "![" + std::string(stress) + " MPa](tests/" + stress + "_MPa.svg)\n";
    page.write("\nThe five pictures above correspond to Fig. 6; numbers in "
               "[tests/comparison.md](tests/comparison.md). The next one corresponds to Fig. "
               "7, coupled against uncoupled law at 1.25 MPa:");
    page.write("![laws](tests/laws.svg)");
    page.show(bench::test_table(ours));
    page.write("## 2. All walls");
    page.show(bench::pooled_peaks(ours));
    page.write("## 3. Modes");
    page.show(bench::rocking_shares(ours));
    page.write(bench::what_differs(ours));
    page.show({bench::rocking_over_stress(ours.large)});
    page.show(bench::rocking_table(ours));
    page.show(bench::mixed_table(ours));
    page.show(bench::mixed_displacements(ours));
    page.show(bench::damping_table(ours.large, combined));
    page.write("## 4. Values per joint");
    page.show(bench::spatial_table(ours.large[2],
                                   bench::level_statistics(spatial_large).front(),
                                   bench::level_statistics(independent).front()));
    page.show(bench::joint_inputs_table(joint_inputs));
    page.write("As Fig. 14 of the paper, 100 walls:");
    page.show(bench::all_curves(spatial, "fig14"));
    page.write("## 5. What the paper leaves open");
    page.show(effects);
    std::vector<app::StudyWalls> discretisations = {paper};
    for (const char* file : {"points_7", "modes_6", "modes_all", "drive_slow"})
        discretisations.push_back(read(("effects/" + std::string(file) + ".h5").c_str()));
    page.show(bench::numerical_scatter(
        discretisations,
        "the discretisation of the study, 7 contact points, 6 modes, all zones "
        "of a block, and a push 3 times as slow"));
    page.write("## 6. Where we differ, and why");
    const auto changed = [&](const char* file) {
        return bench::read_levels(work / "effects" / file);
    };
    page.write(bench::remarks_on_differences(
        {ours, last_falls(work), bench::level_statistics(spatial_large).front(), rigid.front(),
         changed("load_height_1.05.h5"), changed("beam_light.h5"), changed("damping_0.5.h5"),
         changed("damping_0.95.h5"), changed("combined.h5"), joint_inputs}));
    page.write("## 7. The other figures");
    page.write("Figs. 3 and 4, the laws of a crack and of a joint, each curve by moving one "
               "contact (`./drystone scene configs/wall.ini` writes it):");
    page.write("![Laws of the contacts](pictures/laws.svg)");
    page.write("Fig. 8, walls of mean values under the stresses of the tests, at the peak and "
               "at the end:");
    for (const char* stress : {"0.15", "0.50", "1.00", "1.25"})
        page.text += "![Wall of mean values under " + std::string(stress) +
                     " MPa](pictures/wall_" + stress + ".svg)\n";
    page.text += "\n";
    page.write("Fig. 9, inputs of the 250 walls and their prescribed densities:");
    page.show(bench::input_histograms(paper));
    page.write("Fig. 10, error of the mean of each input:");
    page.show({bench::running_errors(paper)});
    page.write("Fig. 11, all 250 curves, and how walls of each mode end:");
    page.show(bench::all_curves(paper, "fig11"));
    page.show({bench::mechanisms(work / "paper.h5", paper)});
    page.write("Fig. 12, peak force against the inputs:");
    page.show(bench::peaks_over_inputs(paper));
    page.write("Fig. 15, mean force over drift of each mode, with 16 and 84 % of the walls:");
    auto means = app::mean_curve_pictures(large);
    for (app::NamedPicture& p : means) p.name = "fig15_" + p.name;
    page.show(means);
    page.show(bench::drifts_of_mean_curves(large));
    page.text += pushed_to_the_end(work).text;
    return page;
}

/// The page as it stands with its last section written anew.
std::string with_new_end(const fs::path& file, const std::string& section)
{
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t at = text.find(kPushedToTheEnd);
    if (at == std::string::npos)
        throw std::runtime_error(file.string() + ": no line \"" + kPushedToTheEnd + "\"");
    return text.replace(at, std::string::npos, section);
}

int run(int argc, char** argv)
{
    const bool end = argc == 4 && argv[3] == std::string("--end");
    if (argc != 3 && !end) {
        std::cerr << "usage: validation WORK DOCS [--end]\n";
        return 2;
    }
    const fs::path docs = argv[2];
    // Everything is read before anything is written.
    Page page = end ? pushed_to_the_end(argv[1]) : page_of(argv[1]);
    if (end) page.text = with_new_end(docs / "validation.md", page.text);
    app::make_folder(docs / "validation");
    for (const app::NamedPicture& p : page.pictures)
        app::write_file(docs / "validation" / (p.name + ".svg"), p.svg);
    app::write_file(docs / "validation.md", page.text);
    std::cerr << "wrote " << (docs / "validation.md").string() << " and "
              << page.pictures.size() << " pictures\n";
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "validation: " << e.what() << '\n';
        return 1;
    }
}
