/// Joint laws: writes DOCS/joint_laws.md from the studies that bench/joint_laws.sh leaves in
/// WORK.
///
///   ./drystone joint_laws     runs everything, then
///   joint_laws WORK DOCS

#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/text/number_text.hpp"
#include "bench/joint_laws/findings.hpp"
#include "bench/joint_laws/laws.hpp"
#include "bench/machine.hpp"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Adds a study where it was run.
void add(bench::NamedStudies& studies, bench::LawStudies& all, const std::string& name,
         const std::string& file)
{
    if (auto study = all.read(file)) studies.push_back({name, std::move(*study)});
}

bench::NamedStudies of_laws(bench::LawStudies& all, const std::string& folder)
{
    bench::NamedStudies studies;
    for (const bench::JointLaw& law : bench::kJointLaws)
        add(studies, all, std::string(law.name), folder + "/" + std::string(law.file));
    return studies;
}

/// A speed of the push and a discretisation.
struct Setting {
    std::string name, file; ///< "3 %", "_fast"
    bool every_law = true;  ///< else the paper's laws, and all with hyperbolic closure
};

/// Each law as it stands in FOLDER and with the other settings.
std::vector<bench::NamedStudies> checks(bench::LawStudies& all, const std::string& folder,
                                        const std::vector<Setting>& settings)
{
    std::vector<bench::NamedStudies> laws;
    for (const bench::JointLaw& law : bench::kJointLaws) {
        bench::NamedStudies& studies = laws.emplace_back();
        for (const Setting& s : settings)
            if (s.every_law || law.file == bench::kPaperLaw || law.file == bench::kAllLaws)
                add(studies, all, std::string(law.name) + ", " + s.name,
                    folder + "/" + std::string(law.file) + s.file);
    }
    return laws;
}

bench::NamedStudies together(const std::vector<bench::NamedStudies>& parts)
{
    bench::NamedStudies all;
    for (const bench::NamedStudies& p : parts) all.insert(all.end(), p.begin(), p.end());
    return all;
}

/// A value of a key, as tables name it, and the file of its study.
struct Choice {
    std::string name, file; ///< "60 GPa/m", "limit_60"
};

/// By setting: the default first, which `mean/all_hyperbolic` is, then the other values of KEY.
std::vector<bench::NamedStudies> choices(bench::LawStudies& all, const std::string& key,
                                         const std::string& usual,
                                         const std::vector<Choice>& others,
                                         const std::vector<Setting>& settings)
{
    std::vector<bench::NamedStudies> by_setting;
    for (const Setting& s : settings) {
        bench::NamedStudies& studies = by_setting.emplace_back();
        const auto name = [&](const std::string& value) {
            return key + " = " + value + ", " + s.name;
        };
        add(studies, all, name(usual), "mean/" + std::string(bench::kAllLaws) + s.file);
        for (const Choice& c : others)
            add(studies, all, name(c.name), "choice/" + c.file + s.file);
    }
    return by_setting;
}

std::string number_tables(const bench::NamedStudies& studies,
                          std::span<const bench::TestedWall> tests, bool secants)
{
    using enum bench::WallNumber;
    const auto table = [&](const char* title, bench::WallNumber number) {
        return std::string(title) + "\n\n" +
               app::as_markdown(bench::mean_walls(studies, number, tests)) + "\n";
    };
    std::string text = table("Peak [kN]:", peak) + table("80 % drop [mm]:", drop);
    if (secants)
        text += table("Secant stiffness where 30 % of the peak is first reached [kN/mm]:",
                      secant_30) +
                table("Secant stiffness where 60 % of the peak is first reached [kN/mm]:",
                      secant_60);
    return text;
}

/// The energy balance of all walls, failed ones too.
std::string ledger_text(const bench::NamedStudies& studies)
{
    double worst = 0.0;
    for (const bench::NamedStudy& s : studies)
        for (const bench::LevelCost& c : s.study.costs) worst = std::fmax(worst, c.residual);
    return "\nNo energy balance of these walls misses more than " +
           app::never_rounded_away(100.0 * worst, 2) + " % of the work.\n";
}

std::string laws_text()
{
    std::string text = "| laws | what differs from the paper's laws |\n|---|---|\n";
    for (const bench::JointLaw& law : bench::kJointLaws)
        text += "| " + std::string(law.name) + " | " + std::string(law.what) + " |\n";
    return text;
}

