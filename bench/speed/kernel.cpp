/// kernel [OUT.md]: what one step costs on one core, rung by rung of the fidelity ladder,
/// against what the core could do, measured in the same run.

#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/report.hpp"
#include "bench/speed/core_speed.hpp"
#include "bench/speed/pushed_walls.hpp"
#include "bench/speed/shortest.hpp"
#include "bench/speed/work_count.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr double kStress = 0.75;   // [MPa]
constexpr int kStepsBefore = 3000; // about 3 mm: joints open and slide
constexpr double kChunk = 0.01;    // [s] timed at a time, so that what disturbs it shows
constexpr int kChunks = 60;        // as kOpening says

struct Rung {
    const char* name;
    dem::Fidelity fidelity;
};

constexpr Rung kRungs[] = {{"rigid", dem::Fidelity::rigid},
                           {"simple", dem::Fidelity::simple},
                           {"standard", dem::Fidelity::standard},
                           {"zones", dem::Fidelity::zones},
                           {"fine", dem::Fidelity::fine}};

struct Measured {
    std::string rung, numbers;
    int lanes = 1;
    double seconds = 0.0;  ///< per step
    double products = 0.0; ///< multiply-adds per second of the port products in the first cache
    bench::StepWork work;
    bench::Traffic traffic;
};

/// Roofs of the core.
struct Roofs {
    double peak = 0.0; ///< [multiply-adds/s]
    void measure() { peak = std::max(peak, bench::multiply_add_peak()); }
};

/// Gather and scatter of the first free block, again and again: multiply-adds per second.
template <class Real> double product_speed(bench::PushedWalls<Real>& w)
{
    const auto& block = w.tables.blocks[w.tables.blocks.size() / 2];
    const dem::ContactOperator& matrix = w.tables.matrices[block.element];
    const int* contact = w.tables.port_contact.data() + block.first_port;
    constexpr int kRounds = 500;
    const double seconds = bench::shortest(kChunks, [&] {
        for (int i = 0; i < kRounds; ++i) {
            dem::gather(matrix, contact, w.tables.area.data(), w.state.stress.data(),
                        w.state.block_force.data());
            dem::scatter(matrix, contact, w.state.v.data() + block.first_mode,
                         w.state.du.data());
        }
    });
    return 4.0 * matrix.ports * matrix.modes * dem::lanes<Real> * kRounds / seconds;
}

template <class Real> Measured measure(const Rung& rung, const char* numbers)
{
    const scenes::Scene scene = scenes::paper_wall(kStress);
    auto walls =
        bench::pushed_walls<Real>(scene, dem::discretisation_of(rung.fidelity), kStepsBefore);
    const double once = bench::shortest(20, [&] { bench::push_on(walls, 1); });
    const int steps = std::max(1, static_cast<int>(kChunk / once));
    const double chunk = bench::shortest(kChunks, [&] { bench::push_on(walls, steps); });
    Measured m;
    m.rung = rung.name;
    m.numbers = numbers;
    m.lanes = dem::lanes<Real>;
    m.seconds = chunk / steps;
    m.work = bench::work_of(walls.tables);
    m.traffic = bench::traffic_of(m.work, sizeof(Real));
    m.products = product_speed(walls);
    return m;
}

double mega(double x) { return 1e-6 * x; }

app::Table speed_table(const std::vector<Measured>& all, const Roofs& roofs)
{
    app::Table t;
    t.head = {"rung",
              "numbers",
              "lanes",
              "contacts",
              "step [us]",
              "contact updates [1e6/s]",
              "block-steps [1e6/s]",
              "multiply-adds per step and wall",
              "other operations",
              "multiply-adds of peak [%]",
              "all operations of peak [%]",
              "products alone of peak [%]"};
    for (const Measured& m : all) {
        const double per_second = m.lanes / m.seconds, peak = roofs.peak;
        const auto adds = static_cast<double>(m.work.multiply_adds),
                   others = static_cast<double>(m.work.operations);
        const auto percent = [](double x) { return app::fixed(100.0 * x, 1); };
        t.rows.push_back({m.rung, m.numbers, std::to_string(m.lanes),
                          std::to_string(m.work.contacts()), app::fixed(1e6 * m.seconds, 2),
                          app::fixed(mega(per_second * m.work.contacts()), 1),
                          app::fixed(mega(per_second * m.work.blocks), 2),
                          std::to_string(m.work.multiply_adds),
                          std::to_string(m.work.operations), percent(adds * per_second / peak),
                          percent((adds + others) * per_second / peak),
                          percent(m.products / peak)});
    }
    return t;
}

struct Law {
    const char* name;
    dem::Closure closure;
};

constexpr Law kLaws[] = {{"linear", dem::Closure::linear},
                         {"hyperbolic", dem::Closure::hyperbolic},
                         {"exponential", dem::Closure::exponential}};

