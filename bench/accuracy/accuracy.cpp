/// accuracy [OUT.md] [--first N] [--count M] [--seed S] [--threads T] [--set
/// section.key=value]... [--references FILE]
///          [--any-references] [--answers FILE] [--before FILE] [--most-seconds S] [--csv FILE]
///          [--print K]:
/// scenes drawn far from the paper, pushed as asked and 20 times slower. What differs is the
/// error of the drive. --set: changes scenes. What sets the speed of the drive is not changed
/// for references. --references: a CSV file that keeps their answers. --any-references: also
/// those of another revision of the solver. --answers: keeps those of the pushes as asked, too.
/// --before: such a file of an earlier program, to be compared with the same references.
/// --most-seconds: of one core, for one push; what takes longer is named as too dear. --print:
/// the study file of one scene, for `drystone push`.

#include "app/input/study/study.hpp"
#include "app/input/study/study_file.hpp"
#include "app/output/atomic_output.hpp"
#include "app/text/number_text.hpp"
#include "bench/accuracy/accuracy_answers.hpp"
#include "bench/accuracy/accuracy_tables.hpp"
#include "bench/report.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iostream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using bench::ComparedScene;

struct Request {
    std::string out, csv, references, answers, before;
    std::uint64_t first = 0, count = 100, seed = 1;
    unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::string> overrides;
    bool any_references = false;
    double most_seconds = 60.0; ///< of one push
    std::optional<std::uint64_t> print;
};

/// Takes one option with a value.
/// @return false if there is no option of this name
bool take(Request& r, const std::string& name, const std::string& value)
{
    if (name == "--first")
        r.first = std::stoull(value);
    else if (name == "--count")
        r.count = std::stoull(value);
    else if (name == "--seed")
        r.seed = std::stoull(value);
    else if (name == "--threads")
        r.threads = static_cast<unsigned>(std::max(1, std::stoi(value)));
    else if (name == "--set")
        r.overrides.push_back(value);
    else if (name == "--references")
        r.references = value;
    else if (name == "--answers")
        r.answers = value;
    else if (name == "--before")
        r.before = value;
    else if (name == "--most-seconds")
        r.most_seconds = std::stod(value);
    else if (name == "--csv")
        r.csv = value;
    else if (name == "--print")
        r.print = std::stoull(value);
    else
        return false;
    return true;
}

Request read(int argc, char** argv)
{
    Request r;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--any-references")
            r.any_references = true;
        else if (!word.starts_with("-") && r.out.empty())
            r.out = word;
        else if (i + 1 == argc || !take(r, word, argv[++i]))
            throw std::invalid_argument(word + ": no such option, or its value is missing");
    }
    return r;
}

/// Overrides that change the scene, and not only how fast it is pushed.
std::vector<std::string> changes_of_scene(const std::vector<std::string>& overrides)
{
    std::vector<std::string> changes;
    for (const std::string& o : overrides) {
        const std::string key = o.substr(0, o.find('='));
        if (key != "solver.accuracy" && key != "solver.steps_per_mm" &&
            key != "solver.unbalance_limit" && key != "solver.min_speed")
            changes.push_back(o);
    }
    return changes;
}

struct Files {
    bench::AnswerFile references, answers, before;
};

/// @param text of the scene with the changes of --set
bench::Answer reference_of(std::uint64_t number, const std::string& text,
                           const app::Study& asked, const dem::SolverOptions& slow,
                           double most_seconds, bench::AnswerFile& references)
{
    const std::string settings = bench::speed_settings(slow);
    if (const auto known = references.find(text, settings, most_seconds)) return *known;
    const bench::Answer answer = bench::push_answer(asked, slow, most_seconds);
    references.add(number, text, settings, answer);
    return answer;
}

/// @throws app::ConfigError where --set does not fit
ComparedScene compare(std::uint64_t number, const Request& request, Files& files)
{
    ComparedScene c;
    c.scene = bench::accuracy_scene(request.seed, number);
    const app::Study study = bench::study_of(c.scene, request.overrides);
    const std::vector<std::string> changes = changes_of_scene(request.overrides);
    std::string text = c.scene.text;
    for (const std::string& change : changes) text += "--set " + change + "\n";
    c.kinematics = app::find_entry(study.source, "solver.kinematics")->value;
    c.fidelity = app::find_entry(study.source, "solver.fidelity")->value;
    try {
        c.facts = bench::facts_of(study);
        c.asked = bench::push_answer(study, study.solver, request.most_seconds);
        files.answers.add(number, text, bench::speed_settings(study.solver), c.asked);
        c.before = files.before.find(text, "", request.most_seconds);
        const dem::SolverOptions slow =
            bench::reference_options(study, bench::study_of(c.scene, changes));
        c.reference =
            reference_of(number, text, study, slow, request.most_seconds, files.references);
    } catch (const std::exception& e) {
        c.broken = std::string("exception: ") + e.what();
    }
    return c;
}