std::string page_of(bench::LawStudies& all, std::span<const bench::TestedWall> tests)
{
    bench::LawRuns runs{of_laws(all, "random"), of_laws(all, "mean"), {}, {}, {}, {}};
    runs.mean_checks = checks(all, "mean",
                              {{"1 %, as in section 2", ""},
                               {"0.3 %", "_slow", false},
                               {"3 %", "_fast"},
                               {"3 %, fine", "_fine"}});
    const std::vector<Setting> choice_settings = {
        {"1 %", ""}, {"3 %", "_fast"}, {"3 %, fine", "_fine"}};
    runs.limits = choices(all, "joint.largest_stiffness", "487 GPa/m (default: 100 k_0)",
                          {{"60 GPa/m", "limit_60"},
                           {"120 GPa/m", "limit_120"},
                           {"240 GPa/m", "limit_240"},
                           {"1000 GPa/m", "limit_1000"}},
                          choice_settings);
    const std::string loss = "joint.closure_loss";
    runs.losses = choices(all, loss, "0 (default)", {{"0.1", "loss_0.1"}, {"0.3", "loss_0.3"}},
                          choice_settings);
    runs.random_checks = checks(all, "checked",
                                {{"3 %, simple, as in section 1", ""},
                                 {"1 %, simple", "_slow"},
                                 {"3 %, standard", "_fine"}});
    const bench::NamedStudies random_checks = together(runs.random_checks);
    bench::NamedStudies cycles;
    for (const Setting& s :
         {Setting{"3 %", ""}, Setting{"1 %", "_slow"}, Setting{"3 %, fine", "_fine"}}) {
        add(cycles, all, "paper, " + s.name, "cycles/paper" + s.file);
        for (const char* share : {"0", "0.1", "0.3"})
            add(cycles, all, "closure, " + loss + " = " + share + ", " + s.name,
                std::string("cycles/loss_") + share + s.file);
    }

    const auto walls_of = [](const bench::NamedStudies& studies) {
        return studies.empty() ? std::string("0")
                               : std::to_string(studies.front().study.walls.study.uq.samples);
    };

    std::string text = "# Joint laws\n\n";
    for (const std::string& sentence : bench::findings(runs, tests))
        text += "- " + sentence + "\n";
    text += "\nWritten by `./drystone joint_laws` on " + bench::machine_line() +
            "; every number comes from the studies that this command runs. ";
    if (!all.missing().empty()) {
        text += "Not run, or not to the end, when the page was written: ";
        for (const std::string& name : all.missing())
            text += (&name == &all.missing().front() ? "" : ", ") + name;
        text += ". ";
    }
    text += "[model.md](model.md), section 3, describes the laws. All walls have finite "
            "displacements and the default damping, and are pushed until the force is down to "
            "70 % of its peak (`configs/closure.ini`). The drop to 80 % of a wall that only "
            "rocks is then observed too.\n\n" +
            laws_text() +
            "\nThe program fits both closures to the paper's four wall moduli; the paper's own "
            "law has one modulus for each stress, interpolated at 0.75 MPa. The energy in "
            "shear is ten times that of mode I (a choice).\n\n";
    text +=
        "## 1. Random walls\n\nThe paper's walls, " + walls_of(runs.random) +
        " under each stress (the command runs 50 unless DRYSTONE_SAMPLES says otherwise), the "
        "same samples with every law, `solver.fidelity = simple` and `solver.accuracy = 3 %` "
        "(section 3 has others). Drift limits: drift at which the force is down to 80 % of its "
        "peak, by Kaplan and Meier, with 95 % intervals.\n\n" +
        app::as_markdown(bench::random_walls(runs.random)) + ledger_text(runs.random);
    if (runs.random.size() > 1)
        text +=
            "\nWall by wall against the paper's laws: geometric means of the ratios with "
            "95 % intervals; nearer and farther: walls whose drop moved by more than a factor "
            "of 1.2.\n\n" +
            app::as_markdown(bench::wall_by_wall(runs.random));
    text +=
        "\n## 2. The wall with mean values, and the tests\n\n`solver.accuracy = 1 %`. Tests: "
        "Lourenço et al. (2005), digitised by Vanin et al. (2017, doi "
        "10.5281/zenodo.812145); \">\": the curve ends there, before the drop. The hyperbola "
        "reads the paper's moduli as secants from the unloaded joint; a push begins under the "
        "vertical load and therefore meets the steeper tangent. The exponential law reads them "
        "as tangents, as the paper's own law does.\n\n" +
        number_tables(runs.mean, tests, true);
    text += "## 3. Other speeds and discretisations\n\nThe same walls at another "
            "`solver.accuracy` and with another `solver.fidelity`. The wall with mean values, "
            "`standard` unless it says fine:\n\n" +
            number_tables(together(runs.mean_checks), {}, true) + "Random walls, " +
            walls_of(random_checks) +
            " under each stress. If this number differs from that in section 1, they are other "
            "walls than there:\n\n" +
            app::as_markdown(bench::random_walls(random_checks));
    text += "\n## 4. Free choices of closure\n\nThe wall with mean values, all "
            "laws and hyperbolic closure, one key at a time, at two speeds and on two "
            "discretisations.\n\n" +
            number_tables(together({together(runs.limits), together(runs.losses)}), {}, false) +
            "Equivalent viscous damping of each cycle of a wall of 1.0 x 1.2 m whose stones do "
            "not crack, under 0.50 MPa and with mean values, by the amplitude. Part of the "
            "damping comes from the solver ([cyclic.md](cyclic.md)).\n\n" +
            app::as_markdown(bench::damping_of_cycles(cycles));
    return text;
}

int run(int argc, char** argv)
{
    if (argc != 3) {
        std::cerr << "usage: joint_laws WORK DOCS\n";
        return 2;
    }
    const fs::path docs = argv[2];
    const char* curves = std::getenv("DRYSTONE_TEST_CURVES");
    const auto tests = bench::tested_walls(
        curves == nullptr || *curves == '\0' ? std::nullopt : std::optional<fs::path>(curves));
    bench::LawStudies all{fs::path(argv[1])};
    const std::string page =
        page_of(all, tests); // everything is read before anything is written
    app::write_file(docs / "joint_laws.md", page);
    std::cerr << "wrote " << (docs / "joint_laws.md").string() << '\n';
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "joint_laws: " << e.what() << '\n';
        return 1;
    }
}
