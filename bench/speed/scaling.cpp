/// scaling [OUT.md | samples | threads | blocks | stones]: what the cost does when samples,
/// cores or blocks become more.

#include "bench/machine.hpp"
#include "bench/report.hpp"
#include "bench/speed/scaling_parts.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>

namespace {

constexpr const char* kSamplesText =
    R"(Two courses of 0.4 m, rigid blocks, pushed by 0.5 mm, all cores; results streamed into a mean. Peak memory:
largest resident set of the program during the row.)";

constexpr const char* kThreadsText =
    R"(The paper's wall at 0.75 MPa, random walls (Table 5), pushed by 12 mm at default settings. Median of three, one
and all cores in turns. At most: by the steps of these walls, with nothing lost but the lanes that the last ones leave
empty.)";

constexpr const char* kBlocksText =
    R"(The paper's wall made wider and higher with the same units, default settings. One core. Model: discretised and
tabulated, once for all walls; in wide walls nearly all of it is the beam's dense eigenvalue problem (here with one
zone between contact points, which steps do not feel). One wall alone in plain doubles, and a register of walls:
memory that a step touches, cost of a block-step per wall, the same against the smallest wall, and the speed at which
memory is moved (least amount, see kernel.md). Shortest of 30 runs after a ramp of the load.)";

constexpr const char* kStonesText =
    R"(Random stones (`wall.bond = rubble`, 0.2 x 0.1 m, dry) beside walls of equal units. Default settings, one core. Units
of one shape share the matrices of their modes; each stone has its own. Cost of a contact point, a step and a wall: of one wall alone in plain
doubles, and in a register of walls. Shortest of 30 runs after a ramp of the load.)";

struct Part {
    const char *name, *title, *text;
    app::Table (*measure)();
};

// Samples first: what they need must not hide behind the memory of a large wall.
constexpr Part kParts[] = {{"samples", "Samples", kSamplesText, bench::sample_table},
                           {"threads", "Threads", kThreadsText, bench::thread_table},
                           {"blocks", "Blocks", kBlocksText, bench::block_table},
                           {"stones", "Stones", kStonesText, bench::stone_table}};

} // namespace

int main(int argc, char** argv)
{
    const std::string argument = argc > 1 ? argv[1] : "";
    const bool write = argument.ends_with(".md");
    const bool known = write || argument.empty() ||
                       std::any_of(std::begin(kParts), std::end(kParts),
                                   [&](const Part& p) { return argument == p.name; });
    if (argc > 2 || !known) {
        std::cerr << "usage: scaling [OUT.md | samples | threads | blocks | stones]\n";
        return 2;
    }
    bench::Report report{"Scaling", "", {}};
    std::cout << bench::machine_line() << '\n' << bench::cache_line() << '\n';
    for (const Part& part : kParts) {
        if (!write && !argument.empty() && argument != part.name) continue;
        const app::Table table = part.measure();
        std::cout << '\n' << app::as_text(table) << std::flush;
        report.sections.push_back({part.name, part.title, part.text, table});
    }
    if (write) bench::write_report(argument, report);
    return 0;
}
