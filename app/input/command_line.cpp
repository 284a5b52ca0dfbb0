#include "app/input/command_line.hpp"

#include "app/input/option.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_name.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/parsers.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

[[noreturn]] void refuse(std::string_view what, const std::string& why)
{
    throw ConfigError("drystone", 0, what, why);
}

[[noreturn]] void refuse_unknown_option(const std::string& token, const Verb* verb)
{
    std::vector<std::string> names;
    for (const Option& o : options())
        if (verb == nullptr || takes(*verb, o)) names.push_back("--" + o.name);
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string name = token.substr(0, token.find('='));
    if (verb == nullptr && nearest_word(name, views).empty())
        refuse(name, "unknown option; write a verb first, or \"drystone help\"");
    refuse(name, "unknown option; " + suggestion(name, views));
}

/// Boost divides the arguments; what it refuses is said in our words.
std::vector<po::option> given_options(const std::vector<std::string>& arguments)
{
    namespace style = po::command_line_style;
    const po::options_description all = described(nullptr);
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

void apply(const Option& option, const po::option& given, Command& command)
{
    const std::string name = "--" + option.name;
    const bool next_option =
        given.original_tokens.size() > 1 && given.value.front().starts_with("--");
    if (next_option) refuse(name, "missing value; write one after it");
    try {
        option.apply(command, given.value.empty() ? "" : given.value.front());
    } catch (const BadValue& bad) {
        refuse(name, bad.what());
    }
}

/// Options whose `apply` is missing ask for another verb; see asked_verb.
void apply_all(const Verb& verb, const std::vector<po::option>& given, Command& command)
{
    for (auto g = given.begin(); g != given.end(); ++g) {
        const Option* option = find_option(g->string_key);
        if (g->string_key.empty() || option->apply == nullptr) continue;
        const bool twice = std::any_of(given.begin(), g, [&](const po::option& before) {
            return before.string_key == option->name;
        });
        if (twice && !option->repeats)
            refuse("--" + option->name, "given twice; keep one of them");
        apply(*option, *g, command);
        if (!takes(verb, *option))
            refuse("--" + option->name,
                   "not an option of " + std::string(verb.name) + "; leave it out");
    }
}

/// The verb that is written, or help or version where an option asks for them.
const Verb& asked_verb(std::span<const Verb> verbs, const std::vector<po::option>& given,
                       std::vector<std::string>& words)
{
    for (const char* const name : {"help", "version"}) {
        const bool asked =
            std::ranges::any_of(given, [&](const auto& g) { return g.string_key == name; });
        if (!asked) continue;
        words.resize(std::min<std::size_t>(words.size(), name == std::string("help") ? 1 : 0));
        return known_verb(verbs, name);
    }
    if (words.empty())
        refuse("", "missing verb; write \"drystone push STUDY.ini\", or \"drystone help\"");
    const Verb& verb = known_verb(verbs, words.front());
    words.erase(words.begin());
    return verb;
}

/// `help --film` asks about an option, and does not give it.
bool asks_about_option(const std::vector<std::string>& arguments)
{
    return arguments.size() == 2 && arguments.front() == "help" &&
           arguments.back().starts_with("--");
}

/// `--set load.height "1 m"`: the blank ends the assignment.
void check_assignments(const std::vector<po::option>& given, const std::string& next)
{
    for (const po::option& g : given)
        if (g.string_key == "set" && !g.value.empty() &&
            g.value.front().find('=') == std::string::npos)
            refuse("--set", in_quotes(g.value.front()) + " is not an assignment; write --set " +
                                g.value.front() + "=" + in_quotes(next));
}

void check_words(const Verb& verb, const std::vector<std::string>& words)
{
    if (words.size() < verb.least)
        refuse(verb.name, "missing " + std::string(verb.words) + "; write \"" +
                              std::string(verb.example) + "\"");
    if (words.size() > verb.most)
        refuse(in_quotes(words[verb.most]), "unexpected argument; leave it out");
}

/// Missing folders on the way are made when the first file is written into them.
void check_out(const Verb& verb, const std::string& out)
{
    std::error_code ignored;
    fs::path path = fs::path(out).lexically_normal();
    if (verb.out != OutKind::folder) {
        if (fs::is_directory(path, ignored))
            refuse("--out",
                   in_quotes(out) + " is a directory; give a file, such as " +
                       in_quotes((path / "name").string() + std::string(verb.extension)));
        path = path.parent_path();
    }
    while (!path.empty() && !fs::exists(path, ignored) && path != path.parent_path()) {
        path = path.parent_path();
    }
    if (!path.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) {
        refuse("--out", in_quotes(path.string()) + " is a file; give a directory");
    }
}

/// Refuses a name whose file is read, belongs to a study, or is written by the same run.
void check_out_file(const Verb& verb, const Command& command)
{
    const fs::path out = command.out;
    const auto say = [&](const std::string& why, std::string_view extension) {
        refuse("--out", in_quotes(command.out) + why + "; write " +
                            in_quotes(fs::path(out).replace_extension(extension).string()));
    };
    std::error_code ignored;
    if (fs::equivalent(out, command.study, ignored))
        say(" is the file that is read", verb.extension);
    if (verb.extension != ".h5" && is_study_name(command.out))
        say(" is the name of a study's file", verb.extension);
}

/// Other verbs know the file of a study by its name.
void check_out_ending(const Command& command)
{
    constexpr std::array<std::string_view, 13> kOthers = {
        ".txt",  ".csv", ".tsv", ".ini", ".json", ".md",  ".tex",
        ".html", ".svg", ".png", ".dxf", ".pdf",  ".xlsx"};
    if (is_study_name(command.out)) return;
    fs::path name = command.out;
    if (std::ranges::find(kOthers, name.extension().string()) != kOthers.end())
        name.replace_extension();
    refuse("--out", in_quotes(command.out) + " is not the name of a study's file; write " +
                        in_quotes(name.string() + ".h5"));
}

/// A folder of results may hold a file named like the one that is read, and would replace it.
void check_out_folder(const Command& command)
{
    const fs::path study = command.study;
    const fs::path folder = study.has_parent_path() ? study.parent_path() : fs::path(".");
    std::error_code ignored;
    if (!is_study_name(command.study) && fs::equivalent(folder, command.out, ignored))
        refuse("--out", in_quotes(command.out) +
                            " is the folder of the file that is read, which could be "
                            "overwritten; give another folder");
}

/// Output made of a file of results lies beside it, output made of a study in runs/. One of its
/// random walls has a folder of its own, apart from the tables: paper_17_0.75.
std::string default_out(const Verb& verb, const Command& command)
{
    const fs::path read = command.study;
    const bool results = is_study_name(read.string());
    std::string name = read.stem().string();
    if (verb.name == "record") name = name.substr(0, name.find('(')); // of a pulse
    if (verb.name == "push" && (results || command.sample || command.mean_wall)) {
        name += command.sample ? "_" + std::to_string(*command.sample) : "_mean";
        if (!command.level.empty())
            name +=
                "_" + command.level.substr(0, command.level.find_first_not_of("0123456789."));
    }
    name.append(verb.suffix).append(verb.extension);
    return ((results ? read.parent_path() : fs::path("runs")) / name).string();
}

void set_out(const Verb& verb, Command& command)
{
    if (verb.out == OutKind::none) return;
    if (verb.out == OutKind::first_word) command.out = command.words.front();
    if (command.out.empty()) command.out = default_out(verb, command);
    if (verb.out == OutKind::file &&
        command.out.back() == '/') // a folder that may not exist yet
        command.out += fs::path(default_out(verb, command)).filename().string();
    check_out(verb, command.out);
    if (verb.out == OutKind::file) check_out_file(verb, command);
    if (verb.extension == ".h5") check_out_ending(command);
    if (verb.out == OutKind::folder) check_out_folder(command);
}

/// `--film wall.gif`: the option stands alone, too, so that Boost gets it without the name.
/// @return that name, taken out of the arguments
std::string take_video(std::vector<std::string>& arguments)
{
    constexpr std::string_view kFilm = "--film";
    const auto ending = [](const std::string& name) { return fs::path(name).extension(); };
    const auto is_film = [&](const std::string& name) {
        constexpr std::array<std::string_view, 8> kKinds = {".gif", ".webm", ".svg",  ".mp4",
                                                            ".avi", ".mov",  ".apng", ".mkv"};
        return std::ranges::find(kKinds, ending(name).string()) != kKinds.end();
    };
    std::string name;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string& a = arguments[i];
        if (a.starts_with("--film=")) {
            name = a.substr(kFilm.size() + 1);
            a = kFilm;
            break;
        }
        if (a != kFilm || i + 1 == arguments.size() || !is_film(arguments[i + 1])) continue;
        name = arguments[i + 1];
        arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        break;
    }
    if (!name.empty() && ending(name) != ".gif" && ending(name) != ".webm")
        refuse("--film", in_quotes(name) +
                             " is no film that can be made; write a name that "
                             "ends in .gif or .webm, or --film alone for film.svg");
    return name;
}

