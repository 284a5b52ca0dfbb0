/// drystone VERB STUDY.ini [options].  Exit codes: 0 done, 1 failed, 2 your input.

#include "app/input/command_line.hpp"
#include "app/input/config_error.hpp"
#include "app/verbs.hpp"

#include <exception>
#include <iostream>

int main(int argc, char** argv)
{
    try {
        const app::Command command =
            app::parse_command_line(app::verbs(), {argv + 1, argv + argc});
        return command.verb->run(command);
    } catch (const app::ConfigError& e) {
        std::cerr << e.what() << '\n';
        return 2;
    } catch (const std::exception& e) {
        std::cerr << "drystone: " << e.what() << '\n';
        return 1;
    }
}
