#include "app/command_line.hpp"

#include "app/config_error.hpp"
#include "app/study_help.hpp"
#include "app/units.hpp"
#include "app/words.hpp"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <thread>

namespace app {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 3> kVerbs = {"push", "help", "version"};
constexpr std::array<std::string_view, 6> kLaterVerbs = {"study",  "fragility", "report",
                                                         "sample", "merge",     "reliability"};

constexpr const char* kUsage =
    R"(Drystone: in-plane push of dry-joint stone masonry walls by the discrete element method.

  drystone push STUDY.ini [options]   push one wall: capacity curve, summary, pictures
  drystone help [push]                this text, or the keys of a study
  drystone version

)";
constexpr const char* kExitCodes = "\nExit codes: 0 done, 1 failed, 2 error in the input.\n";

[[noreturn]] void refuse(std::string_view what, const std::string& why)
{
    throw ConfigError("drystone", 0, what, why);
}

int default_threads()
{
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

po::options_description options()
{
    const auto text = [](const char* name) {
        return po::value<std::string>()->value_name(name);
    };
    const std::string threads =
        "threads to use (default: " + std::to_string(default_threads()) +
        ", all of this machine)";
    po::options_description all("Options", 96);
    auto add = all.add_options();
    add("out", text("DIR"), "output directory (default: runs/<name of the study file>)");
    add("set", text("section.key=value"), "value in place of the study's; may be repeated");
    add("threads", text("N"), threads.c_str());
    add("quiet", "no progress on stderr (default: progress)");
    add("help,h", "help, after a verb on that verb");
    add("version", "name and version");
    return all;
}

[[noreturn]] void refuse_unknown_option(const std::string& token)
{
    constexpr std::array<std::string_view, 6> kNames = {"--out",   "--set",  "--threads",
                                                        "--quiet", "--help", "--version"};
    const std::string name = token.substr(0, token.find('='));
    refuse(name, "unknown option; " + suggestion(name, kNames));
}

/// Boost splits the arguments; what it refuses is said in our words.
std::vector<po::option> split(const std::vector<std::string>& arguments)
{
    namespace style = po::command_line_style;
    const po::options_description all = options();
    try {
        return po::command_line_parser(arguments)
            .options(all)
            .style(style::default_style & ~style::allow_guessing)
            .allow_unregistered()
            .run()
            .options;
    } catch (const po::invalid_command_line_syntax& error) {
        const bool extra = error.kind() == po::invalid_syntax::extra_parameter;
        refuse(error.get_option_name(),
               extra ? "takes no value; write it alone" : "missing value; write one after it");
    }
}

int parse_threads(const std::string& text)
{
    constexpr double kMost = 1024;
    double n = 0.0;
    try {
        n = parse_count(text);
    } catch (const BadValue& bad) {
        refuse("--threads", bad.what());
    }
    if (n < 1 || n > kMost)
        refuse("--threads", in_quotes(text) + " is out of range; must be in [1, 1024]");
    return static_cast<int>(n);
}

/// The directory itself is made by who writes into it.
void check_out(const std::string& out)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    fs::path path = fs::path(out).lexically_normal();
    while (!path.empty() && !fs::exists(path, ignored) && path != path.parent_path()) {
        path = path.parent_path();
    }
    if (!path.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) {
        refuse("--out", in_quotes(path.string()) + " is a file; give a directory");
    }
}

/// Sort one option into the command; words without -- are kept apart.
void take(const po::option& option, Command& command, std::vector<std::string>& words)
{
    if (option.unregistered) refuse_unknown_option(option.original_tokens.front());
    const bool next_option =
        option.original_tokens.size() > 1 && option.value.front().starts_with("--");
    if (next_option) refuse("--" + option.string_key, "missing value; write one after it");
    const std::string& name = option.string_key;
    if (name.empty()) {
        words.push_back(option.value.front());
    } else if (name == "set") {
        command.overrides.push_back(option.value.front());
    } else if (name == "out") {
        command.out = option.value.front();
        if (command.out.empty()) refuse("--out", "missing value; write one after it");
    } else if (name == "threads") {
        command.threads = parse_threads(option.value.front());
    } else if (name == "quiet") {
        command.quiet = true;
    }
}

void refuse_doubled(const std::vector<po::option>& given)
{
    for (const char* const name : {"out", "threads"}) {
        const auto times = std::count_if(given.begin(), given.end(), [&](const po::option& o) {
            return o.string_key == name;
        });
        if (times > 1) refuse("--" + std::string(name), "given twice; keep one of them");
    }
}

bool has(const std::vector<po::option>& given, const char* name)
{
    return std::any_of(given.begin(), given.end(),
                       [&](const po::option& o) { return o.string_key == name; });
}

std::string known_verb(const std::string& word)
{
    if (std::find(kVerbs.begin(), kVerbs.end(), word) != kVerbs.end()) return word;
    if (std::find(kLaterVerbs.begin(), kLaterVerbs.end(), word) != kLaterVerbs.end()) {
        refuse(word, "not in this version; \"drystone help\" lists what is");
    }
    refuse(word, "unknown verb; " + suggestion(word, kVerbs));
}

/// VERB and what follows it.
void read_words(const std::vector<std::string>& words, Command& command)
{
    if (words.empty()) {
        refuse("", "missing verb; write \"drystone push STUDY.ini\", or \"drystone help\"");
    }
    const std::string verb = known_verb(words.front());
    const std::size_t most = verb == "version" ? 1 : 2;
    if (words.size() > most) refuse(in_quotes(words[most]), "one word too many; leave it out");
    if (verb == "version") {
        command.verb = Verb::version;
    } else if (verb == "help") {
        command.verb = Verb::help;
        if (words.size() == 2) command.topic = known_verb(words[1]);
    } else if (words.size() == 2) {
        command.verb = Verb::push;
        command.study = words[1];
    } else {
        refuse(verb, "missing study file; write \"drystone push configs/wall.ini\"");
    }
}

} // namespace

Command parse_command_line(const std::vector<std::string>& arguments)
{
    Command command;
    command.threads = default_threads();
    std::vector<std::string> words;
    const std::vector<po::option> given = split(arguments);
    refuse_doubled(given);
    for (const po::option& option : given) take(option, command, words);

    if (has(given, "help")) {
        if (!words.empty()) command.topic = known_verb(words.front());
        return command;
    }
    if (has(given, "version")) {
        command.verb = Verb::version;
        return command;
    }
    read_words(words, command);
    if (command.verb != Verb::push) return command;
    if (command.out.empty()) {
        const std::filesystem::path stem = std::filesystem::path(command.study).stem();
        command.out = (std::filesystem::path("runs") / stem).string();
    }
    check_out(command.out);
    return command;
}

std::string help_text(std::string_view topic)
{
    std::ostringstream text;
    text << kUsage << options() << kExitCodes;
    if (topic == "push") {
        text << "\nA study file has sections of keys: name, default, values allowed, meaning.\n"
             << study_help();
    }
    return text.str();
}

} // namespace app
