#include "app/input/command_options.hpp"

#include "app/input/command_line.hpp"
#include "app/input/distribution_text.hpp"
#include "app/input/study_help.hpp"

#include <algorithm>
#include <sstream>
#include <thread>

namespace app {

namespace po = boost::program_options;

int default_threads()
{
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

po::options_description command_options()
{
    const auto text = [](const char* name) {
        return po::value<std::string>()->value_name(name);
    };
    const std::string threads =
        "threads to use (default: " + std::to_string(default_threads()) +
        ", all of this machine)";
    po::options_description all("Options", 96);
    auto add = all.add_options();
    add("out", text("PATH"),
        "output directory or file (default: runs/<name of the study file>...)");
    add("set", text("section.key=value"), "value in place of the study's; may be repeated");
    add("threads", text("N"), threads.c_str());
    add("quiet", "no progress on stderr (default: progress)");
    add("sample", text("K"), "push: wall K, from 0, of a study with distributions");
    add("level", text("STRESS"), "push: its vertical stress, such as \"0.75 MPa\"");
    add("shard", text("I/N"), "study: part I of N, I from 1; each into a file of its own");
    add("slurm", text("FILE"),
        "study: write a job array of shards (--shard */N, or as many as needed), run nothing");
    add("rerun-failed", "study: run walls that failed again");
    add("report",
        "study: when it is done, its tables (fragility) and its page (report) beside it");
    add("drift", text("COLUMN"), "fragility of a table: its column of drifts; may be repeated");
    add("censored", text("COLUMN"),
        "fragility of a table: 1 or yes where the drift is only a lower bound");
    add("group", text("COLUMN"), "fragility of a table: whose rows belong together");
    add("partial", "merge: although walls are missing");
    add("walls", text("N"),
        "report: how many walls can be looked at (default: all, of large studies a choice)");
    add("help,h", "help, after a verb on that verb");
    add("version", "name and version");
    return all;
}

namespace {

constexpr const char* kExitCodes = "\nExit codes: 0 done, 1 failed, 2 error in the input.\n";

std::string usage()
{
    std::string text =
        "Drystone: in-plane push of dry-joint stone masonry walls by the discrete "
        "element method.\n\n";
    const auto line = [&](std::string left, std::string_view meaning) {
        left.resize(std::max<std::size_t>(left.size() + 2, 46), ' ');
        text += left + std::string(meaning) + "\n";
    };
    for (const VerbRule& r : verb_rules())
        line("  drystone " + std::string(r.name) + " " + std::string(r.words) + " [options]",
             r.meaning);
    line("  drystone help [VERB]", "this text, or the keys of a study");
    line("  drystone version", "");
    return text + "\n";
}

} // namespace

std::string help_text(std::string_view topic)
{
    std::ostringstream text;
    text << usage() << command_options() << kExitCodes;
    if (const VerbRule* rule = find_verb(topic); rule != nullptr && takes(*rule, "set")) {
        text << "\nA study file has sections of keys: name, default, values allowed, meaning.\n"
             << study_help() << '\n'
             << distribution_help();
    }
    return text.str();
}

} // namespace app
