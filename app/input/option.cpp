#include "app/input/option.hpp"

#include "app/input/study/units.hpp"
#include "app/input/verb.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <boost/program_options/value_semantic.hpp>

#include <arpa/inet.h>

#include <algorithm>
#include <string_view>
#include <thread>
#include <vector>

namespace app {
namespace {

namespace po = boost::program_options;

int whole_number(const std::string& text, double least, double most)
{
    const double n = parse_count(text);
    if (n < least || n > most)
        throw BadValue(in_quotes(text) + " is out of range; must be in [" + number(least, 12) +
                       ", " + number(most, 12) + "]");
    return static_cast<int>(n);
}

/// "3/16", or "*/16" for the number of shards alone.
Shard shard_of(const std::string& text)
{
    constexpr double kMostShards = 100'000;
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        throw BadValue(in_quotes(text) + " is not a part of a whole; write e.g. \"3/16\"");
    Shard s;
    s.count = whole_number(text.substr(slash + 1), 1, kMostShards);
    s.every = text.substr(0, slash) == "*";
    if (!s.every) s.index = whole_number(text.substr(0, slash), 1, s.count) - 1;
    return s;
}

/// For options that take any text but none.
std::string some_text(const std::string& text)
{
    if (text.empty()) throw BadValue("missing value; write one after it");
    return text;
}

/// Without the scheme, the brackets and the port that stand around it in an address.
std::string host_name(const std::string& text)
{
    constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
    in6_addr room{};
    if (some_text(text).find_first_not_of(kLetters) != std::string::npos &&
        ::inet_pton(AF_INET6, text.c_str(), &room) != 1)
        throw BadValue(
            in_quotes(text) +
            " is not a name of a machine; write the name alone, such as \"lab.example\"");
    return text;
}

using Text = const std::string&;

/// The name of an option as a template argument.
template <std::size_t N> struct OptionName {
    char text[N]{};
    constexpr OptionName(const char (&name)[N]) { std::copy_n(name, N, text); } // NOLINT
};

/// An answer of a new study (app/new/new_answers.hpp).
template <OptionName Name> void answer(Command& c, Text v)
{
    c.answers[Name.text] = some_text(v);
}

// clang-format off
std::vector<Option> table()
{
    return {
        {"out", "PATH", "output directory or file (default: runs/<name of the study>; beside a FILE.h5 that is read)",
         "push scene stones study sample reliability fragility report sheet choices compare curves calibrate record surrogate shake", false,
         [](Command& c, Text v) { c.out = some_text(v); }},
        {"set", "section.key=value", "value in place of the one in the study file; an empty one takes the key out; a path counts from the current folder; may be repeated",
         "push scene study sample reliability fragility sheet choices serve calibrate shake", true,
         [](Command& c, Text v) { c.overrides.push_back(v); }},
        {"threads", "N", "number of threads (default: " + std::to_string(default_threads()) + ", all of this machine)",
         "push study reliability report sheet choices serve calibrate", false,
         [](Command& c, Text v) { c.threads = whole_number(v, 1, 1024); }},
        {"predict", "STRESS", "further vertical stress, such as \"0.75 MPa\", under which a new wall is predicted; may be repeated", "calibrate", true,
         [](Command& c, Text v) { c.predict.push_back(some_text(v)); }},
        {"quiet", "", "no progress on stderr (default: progress)",
         "push stones study sample reliability fragility report sheet choices compare curves merge serve calibrate record surrogate shake", false,
         [](Command& c, Text) { c.quiet = true; }},
        {"verbose", "", "print all rows and columns of the tables (default: ten rows, the main columns)",
         "study fragility", false,
         [](Command& c, Text) { c.verbose = true; }},
        {"sample", "K", "wall K, from 0, of a study with distributions; or mean: the wall of their means", "push shake", false,
         [](Command& c, Text v) {
             c.mean_wall = v == "mean";
             if (!c.mean_wall) c.sample = whole_number(v, 0, 1e9);
         }},
        {"film", "", "write a moving picture of the push or the shaking, film.svg, for a page or a talk; of a push with a name, --film wall.gif or wall.webm, that file too (needs ffmpeg)", "push shake", false,
         [](Command& c, Text) { c.film = true; }},
        {"beside", "TEST.csv", "draw a measured curve (displacement_mm,force_kN) in the pictures of the curve; may be repeated", "push", true,
         [](Command& c, Text v) { c.beside.push_back(some_text(v)); }},
        {"level", "STRESS", "vertical stress, such as \"0.75 MPa\", where the study has several", "push reliability sheet choices shake", false,
         [](Command& c, Text v) { c.level = v; }},
        {"shard", "I/N", "part I of N, I from 1; each part is written to a file of its own", "study", false,
         [](Command& c, Text v) { c.shard = shard_of(v); }},
        {"slurm", "FILE", "write a job array of shards (--shard */N, or as many as needed) and run nothing", "study", false,
         [](Command& c, Text v) { c.script = some_text(v); }},
        {"rerun-failed", "", "run walls that failed again", "study", false,
         [](Command& c, Text) { c.rerun_failed = true; }},
        {"report", "", "when the study is done, write its tables (fragility) and its page (report) beside it", "study", false,
         [](Command& c, Text) { c.report = true; }},
        {"drift", "COLUMN", "column of drifts in a table; may be repeated", "fragility", true,
         [](Command& c, Text v) { c.drift.push_back(v); }},
        {"censored", "COLUMN", "column of a table that says 1 or yes where the drift is only a lower bound; one for all, or one for each --drift", "fragility", true,
         [](Command& c, Text v) { c.censored.push_back(some_text(v)); }},
        {"group", "COLUMN", "column of a table that says which rows belong together", "fragility", false,
         [](Command& c, Text v) { c.group = v; }},
        {"intensity", "NAME", "column of intensities in a table of counts; of walls that were shaken the measure: pga, pgv, \"sa(0.3 s)\", ... (default: that of the study)", "fragility", false,
         [](Command& c, Text v) { c.intensity = some_text(v); }},
        {"hazard", "FILE.csv", "hazard curve: intensity and annual rate at which it is exceeded, for the annual rate of each state of walls that were shaken", "fragility", false,
         [](Command& c, Text v) { c.hazard = some_text(v); }},
        {"failed", "COLUMN", "column of the numbers that reached a limit state; may be repeated, mildest first", "fragility", true,
         [](Command& c, Text v) { c.failed.push_back(some_text(v)); }},
        {"of", "NAME", "column of the total numbers of walls (analyses, buildings) in a table of counts; of a surrogate its response (default: peak_force)", "fragility surrogate", false,
         [](Command& c, Text v) { c.of = some_text(v); }},
        {"state", "COLUMN", "column of damage states (0 for none, 1, 2, ...) in place of --failed", "fragility", false,
         [](Command& c, Text v) { c.state = some_text(v); }},
        {"partial", "", "merge although walls are missing", "merge", false,
         [](Command& c, Text) { c.partial = true; }},
        {"walls", "N", "how many walls the page can show (default: all; a selection of large studies)", "report", false,
         [](Command& c, Text v) { c.walls = whole_number(v, 0, 1e6); }},
        {"title", "TEXT", "title of the page (default: name of the study)", "report study sheet", false,
         [](Command& c, Text v) { c.title = some_text(v); }},
        {"measure", "NAME", "further measure of intensity, such as \"sa(0.5 s)\", \"avg_sa(0.5 s)\", \"fiv3(0.5 s)\" or \"rocking_pgv(0.5 m, 0.6 m)\"; may be repeated", "record", true,
         [](Command& c, Text v) { c.measures.push_back(some_text(v)); }},
        {"acceleration-unit", "UNIT", "unit of the accelerations of a file, in place of the one that it states: g, m/s2, cm/s2, mm/s2 or g/10", "record", false,
         [](Command& c, Text v) { c.unit = some_text(v); }},
        {"method", "NAME", "how stones are told from mortar: threshold, kmeans or watershed (default: the one whose stones are the most compact)", "stones", false,
         [](Command& c, Text v) { c.method = some_text(v); }},
        {"length", "LENGTH", "length of the wall, along the push, such as \"3 m\"", "new", false, answer<"length">},
        {"height", "LENGTH", "height of the wall", "new", false, answer<"height">},
        {"thickness", "LENGTH", "thickness of the wall", "new", false, answer<"thickness">},
        {"material", "NAME", "one of docs/materials.md, such as roughly_squared", "new", false, answer<"material">},
        {"unit", "SIZE", "a usual stone, length x height, such as \"0.4 x 0.2 m\"", "new", false, answer<"unit">},
        {"bond", "NAME", "running (default), stack, english, flemish, header or rubble", "new", false, answer<"bond">},
        {"openings", "BOXES", "doors and windows, as wall.openings (default: none)", "new", false, answer<"openings">},
        {"stress", "STRESS", "vertical stress on top of the wall, such as \"0.20 MPa\"", "new", false, answer<"stress">},
        {"port", "N", "port of a server, 0 for any free one (default: 4242)", "serve", false,
         [](Command& c, Text v) { c.port = whole_number(v, 0, 65535); }},
        {"address", "IP", "address at which a server listens (default: 127.0.0.1, this machine alone)", "serve", false,
         [](Command& c, Text v) { c.address = some_text(v); }},
        {"host", "NAME", "further name under which clients reach a server, or of a machine whose pages may ask it; may be repeated", "serve", true,
         [](Command& c, Text v) { c.hosts.push_back(host_name(v)); }},
        {"input", "section.key", "key that a server takes as an input (default: all random variables); may be repeated", "serve", true,
         [](Command& c, Text v) { c.inputs.push_back(some_text(v)); }},
        {"response", "NAME", "what a server gives, such as ultimate_drift (default: peak_force); may be repeated", "serve", true,
         [](Command& c, Text v) { c.responses.push_back(some_text(v)); }},
        {"help", "", "this text; after a verb, the help of that verb", "", true, nullptr},
        {"version", "", "version and commit of the program, revision of its solver", "", true, nullptr},
    };
}
// clang-format on

} // namespace

int default_threads()
{
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::span<const Option> options()
{
    static const std::vector<Option> all = table();
    return all;
}

const Option* find_option(std::string_view name)
{
    for (const Option& o : options())
        if (o.name == name) return &o;
    return nullptr;
}

bool takes(const Verb& verb, const Option& option)
{
    return option.verbs.empty() || option.verbs.has(verb.name);
}

po::options_description described(const Verb* verb)
{
    constexpr unsigned kUnbroken = 1000; // lines are broken as wide as the terminal is
    po::options_description all("Options", kUnbroken);
    for (const Option& o : options()) {
        if (verb != nullptr && !takes(*verb, o)) continue;
        const std::string name = o.name + (o.name == "help"      ? ",h"
                                           : o.name == "version" ? ",V"
                                                                 : "");
        if (o.value_name.empty())
            all.add_options()(name.c_str(), o.meaning.c_str());
        else
            all.add_options()(name.c_str(), po::value<std::string>()->value_name(o.value_name),
                              o.meaning.c_str());
    }
    return all;
}

} // namespace app