/// Steps of the same walls with joints that close, over the step of joints that do not. The
/// laws take turns, so that what disturbs meets all of them.
app::Table closure_table()
{
    app::Table t;
    t.head = {"rung", "closure", "step [us]", "over the linear step [-]"};
    for (const Rung& rung : {kRungs[1], kRungs[2]}) {
        std::vector<bench::PushedWalls<dem::Pack>> walls;
        for (const Law& law : kLaws) {
            scenes::Scene scene = scenes::paper_wall(kStress);
            scene.closure = law.closure;
            scene.joint.closing = {4.87e9, 0.154e-3, 0.0, 487e9};
            walls.push_back(bench::pushed_walls<dem::Pack>(
                scene, dem::discretisation_of(rung.fidelity), kStepsBefore));
        }
        constexpr int kSteps = 100;
        std::vector<double> seconds(walls.size(), 1e9);
        for (int round = 0; round < 3 * kChunks; ++round)
            for (std::size_t i = 0; i < walls.size(); ++i)
                seconds[i] = std::min(
                    seconds[i], bench::shortest(1, [&] { bench::push_on(walls[i], kSteps); }));
        for (std::size_t i = 0; i < walls.size(); ++i)
            t.rows.push_back({rung.name, kLaws[i].name,
                              app::fixed(1e6 * seconds[i] / kSteps, 2),
                              app::fixed(seconds[i] / seconds[0], 3)});
    }
    return t;
}

app::Table roofline_table(const std::vector<Measured>& all, const Roofs& roofs)
{
    app::Table t;
    t.head = {"rung",
              "numbers",
              "state [kB]",
              "moved per step [kB]",
              "operations per byte",
              "bandwidth [GB/s]",
              "compute roof [us]",
              "memory roof [us]",
              "step [us]",
              "binds",
              "of the roof [%]"};
    for (const Measured& m : all) {
        const double operations =
            static_cast<double>(m.work.multiply_adds + m.work.operations) * m.lanes;
        const double bandwidth =
            bench::sweep_bandwidth(static_cast<std::size_t>(m.traffic.state));
        const double compute = operations / roofs.peak, memory = m.traffic.moved() / bandwidth;
        const double roof = std::max(compute, memory);
        t.rows.push_back({m.rung, m.numbers, app::fixed(1e-3 * m.traffic.state, 0),
                          app::fixed(1e-3 * m.traffic.moved(), 0),
                          app::fixed(operations / m.traffic.moved(), 2),
                          app::fixed(1e-9 * bandwidth, 1), app::fixed(1e6 * compute, 2),
                          app::fixed(1e6 * memory, 2), app::fixed(1e6 * m.seconds, 2),
                          compute > memory ? "compute" : "memory",
                          app::fixed(100.0 * roof / m.seconds, 0)});
    }
    return t;
}

constexpr const char* kOpening =
    R"(One core, the paper's wall at 0.75 MPa, random walls (Table 5, one draw per joint) after 3000 steps of the
push, still being pushed. Shortest of 60 runs of about 10 ms.

Multiply-add peak, measured between the rungs with independent chains in registers, all lanes counted:)";

constexpr const char* kSpeedText =
    R"(Multiply-adds: of the port products, 2 products x 2 rows x ports x modes, summed over the blocks. Other
operations: sums, products, signs, comparisons and selections of modes and laws as written, each as costly as a
multiply-add. What cracks that open take besides is in the time and not in the count. Products alone: gather and
scatter of one block again and again, everything in the first cache. Scalar rows are held against the same peak.)";

constexpr const char* kRooflineText =
    R"(State: all that a step touches, matrices included. Moved: read and written at least, when neither pass
(blocks, contacts) finds anything of the other in the first cache. Bandwidth: x = a x over as many bytes, both ways
counted. Compute roof: all operations at the multiply-add peak.)";

constexpr const char* kClosureText =
    R"(The same walls with dry joints that close, k_0 = 4.87 GPa/m, V = 0.154 mm, at most 487 GPa/m, no loss, in
registers. The three laws take turns; shortest of 180 runs of 100 steps.)";

/// Text that says what each operation count is made of.
std::string counted()
{
    const auto per = [](int n, const char* what) { return std::to_string(n) + " per " + what; };
    return per(bench::kModeOperations, "mode, ") + per(bench::kPortOperations, "port, ") +
           per(bench::kDryOperations, "dry contact, ") +
           per(bench::kTiedOperations, "tied contact, ") +
           per(bench::kCrackOperations, "crack that holds");
}

bench::Report report_of(const std::vector<Measured>& all, const Roofs& roofs)
{
    bench::Report r;
    r.title = "Kernel";
    r.opening = std::string(kOpening) + " **" + app::fixed(1e-9 * roofs.peak, 1) + "e9/s**.";
    r.sections.push_back({"", "Speed",
                          std::string(kSpeedText) + "\n\nCounted: " + counted() + ".",
                          speed_table(all, roofs)});
    r.sections.push_back({"roofline", "Roofline", kRooflineText, roofline_table(all, roofs)});
    r.sections.push_back({"closure", "Closure of joints", kClosureText, closure_table()});
    return r;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc > 2) {
        std::cerr << "usage: kernel [OUT.md]\n";
        return 2;
    }
    std::vector<Measured> all;
    Roofs roofs;
    for (const Rung& rung : kRungs) {
        std::cerr << rung.name << '\n';
        roofs.measure();
        all.push_back(measure<dem::Pack>(rung, "register"));
        all.push_back(measure<double>(rung, "scalar"));
    }
    const bench::Report report = report_of(all, roofs);
    std::cout << bench::machine_line() << "\n"
              << bench::cache_line() << "\n\n"
              << report.opening << "\n";
    for (const bench::Section& s : report.sections) std::cout << '\n' << app::as_text(s.table);
    if (argc == 2) bench::write_report(argv[1], report);
    return 0;
}