std::vector<ComparedScene> run_all(const Request& request)
{
    Files files{{request.references, request.any_references},
                {request.answers, false},
                {request.before, true}};
    std::vector<ComparedScene> scenes(request.count);
    std::atomic<std::uint64_t> next{0};
    std::mutex mutex; // of stderr and `error`
    std::exception_ptr error;
    std::uint64_t done = 0;
    {
        std::vector<std::jthread> team;
        for (unsigned t = 0; t < request.threads; ++t)
            team.emplace_back([&] {
                for (std::uint64_t k = next++; k < request.count; k = next++) {
                    try {
                        scenes[k] = compare(request.first + k, request, files);
                    } catch (...) {
                        const std::lock_guard lock(mutex);
                        error = std::current_exception();
                        next = request.count;
                        return;
                    }
                    const std::lock_guard lock(mutex);
                    std::cerr << '\r' << ++done << " of " << request.count << std::flush;
                }
            });
    }
    std::cerr << '\n';
    if (error) std::rethrow_exception(error);
    return scenes;
}

std::string opening(const Request& request)
{
    return "Scenes " + std::to_string(request.first) + " to " +
           std::to_string(request.first + request.count - 1) + " (seed " +
           std::to_string(request.seed) + ") far from the paper, each pushed as asked and " +
           app::number(bench::kReferenceFactor, 3) +
           " times slower, for an accuracy as much finer: the reference. `accuracy --print "
           "SCENE` "
           "prints one for "
           "`drystone push`.\n\n"
           "Drawn at random: courses (running, stack, flemish, a shift of 0.3, units of random "
           "length), openings, drawings with sloping joints and portals, arches (semicircular, "
           "segmental, pointed, 7 to 26 stones, with and without piers) and rubble; 1 to 40 "
           "courses, "
           "0.3 to 6 times as high as long; mortar, crushing, wear, cracks at mid-length and "
           "in "
           "patterns; small and finite displacements; rigid, simple and standard blocks; k_n "
           "1e9 "
           "to "
           "1e15 Pa/m; 0 to 5 MPa; a beam that pushes, free or level, under dead load, a fixed "
           "line, "
           "a follower or a link, and body forces.\n\n"
           "A reference that takes more than " +
           app::number(request.most_seconds, 3) +
           " s of one core, or fails, compares with nothing: such scenes are named and not "
           "counted. Lost: "
           "one of both has a peak and the other none; it counts as outside of 1 % and 3 %. "
           "Falls: "
           "walls that come down to 80 % of the peak in one of both; a branch, in one only, "
           "counts as "
           "outside of 2 %. Error reported: share of walls whose reported error is not smaller "
           "than "
           "the true one; a true one below " +
           app::number(100.0 * bench::kTooSmall, 3) +
           " % counts as reported, since the reference is not known better. Fall reported: "
           "share of falls whose reference lies in the range that the push gives its ultimate "
           "displacement; a wall that does not fall may fall beyond its push.";
}

bench::Report report_of(const std::vector<ComparedScene>& scenes, const Request& request)
{
    bench::Report r;
    r.title = "Error of a push by the speed of its drive";
    r.opening = opening(request);
    r.sections = {{"errors", "Errors of the peak force and of the fall to 80 %", "",
                   bench::error_table(scenes)},
                  {"worst", "Largest errors", "", bench::worst_table(scenes)},
                  {"remarks", "Remarks", "", bench::apart_table(scenes)}};
    if (request.before.empty()) return r;
    const std::vector<ComparedScene> before = bench::as_before(scenes);
    r.sections.push_back({"before",
                          "Before: the same scenes and references, solver revision " +
                              bench::AnswerFile(request.before, true).revision(),
                          "", bench::error_table(before)});
    r.sections.push_back(
        {"before_worst", "Before: largest errors", "", bench::worst_table(before)});
    return r;
}

} // namespace

int main(int argc, char** argv)
try {
    const Request request = read(argc, argv);
    if (request.print) {
        std::cout << bench::accuracy_scene(request.seed, *request.print).text;
        return 0;
    }
    const std::vector<ComparedScene> scenes = run_all(request);
    if (!request.csv.empty())
        app::write_file(request.csv, app::as_csv(bench::scene_table(scenes)));
    const bench::Report report = report_of(scenes, request);
    if (request.out.empty())
        std::cout << bench::as_markdown(report);
    else
        bench::write_report(request.out, report);
    return 0;
} catch (const std::invalid_argument& e) {
    std::cerr
        << e.what()
        << "\nusage: accuracy [OUT.md] [--first N] [--count M] [--seed S] [--threads T] "
           "[--set section.key=value]... [--references FILE] [--any-references] "
           "[--answers FILE] [--before FILE] [--most-seconds S] [--csv FILE] [--print K]\n";
    return 2;
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 2;
}