void check_study_options(const Command& command)
{
    if (is_study_name(command.study) &&
        is_listed(command.verb->name, "study reliability serve"))
        refuse(command.study,
               "is a file of results; write the study file that it was made from");
    const bool script = !command.script.empty();
    if (command.report && (command.shard.count > 1 || script))
        refuse("--report",
               "a shard has no report; merge the shards, then run fragility and report");
    if (!command.title.empty() && command.verb->name == "study" && !command.report)
        refuse("--title", "is the title of the page; write --report too");
    std::error_code ignored;
    if (script && fs::equivalent(command.script, command.study, ignored))
        refuse("--slurm", in_quotes(command.script) +
                              " is the file that is read; give the script another name");
    const std::string n = std::to_string(command.shard.count);
    if (script && command.shard.count > 1 && !command.shard.every)
        refuse("--shard", "a job array runs every shard; write \"*/" + n + "\"");
    if (!script && command.shard.every)
        refuse("--shard",
               "\"*/" + n + "\" is for --slurm; write one shard, such as \"1/" + n + "\"");
    if (script && command.rerun_failed)
        refuse("--rerun-failed", "not an option of --slurm; leave it out");
}

} // namespace

Command parse_command_line(std::span<const Verb> verbs,
                           const std::vector<std::string>& given_arguments)
{
    Command command;
    std::vector<std::string> arguments = given_arguments;
    command.video = take_video(arguments);
    command.threads = default_threads();
    if (asks_about_option(arguments)) {
        command.verb = &known_verb(verbs, "help");
        command.words = {arguments.back()};
        return command;
    }
    const std::vector<po::option> given = given_options(arguments);
    for (const po::option& g : given)
        if (g.string_key.empty() && !g.unregistered) command.words.push_back(g.value.front());
    for (const po::option& g : given)
        if (g.unregistered)
            refuse_unknown_option(
                g.original_tokens.front(),
                command.words.empty() ? nullptr : find_verb(verbs, command.words.front()));
    const Verb& verb = asked_verb(verbs, given, command.words);
    command.verb = &verb;
    if (command.words.size() > verb.most) check_assignments(given, command.words[verb.most]);
    check_words(verb, command.words);
    if (command.words.empty() || verb.name == "help") return command;
    command.study = command.words.front();
    apply_all(verb, given, command);
    check_study_options(command);
    set_out(verb, command);
    return command;
}

} // namespace app
