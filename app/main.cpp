/// drystone VERB STUDY.ini [options].  Exit codes: 0 done, 1 failed, 2 your input.

#include "app/fragility/fragility_command.hpp"
#include "app/input/command_line.hpp"
#include "app/input/config_error.hpp"
#include "app/push/push_command.hpp"
#include "app/reliability/reliability_command.hpp"
#include "app/report/report_command.hpp"
#include "app/study/curves_command.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/merge_command.hpp"
#include "app/study/sample_command.hpp"
#include "app/study/study_command.hpp"
#include "app/version.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

/// Tables in the folder of the name of the file, the page beside it. Walls are filmed while they are
/// pushed.
int study_then_report(const app::Command& study)
{
    app::FilmShelf films;
    const int code = app::study_command( // 1 if walls failed: the tables count them
        study, [&](auto key, bool rocking, auto frames) { films.put(key, rocking, frames); });
    if (app::interrupted()) return code;
    const std::filesystem::path file = study.out;
    app::Command after;
    after.words = {file.string()};
    after.study = file.string();
    after.threads = study.threads;
    after.quiet = study.quiet;
    after.verb = app::Verb::fragility;
    after.out = (file.parent_path() / file.stem()).string();
    const int tables = app::fragility_command(after);
    after.verb = app::Verb::report;
    after.out += ".html";
    return std::max({code, tables, app::report_command(after, films)});
}

int run(const std::vector<std::string>& arguments)
{
    const app::Command command = app::parse_command_line(arguments);
    switch (command.verb) {
    case app::Verb::help:
        std::cout << app::help_text(command.topic);
        return 0;
    case app::Verb::version:
        std::cout << "drystone " << app::kVersion << '\n';
        return 0;
    case app::Verb::push:
        return app::push_command(command);
    case app::Verb::study:
        return command.report ? study_then_report(command) : app::study_command(command);
    case app::Verb::sample:
        return app::sample_command(command);
    case app::Verb::reliability:
        return app::reliability_command(command);
    case app::Verb::report:
        return app::report_command(command);
    case app::Verb::fragility:
        return app::fragility_command(command);
    case app::Verb::curves:
        return app::curves_command(command);
    case app::Verb::merge:
        return app::merge_command(command);
    }
    return 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run({argv + 1, argv + argc});
    } catch (const app::ConfigError& e) {
        std::cerr << e.what() << '\n';
        return 2;
    } catch (const std::exception& e) {
        std::cerr << "drystone: " << e.what() << '\n';
        return 1;
    }
}
