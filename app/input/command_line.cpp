#include "app/input/command_line.hpp"

#include "app/input/command_options.hpp"
#include "app/input/config_error.hpp"
#include "app/input/number_text.hpp"
#include "app/input/units.hpp"
#include "app/input/words.hpp"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/parsers.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace app {
namespace {

namespace po = boost::program_options;

[[noreturn]] void refuse(std::string_view what, const std::string& why)
{
    throw ConfigError("drystone", 0, what, why);
}

[[noreturn]] void refuse_unknown_option(const std::string& token)
{
    std::vector<std::string> names;
    const po::options_description all = command_options();
    for (const auto& option : all.options()) names.push_back("--" + option->long_name());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string name = token.substr(0, token.find('='));
    refuse(name, "unknown option; " + suggestion(name, views));
}

/// Boost splits the arguments; what it refuses is said in our words.
std::vector<po::option> split(const std::vector<std::string>& arguments)
{
    namespace style = po::command_line_style;
    const po::options_description all = command_options();
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

int parse_whole(const std::string& option, const std::string& text, double least, double most)
{
    double n = 0.0;
    try {
        n = parse_count(text);
    } catch (const BadValue& bad) {
        refuse(option, bad.what());
    }
    if (n < least || n > most)
        refuse(option, in_quotes(text) + " is out of range; must be in [" + number(least, 12) +
                           ", " + number(most, 12) + "]");
    return static_cast<int>(n);
}

constexpr double kMostShards = 100'000;

Shard parse_shard(const std::string& text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        refuse("--shard", in_quotes(text) + " is not a part of a whole; write e.g. \"3/16\"");
    Shard s;
    s.count = parse_whole("--shard", text.substr(slash + 1), 1, kMostShards);
    if (text.substr(0, slash) != "*")
        s.index = parse_whole("--shard", text.substr(0, slash), 1, s.count) - 1;
    return s;
}

/// Folders on the way are made by who writes into them.
void check_out(const VerbRule& rule, const std::string& out)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    fs::path path = fs::path(out).lexically_normal();
    if (rule.out != OutKind::folder) {
        if (fs::is_directory(path, ignored))
            refuse("--out",
                   in_quotes(out) + " is a directory; give a file, such as " +
                       in_quotes((path / "name").string() + std::string(rule.extension)));
        path = path.parent_path();
    }
    while (!path.empty() && !fs::exists(path, ignored) && path != path.parent_path()) {
        path = path.parent_path();
    }
    if (!path.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) {
        refuse("--out", in_quotes(path.string()) + " is a file; give a directory");
    }
}

/// What would be written over a file that is read, over a study's, or over what the same run writes.
void check_out_file(const VerbRule& rule, const Command& command)
{
    namespace fs = std::filesystem;
    if (rule.out != OutKind::file) return;
    const fs::path out = command.out;
    const auto say = [&](const std::string& why, std::string_view extension) {
        refuse("--out", in_quotes(command.out) + why + "; write " +
                            in_quotes(fs::path(out).replace_extension(extension).string()));
    };
    std::error_code ignored;
    if (fs::equivalent(out, command.study, ignored))
        say(" is the file that is read", rule.extension);
    if (rule.extension != ".h5" && out.extension() == ".h5")
        say(" is the name of a study's file", rule.extension);
    if (command.report && (!out.has_extension() || out.extension() == ".html"))
        say(" is the name of the tables' folder or of the page", rule.extension);
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
        command.threads = parse_whole("--threads", option.value.front(), 1, 1024);
    } else if (name == "sample") {
        command.sample = parse_whole("--sample", option.value.front(), 0, 1e9);
    } else if (name == "level") {
        command.level = option.value.front();
    } else if (name == "shard") {
        command.shard = parse_shard(option.value.front());
    } else if (name == "slurm") {
        command.script = option.value.front();
    } else if (name == "quiet") {
        command.quiet = true;
    } else if (name == "rerun-failed") {
        command.rerun_failed = true;
    } else if (name == "report") {
        command.report = true;
    } else if (name == "drift") {
        command.drift.push_back(option.value.front());
    } else if (name == "censored") {
        command.censored = option.value.front();
    } else if (name == "group") {
        command.group = option.value.front();
    } else if (name == "partial") {
        command.partial = true;
    } else if (name == "walls") {
        command.walls = parse_whole("--walls", option.value.front(), 0, 1e6);
    }
}

void refuse_doubled(const std::vector<po::option>& given)
{
    for (const char* const name : {"out", "threads", "sample", "level", "shard", "slurm",
                                   "walls", "censored", "group"}) {
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
    if (word == "help" || word == "version" || find_verb(word) != nullptr) return word;
    std::vector<std::string_view> names;
    for (const VerbRule& r : verb_rules()) names.push_back(r.name);
    names.insert(names.end(), {"help", "version"});
    refuse(word, "unknown verb; " + suggestion(word, names));
}

[[noreturn]] void refuse_extra(const std::string& word)
{
    refuse(in_quotes(word), "one word too many; leave it out");
}

void read_verb_words(const VerbRule& rule, const std::vector<std::string>& words,
                     Command& command)
{
    command.verb = rule.verb;
    command.words.assign(words.begin() + 1, words.end());
    if (command.words.size() < rule.least)
        refuse(rule.name, "missing " + std::string(rule.words) + "; write \"" +
                              std::string(rule.example) + "\"");
    if (command.words.size() > rule.most) refuse_extra(command.words[rule.most]);
    command.study = command.words.front();
}

/// VERB and what follows it.
void read_words(const std::vector<std::string>& words, Command& command)
{
    if (words.empty()) {
        refuse("", "missing verb; write \"drystone push STUDY.ini\", or \"drystone help\"");
    }
    const std::string verb = known_verb(words.front());
    if (const VerbRule* rule = find_verb(verb)) return read_verb_words(*rule, words, command);
    const std::size_t most = verb == "version" ? 1 : 2;
    if (words.size() > most) refuse_extra(words[most]);
    command.verb = verb == "version" ? Verb::version : Verb::help;
    if (words.size() == 2) command.topic = known_verb(words[1]);
}

void refuse_foreign(const VerbRule& rule, const std::vector<po::option>& given)
{
    for (const po::option& o : given)
        if (!o.string_key.empty() && !takes(rule, o.string_key))
            refuse("--" + o.string_key,
                   "not an option of " + std::string(rule.name) + "; leave it out");
}

void set_out(const VerbRule& rule, Command& command)
{
    namespace fs = std::filesystem;
    if (rule.out == OutKind::first_word) command.out = command.words.front();
    if (command.out.empty())
        command.out = (fs::path("runs") / fs::path(command.study).stem()).string() +
                      std::string(rule.extension);
    check_out(rule, command.out);
    check_out_file(rule, command);
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
    if (command.verb == Verb::help || command.verb == Verb::version) return command;
    const VerbRule& rule = rule_of(command.verb);
    refuse_foreign(rule, given);
    if (command.report && (command.shard.count > 1 || !command.script.empty()))
        refuse("--report", "not of a shard; merge the shards, then run fragility and report");
    set_out(rule, command);
    return command;
}

} // namespace app
