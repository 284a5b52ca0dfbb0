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
    std::string text = "# Cyclic pushes\n\nWritten by `./drystone cyclic` on " +
                       bench::machine_line() +
                       ". What is read off cycles: [model.md](model.md), section 5.\n\n";
    text +=
        "## 1. Closed forms\n\n" + app::as_markdown(bench::block_loops()) +
        "\nWhat a rocking block loses is friction: contact points that unload slip, and "
        "come into contact again at "
        "another place. A block whose toe is held hardly does; the solver takes next to "
        "nothing. Neither more contact points nor a slower drive takes that friction "
        "away:\n\n" +
        app::as_markdown(bench::rocking_loops()) +
        "\nThat friction is the wall's. A rigid block on the same springs and friction that is "
        "in balance at every moment loses the same (tests/scenes/rocking_statics.hpp), and "
        "with finite displacements nearly so:\n\n" +
        app::as_markdown(bench::rocking_in_balance()) +
        "\nWhere the joint opens, a point loses its compression while it still carries shear: "
        "it slips, and comes into contact again without shear. More friction lets fewer points "
        "slip before they open, but a point that opens gives up its shear whatever its "
        "friction. What the solver takes is in the column beside.\n\n";
    text += "## 2. Speed of the drive\n\n" + app::as_markdown(bench::loops_over_speed()) +
            "\nThe solver's damping is no property of the wall. Its share of small loops "
            "shrinks with the speed; of large "
            "ones it is what cracks and jumps leave to be damped.\n\n";
    text += "## 3. Cost\n\n" + app::as_markdown(bench::protocol_cost()) +
            "\nThe drive brakes before turns, and starts as softly after them.\n\n";
    text += "## 4. The paper's walls\n\n`configs/paper.ini`, " + n +
            " walls under each stress, with the default damping (`solver.damping = combined`) "
            "because the paper's drags, "
            "which a loop would show as energy of the wall. One way to 30 mm, and cycles of 3, "
            "6, 10, 15, 20 and 30 mm, read "
            "on the mean of both backbones.\n\n";
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
