#include "app/commands.hpp"
#include "app/input/study_reading.hpp"

#include "app/input/prepared_study.hpp"
#include "app/new/new_study.hpp"
#include "app/output/atomic_output.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

void check_new_file(const std::string& path)
{
    const std::string example = fs::path(path).replace_extension(".ini").string();
    if (!path.ends_with(".ini"))
        throw ConfigError("drystone", 0, "new",
                          in_quotes(path) + " is not the name of a study; write " +
                              in_quotes(example));
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found)
        throw ConfigError("drystone", 0, "new",
                          in_quotes(path) + " is there already; write another name");
}

/// @throws ConfigError where the answers do not make a wall together
void check_study(const std::string& path, const std::string& text)
{
    try {
        static_cast<void>(prepare(read_study(parse_study_text(path, text))));
    } catch (const ConfigError& error) {
        throw ConfigError("drystone", 0, "new",
                          std::string("these answers make no wall, and nothing was written: ") +
                              error.what());
    }
}

} // namespace

int new_command(const Command& command)
{
    const std::string path = command.words.front();
    check_new_file(path);
    std::istream* const person = ::isatty(STDIN_FILENO) == 1 ? &std::cin : nullptr;
    const std::string text = new_study_text(answers(command.answers, person, std::cout), path);
    check_study(path, text);
    const fs::path file = path;
    if (file.has_parent_path()) make_folder(file.parent_path());
    write_file(file, text);
    Command drawing;
    drawing.study = path;
    drawing.out = (fs::path("runs") / file.stem()).string() + "_scene";
    drawing.quiet = true;
    std::cout << "study written to " << path << '\n';
    const int code = scene_command(drawing);
    std::cout << "Next: look at " << drawing.out << "/scene.svg, read " << path
              << ", change what you know better, then\n  drystone push " << path
              << " --sample mean\n  drystone study " << path << " --report\n";
    return code;
}

} // namespace app
