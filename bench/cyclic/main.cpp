/// Cyclic pushes: writes DOCS/cyclic.md and its pictures from the studies that bench/cyclic.sh
/// leaves in WORK, and from single walls that it pushes itself.
///
///   ./drystone cyclic     runs everything, then
///   cyclic WORK DOCS

#include "app/fragility/fragility_cycles.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "bench/cyclic/single_walls.hpp"
#include "bench/cyclic/study_tables.hpp"
#include "bench/machine.hpp"

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace fs = std::filesystem;

/// The same walls must stand in both.
void check_same_walls(const bench::TwoStudies& both)
{
    const app::UqInput &a = both.one_way.study.uq, &b = both.cyclic.study.uq;
    if (a.seed != b.seed || a.samples != b.samples ||
        both.one_way.levels.size() != both.cyclic.levels.size())
        throw std::runtime_error("one_way.h5 and cyclic.h5 are not of the same walls");
}

std::string page_of(const bench::TwoStudies& both)
{
    const std::string n = std::to_string(both.cyclic.study.uq.samples);
    std::string text =
        "# Cyclic pushes\n\nWritten by `./drystone cyclic` on " + bench::machine_line() +
        ". [model.md](model.md), section 5, explains the numbers read off cycles.\n\n";
    text +=
        "## 1. Closed forms\n\n" + app::as_markdown(bench::block_loops()) +
        "\nA rocking block loses energy by friction: contact points that unload slip, and come "
        "into contact again at another place. A block with a held toe hardly slips; the solver "
        "takes almost nothing. Neither more contact points nor a slower push removes this "
        "friction:\n\n" +
        app::as_markdown(bench::rocking_loops()) +
        "\nThis friction belongs to the wall. A rigid block on the same springs and friction, "
        "computed in balance at every moment, loses the same energy "
        "(tests/scenes/rocking_statics.hpp), and nearly the same with finite "
        "displacements:\n\n" +
        app::as_markdown(bench::rocking_in_balance()) +
        "\nWhere the joint opens, a point loses its compression while it still carries shear: "
        "it slips, and comes into contact again without shear. With more friction fewer points "
        "slip before they open, but a point that opens gives up its shear at any friction. The "
        "column 'solver' has the energy that the solver takes.\n\n";
    text += "## 2. Speed of the push\n\n" + app::as_markdown(bench::loops_over_speed()) +
            "\nThe solver's damping is not a property of the wall. Its share of small loops "
            "shrinks with the speed; in large loops it takes the energy that cracks and jumps "
            "set free.\n\n";
    text += "## 3. Cost\n\n" + app::as_markdown(bench::protocol_cost()) +
            "\nThe load line brakes before turns, and starts as softly after them.\n\n";
    text += "## 4. The paper's walls\n\n`configs/paper.ini`, " + n +
            " walls under each stress, with the default damping (`solver.damping = combined`): "
            "the paper's damping drags moving blocks, and a loop would show this as energy of "
            "the wall. The walls are pushed one way to 30 mm, and in cycles of 3, 6, 10, 15, "
            "20 and 30 mm, read on the mean of both backbones.\n\n";
    text += "**Drift limits**\n\n" + app::as_markdown(bench::limit_table(both)) + "\n";
    text += "**Modes**\n\n" + app::as_markdown(bench::share_table(both)) + "\n";
    text += "## 5. Damping\n\n";
    for (const app::NamedPicture& p : app::cycle_pictures(both.cyclic))
        text += "![" + p.title + "](cyclic/" + p.name + ".svg)\n";
    app::Table damping = app::cycle_table(both.cyclic);
    damping.title.clear();
    return text + "\n" + app::as_markdown(damping);
}

int run(int argc, char** argv)
{
    if (argc != 3) {
        std::cerr << "usage: cyclic WORK DOCS\n";
        return 2;
    }
    const fs::path work = argv[1], docs = argv[2];
    const bench::TwoStudies both{app::read_study_walls(work / "one_way.h5"),
                                 app::read_study_walls(work / "cyclic.h5")};
    check_same_walls(both);
    const std::string page = page_of(both); // everything is read before anything is written
    app::make_folder(docs / "cyclic");
    for (const app::NamedPicture& p : app::cycle_pictures(both.cyclic))
        app::write_file(docs / "cyclic" / (p.name + ".svg"), p.svg);
    app::write_file(docs / "cyclic.md", page);
    std::cerr << "wrote " << (docs / "cyclic.md").string() << '\n';
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "cyclic: " << e.what() << '\n';
        return 1;
    }
}
